#include "technique/derived_maps.hpp"

#include "core/error.hpp"
#include "gpu/commands.hpp"
#include "gpu/timers.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace reliefbench {

namespace {

/// Of prepare.comp, on each side.
constexpr std::uint32_t workgroup_side = 8;

std::size_t index_of_map(const Manifest& manifest, const std::string& name) {
    for (std::size_t i = 0; i < manifest.maps.size(); ++i) {
        if (manifest.maps[i].name == name) return i;
    }
    fail("technique '{}' has no map '{}'", manifest.id, name);
}

std::uint32_t groups(std::uint32_t texels) {
    return (texels + workgroup_side - 1) / workgroup_side;
}

}  // namespace

vk::Format vulkan_format(const MapDeclaration& map) {
    static const std::array<std::pair<std::string_view, vk::Format>, 7> formats{{
        {"r8", vk::Format::eR8Unorm},
        {"r16", vk::Format::eR16Unorm},
        {"r32f", vk::Format::eR32Sfloat},
        {"rg32f", vk::Format::eR32G32Sfloat},
        {"rgba8", vk::Format::eR8G8B8A8Unorm},
        {"rgba16", vk::Format::eR16G16B16A16Unorm},
        {"rgba32f", vk::Format::eR32G32B32A32Sfloat},
    }};
    for (const auto& [name, format] : formats) {
        if (name == map.format) return format;
    }
    fail("map '{}' has the unknown format '{}'", map.name, map.format);
}

vk::Extent2D map_extent(const MapDeclaration& map, Resolution height_map) {
    const auto width = static_cast<std::uint32_t>(height_map.width);
    const auto height = static_cast<std::uint32_t>(height_map.height);
    if (map.size == MapDeclaration::Size::height_map) return {width, height};
    return {std::bit_ceil(width), std::bit_ceil(height)};
}

DerivedMaps::DerivedMaps(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
                         const SceneOnDevice::Textures& scene)
    : device_(&device), heights_(&scene) {
    for (const MapDeclaration& map : technique.manifest.maps) {
        if (!all_hold(map.only_with, parameters)) {
            maps_.emplace_back();
            continue;
        }
        const vk::Extent2D extent = map_extent(map, scene.size);
        const std::uint32_t levels = map.mip_chain ? gpu::full_mip_chain(extent) : 1;
        const vk::Filter filter = map.linear_filter ? vk::Filter::eLinear : vk::Filter::eNearest;
        const auto slices = static_cast<std::uint32_t>(map.slices(parameters));
        maps_.emplace_back(Map{gpu::Texture(device, extent, vulkan_format(map), levels, map_usage, slices),
                               gpu::make_sampler(device, {.filter = filter})});
    }
    for (const PassDeclaration& pass : technique.manifest.passes) {
        if (maps_[index_of_map(technique.manifest, pass.writes)])
            passes_.push_back(make_pass(technique, pass, parameters, scene));
    }
}

DerivedMaps::Pass DerivedMaps::make_pass(const Technique& technique, const PassDeclaration& declaration,
                                         const ParameterValues& parameters,
                                         const SceneOnDevice::Textures& scene) const {
    const Manifest& manifest = technique.manifest;
    const Map& target = *maps_[index_of_map(manifest, declaration.writes)];
    const gpu::ComputePipelineOptions options{.shader = compile_pass(*device_, technique, parameters, declaration),
                                              .constants = parameter_constants(manifest, parameters),
                                              .push_constant_bytes = sizeof(std::int32_t)};
    const bool above_base = declaration.levels == PassDeclaration::Levels::above_base;
    const std::uint32_t first_level = above_base ? 1 : 0;
    const std::uint32_t end_level = above_base ? target.texture.levels : 1;
    std::vector<std::vector<gpu::Binding>> sets;
    std::vector<vk::Extent2D> sizes;
    for (std::uint32_t level = first_level; level < end_level; ++level) {
        std::vector<gpu::Binding>& bindings = sets.emplace_back(scene.height_bindings());
        bindings.push_back(gpu::storage_image(binding::target_map, target.texture.level_views[level]));
        if (above_base)
            bindings.push_back(gpu::sampled_image(binding::previous_map, target.texture.level_views[level - 1],
                                                  scene.nearest_repeat, vk::ImageLayout::eGeneral));
        for (const std::size_t map : maps_before(manifest, declaration))
            bindings.push_back(bind_map(map, vk::ImageLayout::eGeneral));
        sizes.push_back(target.texture.level_extent(level));
    }
    Pass pass{.name = declaration.name,
              .pipeline = {},
              .first_level = first_level,
              .level_sizes = sizes,
              .slices = std::max(target.texture.slices, 1u)};
    // A map of one texel has no level above its base.
    if (!sets.empty()) pass.pipeline = gpu::make_compute_pipeline(*device_, options, sets);
    return pass;
}

