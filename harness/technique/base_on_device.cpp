#include "technique/base_on_device.hpp"

#include "gpu/device.hpp"

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

gpu::Buffer upload_vertices(const gpu::Device& device, const BaseMesh& mesh) {
    std::vector<DeviceVertex> vertices;
    vertices.reserve(mesh.vertices.size());
    for (const MeshVertex& vertex : mesh.vertices)
        vertices.push_back({vertex.position, vertex.uv.x, vertex.normal, vertex.uv.y});
    return gpu::make_device_buffer(device, vk::BufferUsageFlagBits::eStorageBuffer, std::as_bytes(std::span(vertices)));
}

}  // namespace

BaseOnDevice::BaseOnDevice(const gpu::Device& device, const BaseMesh& mesh)
    : vertices_(upload_vertices(device, mesh)),
      indices_(gpu::make_device_buffer(device, vk::BufferUsageFlagBits::eStorageBuffer,
                                       std::as_bytes(std::span(mesh.triangles)))) {}

std::vector<gpu::Binding> BaseOnDevice::bindings() const {
    return {gpu::storage_buffer("base_vertices", vertices_.buffer),
            gpu::storage_buffer("base_indices", indices_.buffer)};
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

std::string unsupported_mesh(const gpu::Device& device, const BaseMesh& mesh) {
    const std::uint64_t bytes =
        std::max(mesh.vertices.size() * sizeof(DeviceVertex), mesh.triangles.size() * sizeof(BaseMesh::Triangle));
    if (bytes <= device.info().max_storage_buffer_bytes) return {};
    return fmt::format("the base '{}' would be a buffer of {} bytes; {} has buffers of {}", mesh.name, bytes,
                       device.info().name, device.info().max_storage_buffer_bytes);
}

}  // namespace reliefbench
