#include "measure/cell_figures.hpp"

#include "core/statistics.hpp"
#include "measure/outliers.hpp"
#include "measure/stopping_rule.hpp"
#include "metrics/hit_errors.hpp"
#include "metrics/image_errors.hpp"
#include "metrics/outline_errors.hpp"
#include "metrics/raster_mismatch.hpp"
#include "metrics/shadow_errors.hpp"
#include "metrics/truth_noise.hpp"
#include "metrics/wrong_surface.hpp"

#include <iterator>
#include <utility>

namespace reliefbench {

std::optional<WorkSummary> summarize_work(const Probe& probe, bool self_shadow) {
    return summarize_work(probe.covered, probe.work, probe.stages, self_shadow ? &probe.shadow_taps : nullptr);
}

FigureValueList errors_of(const DrawnCell& drawn, const Lighting& lighting, bool self_shadow) {
    const Probe& probe = drawn.probe;
    const Truth& truth = drawn.truth;
    const ComparedHits hits = compared_hits(drawn);
    FigureValueList all = figures_of(compare_hits(hits));
    const auto add = [&all](FigureValueList family) {
        std::move(family.begin(), family.end(), std::back_inserter(all));
    };
    add(figures_of(compare_outlines(hits)));
    // A polygon within a relief that ends at its border shows pixels that are not of the footprint (is_in_footprint).
    const Relief& relief = drawn.relief;
    const bool shows_footprint = relief.polygon_height == 1 || relief.boundary == Boundary::repeat;
    if (drawn.draws_base && shows_footprint)
        add(figures_of_raster_mismatch(raster_mismatch(probe.covered, truth.footprint)));
    if (truth.front) add(figures_of_wrong_surface(wrong_surface(*probe.front, *truth.front, truth.footprint)));
    if (self_shadow) {
        ShadowErrors shadow = compare_shadows(probe.light_visibility, truth.light_visibility.fractions, hits, lighting);
        shadow.truth_standard_error = truth.light_visibility.standard_error;
        add(figures_of(shadow));
    }
    add(figures_of(
        compare_images(probe.colour, probe.hits, truth.colour, truth.hits, {truth.footprint, truth.background})));
    if (drawn.truth_noise) add(figures_of(*drawn.truth_noise));
    return all;
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
