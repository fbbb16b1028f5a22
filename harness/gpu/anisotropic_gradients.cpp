#include "gpu/anisotropic_gradients.hpp"

#include "gpu/commands.hpp"
#include "gpu/handles.hpp"
#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"

#include <array>
#include <cstring>
#include <memory>
#include <span>

namespace reliefbench::gpu {

namespace {

constexpr std::uint32_t texels_per_side = 8;
constexpr float max_anisotropy = 2;

// Footprints of level 1: two texels to either side, and four to one, which is twice as long as the maximum lets the
// level be.
const char* const two_footprints = R"(
layout(local_size_x = 1) in;
layout(set = 0, binding = 0) uniform sampler2D levels;
layout(set = 0, binding = 1, std430) buffer Footprints { float even; float aslant; } footprints;
void main() {
    const float texel = 1.0 / 8.0;
    footprints.even = textureGrad(levels, vec2(0.5), vec2(2.0 * texel, 0.0), vec2(0.0, 2.0 * texel)).r;
    footprints.aslant = textureGrad(levels, vec2(0.5), vec2(4.0 * texel, 0.0), vec2(0.0, texel)).r;
}
)";

struct Footprints {
    float even = 0;
    float aslant = 0;
};

/// Black at level 0, and white above.
Texture make_levels(const Device& device) {
    constexpr vk::Extent2D extent{texels_per_side, texels_per_side};
    Texture texture(device, extent, vk::Format::eR8Unorm, full_mip_chain(extent),
                    vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst);
    std::vector<std::vector<std::byte>> levels;
    for (std::uint32_t level = 0; level < texture.levels; ++level) {
        const vk::Extent2D size = texture.level_extent(level);
        levels.emplace_back(std::size_t{size.width} * size.height, level == 0 ? std::byte{0} : std::byte{255});
    }
    upload_levels(device, texture, levels);
    return texture;
}

bool find_whether_gradients_are_taken(const Device& device) {
    const char* const file = "two_footprints.comp";
    const auto code = std::make_shared<const SpirV>(compile_shader({.stage = ShaderStage::compute,
                                                                    .file = file,
                                                                    .roots = {},
                                                                    .generated = {{file, two_footprints}},
                                                                    .preamble = {}}));
    Footprints footprints;
    const Buffer buffer =
        make_filled_buffer(device, vk::BufferUsageFlagBits::eStorageBuffer, std::as_bytes(std::span(&footprints, 1)));
    const Texture levels = make_levels(device);
    const vk::raii::Sampler sampler = make_sampler(device, {.anisotropy = max_anisotropy});
    const Pipeline pipeline =
        make_compute_pipeline(device, {.shader = {ShaderStage::compute, code}, .constants = {}},
                              {{sampled_image("levels", levels.view, sampler, vk::ImageLayout::eShaderReadOnlyOptimal),
                                storage_buffer("footprints", buffer.buffer)}});
    submit_and_wait(device, "look at anisotropic footprints", [&](const vk::raii::CommandBuffer& commands) {
        pipeline.bind(commands);
        commands.dispatch(1, 1, 1);
    });
    std::memcpy(&footprints, buffer.mapped, sizeof footprints);
    constexpr float white = 0.5;
    return footprints.even > white && footprints.aslant > white;
}

}  // namespace

bool anisotropy_takes_gradients(const Device& device) {
    std::optional<bool>& known = *device.handles().anisotropy_takes_gradients;
    if (!known) known = find_whether_gradients_are_taken(device);
    return *known;
}

}  // namespace reliefbench::gpu
