#pragma once

#include "compare/comparison.hpp"
#include "compare/describe.hpp"

#include <string>
#include <utility>

namespace reliefbench {

inline CellComparison compared(std::string cell, Verdict verdict, double ratio, Interval ci95) {
    CellComparison comparison;
    comparison.cell = std::move(cell);
    comparison.verdict = verdict;
    comparison.time.ratio = ratio;
    comparison.time.ci95 = ci95;
    comparison.time.visible = 0.031;
    comparison.time.units = 5;
    comparison.time.more = 0;
    comparison.reason = describe(comparison.time, verdict, "runs");
    return comparison;
}

/// One of everything.
inline Comparison sample_comparison() {
    Comparison comparison;
    comparison.cells = {
        compared("pom | view_angle=60", Verdict::same, 1.0004, {0.99, 1.01}),
        compared("steep | view_angle=60", Verdict::slower, 1.072, {1.051, 1.094}),
        compared("qdm | view_angle=60", Verdict::undecided, 1.03, {0.96, 1.11}),
        compared("relief | view_angle=60", Verdict::faster, 0.8, {0.75, 0.85}),
        compared("steep | view_angle=0", Verdict::slower, 2.5, {2.25, 2.75}),
    };
    comparison.cells[2].time.more = 9;
    comparison.cells[2].reason =
        describe(comparison.cells[2].time, Verdict::undecided, "runs") + "; measured in 4 of 5 base runs only";
    comparison.cells[0].quality = {QualityVerdict::worse,
                                   {{"error.uv_texels.p99", 0.75, 0.8100001, true, false},
                                    {"image.psnr", std::nullopt, 40, false, false},
                                    {"error.missed", 0.02, 0.01, false, true}}};
    comparison.cells[3].quality = {QualityVerdict::same, {{"work.taps_mean", 17.5, 34, false, false}}};
    comparison.uncompared = {{"flat | view_angle=60", "only in the base", false},
                             {"mine | view_angle=60", "ok in the base, failed now: trace.glsl:3: error", true},
                             {"flat | view_angle=0", "only in the base", false}};
    comparison.notices = {"the driver changed: Mesa 22.3.6, now Mesa 23.0.0"};
    comparison.environment = {{"noise", "default"}};
    return comparison;
}

}  // namespace reliefbench
