#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "scene/surface/base_surface.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench {

/// The triangles of a base on the device, as harness/shaders/driver/base_mesh.glsl reads them.
class BaseOnDevice {
public:
    BaseOnDevice(const gpu::Device& device, const BaseMesh& mesh);

    /// The buffers must outlive what is bound.
    std::vector<gpu::Binding> bindings() const;

private:
    gpu::Buffer vertices_;
    gpu::Buffer indices_;
    /// By name: the grid that finds a chart's triangles.
    std::vector<std::pair<std::string, gpu::Buffer>> charts_;
};

/// Those in use: renderers that draw one mesh at a time share it.
class BasesOnDevice {
public:
    explicit BasesOnDevice(const gpu::Device& device) : device_(&device) {}

    /// Null for a flat base.
    std::shared_ptr<const BaseOnDevice> get(const BaseSurface& base) const;

private:
    struct InUse {
        std::weak_ptr<const BaseMesh> mesh;
        std::weak_ptr<const BaseOnDevice> on_device;
    };

    const gpu::Device* device_;
    /// What is in it is a matter of who draws, not of the scene.
    mutable std::vector<InUse> in_use_;
};

/// Why the device cannot hold the mesh; empty when it can.
std::string unsupported_mesh(const gpu::Device& device, const BaseMesh& mesh);

}  // namespace reliefbench
