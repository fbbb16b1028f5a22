// The promises of `compare`, short: benchmarks/regression_power has them long, on recorded noise.

#include "compare/compare_runs.hpp"

#include "compare/synthetic_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

using namespace reliefbench;

namespace {

std::optional<NoiseRecord> no_record(const MachineKey&) {
    return std::nullopt;
}

struct Counts {
    int cells = 0;
    int slower = 0;
    int faster = 0;
    /// Undecided, although the change is larger than what the cell says could have been seen.
    int overlooked = 0;
};

/// `trials` comparisons of runs split in two; the first `slowed` cells of the new side are made slower by `factor`, and
/// only those are counted.
Counts count_verdicts(const RunsModel& model, std::size_t runs_a_side, int trials, double factor, std::size_t slowed) {
    Random random(7);
    Counts counts;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<StoredRun> runs = synthetic_runs(model, 2 * runs_a_side, random);
        for (std::size_t run = runs_a_side; run < runs.size(); ++run) {
            // New code: no cell is a control that would vouch for the others.
            runs[run].run.run["environment"]["git_revision"] = "def";
            for (std::size_t cell = 0; cell < slowed; ++cell) {
                runs[run].run.cells[cell].time["draw"].median_ms *= factor;
            }
        }
        const std::span<const StoredRun> all = runs;
        const Comparison comparison =
            compare_runs(all.first(runs_a_side), all.subspan(runs_a_side), CompareOptions(), no_record);
        for (std::size_t index = 0; index < slowed; ++index) {
            const CellComparison& cell = comparison.cells[index];
            ++counts.cells;
            counts.slower += cell.verdict == Verdict::slower;
            counts.faster += cell.verdict == Verdict::faster;
            counts.overlooked += cell.verdict == Verdict::undecided && factor - 1 > cell.time.visible;
        }
    }
    return counts;
}

constexpr int trials = 20;
const RunsModel quiet;

TEST(RegressionProof, IdenticalCodeIsNotCalledDifferent) {
    for (const std::size_t runs : {1, 2, 3, 5, 10}) {
        const Counts counts = count_verdicts(quiet, runs, trials, 1, quiet.cells);
        EXPECT_EQ(counts.cells, 1500);
        EXPECT_EQ(counts.slower + counts.faster, 0) << runs << " runs a side";
    }
}

TEST(RegressionProof, IdenticalCodeIsNotCalledDifferentWhenAllCellsMoveTogether) {
    RunsModel busy;
    busy.common_sd = 0.2;
    for (const std::size_t runs : {3, 5, 10}) {
        const Counts counts = count_verdicts(busy, runs, trials, 1, busy.cells);
        EXPECT_EQ(counts.slower + counts.faster, 0) << runs << " runs a side";
    }
}

TEST(RegressionProof, IdenticalCodeIsNotCalledDifferentWhenSomeCellsAreMuchNoisier) {
    RunsModel uneven;
    uneven.smallest_sd = 0.005;
    uneven.largest_sd = 0.3;
    for (const std::size_t runs : {3, 5, 10}) {
        const Counts counts = count_verdicts(uneven, runs, trials, 1, uneven.cells);
        EXPECT_LE(counts.slower + counts.faster, 1) << runs << " runs a side";
    }
}

TEST(RegressionProof, FiveRunsASideSeeThirtyPerCentInAllCells) {
    const Counts counts = count_verdicts(quiet, 5, trials, 1.3, quiet.cells);
    EXPECT_GE(counts.slower, counts.cells * 95 / 100);
    EXPECT_EQ(counts.faster, 0);
    EXPECT_LE(counts.overlooked, counts.cells / 100);  // visible means 99 in 100
}

TEST(RegressionProof, FiveRunsASideSeeThirtyPerCentInOneTechniqueAndInOneCell) {
    const Counts technique = count_verdicts(quiet, 5, trials, 1.3, 12);
    EXPECT_GE(technique.slower, technique.cells * 95 / 100);
    const Counts cell = count_verdicts(quiet, 5, 100, 1.3, 1);
    EXPECT_GE(cell.slower, 95);
    EXPECT_LE(cell.overlooked, 1);
}

TEST(RegressionProof, EveryChangeAboveTheVisibleOneIsDecided) {
    // At a change that is only just visible for most cells.
    for (const double factor : {1.25, 1.35, 1.5}) {
        const Counts counts = count_verdicts(quiet, 3, trials, factor, quiet.cells);
        EXPECT_LE(counts.overlooked, counts.cells / 100) << factor;
    }
}

}  // namespace
