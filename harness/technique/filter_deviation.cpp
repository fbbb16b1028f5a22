#include "core/error.hpp"
#include "core/random.hpp"
#include "gpu/commands.hpp"
#include "gpu/shader_cache.hpp"
#include "manifest/shared_shaders.hpp"
#include "technique/scene_textures.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace reliefbench {

namespace {

/// std430 mirror of filter_deviation.comp.
struct FilteredTap {
    float u, v, h, unused;
};

constexpr int map_side = 64;
constexpr std::size_t tap_count = 65536;
constexpr std::uint64_t seed = 1;

/// Noise: neighbours differ as much as heights can, so that an error of the weights shows in full.
HeightMap noise_map(HeightFormat format) {
    Image<float> heights(Resolution{map_side, map_side});
    Random random(seed);
    for (float& height : heights.texels)
        height = static_cast<float>(random.uniform());
    return make_height_map(heights, format, "noise");
}

std::vector<FilteredTap> scattered_taps() {
    std::vector<FilteredTap> taps(tap_count);
    Random random(seed + 1);
    for (FilteredTap& tap : taps) {
        const double u = random.uniform();
        const double v = random.uniform();
        tap = {.u = static_cast<float>(u), .v = static_cast<float>(v), .h = 0, .unused = 0};
    }
    return taps;
}

Albedo black_texel() {
    Albedo albedo;
    albedo.texels = Image<std::array<float, 4>>(Resolution{1, 1});
    return albedo;
}

}  // namespace

double measure_filter_deviation(const gpu::Device& device, HeightFormat format) {
    const HeightMap map = noise_map(format);
    const SceneOnDevice scene(device, map, black_texel());
    std::vector<FilteredTap> taps = scattered_taps();
    const gpu::Buffer buffer =
        gpu::make_filled_buffer(device, vk::BufferUsageFlagBits::eStorageBuffer, std::as_bytes(std::span(taps)));

    const char* const file = "filter_deviation.comp";
    const auto code = device.shader_cache().get(shader_root().string() + "\n" + file, [&] {
        return gpu::compile_shader({.stage = gpu::ShaderStage::compute,
                                    .file = file,
                                    .roots = shared_shader_folders(shader_root()),
                                    .generated = {},
                                    .preamble = {}});
    });
    std::vector<gpu::Binding> bindings = scene.textures().height_bindings();
    bindings.push_back(gpu::storage_buffer("Taps", buffer.buffer));
    const gpu::Pipeline pipeline =
        gpu::make_compute_pipeline(device, {.shader = {gpu::ShaderStage::compute, code}, .constants = {}}, {bindings});
    gpu::submit_and_wait(device, "measure the filter", [&](const vk::raii::CommandBuffer& commands) {
        pipeline.bind(commands);
        commands.dispatch(static_cast<std::uint32_t>(tap_count) / pipeline.interface().local_size[0], 1, 1);
    });
    std::memcpy(taps.data(), buffer.mapped, buffer.size);

    double largest = 0;
    for (const FilteredTap& tap : taps) {
        const double exact = map.sample(static_cast<double>(tap.u), static_cast<double>(tap.v));
        largest = std::max(largest, std::abs(static_cast<double>(tap.h) - exact));
    }
    return largest;
}

}  // namespace reliefbench
