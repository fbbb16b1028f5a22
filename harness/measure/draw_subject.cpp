#include "measure/draw_subject.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace reliefbench {

namespace {

/// Bounds one submission even where a draw is too short for the device's clock to see.
constexpr int most_repeats = 1000;
/// The clock of an idle device rises while draws are timed, so that a first guess at the repeats may fall short.
constexpr int most_guesses = 4;
/// What warming up lasts at least, all its draws together: a few short draws would leave the clock where it idles.
constexpr double least_warm_up_ms = 20;

}  // namespace

DrawSubject::DrawSubject(TimeDraw time_draw, const SamplingSettings& settings)
    : time_draw_(std::move(time_draw)), settings_(settings) {}

void DrawSubject::warm_up() {
    double warm_ms = draw_unrecorded(settings_.warm_up, 1);
    repeats_ = 1;
    double pass_ms = 0;
    for (int guess = 0; guess < most_guesses; ++guess) {
        pass_ms = draw_unrecorded(1, repeats_);
        warm_ms += pass_ms;
        if (pass_ms >= settings_.minimum_pass_ms || repeats_ == most_repeats) break;
        const double wanted = pass_ms > 0 ? std::ceil(settings_.minimum_pass_ms / (pass_ms / repeats_)) : most_repeats;
        repeats_ = static_cast<int>(std::clamp(wanted, repeats_ + 1.0, static_cast<double>(most_repeats)));
    }
    if (settings_.warm_up > 0 && pass_ms > 0 && warm_ms < least_warm_up_ms) {
        draw_unrecorded(static_cast<int>(std::ceil((least_warm_up_ms - warm_ms) / pass_ms)), repeats_);
    }
}

double DrawSubject::draw_unrecorded(int samples, int repeats) {
    if (samples == 0) return 0;
    const std::vector<double> draw_ms = time_draw_(samples, repeats);
    return repeats * std::accumulate(draw_ms.begin(), draw_ms.end(), 0.0);
}

std::map<std::string, std::vector<double>> DrawSubject::visit(int count) {
    return {{draw_pass, time_draw_(count, repeats_)}};
}

}  // namespace reliefbench
