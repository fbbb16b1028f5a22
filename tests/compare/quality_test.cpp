#include "compare/quality.hpp"

#include "support/cell_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

using namespace reliefbench;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

CellResult result() {
    CellResult result;
    for (const char* path : {"error.uv_texels", "error.normal_deg"})
        set_summary(result, path, {0.2, 0.2, 0.05, 0.5, 0.8, 3});
    set_summary(result, "error.depth", {-0.001, 0.002, 0.0005, 0.005, 0.01, 0.03});
    set_figures(result, {{"error.compared", 65000},
                         {"error.missed", 0.01},
                         {"error.false_hits", 0.02},
                         {"error.outside_quad.pixels", 12},
                         {"error.outside_quad.covered", 0.5},
                         {"error.coverage_iou", 0.98},
                         {"error.shadow.mean", 0.02},
                         {"error.shadow.false_shadow", 0.01},
                         {"error.shadow.missed_shadow", 0.015},
                         {"error.shadow.compared", 64000},
                         {"error.shadow.truth_standard_error", 0.001},
                         {"error.wrong_surface", 0.003}});
    set_figures(result, {{"image.flip", 0.3},
                         {"image.psnr", 30},
                         {"image.ssim", 0.9},
                         {"image.rmse", 0.03},
                         {"image.footprint.flip", 0.1},
                         {"image.footprint.psnr", 35},
                         {"image.footprint.ssim", 0.95},
                         {"image.footprint.rmse", 0.02}});
    set_figures(result, {{"motion.texels.mean", 0.5},
                         {"motion.texels.p95", 2},
                         {"motion.texels.max", 8},
                         {"motion.flip.mean", 0.1},
                         {"motion.flip.p95", 0.2},
                         {"motion.flip.max", 0.3},
                         {"motion.compared", 500000},
                         {"motion.hit_once", 12},
                         {"motion.unseen", 700}});
    set_group(result, "work", 0);
    set_figures(
        result,
        {{"work.taps_mean", 17.5}, {"work.steps_mean", 16}, {"work.unconverged", 0.1}, {"work.covered_pixels", 65536}});
    remove_figures(result, "work.shadow_taps_mean");
    remove_figures(result, "work.shadow_taps_p95");
    result.prepare_bytes = 1000;
    return result;
}

/// Of version 0.1.0, which had none.
CellResult without_footprint(CellResult cell) {
    remove_figures(cell, "image.footprint");
    return cell;
}

QualityComparison compare(const CellResult& base, const CellResult& changed) {
    return compare_quality(base, changed, default_deciding_figures());
}

using Change = std::function<void(CellResult&)>;

CellResult changed_by(const Change& change) {
    CellResult changed = result();
    change(changed);
    return changed;
}

QualityComparison quality_of(const Change& change) {
    return compare(result(), changed_by(change));
}

std::vector<std::string> fields_of(const QualityComparison& comparison) {
    std::vector<std::string> fields;
    for (const QualityChange& change : comparison.changes) {
        fields.push_back(change.field);
    }
    return fields;
}

/// The change is judged so, and the other way round the opposite.
void expect_verdict(const Change& change, QualityVerdict verdict) {
    using enum QualityVerdict;
    const QualityVerdict opposite = verdict == worse ? better : verdict == better ? worse : verdict;
    EXPECT_EQ(compare(result(), changed_by(change)).verdict, verdict);
    EXPECT_EQ(compare(changed_by(change), result()).verdict, opposite) << "the other way round";
}

TEST(Quality, EqualResultsAreTheSame) {
    const QualityComparison comparison = compare(result(), result());
    EXPECT_EQ(comparison.verdict, QualityVerdict::same);
    EXPECT_THAT(comparison.changes, IsEmpty());
    EXPECT_THAT(compare({}, {}).changes, IsEmpty());
}

