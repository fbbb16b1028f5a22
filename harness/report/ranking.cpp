#include "report/ranking.hpp"

#include <algorithm>

namespace reliefbench {

std::optional<double> wrong_hits(const CellResult& cell) {
    if (!cell.error) return std::nullopt;
    return cell.error->missed + cell.error->false_hits;
}

bool hits_within_limit(const CellResult& cell) {
    const std::optional<double> wrong = wrong_hits(cell);
    return wrong && *wrong <= wrong_hits_limit;
}

const PassTiming* draw_timing(const CellResult& cell) {
    const auto draw = cell.time.find(draw_pass);
    return draw == cell.time.end() ? nullptr : &draw->second;
}

RankingFlip ranking_flip(const std::vector<CellResult>& cells) {
    const bool lacking = std::any_of(cells.begin(), cells.end(),
                                     [](const CellResult& cell) { return cell.image && !cell.image->footprint; });
    return lacking ? RankingFlip::whole : RankingFlip::footprint;
}

std::optional<double> flip_of(const CellResult& cell, RankingFlip flip) {
    if (!cell.image) return std::nullopt;
    if (flip == RankingFlip::whole) return cell.image->flip;
    return cell.image->footprint ? cell.image->footprint->flip : std::nullopt;
}

std::string_view path_of(RankingFlip flip) {
    return flip == RankingFlip::whole ? "image.flip" : "image.footprint.flip";
}

std::string_view extent_of(RankingFlip flip) {
    return flip == RankingFlip::whole ? "of the whole picture" : "over the footprint";
}

std::string_view caveat_of(RankingFlip flip) {
    if (flip == RankingFlip::footprint) return "";
    return "FLIP is that of the whole picture, for this run has none over the footprint: relief beyond the quad counts "
           "in it, which no per-pixel technique can draw.";
}

}  // namespace reliefbench
