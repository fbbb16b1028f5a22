#include "metrics/truth_noise.hpp"

#include "core/statistics.hpp"
#include "metrics/image_errors.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace reliefbench {

namespace {

FigureDeclaration of_noise(std::string path, std::string label, std::string unit) {
    return {.path = std::move(path),
            .label = std::move(label),
            .unit = std::move(unit),
            .needs = {std::string(figure_needs::truth), std::string(figure_needs::lighting)}};
}

const std::vector<FigureOf<TruthNoise>>& truth_noise_table() {
    static const std::vector<FigureOf<TruthNoise>> table = {
        {of_noise("image.truth_standard_error.mean", "Standard error of the truth's picture, mean", "linear"),
         [](const TruthNoise& noise) { return noise.mean; }},
        {of_noise("image.truth_standard_error.rms", "Standard error of the truth's picture, RMS", "linear"),
         [](const TruthNoise& noise) { return noise.rms; }},
        {at_percentile(
             99, of_noise("image.truth_standard_error.p99", "Standard error of the truth's picture, p99", "linear")),
         [](const TruthNoise& noise) { return noise.p99; }},
        {of_noise("image.footprint.truth_noise_flip", "FLIP of the truth's noise, footprint", ""),
         [](const TruthNoise& noise) { return noise.flip; }},
    };
    return table;
}

}  // namespace

TruthNoise truth_noise(const Image<float>& standard_error, const Image<std::array<float, 3>>& half_picture,
                       const Image<std::array<float, 3>>& picture, const Footprint& footprint) {
    const Image<float> flip = footprint_flip_map(half_picture, picture, footprint);
    std::vector<double> errors;
    double sum = 0;
    double squares = 0;
    double flip_sum = 0;
    for (std::size_t pixel = 0; pixel < footprint.inside.texels.size(); ++pixel) {
        if (footprint.inside.texels[pixel] == 0) continue;
        const double error = standard_error.texels[pixel];
        errors.push_back(error);
        sum += error;
        squares += error * error;
        flip_sum += flip.texels[pixel];
    }
    if (errors.empty()) return {};
    const auto count = static_cast<double>(errors.size());
    return {.mean = sum / count,
            .rms = std::sqrt(squares / count),
            .p99 = quantile(errors, 0.99),
            .flip = flip_sum / count};
}

std::vector<FigureDeclaration> truth_noise_figures() {
    return declarations_in(truth_noise_table());
}

FigureValueList figures_of(const TruthNoise& noise) {
    return values_in(truth_noise_table(), noise);
}

}  // namespace reliefbench
