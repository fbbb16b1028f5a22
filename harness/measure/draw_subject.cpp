#include "measure/draw_subject.hpp"

#include "core/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

namespace reliefbench {

namespace {

/// Bounds one submission even where a draw is too short for the device's clock to see.
constexpr int max_repeats = 1000;
/// The clock of an idle device rises while draws are timed, so that a first guess at the repeats may fall short.
constexpr int max_guesses = 4;
/// A batch of warm-up draws lasts about so long, so that a clock that rises shows between one and the next.
constexpr double batch_ms = 10;
constexpr double max_samples_of_batch = 1000;
/// Warming up ends when the newest of so many batches is not faster than the oldest by more than noise. Slower ones are
/// noise or drift, which the rounds are for.
constexpr std::size_t batches_compared = 3;
/// At least what counts as faster, as a fraction: batches are short.
constexpr double min_noise = 0.05;
/// Ends it even if timings never settle.
constexpr double max_warm_up_ms = 1000;
constexpr std::size_t max_batches = 100;

struct Batch {
    double median_ms = 0;
    /// About a standard deviation.
    double noise_ms = 0;
};

Batch summarize_batch(const std::vector<double>& draw_ms) {
    constexpr double standard_deviations_per_mad = 1.4826;
    return {median(draw_ms), standard_deviations_per_mad * median_absolute_deviation(draw_ms)};
}

bool is_faster(const Batch& newest, const Batch& oldest) {
    const double noise_ms = std::max({min_noise * oldest.median_ms, oldest.noise_ms, newest.noise_ms});
    return oldest.median_ms - newest.median_ms > noise_ms;
}

/// Timed when it is submitted.
DrawTimer undivided(TimeDraw time_draw) {
    const auto timed = std::make_shared<std::vector<double>>();
    return {.submit = [time_draw = std::move(time_draw), timed](int samples,
                                                                int repeats) { *timed = time_draw(samples, repeats); },
            .collect = [timed] { return *timed; }};
}

}  // namespace

DrawTimer timer_of(Renderer& renderer) {
    return {.submit = [&renderer](int samples, int repeats) { renderer.submit_draw(samples, repeats); },
            .collect = [&renderer] { return renderer.collect_draw(); }};
}

DrawSubject::DrawSubject(DrawTimer timer, const SamplingSettings& settings)
    : timer_(std::move(timer)), settings_(settings) {}

DrawSubject::DrawSubject(TimeDraw time_draw, const SamplingSettings& settings)
    : DrawSubject(undivided(std::move(time_draw)), settings) {}

void DrawSubject::warm_up() {
    warm_up_ms_ = 0;
    if (settings_.warm_up > 0) draw_unrecorded(settings_.warm_up, 1);
    const double pass_ms = find_repeats();
    if (settings_.warm_up == 0) return;
    const double wanted = pass_ms > 0 ? std::ceil(batch_ms / pass_ms) : max_samples_of_batch;
    const int samples = static_cast<int>(std::clamp(wanted, 1.0, max_samples_of_batch));
    std::vector<Batch> batches;
    while (batches.size() < max_batches && warm_up_ms_ < max_warm_up_ms) {
        batches.push_back(summarize_batch(draw_unrecorded(samples, repeats_)));
        if (batches.size() < batches_compared) continue;
        if (!is_faster(batches.back(), batches[batches.size() - batches_compared])) return;
    }
}

/// Milliseconds of one timed pass with them.
double DrawSubject::find_repeats() {
    repeats_ = 1;
    double pass_ms = 0;
    for (int guess = 0; guess < max_guesses; ++guess) {
        pass_ms = repeats_ * draw_unrecorded(1, repeats_).front();
        if (pass_ms >= settings_.minimum_pass_ms || repeats_ == max_repeats) break;
        const double wanted = pass_ms > 0 ? std::ceil(settings_.minimum_pass_ms / (pass_ms / repeats_)) : max_repeats;
        repeats_ = static_cast<int>(std::clamp(wanted, repeats_ + 1.0, static_cast<double>(max_repeats)));
    }
    return pass_ms;
}

std::vector<double> DrawSubject::draw_unrecorded(int samples, int repeats) {
    timer_.submit(samples, repeats);
    std::vector<double> draw_ms = timer_.collect();
    warm_up_ms_ += repeats * std::accumulate(draw_ms.begin(), draw_ms.end(), 0.0);
    return draw_ms;
}

Subject::Samples DrawSubject::visit(int count) {
    submit(count);
    return collect();
}

void DrawSubject::submit(int count) {
    timer_.submit(count, repeats_);
}

Subject::Samples DrawSubject::collect() {
    return {{draw_pass, timer_.collect()}};
}

}  // namespace reliefbench