TEST(Quality, ADecidingFigureDecidesByItsDirectionBeyondItsTolerances) {
    using enum QualityVerdict;
    const auto p99 = [](double value) {
        return [value](CellResult& r) { set_figure(r, "error.uv_texels.p99", value); };
    };
    expect_verdict(p99(0.9), worse);
    expect_verdict(p99(0.08), better);
    expect_verdict(p99(0.845), same);
    expect_verdict([](CellResult& r) { set_figure(r, "error.uv_texels.mean", 0.3); }, worse);
    expect_verdict([](CellResult& r) { set_figure(r, "error.uv_texels.mean", 0.24); }, same);
    expect_verdict([](CellResult& r) { set_figure(r, "error.missed", 0.0115); }, worse);
    expect_verdict([](CellResult& r) { set_figure(r, "error.false_hits", 0); }, better);
    expect_verdict([](CellResult& r) { set_figure(r, "error.missed", 0.0109); }, same);
    expect_verdict([](CellResult& r) { set_figure(r, "image.footprint.flip", 0.103); }, worse);
    expect_verdict([](CellResult& r) { set_figure(r, "image.footprint.flip", 0.05); }, better);
    expect_verdict([](CellResult& r) { set_figure(r, "image.footprint.flip", 0.1015); }, same);
    expect_verdict([](CellResult& r) { set_figure(r, "error.shadow.mean", 0.03); }, worse);
    expect_verdict([](CellResult& r) { set_figure(r, "error.shadow.mean", 0.024); }, same);
    expect_verdict([](CellResult& r) { set_figure(r, "motion.texels.mean", 0.6); }, worse);
    expect_verdict([](CellResult& r) { set_figure(r, "motion.texels.mean", 0.52); }, same);
    expect_verdict([](CellResult& r) { set_figure(r, "motion.flip.mean", 0.05); }, better);
    expect_verdict([](CellResult& r) { set_figure(r, "motion.flip.mean", 0.104); }, same);
}

TEST(Quality, ToleranceOfALargeErrorIsAShareOfIt) {
    CellResult base = result();
    set_figure(base, "error.uv_texels.p99", 8);
    CellResult changed = base;
    set_figure(changed, "error.uv_texels.p99", 8.3);
    EXPECT_EQ(compare(base, changed).verdict, QualityVerdict::same);
    set_figure(changed, "error.uv_texels.p99", 8.6);
    EXPECT_EQ(compare(base, changed).verdict, QualityVerdict::worse);
}

TEST(Quality, AnErrorThatIsNoneOnOneSideCountsInItsUnit) {
    CellResult exact = result();
    set_figure(exact, "error.uv_texels.p99", 0);
    CellResult changed = exact;
    set_figure(changed, "error.uv_texels.p99", 0.04);
    EXPECT_EQ(compare(exact, changed).verdict, QualityVerdict::same);
    set_figure(changed, "error.uv_texels.p99", 0.06);
    EXPECT_EQ(compare(exact, changed).verdict, QualityVerdict::worse);
    EXPECT_EQ(compare(changed, exact).verdict, QualityVerdict::better);
}

TEST(Quality, MissedAndFalseHitsCountTogether) {
    expect_verdict(
        [](CellResult& r) {
            set_figure(r, "error.missed", 0.015);
            set_figure(r, "error.false_hits", 0.015);
        },
        QualityVerdict::same);
    expect_verdict(
        [](CellResult& r) {
            set_figure(r, "error.missed", *value_of("error.missed", r) + 0.0006);
            set_figure(r, "error.false_hits", *value_of("error.false_hits", r) + 0.0006);
        },
        QualityVerdict::worse);
}

// Linear refinement put back: the error falls to a tenth, while one pixel's normal is further off than any before.
TEST(Quality, WhatDoesNotDecideNeverMakesABetterPictureWorse) {
    const QualityComparison comparison = quality_of([](CellResult& r) {
        set_figure(r, "error.uv_texels.p99", 0.08);
        set_figure(r, "error.normal_deg.max", 60);
        set_figure(r, "error.depth.mean", -0.002);
        set_figure(r, "error.coverage_iou", 0.9);
        set_figure(r, "image.flip", 0.4);
        set_figure(r, "image.ssim", 0.5);
        set_figure(r, "work.unconverged", 0.5);
        set_figure(r, "work.taps_mean", 30);
        set_figure(r, "motion.hit_once", 20);
    });
    EXPECT_EQ(comparison.verdict, QualityVerdict::better);
    EXPECT_EQ(comparison.changes[0].field, "error.uv_texels.p99");
    for (std::size_t change = 1; change < comparison.changes.size(); ++change) {
        EXPECT_FALSE(comparison.changes[change].decides) << comparison.changes[change].field;
    }
    EXPECT_EQ(comparison.changes.size(), 9U);
}

