// The promises of comparing, held to the noise that a busy shared machine really made: identical code is never called
// slower, and a real slowdown is found. benchmarks/regression_power is the long form, with real draws.

#include "replayed_machine.hpp"

#include "cli/variant_comparison.hpp"
#include "compare/compare_runs.hpp"
#include "compare/synthetic_runs.hpp"
#include "measure/paired_rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <span>

namespace reliefbench {
namespace {

struct Tally {
    std::size_t cells = 0;
    std::size_t slower = 0;
    std::size_t faster = 0;
    /// Undecided though they say that a change of the true size would have been seen.
    std::size_t overlooked = 0;

    Tally& operator+=(const Tally& other) {
        cells += other.cells;
        slower += other.slower;
        faster += other.faster;
        overlooked += other.overlooked;
        return *this;
    }
};

Tally tally(const Comparison& comparison, double change) {
    Tally tally;
    for (const CellComparison& cell : comparison.cells) {
        ++tally.cells;
        tally.slower += cell.verdict == Verdict::slower ? 1 : 0;
        tally.faster += cell.verdict == Verdict::faster ? 1 : 0;
        tally.overlooked += cell.verdict == Verdict::undecided && cell.time.visible < change ? 1 : 0;
    }
    return tally;
}

/// `ab` over `cells` pairs of which the changed side takes `ratio` times as long, from some moment of the record on.
Tally interleave(const RecordedNoise& noise, std::size_t start, std::size_t cells, double ratio, double budget_s) {
    constexpr double threshold = 0.01;
    const VariantSettings settings;
    ReplayedMachine machine(noise.draws_ms, start);
    std::vector<ReplayedSubject> subjects;
    subjects.reserve(2 * cells);
    std::vector<SubjectPair> pairs;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        subjects.emplace_back(machine, settings.minimum_pass_ms);
        subjects.emplace_back(machine, settings.minimum_pass_ms * ratio);
        pairs.push_back({&subjects[2 * cell], &subjects[2 * cell + 1]});
    }
    const CellIsDecided is_decided = decided_at_looks(threshold, cells);
    PairCallbacks callbacks;
    callbacks.is_decided = [&](std::size_t, const LogRatios& log_ratios) { return is_decided(log_ratios); };
    callbacks.on_failure = [](std::size_t, const std::string& reason) { FAIL() << reason; };
    const PairSampling sampling{.samples_per_visit = settings.samples_per_visit, .budget_s = budget_s, .seed = start};
    VariantOutcome outcome;
    for (LogRatios& log_ratios : sample_pairs(pairs, sampling, callbacks, machine)) {
        const CellResult cell = cell_result(fmt::format("c{}", outcome.measured.size()), 1);
        outcome.measured.push_back({cell, cell, std::move(log_ratios)});
    }
    return tally(compare_variants(outcome, threshold), ratio - 1);
}

/// `compare` of `runs_a_side` recorded runs against as many others, in random order; the new side, of changed code,
/// takes `ratio` times as long.
Tally compare_stored(const RecordedNoise& noise, std::uint64_t seed, double ratio) {
    constexpr std::size_t runs_a_side = 5;
    std::vector<std::size_t> order(noise.run_times_ms.front().size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Random(seed).shuffle(std::span<std::size_t>(order));
    std::vector<StoredRun> runs;
    for (std::size_t index = 0; index < 2 * runs_a_side; ++index) {
        const bool is_new = index >= runs_a_side;
        std::vector<CellResult> cells;
        for (const std::vector<double>& times : noise.run_times_ms) {
            cells.push_back(cell_result(fmt::format("c{}", cells.size()), times[order[index]] * (is_new ? ratio : 1)));
        }
        runs.push_back(one_run(fmt::format("run{}", index), std::move(cells)));
        // Changed sources: no cell is a control that would vouch for the others.
        if (is_new) runs.back().run.run["techniques"]["first"] = "changed";
    }
    const std::span<const StoredRun> all = runs;
    const auto no_record = [](const MachineKey&) { return std::optional<NoiseRecord>(); };
    return tally(compare_runs(all.first(runs_a_side), all.subspan(runs_a_side), CompareOptions(), no_record),
                 ratio - 1);
}

}  // namespace

TEST(RegressionPower, TwoHundredIdenticalPairsAreNeverCalledSlowerOrFaster) {
    const RecordedNoise noise = read_recorded_noise();
    Tally all;
    for (std::size_t block = 0; block < 4; ++block) {
        all += interleave(noise, 2971 * block, 50, 1.0, 150);
    }
    EXPECT_EQ(all.cells, 200U);
    EXPECT_EQ(all.slower, 0U);
    EXPECT_EQ(all.faster, 0U);
}

TEST(RegressionPower, AFivePerCentSlowdownIsFoundInNineteenOfTwentyCellsWithinTheBudget) {
    const RecordedNoise noise = read_recorded_noise();
    Tally all;
    for (std::size_t trial = 0; trial < 6; ++trial) {
        all += interleave(noise, 1997 * trial, 10, 1.05, 300);
    }
    EXPECT_EQ(all.cells, 60U);
    EXPECT_GE(all.slower, 57U);
    EXPECT_EQ(all.overlooked, 0U);
}

TEST(RegressionPower, StoredRunsOfOneConfigurationGiveAtMostOneFalseVerdictInAThousandCells) {
    const RecordedNoise noise = read_recorded_noise();
    Tally all;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        all += compare_stored(noise, seed, 1.0);
    }
    EXPECT_GE(all.cells, 1000U);
    EXPECT_LE(1000 * (all.slower + all.faster), all.cells);
}

TEST(RegressionPower, FiveRunsASideFindAThirtyPerCentSlowdownInNineteenOfTwentyCells) {
    const RecordedNoise noise = read_recorded_noise();
    Tally all;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        all += compare_stored(noise, seed, 1.3);
    }
    EXPECT_GE(20 * all.slower, 19 * all.cells);
    EXPECT_EQ(all.overlooked, 0U);
}

}  // namespace reliefbench
