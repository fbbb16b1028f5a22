#include "measure/time_estimate.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

TEST(TimeEstimate, IsUnknownUntilACellWasPreparedAndVisited) {
    TimeEstimate estimate(4, 2);
    EXPECT_LT(estimate.remaining_seconds(), 0);
    estimate.add_preparation(1);
    EXPECT_LT(estimate.remaining_seconds(), 0);
    estimate.add_untimed_visit();
    EXPECT_LT(estimate.remaining_seconds(), 0);
    estimate.add_visit(0.5);
    // Three cells to prepare, six of eight visits to make.
    EXPECT_EQ(estimate.remaining_seconds(), 3 * 1 + 6 * 0.5);
}

TEST(TimeEstimate, EndsAtZero) {
    TimeEstimate estimate(2, 2);
    estimate.add_preparation(1);
    estimate.add_preparation(3);
    for (int visit = 0; visit < 4; ++visit) {
        estimate.add_visit(0.5);
    }
    EXPECT_EQ(estimate.remaining_seconds(), 0);
}

TEST(TimeEstimate, ADroppedCellWantsNoMoreVisits) {
    TimeEstimate estimate(2, 4);
    estimate.add_preparation(1);
    estimate.add_preparation(1);
    estimate.add_visit(2);
    estimate.drop_cell(1);
    EXPECT_EQ(estimate.remaining_seconds(), 4 * 2);
}

}  // namespace
}  // namespace reliefbench
