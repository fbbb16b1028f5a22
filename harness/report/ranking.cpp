#include "report/ranking.hpp"

#include "store/chosen_figures.hpp"

#include <algorithm>

namespace reliefbench {

std::optional<double> wrong_hits(const CellResult& cell) {
    const std::optional<double> missed = value_of(chosen_figures::missed, cell);
    const std::optional<double> false_hits = value_of(chosen_figures::false_hits, cell);
    return missed && false_hits ? std::optional(*missed + *false_hits) : std::nullopt;
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
    const FigureDeclaration& whole = known_figure(chosen_figures::flip_of_whole_picture);
    const FigureDeclaration& footprint = known_figure(chosen_figures::flip);
    const bool lacking = std::any_of(cells.begin(), cells.end(), [&](const CellResult& cell) {
        return is_given(whole, cell) && !is_given(footprint, cell);
    });
    return lacking ? RankingFlip::whole : RankingFlip::footprint;
}

std::string_view path_of(RankingFlip flip) {
    return flip == RankingFlip::whole ? chosen_figures::flip_of_whole_picture : chosen_figures::flip;
}

std::string_view caveat_of(RankingFlip flip) {
    if (flip == RankingFlip::footprint) return "";
    return "FLIP is that of the whole picture, for this run has none over the footprint: relief outside it "
           "counts, which no per-pixel technique can draw.";
}

}  // namespace reliefbench
