#include "report/ranking.hpp"

#include "core/counted.hpp"
#include "core/json_lookup.hpp"
#include "store/chosen_figures.hpp"

#include <fmt/format.h>

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

int truth_samples(const Json& record) {
    const Json samples = value_at(record, {"configuration", "truth", "samples"});
    return samples.is_number_integer() ? samples.get<int>() : 1;
}

std::string truth_words(int samples) {
    return fmt::format("FLIP is against a truth of {} a pixel.", counted(static_cast<std::size_t>(samples), "sample"));
}

const FigureDeclaration& front_quality(const std::vector<CellResult>& cells, const Json& record) {
    const FigureDeclaration& flip = known_figure(chosen_figures::flip);
    const bool is_filtered = truth_samples(record) > 1 && std::ranges::any_of(cells, [&](const CellResult& cell) {
                                 return value_of(flip, cell).has_value();
                             });
    return is_filtered ? flip : known_figure(chosen_figures::quality);
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
