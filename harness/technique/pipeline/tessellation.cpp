#include "technique/base_on_device.hpp"
#include "technique/pipeline/draw_pipeline.hpp"

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>

namespace reliefbench {

namespace {

/// What no device is asked to draw at once: a mistake in tiling or view, not a measurement.
constexpr double max_patches = 1 << 22;
/// Vulkan's minimum, and the most that technique.json can ask for.
constexpr int tessellation_factor = 64;
constexpr std::uint32_t quad_corners = 4;
constexpr std::uint32_t triangle_corners = 3;

/// PatchGrid before its numbers are known to be integers of 32 bits.
struct RealGrid {
    glm::dvec2 per_side{1, 1};
    glm::dvec2 first{0, 0};
    glm::dvec2 count{1, 1};
};

/// Boundary::clip: the unit square. Boundary::repeat: also what rays that enter inside the unit square can reach within
/// the relief.
RealGrid real_grid(const DrawnView& drawn) {
    const Shape& shape = drawn.manifest.shape;
    const Relief& relief = drawn.view.relief;
    RealGrid grid;
    const auto asked = std::get<std::int64_t>(drawn.parameters.at(shape.patches_parameter));
    const glm::dvec2 texels = relief.tiling * glm::dvec2(drawn.height_map.width, drawn.height_map.height);
    grid.per_side = asked > 0 ? glm::dvec2(static_cast<double>(asked))
                              : glm::max(glm::ceil(texels / double(shape.texels_per_patch)), 1.0);
    const PatchRegion region = relief.boundary == Boundary::clip
                                   ? PatchRegion{}
                                   : visible_region(flat_base(relief.base), drawn.view.camera, relief.height_scale);
    grid.first = glm::floor(region.low * grid.per_side);
    grid.count = glm::ceil(region.high * grid.per_side) - grid.first;
    return grid;
}

std::string tessellation_preamble(const Manifest& manifest, const ParameterValues& parameters,
                                  const BaseSurface& base) {
    const std::uint32_t corners =
        is_flat(base) ? static_cast<std::uint32_t>(manifest.shape.patch_corners(parameters)) : triangle_corners;
    return fmt::format("const int patch_corners = {};\n", corners);
}

std::string unsupported_tessellation(const gpu::Device& device, const DrawnView& drawn) {
    if (drawn.view.self_shadow.mode != SelfShadow::Mode::off)
        return "self-shadowing searches along the light's ray in the relief; real geometry has no such search (an "
               "engine would give it a shadow map)";
    if (drawn.view.depth_write != DepthWrite::on) return "real geometry has its own depth, and no other";
    if (drawn.view.material.gradients != MaterialFilter::Gradients::before_search)
        return "real geometry has no search: its gradients are its own, those of material_gradients=before_search";
    if (device.info().max_tessellation_factor < tessellation_factor)
        return fmt::format("{} cuts sides of patches into at most {} segments; {} are needed", device.info().name,
                           device.info().max_tessellation_factor, tessellation_factor);
    double patches = 0;
    if (is_flat(drawn.view.relief.base)) {
        const RealGrid grid = real_grid(drawn);
        patches = grid.count.x * grid.count.y;
    } else {
        if (drawn.manifest.shape.triangles_with.empty())
            return "its patches are quads; those of a base that is not flat are triangles";
        const BaseMesh& mesh = curved_base(drawn.view.relief.base);
        if (std::string too_large = unsupported_mesh(device, mesh); !too_large.empty()) return too_large;
        patches = static_cast<double>(mesh.triangles.size());
    }
    if (patches <= max_patches) return {};
    return fmt::format("the view would take {:.3g} patches, more than {:.0f}", patches, max_patches);
}

/// lavapipe (Mesa 22.3) numbers the vertices that tessellation makes in one draw with 16 bits and silently connects
/// wrong ones beyond; 15 patches at the largest factor, of 65·65 vertices each, stay below. It also takes time that
/// grows with the square of a draw's vertices: 16 such patches took five times as long in draws of 15 as in draws of 4.
constexpr std::uint32_t patches_per_call_on_cpu = 4;

/// The same of a mesh's triangles, which are many and mostly cut into few segments: at the largest factor, of 2,145
/// vertices each, so many stay below 16 bits.
constexpr std::uint32_t triangles_per_call_on_cpu = 16;

DrawGeometry mesh_geometry(const gpu::Device& device, const BaseMesh& mesh) {
    const auto vertices = static_cast<std::uint32_t>(triangle_corners * mesh.triangles.size());
    const bool on_cpu = device.info().type == gpu::DeviceType::cpu;
    return {.vertices = vertices,
            .vertices_per_call = on_cpu ? triangles_per_call_on_cpu * triangle_corners : vertices,
            .topology = vk::PrimitiveTopology::ePatchList,
            .cull = vk::CullModeFlagBits::eBack,
            .patch_vertices = triangle_corners};
}

DrawGeometry tessellation_geometry(const gpu::Device& device, const DrawnView& drawn) {
    if (!is_flat(drawn.view.relief.base)) return mesh_geometry(device, curved_base(drawn.view.relief.base));
    const RealGrid real = real_grid(drawn);
    const PatchGrid grid{glm::ivec2(real.per_side), glm::ivec2(real.first), glm::ivec2(real.count)};
    const auto corners = static_cast<std::uint32_t>(drawn.manifest.shape.patch_corners(drawn.parameters));
    const std::uint32_t patches_per_quad = corners == quad_corners ? 1 : 2;
    const std::uint32_t vertices = corners * patches_per_quad * static_cast<std::uint32_t>(grid.count.x * grid.count.y);
    const bool on_cpu = device.info().type == gpu::DeviceType::cpu;
    return {.vertices = vertices,
            .vertices_per_call = on_cpu ? patches_per_call_on_cpu * corners : vertices,
            .topology = vk::PrimitiveTopology::ePatchList,
            .cull = vk::CullModeFlagBits::eBack,
            .patch_vertices = corners,
            .grid = grid};
}

void record_tessellation(const vk::raii::CommandBuffer& commands, const DrawGeometry& geometry) {
    for (std::uint32_t first = 0; first < geometry.vertices; first += geometry.vertices_per_call)
        commands.draw(std::min(geometry.vertices_per_call, geometry.vertices - first), 1, first, 0);
}

}  // namespace

DrawPipeline tessellation_pipeline() {
    return {.shape = "patches",
            .features = {"tessellationShader", "vertexPipelineStoresAndAtomics"},
            .preamble = tessellation_preamble,
            .unsupported = unsupported_tessellation,
            .geometry = tessellation_geometry,
            .record = record_tessellation,
            // A rasteriser snaps vertices to 1/256 pixel, so that what it interpolates on the outline of real geometry
            // is extrapolated by as much.
            .range_tolerance = 1e-3};
}

}  // namespace reliefbench
