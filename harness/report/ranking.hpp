#pragma once

#include "store/cell_result.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// What cells of a run are ranked by, in tables and in advice.

/// Missed and false hits together above this fraction of the footprint: discarding hard pixels wins nothing.
constexpr double wrong_hits_limit = 0.005;

/// Empty where nothing was compared with a truth.
std::optional<double> wrong_hits(const CellResult& cell);
/// Whether the cell's errors count.
bool hits_within_limit(const CellResult& cell);

/// Of the draw; null where the cell was not timed.
const PassTiming* draw_timing(const CellResult& cell);

/// With how many samples for each pixel the truth's picture was made that a run's pictures are compared with; `record`
/// is its run.json, in which runs of versions that knew one only say nothing.
int truth_samples(const Json& record);

/// "FLIP is against a truth of 64 samples a pixel."
std::string truth_words(int samples);

/// What the Pareto front weighs against the cost: FLIP over the footprint where the truth is filtered as a player sees
/// it; with one sample, when it counts what filters do to a picture as errors, the UV error.
const FigureDeclaration& front_quality(const std::vector<CellResult>& cells, const Json& record);

/// Which FLIP ranks cells that are shown together.
enum class RankingFlip {
    /// chosen_figures::flip
    footprint,
    /// chosen_figures::flip_of_whole_picture, of runs of version 0.1.0: relief outside the footprint counts in it,
    /// which no per-pixel technique can draw.
    whole,
};

/// Over the footprint, unless some cell has a picture and no figures over its footprint: what is ranked is alike in
/// all.
RankingFlip ranking_flip(const std::vector<CellResult>& cells);

std::string_view path_of(RankingFlip flip);

/// A sentence that has to be said of it; "" for the footprint.
std::string_view caveat_of(RankingFlip flip);

}  // namespace reliefbench
