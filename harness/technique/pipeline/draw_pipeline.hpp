#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/device.hpp"
#include "gpu/vulkan.hpp"
#include "manifest/manifest.hpp"
#include "scene/relief.hpp"
#include "technique/scene_uniforms.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace reliefbench {

/// What a draw is of, as far as its geometry depends on it.
struct DrawnView {
    const Manifest& manifest;
    const ParameterValues& parameters;
    const View& view;
    /// Of the height map.
    Resolution height_map;
};

/// What goes through the stages.
struct DrawGeometry {
    /// In all, and in one draw call at most.
    std::uint32_t vertices = 0;
    std::uint32_t vertices_per_call = 0;
    vk::PrimitiveTopology topology = vk::PrimitiveTopology::eTriangleStrip;
    vk::CullModeFlags cull = vk::CullModeFlagBits::eNone;
    /// Of patches, which have tessellation stages; 0: none.
    std::uint32_t patch_vertices = 0;
    /// What the uniforms tell of it.
    PatchGrid grid = {};
};

/// A way to draw: everything that the renderer knows of it, and nobody else. The stages that it is compiled from, and
/// what technique.json says of it, are the ShapeKind of the same word (manifest/shape.hpp).
struct DrawPipeline {
    std::string shape;
    /// Of the device, beside those of the manifest.
    std::vector<std::string> features;
    /// Put in front of each stage; what it says is part of the key that compilations are kept by. May be empty.
    std::string (*preamble)(const Manifest& manifest, const ParameterValues& parameters, const BaseSurface& base);
    /// Why this device cannot draw the view so, beside missing features; empty when it can.
    std::string (*unsupported)(const gpu::Device& device, const DrawnView& drawn);
    /// Of a view that is not unsupported.
    DrawGeometry (*geometry)(const gpu::Device& device, const DrawnView& drawn);
    /// Records the draw calls, within a render pass and with the pipeline bound.
    void (*record)(const vk::raii::CommandBuffer& commands, const DrawGeometry& geometry);
    /// Whether it draws the plane as triangles, too (drawn_base).
    bool needs_triangles = false;
    /// What u, v and h of a hit may leave [0, 1] by.
    double range_tolerance = 0;
};

/// Every one there is; each shape_kinds() has one.
const std::vector<DrawPipeline>& draw_pipelines();

const DrawPipeline& pipeline_of(const Manifest& manifest);

/// The base as the technique's draws are compiled for it and have it on the device.
BaseSurface drawn_base(const Manifest& manifest, const BaseSurface& base);

}  // namespace reliefbench
