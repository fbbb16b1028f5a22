#include "core/error.hpp"
#include "technique/scene_textures.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace reliefbench {

namespace {

/// The material's textures are the base of mip chains.
constexpr auto sampled =
    vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst | vk::ImageUsageFlagBits::eTransferSrc;

vk::Extent2D extent_of(Resolution size) {
    return {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)};
}

template <typename Value>
std::vector<std::byte> to_bytes(const std::vector<Value>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    return {bytes.begin(), bytes.end()};
}

template <typename Stored>
std::vector<Stored> to_unorm(std::span<const float> values) {
    constexpr double largest = std::numeric_limits<Stored>::max();
    std::vector<Stored> stored(values.size());
    std::transform(values.begin(), values.end(), stored.begin(), [](float value) {
        return static_cast<Stored>(std::lround(std::clamp(static_cast<double>(value), 0.0, 1.0) * largest));
    });
    return stored;
}

gpu::Texture make_texture(const gpu::Device& device, Resolution size, vk::Format format,
                          const std::vector<std::byte>& texels) {
    const auto needed = vk::FormatFeatureFlagBits::eSampledImage | vk::FormatFeatureFlagBits::eSampledImageFilterLinear;
    const auto properties = device.handles().physical_device.getFormatProperties(format);
    if ((properties.optimalTilingFeatures & needed) != needed)
        fail("{} cannot filter textures of format {}", device.info().name, vk::to_string(format));
    gpu::Texture texture(device, extent_of(size), format, 1, sampled);
    gpu::upload_texture(device, texture, texels);
    return texture;
}

gpu::Texture make_albedo_texture(const gpu::Device& device, const Albedo& albedo) {
    if (albedo.format == Albedo::Format::float32)
        return make_texture(device, albedo.texels.size, vk::Format::eR32G32B32A32Sfloat,
                            to_bytes(albedo.texels.texels));
    const std::span<const float> channels(albedo.texels.texels.front().data(), albedo.texels.texels.size() * 4);
    return make_texture(device, albedo.texels.size, vk::Format::eR16G16B16A16Unorm,
                        to_bytes(to_unorm<std::uint16_t>(channels)));
}

}  // namespace

vk::Format vulkan_format(HeightFormat format) {
    switch (format) {
        case HeightFormat::r8:
            return vk::Format::eR8Unorm;
        case HeightFormat::r16:
            return vk::Format::eR16Unorm;
        case HeightFormat::r32f:
            return vk::Format::eR32Sfloat;
    }
    fail("unknown height format {}", static_cast<int>(format));
}

std::vector<std::byte> encode_heights(const Image<float>& heights, HeightFormat format) {
    switch (format) {
        case HeightFormat::r8:
            return to_bytes(to_unorm<std::uint8_t>(heights.texels));
        case HeightFormat::r16:
            return to_bytes(to_unorm<std::uint16_t>(heights.texels));
        case HeightFormat::r32f:
            return to_bytes(heights.texels);
    }
    fail("unknown height format {}", static_cast<int>(format));
}

SceneOnDevice::Textures::Textures(const gpu::Device& device, const HeightMap& map, const Albedo& scene_albedo)
    : size(map.heights.size),
      height_map_hash(map.hash),
      heights(make_texture(device, size, vulkan_format(map.format), encode_heights(map.heights, map.format))),
      derivatives(make_texture(device, size, vk::Format::eR32G32Sfloat, to_bytes(height_derivatives(map).texels))),
      albedo(make_albedo_texture(device, scene_albedo)),
      linear_repeat(gpu::make_sampler(device, {})),
      nearest_repeat(gpu::make_sampler(device, {.filter = vk::Filter::eNearest})),
      bases(device),
      blue_noise(device),
      device_(&device) {}

std::vector<gpu::Binding> SceneOnDevice::Textures::height_bindings() const {
    constexpr auto layout = vk::ImageLayout::eShaderReadOnlyOptimal;
    return {gpu::sampled_image("height_map", heights.view, linear_repeat, layout),
            gpu::sampled_image("height_texels", heights.view, nearest_repeat, layout)};
}

std::vector<gpu::Binding> SceneOnDevice::Textures::material_bindings() const {
    constexpr auto layout = vk::ImageLayout::eShaderReadOnlyOptimal;
    return {gpu::sampled_image("height_derivatives", derivatives.view, linear_repeat, layout),
            gpu::sampled_image("albedo_map", albedo.view, linear_repeat, layout)};
}

std::shared_ptr<const MaterialMips> SceneOnDevice::Textures::material_mips() const {
    if (std::shared_ptr<const MaterialMips> shared = mips_in_use_.lock()) return shared;
    auto made = std::make_shared<const MaterialMips>(*device_, albedo, derivatives);
    mips_in_use_ = made;
    return made;
}

SceneOnDevice::SceneOnDevice(const gpu::Device& device, const HeightMap& map, const Albedo& albedo)
    : textures_(std::make_unique<Textures>(device, map, albedo)) {}

SceneOnDevice::~SceneOnDevice() = default;
SceneOnDevice::SceneOnDevice(SceneOnDevice&&) noexcept = default;

}  // namespace reliefbench
