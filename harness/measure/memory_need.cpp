#include "measure/memory_need.hpp"

#include "core/memory.hpp"
#include "gpu/device.hpp"
#include "reference/relief_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reliefbench {

namespace {

// Bytes of a texel or pixel. Measured where they are sums of what several layers hold at once.

constexpr std::uint64_t host_height = 4;
constexpr std::uint64_t host_albedo = 16;
constexpr std::uint64_t device_derivatives = 8;
constexpr std::uint64_t device_albedo = 8;
/// Encoded once more and once again for the upload, of which the device has one copy.
constexpr std::uint64_t host_upload = 16;
constexpr std::uint64_t device_upload = 8;

/// Probe and truth, and what is computed from them.
constexpr std::uint64_t host_pixel = 128;
/// A second probe and its truth.
constexpr std::uint64_t host_motion_pixel = 100;
/// Targets and counters of the probed draw, one of them read back, and the timed draw's targets.
constexpr std::uint64_t device_pixel = 92;

/// The exact tracer's maximum mip chain, and derivatives for shading.
constexpr std::uint64_t host_truth_texel = 10;
/// Vertices and Embree's hierarchy over its grids.
constexpr std::uint64_t host_mesh_vertex = 32;

std::uint64_t texels(Resolution size) {
    return std::uint64_t{size.pixels()};
}

std::uint64_t format_bytes(HeightFormat format) {
    return format == HeightFormat::r8 ? 1 : format == HeightFormat::r16 ? 2 : 4;
}

/// Over bases of triangles: a piece of the relief with its box, and what Embree's hierarchy takes while it is built.
constexpr std::uint64_t host_relief_piece = 150;
/// A triangle of the base as the tracer has it, and its place in a hierarchy.
constexpr std::uint64_t host_base_triangle = 600;
/// A facet of the diced mesh, while it is built.
constexpr std::uint64_t host_diced_facet = 200;
/// By pixel: normals, entries, charts, and the hits in double.
constexpr std::uint64_t host_curved_pixel = 80;

/// Of the triangles of generated bases; of a file's nothing is known before it is read.
std::uint64_t curved_truth_need(const Cell& cell, const InputSizes& sizes, const TruthSettings& truth) {
    const BaseSource& base = cell.view.base;
    const double side = base.is_generated() ? base.segments : 0;
    const double tiling = cell.view.view.relief.tiling;
    const double cells = static_cast<double>(texels(sizes.height_map)) * tiling * tiling;
    // Its triangles' sides cut cells along three directions.
    const double cut = side * tiling * (sizes.height_map.width + sizes.height_map.height) * 2;
    const double triangles = 2 * side * side;
    const double pieces = std::min(cells + cut + triangles, max_relief_pieces) + triangles;
    double bytes = pieces * host_relief_piece + triangles * host_base_triangle;
    if (truth.kind == TruthSettings::Kind::mesh) {
        const double subdivision = truth.subdivision;
        bytes += (2 * cells * subdivision * subdivision + 2 * cut * subdivision + triangles) * host_diced_facet;
    }
    return static_cast<std::uint64_t>(bytes) + texels(cell.view.view.resolution) * host_curved_pixel +
           texels(sizes.height_map) * host_truth_texel * 2;
}

std::uint64_t truth_need(const Cell& cell, const InputSizes& sizes, const TruthSettings& truth) {
    if (!cell.view.base.is_flat()) return curved_truth_need(cell, sizes, truth);
    const std::uint64_t tracer = texels(sizes.height_map) * host_truth_texel;
    if (truth.kind != TruthSettings::Kind::mesh) return tracer;
    const double per_side = cell.view.view.relief.tiling * truth.subdivision;
    const double vertices = static_cast<double>(texels(sizes.height_map)) * per_side * per_side;
    return tracer + static_cast<std::uint64_t>(vertices * static_cast<double>(host_mesh_vertex));
}

}  // namespace

InputSizes input_sizes(const HeightMapSource& source) {
    const Resolution heights = height_map_size(source);
    return {heights, albedo_size(source, heights)};
}

MemoryNeed loading_need(const InputSizes& sizes, HeightFormat format) {
    const std::uint64_t heights = texels(sizes.height_map);
    const std::uint64_t albedo = texels(sizes.albedo);
    const std::uint64_t uploaded = std::max(heights, albedo);
    return {heights * host_height + albedo * host_albedo + uploaded * host_upload,
            heights * (format_bytes(format) + device_derivatives) + albedo * device_albedo + uploaded * device_upload};
}

MemoryNeed cell_need(const Technique& technique, const Cell& cell, const InputSizes& sizes,
                     const Configuration& configuration) {
    const std::uint64_t pixels = texels(cell.view.view.resolution);
    const std::uint64_t host = host_pixel + (configuration.motion ? host_motion_pixel : 0);
    return {pixels * host + truth_need(cell, sizes, configuration.truth),
            pixels * device_pixel + derived_map_bytes(technique, cell.parameters, sizes.height_map)};
}

MemoryNeed with_inputs(MemoryNeed cell, const InputSizes& sizes, HeightFormat format) {
    const MemoryNeed loading = loading_need(sizes, format);
    const std::uint64_t uploaded = std::max(texels(sizes.height_map), texels(sizes.albedo));
    // What the upload took is free again when the cell begins.
    return {std::max(loading.host, loading.host - uploaded * host_upload + cell.host),
            std::max(loading.device, loading.device - uploaded * device_upload + cell.device)};
}

std::string lacking_memory(const gpu::Device& device, const std::string& what, MemoryNeed need) {
    const gpu::DeviceType type = device.info().type;
    if (type == gpu::DeviceType::cpu || type == gpu::DeviceType::integrated) {
        need.host += need.device;
    } else if (const std::uint64_t has = device_memory_bytes(device); need.device > has) {
        return fmt::format("{} takes about {} of memory on {}, which has {}", what, memory_text(need.device),
                           device.info().name, memory_text(has));
    }
    const std::uint64_t available = available_memory();
    if (need.host <= available) return {};
    return fmt::format("{} takes about {} of memory, and {} is available", what, memory_text(need.host),
                       memory_text(available));
}

}  // namespace reliefbench
