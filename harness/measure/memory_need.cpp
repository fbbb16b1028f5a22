#include "measure/memory_need.hpp"

#include "core/memory.hpp"
#include "gpu/device.hpp"
#include "reference/relief_pieces.hpp"

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

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
/// Of a truth of several samples: its noise and the picture of half of them.
constexpr std::uint64_t host_filtered_pixel = 16;
/// A second probe and its truth.
constexpr std::uint64_t host_motion_pixel = 100;
/// The history and its still picture, those of the next frame, and what is drawn and computed for them.
constexpr std::uint64_t host_history_pixel = 208;
/// Of a picture that is not the probed draw's own: one draw as it is read back, and the sum of them all.
constexpr std::uint64_t host_drawn_pixel = 56;
/// Targets and counters of the probed draw, one of them read back.
constexpr std::uint64_t device_probed_pixel = 84;
/// Of the draw that is timed, colour and depth, for each sample; and what the samples are resolved to.
constexpr std::uint64_t device_timed_sample = 8;
constexpr std::uint64_t device_resolved_pixel = 4;
/// The same of a draw for its picture, with what is read back.
constexpr std::uint64_t device_float_sample = 20;
constexpr std::uint64_t device_float_pixel = 32;

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

/// What the triangles of a base make of the height map: in texels, once for each time that a chart lies over them.
struct BaseInTexels {
    double area = 0;
    /// Cells that the triangles' sides cut, once for each triangle.
    double cut = 0;
};

BaseInTexels base_in_texels(const BaseMesh& mesh, Resolution map, double tiling) {
    BaseInTexels sum;
    const glm::dvec2 texels_of_patch = glm::dvec2(map.width, map.height) * tiling;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const BaseMesh::Triangle& corners = mesh.triangles[triangle];
        const glm::dvec2 a(mesh.vertices[corners[0]].uv);
        const glm::dvec2 b(mesh.vertices[corners[1]].uv);
        const glm::dvec2 c(mesh.vertices[corners[2]].uv);
        const glm::dvec2 extent = (glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c)) * texels_of_patch;
        sum.area += std::abs(chart_area(mesh, triangle)) * texels_of_patch.x * texels_of_patch.y;
        sum.cut += extent.x + extent.y;
    }
    return sum;
}

std::uint64_t curved_truth_need(const View& view, const BaseMesh& mesh, Resolution map, const TruthSettings& truth) {
    const BaseInTexels base = base_in_texels(mesh, map, view.relief.tiling);
    const auto triangles = static_cast<double>(mesh.triangles.size());
    const double pieces = std::min(base.area + base.cut + triangles, max_relief_pieces) + triangles;
    double bytes = pieces * host_relief_piece + triangles * host_base_triangle;
    if (truth.kind == TruthSettings::Kind::mesh) {
        const double subdivision = truth.subdivision;
        bytes +=
            (2 * base.area * subdivision * subdivision + 2 * base.cut * subdivision + triangles) * host_diced_facet;
    }
    return static_cast<std::uint64_t>(bytes) + texels(view.resolution) * host_curved_pixel +
           texels(map) * host_truth_texel * 2;
}

/// By pixel: targets of the draws, of which the one that is timed stays.
std::uint64_t device_pixel(const View& view) {
    const auto samples = static_cast<std::uint64_t>(view.samples_per_pixel);
    const std::uint64_t timed = samples * device_timed_sample + (samples > 1 ? device_resolved_pixel : 0);
    if (!has_picture_of_its_own(view)) return device_probed_pixel + timed;
    return std::max(device_probed_pixel, samples * device_float_sample + device_float_pixel) + timed;
}

std::uint64_t truth_need(const Cell& cell, const BaseSurface& base, const InputSizes& sizes,
                         const TruthSettings& truth) {
    if (!is_flat(base)) return curved_truth_need(cell.view.view, curved_base(base), sizes.height_map, truth);
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

MemoryNeed cell_need(const Technique& technique, const Cell& cell, const BaseSurface& base, const InputSizes& sizes,
                     const Configuration& configuration) {
    const std::uint64_t pixels = texels(cell.view.view.resolution);
    const std::uint64_t curved = is_flat(base) ? 0 : host_curved_pixel;
    const std::uint64_t filtered = configuration.truth.samples > 1 ? host_filtered_pixel : 0;
    const std::uint64_t drawn = has_picture_of_its_own(cell.view.view) ? host_drawn_pixel : 0;
    const bool has_history = configuration.motion && configuration.motion->history_weight;
    const std::uint64_t moving =
        configuration.motion ? host_motion_pixel + curved + (has_history ? host_history_pixel : 0) : 0;
    const std::uint64_t host = host_pixel + filtered + drawn + moving;
    const std::uint64_t triangles = is_flat(base) ? 0 : base_bytes(curved_base(base));
    // What the device has of the triangles is gathered here first.
    return {pixels * host + truth_need(cell, base, sizes, configuration.truth) + triangles,
            pixels * device_pixel(cell.view.view) + derived_map_bytes(technique, cell.parameters, sizes.height_map) +
                material_mip_bytes(cell.view.view.material, sizes.height_map, sizes.albedo) + triangles};
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