void DerivedMaps::record_pass(const vk::raii::CommandBuffer& commands, const Pass& pass) const {
    for (std::size_t i = 0; i < pass.level_sizes.size(); ++i) {
        const auto level = static_cast<std::int32_t>(pass.first_level + i);
        pass.pipeline.bind(commands, i);
        commands.pushConstants<std::int32_t>(pass.pipeline.layout(), vk::ShaderStageFlagBits::eCompute, 0, level);
        commands.dispatch(groups(pass.level_sizes[i].width), groups(pass.level_sizes[i].height), pass.slices);
        gpu::full_barrier(commands);
    }
}

Preparation DerivedMaps::prepare(int samples) {
    Preparation result;
    std::vector<const gpu::Texture*> textures;
    for (const std::optional<Map>& map : maps_) {
        if (!map) continue;
        textures.push_back(&map->texture);
        result.bytes += map->texture.bytes;
    }
    if (textures.empty()) return result;

    for (int sample = 0; sample < samples; ++sample) {
        const gpu::Timestamps timestamps(*device_,
                                         static_cast<std::uint32_t>(std::max<std::size_t>(passes_.size(), 1)));
        gpu::submit_and_wait(*device_, "prepare the derived maps", [&](const vk::raii::CommandBuffer& commands) {
            timestamps.reset(commands);
            for (const gpu::Texture* texture : textures)
                gpu::change_layout(commands, *texture->image, texture->all(), vk::ImageLayout::eUndefined,
                                   vk::ImageLayout::eGeneral);
            for (std::uint32_t i = 0; i < passes_.size(); ++i) {
                timestamps.start(commands, i);
                record_pass(commands, passes_[i]);
                timestamps.end(commands, i);
            }
            for (const gpu::Texture* texture : textures)
                gpu::change_layout(commands, *texture->image, texture->all(), vk::ImageLayout::eGeneral,
                                   vk::ImageLayout::eShaderReadOnlyOptimal);
        });
        if (passes_.empty()) continue;
        const std::vector<double> milliseconds = timestamps.milliseconds();
        for (std::size_t i = 0; i < passes_.size(); ++i)
            result.pass_ms[passes_[i].name].push_back(milliseconds[i]);
    }
    return result;
}

gpu::Binding DerivedMaps::bind_map(std::size_t index, vk::ImageLayout layout) const {
    const std::uint32_t place = binding::first_derived_map + static_cast<std::uint32_t>(index);
    const std::optional<Map>& map = maps_[index];
    if (map) return gpu::sampled_image(place, map->texture.view, map->sampler, layout);
    return gpu::sampled_image(place, heights_->heights.view, heights_->nearest_repeat,
                              vk::ImageLayout::eShaderReadOnlyOptimal);
}

std::vector<gpu::Binding> DerivedMaps::draw_bindings() const {
    std::vector<gpu::Binding> bindings;
    for (std::size_t i = 0; i < maps_.size(); ++i)
        bindings.push_back(bind_map(i, vk::ImageLayout::eShaderReadOnlyOptimal));
    return bindings;
}

}  // namespace reliefbench
