#include "measure/time_estimate.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

TEST(TimeEstimate, IsUnknownUntilACellWasPreparedAndVisited) {
    TimeEstimate estimate(4, 2);
    EXPECT_LT(estimate.remaining_seconds(), 0);
    estimate.add_preparation(1);
    EXPECT_LT(estimate.remaining_seconds(), 0);
    estimate.add_visit(0.5);
    // Three cells to prepare, seven of eight visits to make.
    EXPECT_EQ(estimate.remaining_seconds(), 3 * 1 + 7 * 0.5);
}

TEST(TimeEstimate, WhatPreparedCellsTakeBesidesIsExpectedOfTheOthersToo) {
    TimeEstimate estimate(4, 1);
    estimate.add_preparation(1);
    estimate.add_preparation(1);
    estimate.extend_preparation(4);
    estimate.add_visit(0.5);
    EXPECT_EQ(estimate.remaining_seconds(), 2 * 3 + 3 * 0.5);
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

TEST(TimeEstimate, LearnsFromFinishedCellsHowManyVisitsOneTakes) {
    TimeEstimate estimate(3, 6);
    for (int cell = 0; cell < 3; ++cell) {
        estimate.add_preparation(1);
    }
    for (int visit = 0; visit < 20; ++visit) {
        estimate.add_visit(0.5);
    }
    // Two cells with 20 visits between them; the third has had none.
    estimate.finish_cell(8);
    estimate.finish_cell(12);
    EXPECT_EQ(estimate.remaining_seconds(), 10 * 0.5);
}

TEST(TimeEstimate, ACellThatTakesLongerThanOthersDidHasNothingNegativeLeft) {
    TimeEstimate estimate(2, 2);
    estimate.add_preparation(1);
    estimate.add_preparation(1);
    for (int visit = 0; visit < 9; ++visit) {
        estimate.add_visit(0.5);
    }
    estimate.finish_cell(2);
    EXPECT_EQ(estimate.remaining_seconds(), 0);
}

TEST(ShareDone, NeverGoesBackThoughEstimatesChange) {
    ShareDone done;
    EXPECT_LT(done.of(1, -1), 0);
    EXPECT_DOUBLE_EQ(done.of(2, 6), 0.25);
    EXPECT_DOUBLE_EQ(done.of(3, 21), 0.25) << "a block with slow cells begins";
    EXPECT_LT(done.of(4, -1), 0) << "unknown";
    EXPECT_DOUBLE_EQ(done.of(10, 10), 0.5);
    EXPECT_DOUBLE_EQ(done.of(20, 0), 1);
}

}  // namespace
}  // namespace reliefbench
