#include "report/comparison_json.hpp"

#include "comparison_sample.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

using namespace reliefbench;

namespace {

TEST(ComparisonJson, HasWhatTheFormatPromisesAndMore) {
    Comparison comparison = sample_comparison();
    comparison.cells.erase(comparison.cells.begin() + 1, comparison.cells.end());
    comparison.uncompared.resize(1);
    comparison.deciding_figures = {default_deciding_figures()[2]};
    EXPECT_EQ(comparison_to_json(comparison), Json::parse(R"({
        "cells": [{
            "cell": "pom | view_angle=60", "verdict": "same", "ratio": 1.0004, "ci95": [0.99, 1.01], "visible": 0.031,
            "reason": "same: +0.0 % (−1.0 to +1.0 %), 5 runs a side", "p_slower": 1.0, "p_faster": 1.0, "p_unchanged": 1.0, "units": 5, "more": 0,
            "quality": {"verdict": "worse", "changes": [
                {"field": "error.uv_texels.p99", "base": 0.75, "new": 0.8100001, "worse": true, "better": false,
                 "decides": true, "tolerances": 1.200002,
                 "text": "worse by 8.0 %: error.uv_texels.p99 0.750 → 0.810 texels"},
                {"field": "error.missed", "base": 0.02, "new": 0.01, "worse": false, "better": true, "decides": false,
                 "tolerances": 10.0, "text": "better by 1.0 % of footprint: error.missed 2.00 → 1.00 % of footprint"},
                {"field": "image.psnr", "base": null, "new": 40.0, "worse": false, "better": false, "decides": false,
                 "tolerances": 0.0, "text": "image.psnr - → 40.0 dB"}
            ]}
        }],
        "uncompared": [{"cell": "flat | view_angle=60", "reason": "only in the base", "failed_now": false}],
        "notices": ["the driver changed: Mesa 22.3.6, now Mesa 23.0.0"],
        "summary": {"slower": 0, "undecided": 0, "faster": 0, "same": 1, "worse": 1, "mixed": 0, "better": 0,
                    "same_quality": 0, "not_comparable": 0, "uncompared": 1, "failed_now": 0},
        "deciding_figures": [{"figure": "error.missed+error.false_hits", "absolute": 0.001, "relative": 0.0,
                              "tolerance": "0.1 % of footprint"}],
        "threshold": 0.02, "unit": "runs", "environment": {"noise": "default"}
    })"));
}

TEST(ComparisonJson, OfQualityAloneThereIsNothingOnTimes) {
    Comparison comparison = sample_comparison();
    comparison.quality_only = true;
    const Json json = comparison_to_json(comparison);
    EXPECT_EQ(json.at("cells").at(3).size(), 2U);
    EXPECT_EQ(json.at("cells").at(3).at("quality").at("verdict"), "same");
    for (const char* member : {"threshold", "unit"})
        EXPECT_FALSE(json.contains(member)) << member;
    for (const char* member : {"slower", "undecided", "faster", "same"})
        EXPECT_FALSE(json.at("summary").contains(member)) << member;
}

TEST(ComparisonJson, WhatIsNotFiniteIsNull) {
    Comparison comparison;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    comparison.cells = {compared("a | v", Verdict::undecided, std::numeric_limits<double>::quiet_NaN(), {0, infinity})};
    comparison.cells[0].time.visible = infinity;
    comparison.cells[0].time.more.reset();
    const Json cell = Json::parse(format_comparison_json(comparison)).at("cells").at(0);
    EXPECT_TRUE(cell.at("ratio").is_null());
    EXPECT_EQ(cell.at("ci95"), Json::parse("[0.0, null]"));
    EXPECT_TRUE(cell.at("visible").is_null());
    EXPECT_TRUE(cell.at("more").is_null());
}

TEST(ComparisonJson, NothingComparedIsAnEmptyArray) {
    const Json json = Json::parse(format_comparison_json({}));
    EXPECT_EQ(json.at("cells"), Json::array());
    EXPECT_EQ(json.at("uncompared"), Json::array());
}

}  // namespace
