#include "technique/base_on_device.hpp"
#include "technique/pipeline/draw_pipeline.hpp"

namespace reliefbench {

namespace {

/// Three tetrahedra of four triangles in the prism of each triangle of the base
/// (harness/shaders/driver/shell_prism.glsl).
constexpr std::uint64_t vertices_per_prism = 3ULL * 4 * 3;
/// The vertices of a draw are counted in 32 bits.
constexpr std::uint64_t max_prisms = (std::uint64_t{1} << 31) / vertices_per_prism;

std::string shell_preamble(const Manifest& /*manifest*/, const ParameterValues& /*parameters*/,
                           const BaseSurface& /*base*/) {
    return {};
}

std::string unsupported_shell(const gpu::Device& device, const DrawnView& drawn) {
    const View& view = drawn.view;
    if (view.self_shadow.mode != SelfShadow::Mode::off)
        return "self-shadowing searches along the light's ray in the relief; the pieces of rays that a shell knows are "
               "those of pixels";
    if (view.depth_write != DepthWrite::on) return "of the shell's pieces of a ray the nearest is found by its depth";
    if (is_flat(view.relief.base) && view.relief.boundary == Boundary::repeat)
        return "the shell ends at the border of its patch, past which the relief goes on (boundary=clip has no such)";
    const BaseMesh& mesh = curved_base(triangulated(view.relief.base));
    if (std::string too_large = unsupported_mesh(device, mesh); !too_large.empty()) return too_large;
    if (mesh.triangles.size() <= max_prisms) return {};
    return fmt::format("the shell of {} triangles would have more vertices than a draw can; it can have that of {}",
                       mesh.triangles.size(), max_prisms);
}

DrawGeometry shell_geometry(const gpu::Device& /*device*/, const DrawnView& drawn) {
    const std::uint64_t prisms = curved_base(triangulated(drawn.view.relief.base)).triangles.size();
    const auto vertices = static_cast<std::uint32_t>(vertices_per_prism * prisms);
    return {.vertices = vertices,
            .vertices_per_call = vertices,
            .topology = vk::PrimitiveTopology::eTriangleList,
            .cull = vk::CullModeFlagBits::eBack};
}

void record_shell(const vk::raii::CommandBuffer& commands, const DrawGeometry& geometry) {
    commands.draw(geometry.vertices, 1, 0, 0);
}

}  // namespace

DrawPipeline shell_pipeline() {
    return {.shape = "shell",
            .features = {},
            .preamble = shell_preamble,
            .unsupported = unsupported_shell,
            .geometry = shell_geometry,
            .record = record_shell,
            .needs_triangles = true,
            // A piece ends past the faces of its tetrahedron by what rounding loses.
            .range_tolerance = 1e-4};
}

}  // namespace reliefbench
