#include "compare/compare_runs.hpp"

#include "compare/between_runs.hpp"
#include "compare/describe.hpp"
#include "compare/pair_runs.hpp"
#include "compare/run_differences.hpp"
#include "compare/run_noise.hpp"
#include "compare/run_side.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "store/device_share.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace reliefbench {

namespace {

/// On all cores.
template <typename Body>
void for_each_index(std::size_t count, const Body& body) {
    constexpr std::size_t at_a_time = 64;
    parallel_for(count, at_a_time, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index)
            body(index);
    });
}

CellMedians times_of(const SideCell& base, const SideCell& changed) {
    const bool quartiles = base.has_lower_quartiles() && changed.has_lower_quartiles();
    const Figure figure = quartiles ? Figure::lower_quartile : Figure::median;
    return {base.milliseconds(figure), changed.milliseconds(figure)};
}

/// Enough for the runs to tell their own noise: three a side.
constexpr std::size_t min_own_degrees_of_freedom = 4;

/// Chance alone makes identical code differ by less.
constexpr double told_inflation = 1.5;

struct NoiseSources {
    RunNoise of_runs;
    RunNoise of_machine;
};

bool runs_tell(std::size_t base_runs, std::size_t new_runs) {
    return base_runs + new_runs >= min_own_degrees_of_freedom + 2;
}

RunNoise noise_for(const NoiseSources& sources, const SideCell& base, const SideCell& changed) {
    if (runs_tell(base.measured.size(), changed.measured.size())) return sources.of_runs;
    RunNoise noise = sources.of_machine;
    noise.log_sd = std::max({noise.log_sd, sources.of_runs.log_sd, deviation_within_runs(base, changed)});
    return noise;
}

/// Of two machines the noisier one's.
RunNoise machine_noise(const StoredRun& base, const StoredRun& changed, const NoiseLookup& find_noise) {
    RunNoise noisiest;
    bool known = false;
    for (const StoredRun* run : {&base, &changed}) {
        const auto record = find_noise(machine_of(run->run.run));
        const RunNoise noise = record ? record->between_runs : RunNoise();
        if (!known || noise.log_sd > noisiest.log_sd) noisiest = noise;
        known = true;
    }
    return noisiest;
}

/// Cells of techniques whose folders did not change are told apart: when they move, something else did.
std::optional<std::string> notice_of_common_shift(const Comparison& comparison, const RunSide& base,
                                                  const RunSide& changed) {
    std::size_t unchanged = 0;
    std::vector<double> slower;
    std::vector<double> faster;
    for (const CellComparison& cell : comparison.cells) {
        const SideCell& before = base.cells.at(cell.cell);
        const SideCell& after = changed.cells.at(cell.cell);
        if (!same_source(*before.runs[0], *after.runs[0], before.measured[0]->technique)) continue;
        ++unchanged;
        if (cell.verdict == Verdict::slower) slower.push_back(cell.time.ratio);
        if (cell.verdict == Verdict::faster) faster.push_back(cell.time.ratio);
    }
    const bool mostly_slower = slower.size() >= faster.size();
    const std::vector<double>& moved = mostly_slower ? slower : faster;
    if (moved.size() < 2) return std::nullopt;
    return fmt::format(
        "{} of {} of techniques whose sources are the same on both sides are {}, by {} in the median: shared "
        "shaders, the harness, the driver or the state of the machine moved them; `reliefbench ab` measures both sides "
        "live",
        moved.size(), counted(unchanged, "cell"), mostly_slower ? "slower" : "faster",
        percent(std::abs(median(moved) - 1)));
}

/// Per run, the time of all preparations of the compared cells; empty unless every run has them all.
std::vector<double> preparation_of(const RunSide& side, const Comparison& comparison) {
    std::vector<double> sums(side.runs.size(), 0.0);
    for (const CellComparison& cell : comparison.cells) {
        const SideCell& results = side.cells.at(cell.cell);
        if (results.measured.size() != side.runs.size()) return {};
        for (std::size_t run = 0; run < side.runs.size(); ++run) {
            sums[run] += results.measured[run]->prepare_ms.value_or(0);
        }
    }
    const bool positive = std::all_of(sums.begin(), sums.end(), [](double sum) { return sum > 0; });
    return positive ? sums : std::vector<double>();
}

std::optional<std::string> notice_of_preparation(const Comparison& comparison, const RunSide& base,
                                                 const RunSide& changed, const RunNoise& noise) {
    const std::vector<double> before = preparation_of(base, comparison);
    const std::vector<double> after = preparation_of(changed, comparison);
    if (before.empty() || after.empty()) return std::nullopt;
    const RatioEstimate estimate = estimate_between_runs(before, after, noise, comparison.threshold);
    const Verdict verdict = decide(std::span(&estimate, 1), comparison.threshold, highest_p_unchanged).front();
    if (verdict != Verdict::slower && verdict != Verdict::faster) return std::nullopt;
    return fmt::format("preparing the maps of all cells together is {}", describe(estimate, verdict, "runs"));
}

Json noise_record(const RunNoise& noise, double inflation) {
    Json json;
    json["log_sd"] = noise.log_sd;
    json["degrees_of_freedom"] = noise.degrees_of_freedom;
    json["inflation"] = inflation;
    json["source"] = noise.source;
    return json;
}

