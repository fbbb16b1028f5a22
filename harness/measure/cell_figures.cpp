#include "measure/cell_figures.hpp"

#include "core/statistics.hpp"
#include "measure/outliers.hpp"
#include "measure/stopping_rule.hpp"

#include <algorithm>

namespace reliefbench {

std::optional<CellResult::Work> summarize_work(const Probe& probe) {
    std::vector<double> taps;
    std::vector<double> texels;
    std::vector<double> steps;
    std::size_t unconverged = 0;
    for (std::size_t pixel = 0; pixel < probe.covered.texels.size(); ++pixel) {
        if (probe.covered.texels[pixel] == 0) {
            continue;
        }
        const PixelWork& work = probe.work.texels[pixel];
        taps.push_back(work.taps);
        texels.push_back(work.texels);
        steps.push_back(work.steps);
        unconverged += work.unconverged > 0 ? 1 : 0;
    }
    if (taps.empty()) {
        return std::nullopt;
    }
    const auto covered = static_cast<double>(taps.size());
    const double stage_taps = probe.stages.taps / covered;
    const double stage_texels = probe.stages.texels / covered;
    const Summary tap_summary = summarize(taps);
    const Summary step_summary = summarize(steps);
    CellResult::Work work;
    work.taps_mean = tap_summary.mean + stage_taps;
    work.taps_p95 = tap_summary.p95 + stage_taps;
    work.texels_mean = summarize(texels).mean + stage_texels;
    work.steps_mean = step_summary.mean;
    work.steps_p95 = step_summary.p95;
    work.unconverged = static_cast<double>(unconverged) / covered;
    work.covered_pixels = taps.size();
    return work;
}

void add_shadow_work(CellResult::Work& work, const Probe& probe) {
    std::vector<double> taps;
    for (std::size_t pixel = 0; pixel < probe.covered.texels.size(); ++pixel) {
        if (probe.covered.texels[pixel] != 0) taps.push_back(probe.shadow_taps.texels[pixel]);
    }
    if (taps.empty()) return;
    const Summary summary = summarize(taps);
    work.shadow_taps_mean = summary.mean;
    work.shadow_taps_p95 = summary.p95;
}

CellResult::ShadowErrors to_shadow_errors(const ShadowErrors& errors, const LightVisibility& truth) {
    CellResult::ShadowErrors fields;
    fields.mean = errors.mean;
    fields.false_shadow = errors.false_shadow;
    fields.missed_shadow = errors.missed_shadow;
    fields.compared = errors.compared;
    fields.truth_standard_error = truth.standard_error;
    return fields;
}

CellResult::Errors to_errors(const HitErrors& errors) {
    CellResult::Errors fields;
    fields.uv_texels = errors.uv_texels;
    fields.depth = errors.depth;
    fields.normal_deg = errors.normal_deg;
    fields.compared = errors.compared;
    fields.missed = errors.missed;
    fields.false_hits = errors.false_hits;
    fields.ties = errors.ties;
    fields.outside_quad_pixels = errors.outside_quad_pixels;
    fields.outside_quad_covered = errors.outside_quad_covered;
    fields.coverage_iou = errors.coverage_iou;
    return fields;
}

CellResult::ImageFields to_image_fields(const ImageComparison& comparison) {
    const auto& [whole, footprint] = comparison;
    return {whole.flip, whole.psnr, whole.ssim, whole.rmse,
            CellResult::FootprintFields{footprint.flip, footprint.psnr, footprint.ssim, footprint.rmse}};
}

PassTiming summarize_timing(const std::vector<std::vector<double>>& rounds, int repeats) {
    std::vector<double> samples;
    for (const std::vector<double>& round : rounds) {
        samples.insert(samples.end(), round.begin(), round.end());
    }
    const std::vector<double> medians = round_medians(rounds);
    PassTiming timing;
    timing.median_ms = median(medians);
    timing.mad_ms = median_absolute_deviation(samples);
    timing.ci95_ms = median_interval(medians);
    timing.lower_quartile_ms = quantile(samples, 0.25);
    timing.n = samples.size();
    timing.repeats = repeats;
    timing.rounds = rounds.size();
    timing.outliers = count_outliers(samples);
    return timing;
}

double preparation_ms(const Preparation& preparation) {
    double sum = 0;
    for (const auto& [pass, samples] : preparation.pass_ms) {
        sum += median(samples);
    }
    return sum;
}

}  // namespace reliefbench
