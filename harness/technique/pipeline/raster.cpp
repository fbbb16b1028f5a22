#include "technique/base_on_device.hpp"
#include "technique/pipeline/draw_pipeline.hpp"

namespace reliefbench {

namespace {

std::string raster_preamble(const Manifest& /*manifest*/, const ParameterValues& /*parameters*/,
                            const BaseSurface& /*base*/) {
    return {};
}

std::string unsupported_raster(const gpu::Device& device, const DrawnView& drawn) {
    const BaseSurface& base = drawn.view.relief.base;
    return is_flat(base) ? std::string() : unsupported_mesh(device, curved_base(base));
}

DrawGeometry raster_geometry(const gpu::Device& /*device*/, const DrawnView& drawn) {
    if (is_flat(drawn.view.relief.base)) {
        constexpr std::uint32_t corners = 4;
        return {.vertices = corners, .vertices_per_call = corners};
    }
    const auto vertices = static_cast<std::uint32_t>(3 * curved_base(drawn.view.relief.base).triangles.size());
    return {.vertices = vertices,
            .vertices_per_call = vertices,
            .topology = vk::PrimitiveTopology::eTriangleList,
            .cull = vk::CullModeFlagBits::eBack};
}

void record_raster(const vk::raii::CommandBuffer& commands, const DrawGeometry& geometry) {
    commands.draw(geometry.vertices, 1, 0, 0);
}

}  // namespace

DrawPipeline raster_pipeline() {
    return {.shape = "quad",
            .features = {},
            .preamble = raster_preamble,
            .unsupported = unsupported_raster,
            .geometry = raster_geometry,
            .record = record_raster,
            .range_tolerance = 1e-6};
}

}  // namespace reliefbench
