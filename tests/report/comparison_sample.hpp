#pragma once

#include "compare/comparison.hpp"
#include "compare/describe.hpp"

#include <optional>
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

/// As compare_quality makes it; of a sum the unit is that of its first term.
inline QualityChange quality_change(std::string field, std::optional<double> base, std::optional<double> changed,
                                    bool decides = false) {
    const FigureDeclaration& figure = *find_figure(field.substr(0, field.find('+')));
    QualityChange change;
    change.field = std::move(field);
    change.base = base;
    change.changed = changed;
    change.worse = base && changed && is_better(*base, *changed, figure.better);
    change.better = base && changed && is_better(*changed, *base, figure.better);
    change.decides = change.is_deciding = decides;
    change.unit = figure.unit;
    change.tolerance = tolerance_of(figure);
    return change;
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
    comparison.cells[0].quality = {
        QualityVerdict::worse,
        {quality_change("error.uv_texels.p99", 0.75, 0.8100001, true), quality_change("error.missed", 0.02, 0.01),
         quality_change("image.psnr", std::nullopt, 40)}};
    comparison.cells[1].quality = {QualityVerdict::mixed,
                                   {quality_change("error.uv_texels.p99", 0.8, 0.08, true),
                                    quality_change("error.missed+error.false_hits", 0.002, 0.005, true)}};
    comparison.cells[3].quality = {QualityVerdict::same, {quality_change("work.taps_mean", 17.5, 34)}};
    comparison.cells[4].quality = {QualityVerdict::same, {quality_change("image.rmse", 0.02, 0.0201)}};
    comparison.uncompared = {{"flat | view_angle=60", "only in the base", false},
                             {"mine | view_angle=60", "ok in the base, failed now: trace.glsl:3: error", true},
                             {"flat | view_angle=0", "only in the base", false}};
    comparison.notices = {"the driver changed: Mesa 22.3.6, now Mesa 23.0.0"};
    comparison.environment = {{"noise", "default"}};
    return comparison;
}

}  // namespace reliefbench
