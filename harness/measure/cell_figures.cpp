#include "measure/cell_figures.hpp"

#include "core/statistics.hpp"
#include "measure/outliers.hpp"
#include "measure/stopping_rule.hpp"

namespace reliefbench {

std::optional<WorkSummary> summarize_work(const Probe& probe, bool self_shadow) {
    return summarize_work(probe.covered, probe.work, probe.stages, self_shadow ? &probe.shadow_taps : nullptr);
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