/// The machine's state moves what no change of code does: by how much the noise has to be widened for it.
double inflation_of(const Comparison& comparison, const RunSide& base, const RunSide& changed,
                    const NoiseSources& noise) {
    std::vector<ControlCell> controls;
    for (const CellComparison& cell : comparison.cells) {
        const SideCell& before = base.cells.at(cell.cell);
        const SideCell& after = changed.cells.at(cell.cell);
        if (!same_code(*before.runs[0], *after.runs[0], before.measured[0]->technique)) continue;
        const RunNoise noise_of_cell = noise_for(noise, before, after);
        const CellMedians times = times_of(before, after);
        const auto own = static_cast<double>(before.measured.size() + after.measured.size() - 2);
        controls.push_back({estimate_between_runs(times.base_ms, times.new_ms, noise_of_cell, comparison.threshold),
                            own + noise_of_cell.degrees_of_freedom});
    }
    return noise_inflation(controls);
}

void estimate_times(Comparison& comparison, const RunSide& base, const RunSide& changed, const NoiseSources& noise,
                    double inflation, double false_discovery_rate) {
    const auto estimate_all = [&](double level) {
        std::vector<RatioEstimate> estimates(comparison.cells.size());
        for_each_index(estimates.size(), [&](std::size_t index) {
            const SideCell& before = base.cells.at(comparison.cells[index].cell);
            const SideCell& after = changed.cells.at(comparison.cells[index].cell);
            const CellMedians times = times_of(before, after);
            estimates[index] = estimate_between_runs(times.base_ms, times.new_ms, noise_for(noise, before, after),
                                                     comparison.threshold, level, inflation);
        });
        return estimates;
    };
    const std::vector<Verdict> verdicts =
        decide(estimate_all(false_discovery_rate), comparison.threshold, false_discovery_rate);
    // What could have been seen depends on how many verdicts there are.
    const std::vector<RatioEstimate> estimates = estimate_all(level_of_verdicts(verdicts, false_discovery_rate));
    for_each_index(comparison.cells.size(), [&](std::size_t index) {
        CellComparison& cell = comparison.cells[index];
        cell.time = estimates[index];
        cell.verdict = verdicts[index];
        cell.reason = describe(cell.time, cell.verdict, comparison.unit) +
                      partial_text(base.cells.at(cell.cell), base.runs.size(), "base") +
                      partial_text(changed.cells.at(cell.cell), changed.runs.size(), "new");
    });
}

}  // namespace

Comparison compare_runs(std::span<const StoredRun> base_runs, std::span<const StoredRun> new_runs,
                        const CompareOptions& options, const NoiseLookup& find_noise) {
    assert(!base_runs.empty() && !new_runs.empty());
    const RunSide base = gather_side(base_runs);
    const RunSide changed = gather_side(new_runs);
    const std::string device = device_difference(base_runs.front(), new_runs.front());
    if (!device.empty() && !options.across_devices) {
        fail(
            "the runs are of different devices, whose times say nothing of each other: {}; --across-devices compares "
            "them all the same",
            device);
    }
    Comparison comparison = pair_runs(base, changed, options.deciding_figures);
    comparison.threshold = options.threshold;
    for (const auto& runs : {base_runs, new_runs}) {
        for (const StoredRun& run : runs) {
            const std::string shared = describe(device_share(run.run.run), "the times of " + run.name);
            if (!shared.empty()) comparison.notices.push_back(shared);
        }
    }
    std::vector<CellMedians> medians;
    for (const CellComparison& cell : comparison.cells) {
        medians.push_back(times_of(base.cells.at(cell.cell), changed.cells.at(cell.cell)));
    }
    const NoiseSources noise{noise_of_runs(medians), machine_noise(base_runs.front(), new_runs.front(), find_noise)};
    const bool own = runs_tell(base_runs.size(), new_runs.size());
    const double inflation = inflation_of(comparison, base, changed, noise);
    estimate_times(comparison, base, changed, noise, inflation, options.false_discovery_rate);
    if (inflation > told_inflation) {
        comparison.notices.insert(
            comparison.notices.begin(),
            fmt::format(
                "cells that run the same code on both sides lie {:.1f} times as far apart as their runs account "
                "for: the machine was in another state, and all intervals are widened by that factor; "
                "`reliefbench ab` measures both sides live",
                inflation));
    }
    if (!own) {
        comparison.notices.push_back(
            fmt::format("noise between runs: {} ({})", percent(noise.of_machine.log_sd), noise.of_machine.source));
    }
    const RunNoise no_prior{0, 0, ""};
    if (auto notice = notice_of_preparation(comparison, base, changed, own ? no_prior : noise.of_machine)) {
        comparison.notices.push_back(std::move(*notice));
    }
    if (auto notice = notice_of_common_shift(comparison, base, changed)) {
        comparison.notices.insert(comparison.notices.begin(), std::move(*notice));
    }
    comparison.environment["noise"] = noise_record(own ? noise.of_runs : noise.of_machine, inflation);
    return comparison;
}

}  // namespace reliefbench