TEST(Quality, WhatInformsHasItsDirectionToo) {
    const QualityComparison comparison = quality_of([](CellResult& r) {
        set_figure(r, "image.ssim", 0.8);
        set_figure(r, "error.normal_deg.max", 2);
        set_figure(r, "error.depth.mean", -0.002);
        set_figure(r, "error.compared", 64000);
    });
    EXPECT_EQ(comparison.verdict, QualityVerdict::same);
    ASSERT_THAT(fields_of(comparison),
                ElementsAre("image.ssim", "error.depth.mean", "error.normal_deg.max", "error.compared"));
    EXPECT_TRUE(comparison.changes[0].worse && !comparison.changes[0].better);
    EXPECT_FALSE(comparison.changes[1].worse || comparison.changes[1].better) << "the mean depth error is signed";
    EXPECT_TRUE(comparison.changes[2].better);
    EXPECT_FALSE(comparison.changes[3].worse || comparison.changes[3].better);
}

TEST(Quality, TimesAreNoQuality) {
    EXPECT_THAT(quality_of([](CellResult& r) {
                    r.time["draw"].median_ms = 5;
                    r.prepare_ms = 7;
                }).changes,
                IsEmpty());
}

TEST(Quality, SomeFiguresBetterAndOthersWorseIsMixed) {
    expect_verdict(
        [](CellResult& r) {
            set_figure(r, "error.uv_texels.p99", 0.1);
            set_figure(r, "error.missed", 0.02);
        },
        QualityVerdict::mixed);
    // A loss within the tolerance takes nothing from a gain beyond it.
    expect_verdict(
        [](CellResult& r) {
            set_figure(r, "error.uv_texels.p99", 0.1);
            set_figure(r, "error.missed", 0.0105);
        },
        QualityVerdict::better);
}

TEST(Quality, WhatMattersMostComesFirst) {
    const QualityComparison comparison = quality_of([](CellResult& r) {
        set_figure(r, "error.normal_deg.max", 90);    // 174 tolerances, and informs
        set_figure(r, "error.uv_texels.mean", 0.22);  // deciding, within its tolerance
        set_figure(r, "error.uv_texels.p99", 0.9);    // 2 tolerances
        set_figure(r, "image.footprint.flip", 0.05);  // 25 tolerances
        remove_figures(r, "motion.flip");             // deciding, and unknown of one side
        set_figure(r, "image.rmse", 0.031);           // informs, half a tolerance
    });
    EXPECT_THAT(fields_of(comparison),
                ElementsAre("image.footprint.flip", "error.uv_texels.p99", "motion.flip.mean", "error.uv_texels.mean",
                            "error.normal_deg.max", "image.rmse", "motion.flip.p95", "motion.flip.max"));
    EXPECT_NEAR(comparison.changes[0].size(), 25, 1e-9);
    EXPECT_NEAR(comparison.changes[1].size(), 2, 1e-9);
    EXPECT_EQ(comparison.verdict, QualityVerdict::mixed);
}

TEST(Quality, AFigureThatOneSideLacksDecidesNothingAndIsNamed) {
    const QualityComparison comparison = quality_of([](CellResult& r) { remove_figures(r, "motion.texels"); });
    EXPECT_EQ(comparison.verdict, QualityVerdict::same);
    ASSERT_FALSE(comparison.changes.empty());
    EXPECT_EQ(comparison.changes[0].field, "motion.texels.mean");
    EXPECT_EQ(comparison.changes[0].base, 0.5);
    EXPECT_EQ(comparison.changes[0].changed, std::nullopt);
    EXPECT_FALSE(comparison.changes[0].worse || comparison.changes[0].better || comparison.changes[0].decides);
}

TEST(Quality, WhereOneSideHasNothingToCompareThatSideIsWorse) {
    const auto hits_nothing = [](CellResult& r) {
        set_figure(r, "error.compared", 0);
        for (const char* group : {"error.uv_texels", "error.depth", "error.normal_deg"})
            remove_figures(r, group);
    };
    expect_verdict(hits_nothing, QualityVerdict::worse);
    EXPECT_EQ(quality_of(hits_nothing).changes[0].field, "error.compared");
    // A mean over no light is none, and not the best one.
    expect_verdict(
        [](CellResult& r) {
            set_group(r, "error.shadow", 0);
            set_figure(r, "error.shadow.truth_standard_error", 0.001);
        },
        QualityVerdict::worse);
    const CellResult none = changed_by(hits_nothing);
    EXPECT_EQ(compare(none, none).verdict, QualityVerdict::same) << "missed and false hits are compared";
}

