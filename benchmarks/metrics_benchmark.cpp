// Image metrics of a pair of 1920×1080: wall time, and the processor time of all threads.
#include "metrics/flip.hpp"
#include "metrics/image_errors.hpp"
#include "metrics/ssim.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace reliefbench {
namespace {

constexpr Resolution size{1920, 1080};
using Colour = std::array<float, 3>;

/// Waves of several lengths; `shift` moves them a little.
Image<Colour> waves(float shift) {
    Image<Colour> image(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const auto column = static_cast<float>(x);
            const auto row = static_cast<float>(y);
            image.at(x, y) = {0.5F + 0.5F * std::sin(0.31F * column + shift),
                              0.5F + 0.5F * std::sin(0.17F * row + shift),
                              0.5F + 0.5F * std::sin(0.05F * (column + row) - shift)};
        }
    }
    return image;
}

Image<double> red_of(const Image<Colour>& image) {
    Image<double> channel(image.size);
    std::transform(image.texels.begin(), image.texels.end(), channel.texels.begin(),
                   [](const Colour& colour) { return static_cast<double>(colour[0]); });
    return channel;
}

void report(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(size.pixels()));
}

void flip(benchmark::State& state) {
    const Image<Colour> first = waves(0);
    const Image<Colour> second = waves(0.4F);
    for (auto _ : state) {
        benchmark::DoNotOptimize(flip_map(first, second).texels.data());
    }
    report(state);
}

void ssim_of_one_channel(benchmark::State& state) {
    const Image<double> first = red_of(waves(0));
    const Image<double> second = red_of(waves(0.4F));
    for (auto _ : state) {
        benchmark::DoNotOptimize(ssim_map(first, second).texels.data());
    }
    report(state);
}

void all_image_errors(benchmark::State& state) {
    const Image<Colour> first = waves(0);
    const Image<Colour> second = waves(0.4F);
    const HitImage hits(size, Hit{0.5F, 0.5F, 0.5F, 1.0F});
    const Image<std::uint8_t> everywhere(size, 1);
    for (auto _ : state) {
        benchmark::DoNotOptimize(compare_images(first, hits, second, hits, {everywhere, {}}));
    }
    report(state);
}

/// As a patch seen at 60°: a trapezium of a fifth of the picture, and beyond its far side relief that it does not have.
void image_errors_of_a_patch(benchmark::State& state) {
    constexpr Colour background{0.02F, 0.02F, 0.03F};
    Image<std::uint8_t> inside(size);
    HitImage technique_hits(size);
    HitImage truth_hits(size);
    for (int y = 260; y < 800; ++y) {
        const int half = 420 + (y - 260) / 2;
        for (int x = size.width / 2 - half; x < size.width / 2 + half; ++x) {
            truth_hits.at(x, y) = Hit{0.5F, 0.5F, 0.5F, 1.0F};
            if (y < 300) continue;
            technique_hits.at(x, y) = truth_hits.at(x, y);
            inside.at(x, y) = 1;
        }
    }
    Image<Colour> technique = waves(0);
    Image<Colour> truth = waves(0.4F);
    for (std::size_t pixel = 0; pixel < size.pixels(); ++pixel) {
        if (!technique_hits.texels[pixel].is_hit()) technique.texels[pixel] = background;
        if (!truth_hits.texels[pixel].is_hit()) truth.texels[pixel] = background;
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(compare_images(technique, technique_hits, truth, truth_hits, {inside, background}));
    }
    report(state);
}

double smallest(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

void add(const char* name, void (*function)(benchmark::State&)) {
    benchmark::RegisterBenchmark(name, function)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->ComputeStatistics("min", smallest);
}

}  // namespace
}  // namespace reliefbench

int main(int argc, char** argv) {
    reliefbench::add("flip", reliefbench::flip);
    reliefbench::add("ssim_of_one_channel", reliefbench::ssim_of_one_channel);
    reliefbench::add("all_image_errors", reliefbench::all_image_errors);
    reliefbench::add("image_errors_of_a_patch", reliefbench::image_errors_of_a_patch);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
