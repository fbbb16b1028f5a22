#include "compare/quality.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace reliefbench;

namespace {

CellResult result() {
    CellResult result;
    CellResult::Errors errors;
    errors.uv_texels = errors.normal_deg = Summary{0.1, 0.2, 0.05, 0.5, 0.8, 3};
    errors.depth = Summary{-0.001, 0.002, 0.0005, 0.005, 0.01, 0.03};
    errors.compared = 65000;
    errors.missed = 0.01;
    errors.false_hits = 0.02;
    errors.outside_quad_pixels = 12;
    errors.outside_quad_covered = 0.5;
    errors.coverage_iou = 0.98;
    errors.shadow = CellResult::ShadowErrors{0.02, 0.01, 0.015, 64000, 0.001};
    errors.wrong_surface = 0.003;
    result.error = errors;
    result.image = {0.1, 30, 0.9, 0.03};
    result.motion = CellResult::Motion{CellResult::MotionFigure{0.5, 2, 8}, CellResult::MotionFigure{0.1, 0.2, 0.3},
                                       500000, 12, 700};
    CellResult::Work work;
    work.taps_mean = 17.5;
    work.steps_mean = 16;
    work.unconverged = 0.1;
    work.covered_pixels = 65536;
    result.work = work;
    result.prepare_bytes = 1000;
    return result;
}

QualityComparison changed_by(const std::function<void(CellResult&)>& change) {
    CellResult changed = result();
    change(changed);
    return compare_quality(result(), changed, {});
}

/// The one field that a change touches, and how it is judged.
void expect_one(const std::function<void(CellResult&)>& change, const std::string& field, QualityVerdict verdict) {
    const QualityComparison comparison = changed_by(change);
    ASSERT_EQ(comparison.changes.size(), 1U) << field;
    EXPECT_EQ(comparison.changes[0].field, field);
    EXPECT_EQ(comparison.verdict, verdict) << field;
    EXPECT_EQ(comparison.changes[0].worse, verdict == QualityVerdict::worse) << field;
    EXPECT_EQ(comparison.changes[0].better, verdict == QualityVerdict::better) << field;
}

TEST(Quality, EqualResultsAreTheSame) {
    const QualityComparison comparison = compare_quality(result(), result(), {});
    EXPECT_EQ(comparison.verdict, QualityVerdict::same);
    EXPECT_TRUE(comparison.changes.empty());
    EXPECT_TRUE(compare_quality({}, {}, {}).changes.empty());
}

TEST(Quality, EachFieldHasItsDirection) {
    using enum QualityVerdict;
    expect_one([](CellResult& r) { r.error->uv_texels->p99 = 0.9; }, "error.uv_texels.p99", worse);
    expect_one([](CellResult& r) { r.error->uv_texels->mean = 0.05; }, "error.uv_texels.mean", better);
    expect_one([](CellResult& r) { r.error->normal_deg->max = 4; }, "error.normal_deg.max", worse);
    expect_one([](CellResult& r) { r.error->depth->rms = 0.001; }, "error.depth.rms", better);
    expect_one([](CellResult& r) { r.motion->texels->mean = 0.6; }, "motion.texels.mean", worse);
    expect_one([](CellResult& r) { r.motion->flip->p95 = 0.1; }, "motion.flip.p95", better);
    expect_one([](CellResult& r) { r.motion->hit_once = 13; }, "motion.hit_once", worse);
    expect_one([](CellResult& r) { r.motion->unseen = 701; }, "motion.unseen", same);
    expect_one([](CellResult& r) { r.error->missed = 0.02; }, "error.missed", worse);
    expect_one([](CellResult& r) { r.error->false_hits = 0; }, "error.false_hits", better);
    expect_one([](CellResult& r) { r.error->coverage_iou = 0.97; }, "error.coverage_iou", worse);
    expect_one([](CellResult& r) { r.error->outside_quad_covered = 0.6; }, "error.outside_quad.covered", better);
    expect_one([](CellResult& r) { r.error->compared = 64000; }, "error.compared", same);
    expect_one([](CellResult& r) { r.error->outside_quad_pixels = 13; }, "error.outside_quad.pixels", same);
    expect_one([](CellResult& r) { r.error->wrong_surface = 0; }, "error.wrong_surface", better);
    expect_one([](CellResult& r) { r.error->shadow->mean = 0.03; }, "error.shadow.mean", worse);
    expect_one([](CellResult& r) { r.error->shadow->false_shadow = 0; }, "error.shadow.false_shadow", better);
    expect_one([](CellResult& r) { r.error->shadow->missed_shadow = 0.02; }, "error.shadow.missed_shadow", worse);
    expect_one([](CellResult& r) { r.work->shadow_taps_mean = 9; }, "work.shadow_taps_mean", same);
    expect_one([](CellResult& r) { r.image->psnr = 31; }, "image.psnr", better);
    expect_one([](CellResult& r) { r.image->ssim = 0.8; }, "image.ssim", worse);
    expect_one([](CellResult& r) { r.image->flip = 0.2; }, "image.flip", worse);
    expect_one([](CellResult& r) { r.image->rmse = 0.02; }, "image.rmse", better);
    expect_one([](CellResult& r) { r.work->unconverged = 0.2; }, "work.unconverged", worse);
    expect_one([](CellResult& r) { r.work->taps_mean = 30; }, "work.taps_mean", same);
    expect_one([](CellResult& r) { r.work->steps_mean = 8; }, "work.steps_mean", same);
    expect_one([](CellResult& r) { r.prepare_bytes = 2000; }, "prepare.bytes", same);
}

TEST(Quality, OfTheSignedMeanDepthTheMagnitudeDecides) {
    using enum QualityVerdict;
    expect_one([](CellResult& r) { r.error->depth->mean = -0.002; }, "error.depth.mean", worse);
    expect_one([](CellResult& r) { r.error->depth->mean = 0.0005; }, "error.depth.mean", better);
    // As far off, on the other side of the surface: told, and neither.
    expect_one([](CellResult& r) { r.error->depth->mean = 0.001; }, "error.depth.mean", same);
}

TEST(Quality, WorseOutweighsBetter) {
    const QualityComparison comparison = changed_by([](CellResult& changed) {
        changed.error->missed = 0.02;
        changed.image->rmse = 0.01;
    });
    EXPECT_EQ(comparison.changes.size(), 2U);
    EXPECT_EQ(comparison.verdict, QualityVerdict::worse);
}

TEST(Quality, ChangesWithinTheToleranceAreNotTold) {
    EXPECT_TRUE(changed_by([](CellResult& r) { r.error->uv_texels->max = 3.0002; }).changes.empty());
    EXPECT_EQ(changed_by([](CellResult& r) { r.error->uv_texels->max = 3.0004; }).changes.size(), 1U);
    EXPECT_TRUE(changed_by([](CellResult& r) { r.error->uv_texels->p50 += 0.9e-6; }).changes.empty());
    CellResult tiny = result();
    tiny.error->missed = 0;
    CellResult other = tiny;
    other.error->missed = 0.9e-6;
    EXPECT_TRUE(compare_quality(tiny, other, {}).changes.empty());
    EXPECT_EQ(compare_quality(tiny, other, {1e-4, 0}).changes.size(), 1U);
}

TEST(Quality, AnImageWithoutAnErrorIsTheBest) {
    CellResult perfect = result();
    perfect.image->psnr = std::nullopt;
    perfect.image->rmse = 0;
    const QualityComparison lost = compare_quality(perfect, result(), {});
    EXPECT_EQ(lost.verdict, QualityVerdict::worse);
    ASSERT_EQ(lost.changes.size(), 2U);
    EXPECT_EQ(lost.changes[0].field, "image.psnr");
    EXPECT_EQ(lost.changes[0].base, std::nullopt);
    EXPECT_EQ(lost.changes[0].changed, 30);
    EXPECT_TRUE(lost.changes[0].worse);
    EXPECT_EQ(compare_quality(result(), perfect, {}).verdict, QualityVerdict::better);
    EXPECT_TRUE(compare_quality(perfect, perfect, {}).changes.empty());
}

TEST(Quality, AFieldThatOneSideLacksIsToldAndNeither) {
    expect_one([](CellResult& r) { r.image->flip = std::nullopt; }, "image.flip", QualityVerdict::same);
    const QualityComparison comparison = changed_by([](CellResult& r) { r.error->uv_texels = std::nullopt; });
    EXPECT_EQ(comparison.changes.size(), 6U);
    EXPECT_EQ(comparison.verdict, QualityVerdict::same);
    EXPECT_EQ(comparison.changes[0].base, 0.1);
    EXPECT_EQ(comparison.changes[0].changed, std::nullopt);
}

}  // namespace
