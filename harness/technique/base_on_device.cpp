#include "technique/base_on_device.hpp"

#include "gpu/device.hpp"
#include "scene/surface/chart_grid.hpp"
#include "technique/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reliefbench {

namespace {

/// BaseVertex of base_mesh.glsl, std430.
struct DeviceVertex {
    glm::vec3 position;
    float u;
    glm::vec3 normal;
    float v;
};
static_assert(sizeof(DeviceVertex) == 32);

/// BaseChart of base_mesh.glsl, std430.
struct DeviceChart {
    ChartCells cells;
    glm::vec2 period;
};
static_assert(sizeof(DeviceChart) == 40);

template <typename Value>
gpu::Buffer upload(const gpu::Device& device, const std::vector<Value>& values) {
    return gpu::make_device_buffer(device, vk::BufferUsageFlagBits::eStorageBuffer, std::as_bytes(std::span(values)));
}

std::vector<std::pair<std::string, gpu::Buffer>> upload_charts(const gpu::Device& device, const BaseMesh& mesh) {
    std::vector<std::pair<std::string, gpu::Buffer>> buffers;
    const ChartGrid grid = make_chart_grid(mesh);
    std::vector<DeviceChart> charts;
    for (std::size_t chart = 0; chart < grid.charts.size(); ++chart)
        charts.push_back({grid.charts[chart], mesh.chart_periods[chart]});
    buffers.emplace_back("base_charts", upload(device, charts));
    buffers.emplace_back("base_triangle_charts", upload(device, mesh.charts));
    buffers.emplace_back("base_cell_starts", upload(device, grid.cell_starts));
    buffers.emplace_back("base_cell_triangles", upload(device, grid.cell_triangles));
    return buffers;
}

gpu::Buffer upload_vertices(const gpu::Device& device, const BaseMesh& mesh) {
    std::vector<DeviceVertex> vertices;
    vertices.reserve(mesh.vertices.size());
    for (const MeshVertex& vertex : mesh.vertices)
        vertices.push_back({vertex.position, vertex.uv.x, vertex.normal, vertex.uv.y});
    return upload(device, vertices);
}

}  // namespace

BaseOnDevice::BaseOnDevice(const gpu::Device& device, const BaseMesh& mesh)
    : vertices_(upload_vertices(device, mesh)),
      indices_(upload(device, mesh.triangles)),
      charts_(upload_charts(device, mesh)) {}

std::vector<gpu::Binding> BaseOnDevice::bindings() const {
    std::vector<gpu::Binding> bindings{gpu::storage_buffer("base_vertices", vertices_.buffer),
                                       gpu::storage_buffer("base_indices", indices_.buffer)};
    for (const auto& [name, buffer] : charts_)
        bindings.push_back(gpu::storage_buffer(name, buffer.buffer));
    return bindings;
}

std::shared_ptr<const BaseOnDevice> BasesOnDevice::get(const BaseSurface& base) const {
    if (is_flat(base)) return nullptr;
    const std::shared_ptr<const BaseMesh>& mesh = std::get<MeshBase>(base.kind).mesh;
    for (const InUse& used : in_use_) {
        if (used.mesh.lock() != mesh) continue;
        if (std::shared_ptr<const BaseOnDevice> shared = used.on_device.lock()) return shared;
    }
    std::erase_if(in_use_, [](const InUse& used) { return used.on_device.expired(); });
    auto made = std::make_shared<const BaseOnDevice>(*device_, *mesh);
    in_use_.push_back({mesh, made});
    return made;
}

std::uint64_t base_bytes(const BaseMesh& mesh) {
    constexpr std::size_t index = sizeof(std::uint32_t);
    // Its chart, a cell of the grid and the cell's entries.
    constexpr std::size_t in_chart = (2 + max_entries_of_triangle) * index;
    return mesh.vertices.size() * sizeof(DeviceVertex) +
           mesh.triangles.size() * (sizeof(BaseMesh::Triangle) + in_chart) +
           mesh.chart_periods.size() * sizeof(DeviceChart);
}

std::string unsupported_mesh(const gpu::Device& device, const BaseMesh& mesh) {
    // Of its buffers those that may be largest: vertices, and the entries of the charts' grid.
    const std::uint64_t bytes = std::max(mesh.vertices.size() * sizeof(DeviceVertex),
                                         mesh.triangles.size() * max_entries_of_triangle * sizeof(std::uint32_t));
    if (bytes <= device.info().max_storage_buffer_bytes) return {};
    return fmt::format("the base '{}' would be a buffer of {} bytes; {} has buffers of {}", mesh.name, bytes,
                       device.info().name, device.info().max_storage_buffer_bytes);
}

}  // namespace reliefbench
