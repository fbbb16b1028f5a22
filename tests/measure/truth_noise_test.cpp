#include "metrics/truth_noise.hpp"

#include "metrics/image_errors.hpp"
#include "reference/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace reliefbench {
namespace {

Truth truth_of(const char* name, double azimuth, int samples) {
    HeightMapSource source;
    source.name = name;
    source.size = {256, 256};
    const HeightMap map = load_height_map(source, HeightFormat::r16);
    View view{.camera = {.view_angle = 60, .azimuth = azimuth}, .relief = {}, .resolution = {96, 64}};
    view.self_shadow.mode = SelfShadow::Mode::hard;
    return trace_exact_truth(map, load_albedo({}, map), view, {}, {.samples = samples});
}

TruthNoise noise_of(const Truth& truth) {
    return truth_noise(*truth.standard_error, *truth.half_picture, truth.colour, {truth.footprint, truth.background});
}

TEST(TruthNoise, ItsFlipIsThatAgainstManyMoreSamples) {
    for (const char* name : {"rock", "bricks"}) {
        const Truth many = truth_of(name, 17, 1024);
        for (const int samples : {4, 16, 64}) {
            const Truth few = truth_of(name, 17, samples);
            const double flip =
                compare_images(few.colour, few.hits, many.colour, many.hits, {many.footprint, many.background})
                    .footprint.flip.value();
            EXPECT_NEAR(noise_of(few).flip.value() / flip, 1, 0.25) << name << " " << samples;
        }
    }
}

TEST(TruthNoise, IsOverTheFootprint) {
    const Truth truth = truth_of("bricks", -90, 16);
    const TruthNoise noise = noise_of(truth);
    double sum = 0;
    double squares = 0;
    std::size_t pixels = 0;
    float largest = 0;
    for (std::size_t pixel = 0; pixel < truth.footprint.texels.size(); ++pixel) {
        if (truth.footprint.texels[pixel] == 0) continue;
        const float error = truth.standard_error->texels[pixel];
        sum += error;
        squares += static_cast<double>(error) * error;
        largest = std::max(largest, error);
        ++pixels;
    }
    ASSERT_LT(pixels, truth.footprint.texels.size());
    EXPECT_NEAR(noise.mean.value(), sum / static_cast<double>(pixels), 1e-12);
    EXPECT_NEAR(noise.rms.value(), std::sqrt(squares / static_cast<double>(pixels)), 1e-12);
    EXPECT_GT(noise.rms.value(), noise.mean.value());
    EXPECT_GT(noise.p99.value(), noise.rms.value());
    EXPECT_LE(noise.p99.value(), largest);
}

TEST(TruthNoise, WithoutAFootprintThereIsNone) {
    const Image<std::array<float, 3>> picture({2, 2});
    const Image<std::uint8_t> nowhere({2, 2});
    const TruthNoise noise = truth_noise(Image<float>({2, 2}), picture, picture, {nowhere, {}});
    EXPECT_FALSE(noise.mean || noise.rms || noise.p99 || noise.flip);
}

}  // namespace
}  // namespace reliefbench