TEST(Quality, FlipOverTheWholePictureStandsInWhereASideHasNoneOverTheFootprint) {
    CellResult changed = result();
    set_figure(changed, "image.flip", 0.2);
    set_figure(changed, "image.footprint.flip", 0.5);
    for (const CellResult& base : {without_footprint(result()), result()}) {
        const QualityComparison comparison = compare(base, without_footprint(changed));
        EXPECT_EQ(comparison.verdict, QualityVerdict::better);
        EXPECT_EQ(comparison.changes[0].field, "image.flip");
        EXPECT_EQ(comparison.changes[0].in_place_of, "image.footprint.flip");
        ASSERT_EQ(comparison.stand_ins.size(), 1U);
        EXPECT_EQ(comparison.stand_ins[0].figure, "image.footprint.flip");
        EXPECT_EQ(comparison.stand_ins[0].decided, "image.flip");
    }
    EXPECT_THAT(compare(result(), changed).stand_ins, IsEmpty());
    EXPECT_EQ(compare(result(), changed).verdict, QualityVerdict::worse);
}

TEST(Quality, WithoutADecidingFigureOfBothSidesThereIsNoVerdict) {
    CellResult base;
    set_group(base, "work", 0);
    CellResult changed = base;
    set_figure(changed, "work.taps_mean", 5);
    EXPECT_EQ(compare(base, changed).verdict, QualityVerdict::not_comparable);
    EXPECT_EQ(compare(base, result()).verdict, QualityVerdict::not_comparable);
}

TEST(Quality, RoundingIsNoChange) {
    EXPECT_THAT(quality_of([](CellResult& r) { set_figure(r, "error.uv_texels.max", 3.0002); }).changes, IsEmpty());
    EXPECT_EQ(quality_of([](CellResult& r) { set_figure(r, "error.uv_texels.max", 3.0004); }).changes.size(), 1U);
    EXPECT_THAT(quality_of([](CellResult& r) {
                    set_figure(r, "error.uv_texels.p50", *value_of("error.uv_texels.p50", r) + 0.9e-6);
                }).changes,
                IsEmpty());
}

TEST(Quality, OtherFiguresDecideWhereTheyAreChosen) {
    const std::vector<DecidingFigure> chosen = {deciding_figure({find_figure("image.psnr")}),
                                                deciding_figure({find_figure("work.taps_mean")})};
    CellResult changed = result();
    set_figure(changed, "error.uv_texels.p99", 5);
    EXPECT_EQ(compare_quality(result(), changed, chosen).verdict, QualityVerdict::same);
    set_figure(changed, "work.taps_mean", 18);
    EXPECT_EQ(compare_quality(result(), changed, chosen).verdict, QualityVerdict::worse);
    set_figure(changed, "image.psnr", 31);
    EXPECT_EQ(compare_quality(result(), changed, chosen).verdict, QualityVerdict::mixed);
}

TEST(Quality, AnImageWithoutAnErrorHasTheBestPsnr) {
    const std::vector<DecidingFigure> psnr = {deciding_figure({find_figure("image.psnr")})};
    CellResult perfect = result();
    remove_figures(perfect, "image.psnr");
    set_figure(perfect, "image.rmse", 0);
    const QualityComparison lost = compare_quality(perfect, result(), psnr);
    EXPECT_EQ(lost.verdict, QualityVerdict::worse);
    EXPECT_EQ(lost.changes[0].base, std::numeric_limits<double>::infinity());
    EXPECT_EQ(lost.changes[0].changed, 30);
    EXPECT_EQ(compare_quality(result(), perfect, psnr).verdict, QualityVerdict::better);
    EXPECT_THAT(compare_quality(perfect, perfect, psnr).changes, IsEmpty());
}

TEST(DecidingFigures, EveryFigureWithADirectionHasATolerance) {
    for (const FigureDeclaration& figure : figures()) {
        const FigureTolerance tolerance = tolerance_of(figure);
        EXPECT_TRUE(tolerance.absolute > 0 || tolerance.relative > 0) << figure.path;
    }
}

}  // namespace
