#include "measure/run_summary.hpp"

#include "core/counted.hpp"
#include "core/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace reliefbench {

namespace {

constexpr std::array stop_reasons{StopReason::precise, StopReason::stalled, StopReason::budget,
                                  StopReason::rounds,  StopReason::time,    StopReason::narrowed};

/// Of so many cells.
std::string_view why_stopped(StopReason reason) {
    switch (reason) {
        case StopReason::precise:
            return "precise enough";
        case StopReason::stalled:
            return "no longer getting more precise";
        case StopReason::budget:
            return "with the budget spent";
        case StopReason::rounds:
            return "with the rounds done";
        case StopReason::time:
            return "with the time spent";
        case StopReason::narrowed:
            return "as they were out of the question";
    }
    return {};
}

std::size_t count_stops(const RunTally& tally, StopReason reason) {
    const auto found = tally.stops.find(reason);
    return found == tally.stops.end() ? 0 : found->second;
}

std::string truths_in_words(const TruthWork& truths) {
    if (truths.cached == 0) return "tracing truths";
    return fmt::format("tracing {} and reading {} that {} cached", counted(truths.traced, "truth"), truths.cached,
                       truths.cached == 1 ? "was" : "were");
}

std::optional<double> utilisation(const TimeSplit& split) {
    if (split.timing_s <= 0) return std::nullopt;
    return split.timing_samples_s / split.timing_s;
}

}  // namespace

Json make_run_summary(const RunOutcome& outcome, const Json& empty_pass) {
    const TimeSplit& split = outcome.split;
    const std::optional<double> utilised = utilisation(split);
    Json json;
    json["cells"] = {{"ok", outcome.tally.ok}, {"skipped", outcome.tally.skipped}, {"failed", outcome.tally.failed}};
    for (const StopReason reason : stop_reasons) {
        json["stop"][std::string(to_string(reason))] = count_stops(outcome.tally, reason);
    }
    json["throttled_cells"] = outcome.tally.throttled_cells;
    json["total_s"] = split.total_s;
    json["samples_s"] = split.samples_s;
    json["truth_s"] = split.truths.seconds;
    json["truths"] = {{"traced", split.truths.traced}, {"cached", split.truths.cached}};
    json["timing"] = {{"total_s", split.timing_s},
                      {"samples_s", split.timing_samples_s},
                      {"utilisation", utilised ? Json(*utilised) : Json(nullptr)}};
    json["empty_pass"] = empty_pass;
    return json;
}

std::string format_run_summary(const RunOutcome& outcome, const Json& empty_pass) {
    const TimeSplit& split = outcome.split;
    const double useful_s = split.samples_s + split.truths.seconds;
    std::string text = fmt::format(
        "time: {:.1f} s in all; {:.1f} s inside counted GPU samples, {:.1f} s {}: {:.0f} %\n", split.total_s,
        split.samples_s, split.truths.seconds, truths_in_words(split.truths), 100 * useful_s / split.total_s);
    const std::optional<double> utilised = utilisation(split);
    if (!utilised) return text;
    text += fmt::format(
        "timing: {:.1f} s from first to last visits, {:.1f} % of it inside counted samples; an empty pass takes {:.4f} "
        "ms\n",
        split.timing_s, 100 * *utilised, empty_pass.at("median_ms").get<double>());
    std::vector<std::string> stops;
    for (const StopReason reason : stop_reasons) {
        if (const std::size_t cells = count_stops(outcome.tally, reason); cells > 0) {
            stops.push_back(fmt::format("{} {} {}", cells, cells == 1 ? "cell" : "cells", why_stopped(reason)));
        }
    }
    if (stops.empty()) return text;  // interrupted before any cell was finished
    text += fmt::format("sampling stopped: {}", join(stops));
    if (const std::size_t cells = outcome.tally.throttled_cells; cells > 0) {
        text +=
            fmt::format("; {} throttled rounds", cells == 1 ? "1 cell counts" : fmt::format("{} cells count", cells));
    }
    return text + '\n';
}

}  // namespace reliefbench
