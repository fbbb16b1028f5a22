#include "measure/run_summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

RunOutcome outcome_of_four() {
    RunOutcome outcome;
    outcome.tally = {
        .ok = 3, .failed = 1, .stops = {{StopReason::precise, 2}, {StopReason::budget, 1}}, .throttled_cells = 1};
    outcome.split = {
        .total_s = 20, .samples_s = 8, .truths = {.seconds = 1, .traced = 2}, .timing_s = 8, .timing_samples_s = 7.5};
    return outcome;
}

const Json empty_pass = {{"median_ms", 0.00125}, {"mad_ms", 0.0}, {"n", 21}};

TEST(RunSummary, SaysHowCellsEndedAndWhereTheTimeWent) {
    EXPECT_EQ(make_run_summary(outcome_of_four(), empty_pass), Json::parse(R"({
        "cells": {"ok": 3, "skipped": 0, "failed": 1},
        "stop": {"precise": 2, "stalled": 0, "budget": 1, "rounds": 0, "time": 0, "narrowed": 0},
        "throttled_cells": 1,
        "total_s": 20.0, "samples_s": 8.0, "truth_s": 1.0, "truths": {"traced": 2, "cached": 0},
        "timing": {"total_s": 8.0, "samples_s": 7.5, "utilisation": 0.9375},
        "empty_pass": {"median_ms": 0.00125, "mad_ms": 0.0, "n": 21}
    })"));
}

TEST(RunSummary, IsPrinted) {
    const std::string text = format_run_summary(outcome_of_four(), empty_pass);
    EXPECT_THAT(text, HasSubstr("time: 20.0 s in all; 8.0 s inside counted GPU samples, 1.0 s tracing truths: 45 %\n"));
    EXPECT_THAT(text, HasSubstr("93.8 % of it inside counted samples; an empty pass takes 0.0013 ms\n"));
    EXPECT_THAT(text, HasSubstr("sampling stopped: 2 cells precise enough, 1 cell with the budget spent; 1 cell counts "
                                "throttled rounds\n"));
}

TEST(RunSummary, TellsTruthsThatWereCached) {
    RunOutcome outcome = outcome_of_four();
    outcome.split.truths = {.seconds = 1, .traced = 1, .cached = 2};
    EXPECT_THAT(format_run_summary(outcome, empty_pass),
                HasSubstr("1.0 s tracing 1 truth and reading 2 that were cached: 45 %\n"));
    EXPECT_EQ(make_run_summary(outcome, empty_pass).at("truths"), Json::parse(R"({"traced": 1, "cached": 2})"));
}

TEST(RunSummary, OfARunInterruptedBeforeACellWasFinishedNamesNoReason) {
    RunOutcome outcome;
    outcome.split.total_s = 2;
    outcome.split.timing_s = 1;
    EXPECT_THAT(format_run_summary(outcome, empty_pass), AllOf(HasSubstr("timing:"), Not(HasSubstr("stopped"))));
}

TEST(RunSummary, WithoutTimingsThereIsNoUtilisation) {
    RunOutcome outcome;
    outcome.split.total_s = 1;
    EXPECT_TRUE(make_run_summary(outcome, empty_pass).at("timing").at("utilisation").is_null());
    EXPECT_THAT(format_run_summary(outcome, empty_pass), Not(HasSubstr("timing:")));
}

}  // namespace
}  // namespace reliefbench
