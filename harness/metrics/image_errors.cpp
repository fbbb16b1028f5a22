#include "metrics/image_errors.hpp"

#include "core/parallel.hpp"
#include "metrics/flip.hpp"
#include "metrics/ssim.hpp"
#include "scene/colour.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace reliefbench {

namespace {

using Colours = Image<std::array<float, 3>>;
constexpr std::size_t channels = 3;

/// Indices of the pixels that either covers.
std::vector<std::size_t> covered_by_either(const HitImage& first, const HitImage& second) {
    std::vector<std::size_t> pixels;
    for (std::size_t pixel = 0; pixel < first.texels.size(); ++pixel) {
        if (first.texels[pixel].is_hit() || second.texels[pixel].is_hit()) pixels.push_back(pixel);
    }
    return pixels;
}

/// Red, green and blue, encoded to sRGB.
using EncodedChannels = std::array<Image<double>, channels>;

EncodedChannels encoded_channels(const Colours& linear) {
    constexpr std::size_t pixels_at_once = 1 << 14;
    EncodedChannels encoded;
    encoded.fill(Image<double>(linear.size));
    parallel_for(linear.texels.size(), pixels_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
            for (std::size_t channel = 0; channel < channels; ++channel) {
                encoded[channel].texels[pixel] = srgb_encode(linear.texels[pixel][channel]);
            }
        }
    });
    return encoded;
}

/// The mean of the channels' maps.
Image<double> mean_ssim_map(const EncodedChannels& first, const EncodedChannels& second) {
    Image<double> mean(first.front().size);
    for (std::size_t channel = 0; channel < channels; ++channel) {
        const Image<double> map = ssim_map(first[channel], second[channel]);
        for (std::size_t pixel = 0; pixel < mean.texels.size(); ++pixel) {
            mean.texels[pixel] += map.texels[pixel] / channels;
        }
    }
    return mean;
}

template <typename Value>
double mean_over(const std::vector<std::size_t>& pixels, const Image<Value>& map) {
    double sum = 0;
    for (const std::size_t pixel : pixels) {
        sum += map.texels[pixel];
    }
    return sum / static_cast<double>(pixels.size());
}

}  // namespace

Image<float> colour_ssim_map(const Colours& first, const Colours& second) {
    const Image<double> map = mean_ssim_map(encoded_channels(first), encoded_channels(second));
    Image<float> rounded(map.size);
    std::transform(map.texels.begin(), map.texels.end(), rounded.texels.begin(),
                   [](double value) { return static_cast<float>(value); });
    return rounded;
}

ImageErrors compare_images(const Colours& technique, const HitImage& technique_hits, const Colours& truth,
                           const HitImage& truth_hits) {
    assert(technique.size == truth.size && technique_hits.size == truth.size && truth_hits.size == truth.size);
    const std::vector<std::size_t> pixels = covered_by_either(technique_hits, truth_hits);
    ImageErrors errors;
    if (pixels.empty()) {
        return errors;
    }
    double sum_of_squares = 0;
    const EncodedChannels first = encoded_channels(technique);
    const EncodedChannels second = encoded_channels(truth);
    for (std::size_t channel = 0; channel < channels; ++channel) {
        for (const std::size_t pixel : pixels) {
            const double difference = first[channel].texels[pixel] - second[channel].texels[pixel];
            sum_of_squares += difference * difference;
        }
    }
    errors.rmse = std::sqrt(sum_of_squares / static_cast<double>(channels * pixels.size()));
    if (*errors.rmse > 0) {
        errors.psnr = -20 * std::log10(*errors.rmse);
    }
    errors.ssim = mean_over(pixels, mean_ssim_map(first, second));
    errors.flip = mean_over(pixels, flip_map(technique, truth));
    return errors;
}

}  // namespace reliefbench
