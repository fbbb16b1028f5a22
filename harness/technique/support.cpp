#include "core/error.hpp"
#include "technique/derived_maps.hpp"
#include "technique/map_needs.hpp"
#include "technique/material_mips.hpp"
#include "technique/pipeline/draw_pipeline.hpp"
#include "technique/renderer.hpp"

#include <algorithm>
#include <optional>

namespace reliefbench {

namespace {

/// Bytes of the work counters of one pixel (work.glsl).
constexpr std::uint64_t work_bytes_per_pixel = 16;
constexpr std::uint64_t scene_bytes_per_texel = 8;

/// Empty: none of this format.
std::optional<vk::Extent3D> largest_volume(const gpu::Device& device, const MapDeclaration& map) {
    const gpu::DeviceHandles& handles = device.handles();
    return gpu::translate_errors("ask for its formats", handles.info.name, [&]() -> std::optional<vk::Extent3D> {
        try {
            return handles.physical_device
                .getImageFormatProperties(vulkan_format(map), vk::ImageType::e3D, vk::ImageTiling::eOptimal, map_usage)
                .maxExtent;
        } catch (const vk::FormatNotSupportedError&) {
            return std::nullopt;
        }
    });
}

std::string unsupported_volume(const gpu::Device& device, const MapDeclaration& map, vk::Extent2D extent, int slices) {
    const std::optional<vk::Extent3D> maximum = largest_volume(device, map);
    if (!maximum)
        return fmt::format("{} has no three-dimensional images of format {} to write", device.info().name, map.format);
    const vk::Extent3D& largest = *maximum;
    const auto depth = static_cast<std::uint32_t>(slices);
    if (extent.width <= largest.width && extent.height <= largest.height && depth <= largest.depth) return {};
    return fmt::format("the map '{}' would be {}x{}x{}; {} has three-dimensional images up to {}x{}x{}", map.name,
                       extent.width, extent.height, depth, device.info().name, largest.width, largest.height,
                       largest.depth);
}

/// Of the base level, in bytes.
std::uint64_t map_bytes(const MapDeclaration& map, const ParameterValues& parameters, Resolution height_map) {
    const vk::Extent2D extent = map_extent(map, height_map);
    const auto slices = static_cast<std::uint64_t>(map.is_volume() ? map.slices(parameters) : 1);
    return std::uint64_t{extent.width} * extent.height * slices * gpu::texel_bytes(vulkan_format(map));
}

/// A limit of drivers, below what the memory holds.
std::string too_large_for_one_image(const gpu::Device& device, const std::string& what, std::uint64_t bytes) {
    const auto properties =
        device.handles()
            .physical_device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceMaintenance3Properties>();
    const std::uint64_t most = properties.get<vk::PhysicalDeviceMaintenance3Properties>().maxMemoryAllocationSize;
    if (bytes <= most) return {};
    return fmt::format("{} would take {} bytes; {} gives at most {} at once", what, bytes, device.info().name, most);
}

std::string unsupported_map(const gpu::Device& device, const MapDeclaration& map, const ParameterValues& parameters,
                            Resolution height_map) {
    const vk::Extent2D extent = map_extent(map, height_map);
    if (static_cast<int>(std::max(extent.width, extent.height)) > device.info().max_image_side)
        return fmt::format("the map '{}' would be {}x{}; {} has images up to {} on a side", map.name, extent.width,
                           extent.height, device.info().name, device.info().max_image_side);
    auto needed = vk::FormatFeatureFlagBits::eStorageImage | vk::FormatFeatureFlagBits::eSampledImage;
    if (map.linear_filter) needed |= vk::FormatFeatureFlagBits::eSampledImageFilterLinear;
    const auto properties = device.handles().physical_device.getFormatProperties(vulkan_format(map));
    const bool basic = map.format == "r32f" || map.format == "rgba8" || map.format == "rgba32f";
    const bool writable = basic || device.info().has_feature("shaderStorageImageExtendedFormats");
    if (!writable || (properties.optimalTilingFeatures & needed) != needed)
        return fmt::format("{} cannot write or filter maps of format {}", device.info().name, map.format);
    if (map.is_volume()) {
        const std::string reason = unsupported_volume(device, map, extent, map.slices(parameters));
        if (!reason.empty()) return reason;
    }
    return too_large_for_one_image(device, "the map '" + map.name + "'", map_bytes(map, parameters, height_map));
}

std::string unsupported_samples(const gpu::Device& device, int samples) {
    constexpr const char* feature = "sampleRateShading";
    if (samples == 1) return {};
    const gpu::DeviceInfo& info = device.info();
    if (!info.has_feature(feature))
        return fmt::format("{} lacks the feature {}, with which each of a pixel's samples is searched for", info.name,
                           feature);
    const vk::PhysicalDeviceLimits limits = device.handles().physical_device.getProperties().limits;
    const vk::SampleCountFlags counts = limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts;
    const auto has = [&](int count) { return bool(counts & static_cast<vk::SampleCountFlagBits>(count)); };
    if (has(samples)) return {};
    std::string available;
    constexpr int largest = 64;
    for (int count = 1; count <= largest; count *= 2) {
        if (has(count)) available += (available.empty() ? "" : ", ") + std::to_string(count);
    }
    return fmt::format("{} has no targets of {} samples per pixel; of these it has {}", info.name, samples, available);
}

}  // namespace

std::string unsupported_reason(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
                               const View& view, Resolution height_map) {
    const std::string unmet = unmet_map_need(technique.manifest, height_map, view.relief);
    if (!unmet.empty()) return unmet;
    if (technique.manifest.contract == 1 && !is_flat(view.relief.base))
        return "it is written to contract 1, whose rays know nothing of stretch and bend: it is drawn over the plane "
               "only";
    const gpu::DeviceInfo& info = device.info();
    std::vector<std::string> needed = technique.manifest.features;
    needed.emplace_back("fragmentStoresAndAtomics");
    const DrawPipeline& pipeline = pipeline_of(technique.manifest);
    needed.insert(needed.end(), pipeline.features.begin(), pipeline.features.end());
    for (const std::string& feature : needed) {
        if (!info.has_feature(feature)) return fmt::format("{} lacks the feature {}", info.name, feature);
    }
    const std::string unfiltered = unsupported_material(device, view.material);
    if (!unfiltered.empty()) return unfiltered;
    const std::string unsampled = unsupported_samples(device, view.samples_per_pixel);
    if (!unsampled.empty()) return unsampled;
    const std::string undrawn = pipeline.unsupported(device, {technique.manifest, parameters, view, height_map});
    if (!undrawn.empty()) return undrawn;
    const int largest = std::max({view.resolution.width, view.resolution.height, height_map.width, height_map.height});
    if (largest > info.max_image_side)
        return fmt::format("an image would be {} texels on a side; {} has {}", largest, info.name, info.max_image_side);
    if ((view.resolution.pixels() + 1) * work_bytes_per_pixel > info.max_storage_buffer_bytes)
        return fmt::format("{}x{} pixels take {} bytes of work counters; {} has buffers of {}", view.resolution.width,
                           view.resolution.height, (view.resolution.pixels() + 1) * work_bytes_per_pixel, info.name,
                           info.max_storage_buffer_bytes);
    // Of the textures that every cell has, derivatives and albedo take most.
    const std::string large = too_large_for_one_image(device, "a texture of the height map's size",
                                                      height_map.pixels() * scene_bytes_per_texel);
    if (!large.empty()) return large;
    for (const MapDeclaration& map : technique.manifest.maps) {
        if (!all_hold(map.only_with, parameters)) continue;
        const std::string reason = unsupported_map(device, map, parameters, height_map);
        if (!reason.empty()) return reason;
    }
    return {};
}

std::uint64_t derived_map_bytes(const Technique& technique, const ParameterValues& parameters, Resolution height_map) {
    std::uint64_t bytes = 0;
    for (const MapDeclaration& map : technique.manifest.maps) {
        if (!all_hold(map.only_with, parameters)) continue;
        const std::uint64_t base = map_bytes(map, parameters, height_map);
        bytes += map.mip_chain ? base + base / 3 : base;
    }
    return bytes;
}

std::uint64_t material_mip_bytes(const MaterialFilter& filter, Resolution height_map, Resolution albedo) {
    if (!filter.has_mips()) return 0;
    const std::uint64_t bases = (std::uint64_t{height_map.pixels()} + albedo.pixels()) * scene_bytes_per_texel;
    return bases + bases / 3;
}

std::uint64_t device_memory_bytes(const gpu::Device& device) {
    const vk::PhysicalDeviceMemoryProperties& memory = device.handles().memory;
    std::uint64_t largest = 0;
    for (std::uint32_t heap = 0; heap < memory.memoryHeapCount; ++heap) {
        const vk::MemoryHeap& candidate = memory.memoryHeaps[heap];
        if (candidate.flags & vk::MemoryHeapFlagBits::eDeviceLocal) largest = std::max(largest, candidate.size);
    }
    return largest;
}

}  // namespace reliefbench
