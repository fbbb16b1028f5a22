#include "measure/draw_subject.hpp"

#include "core/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reliefbench {

namespace {

/// Bounds one submission even where a draw is too short for the device's clock to see.
constexpr int most_repeats = 1000;
/// The clock of an idle device rises while draws are timed, so that a first guess at the repeats may fall short.
constexpr int most_guesses = 4;

}  // namespace

DrawSubject::DrawSubject(TimeDraw time_draw, const SamplingSettings& settings)
    : time_draw_(std::move(time_draw)), settings_(settings) {}

void DrawSubject::warm_up() {
    if (settings_.warm_up > 0) {
        time_draw_(settings_.warm_up, 1);
    }
    repeats_ = 1;
    for (int guess = 0; guess < most_guesses && repeats_ < most_repeats; ++guess) {
        const double draw_ms = median(time_draw_(1, repeats_));
        if (draw_ms * repeats_ >= settings_.minimum_pass_ms) {
            return;
        }
        const double wanted = draw_ms > 0 ? std::ceil(settings_.minimum_pass_ms / draw_ms) : most_repeats;
        repeats_ = static_cast<int>(std::clamp(wanted, repeats_ + 1.0, static_cast<double>(most_repeats)));
    }
}

std::map<std::string, std::vector<double>> DrawSubject::visit(int count) {
    return {{draw_pass, time_draw_(count, repeats_)}};
}

}  // namespace reliefbench
