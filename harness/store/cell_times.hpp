#pragma once

#include "core/figure.hpp"
#include "core/statistics.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// Name of the draw among a cell's passes.
inline constexpr const char* draw_pass = "draw";

struct PassTiming {
    /// Of the rounds' medians.
    double median_ms = 0;
    /// Of all samples.
    double mad_ms = 0;
    /// Of the median, over the rounds' medians.
    Interval ci95_ms;
    std::size_t n = 0;
    /// Draws inside one timestamp pair.
    int repeats = 1;
    std::size_t rounds = 0;
    /// Samples far from the median: counted here, dropped nowhere.
    std::size_t outliers = 0;
    /// Of all samples: what runs are compared by, for what disturbs a draw only ever makes it longer. Empty in runs
    /// made before it was kept.
    std::optional<double> lower_quartile_ms = {};
};

/// Why a cell got no more rounds.
enum class StopReason {
    /// The interval of the median is as narrow as asked for.
    precise,
    /// More rounds do not narrow it.
    stalled,
    /// It is not as narrow as asked for, but the cell's time is spent.
    budget,
    /// The rounds asked for are done.
    rounds,
    /// The time asked for is spent.
    time,
    /// It is out of the question for what the run is asked (advise --map), be its interval wide.
    narrowed,
};

/// What a cell takes: each pass that was timed, and what it is worth knowing of that.
struct CellTimes {
    std::map<std::string, PassTiming> time;
    std::optional<double> ns_per_pixel;
    std::optional<StopReason> stop;
    /// Rounds in which the device was throttled and that count all the same, because repeating them did not help.
    std::size_t throttled_rounds = 0;
    std::optional<double> prepare_ms;
    std::optional<std::uint64_t> prepare_bytes;
};

/// Of the draw, then of the cell: the first figures of every list.
std::vector<FigureDeclaration> time_figures();
std::size_t time_figure_count();

/// By the figure's place among time_figures. Empty where it is none of a pass, or there is no value.
std::optional<double> pass_value(std::size_t figure, const PassTiming& timing);
void set_pass_value(std::size_t figure, PassTiming& timing, double value);
/// Whether every version writes it of a pass.
bool is_of_every_pass(std::size_t figure);

std::optional<double> time_value(std::size_t figure, const CellTimes& times);
/// Of the cell, not of a pass.
void set_time_value(std::size_t figure, CellTimes& times, double value);

}  // namespace reliefbench
