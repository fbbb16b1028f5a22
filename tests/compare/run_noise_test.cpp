#include "compare/run_noise.hpp"

#include "core/random.hpp"
#include "support/error_message.hpp"
#include "support/normal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace reliefbench;

namespace {

std::vector<CellMedians> medians(std::size_t cells, std::size_t runs, double smallest_sd, double largest_sd,
                                 double common_sd) {
    Random random(2);
    std::vector<double> common;
    for (std::size_t run = 0; run < 2 * runs; ++run) {
        common.push_back(common_sd * standard_normal(random));
    }
    std::vector<CellMedians> result(cells);
    for (CellMedians& cell : result) {
        const double sd = random.uniform(smallest_sd, largest_sd);
        for (std::size_t run = 0; run < 2 * runs; ++run) {
            const double ms = std::exp(common[run] + sd * standard_normal(random));
            (run < runs ? cell.base_ms : cell.new_ms).push_back(ms);
        }
    }
    return result;
}

TEST(PoolNoise, IsTheRootMeanSquareWithTheFreedomOfOneCell) {
    const std::vector<NoiseRecord::Cell> cells = {
        {"a", {1.0, 1.2, 1.4}, 0, 0},  // standard deviation 0.2
        {"b", {5.0, 5.1, 5.2}, 0, 0},  // 0.1
        {"c", {7.0}, 0, 0},
    };
    const RunNoise noise = pool_noise(cells, "2026-01-02");
    EXPECT_NEAR(noise.log_sd, std::sqrt((0.04 + 0.01) / 2), 1e-15);
    EXPECT_EQ(noise.degrees_of_freedom, 2);
    EXPECT_EQ(noise.source, "measured on this machine by `reliefbench selfcheck`, 2026-01-02, 3 processes");
}

TEST(PoolNoise, OneProcessIsAnError) {
    EXPECT_THAT(error_message([] { pool_noise({}, ""); }), testing::HasSubstr("two processes or more"));
    const std::vector<NoiseRecord::Cell> cells = {{"a", {1.0}, 0, 0}};
    EXPECT_THAT(error_message([&] { pool_noise(cells, ""); }), testing::HasSubstr("two processes or more"));
}

TEST(NoiseOfRuns, AlikeCellsLendEachOtherTheirFreedom) {
    const RunNoise noise = noise_of_runs(medians(75, 5, 0.06, 0.06, 0));
    // 600 degrees of freedom in all: 3 % of the standard deviation is its standard error.
    EXPECT_NEAR(noise.log_sd, 0.06, 0.006);
    // How alike the variances are is itself known by chance only; the cells' own are 8.
    EXPECT_GT(noise.degrees_of_freedom, 30);
}

TEST(NoiseOfRuns, CellsThatMoveTogetherLendNothing) {
    EXPECT_LT(noise_of_runs(medians(75, 5, 0.005, 0.005, 0.1)).degrees_of_freedom, 0.5);
}

TEST(NoiseOfRuns, CellsOfDifferentNoiseLendLittle) {
    EXPECT_LT(noise_of_runs(medians(75, 5, 0.01, 0.3, 0)).degrees_of_freedom, 8);
}

TEST(NoiseOfRuns, MatchesSmythsMomentsWorkedOutBySciPy) {
    // Four cells of 3 + 3 runs with variances 0.0004, 0.0025, 0.01, 0.09: too unlike for their number. With
    // scipy.special: d0 = 1.0455, s0 = 0.04634.
    std::vector<CellMedians> cells;
    for (const double sd : {0.02, 0.05, 0.1, 0.3}) {
        CellMedians cell;
        for (const double deviation : {-1.0, 0.0, 1.0}) {
            cell.base_ms.push_back(std::exp(sd * deviation));
            cell.new_ms.push_back(std::exp(1 + sd * deviation));
        }
        cells.push_back(cell);
    }
    // They move together perfectly here, so that no freedom is lent at all; in the scale that does not show.
    const RunNoise noise = noise_of_runs(cells);
    EXPECT_EQ(noise.degrees_of_freedom, 0);
    EXPECT_NEAR(noise.log_sd, 0.04633970699074188, 1e-9);
}

TEST(NoiseOfRuns, TooFewCellsOrConstantOnesTellNothing) {
    EXPECT_EQ(noise_of_runs({}).degrees_of_freedom, 0);
    EXPECT_EQ(noise_of_runs(medians(2, 5, 0.06, 0.06, 0)).degrees_of_freedom, 0);
    const std::vector<CellMedians> constant(10, CellMedians{{1, 1, 1}, {2, 2, 2}});
    EXPECT_EQ(noise_of_runs(constant).degrees_of_freedom, 0);
    const std::vector<CellMedians> single(10, CellMedians{{1}, {2}});
    EXPECT_EQ(noise_of_runs(single).degrees_of_freedom, 0);
}

}  // namespace
