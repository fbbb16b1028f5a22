#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "scene/material_filter.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace reliefbench {

/// Albedo and the height's derivatives with mip chains, whose base is a copy of the scene's textures. Linear light and
/// slopes are averaged, not encoded colours and normals.
class MaterialMips {
public:
    /// Textures without chains, ready for sampling; they are not needed any more afterwards.
    MaterialMips(const gpu::Device& device, const gpu::Texture& albedo, const gpu::Texture& derivatives);

    /// Makes the levels above the base so many times. Milliseconds of each.
    std::vector<double> make(int samples) const;

    /// Device memory that the levels above the base take, by what the driver asks for with and without them: that of
    /// the base is the material's own, with or without a chain.
    std::uint64_t bytes() const { return bytes_; }

    /// Of draws, which read through `sampler`.
    std::vector<gpu::Binding> bindings(const vk::raii::Sampler& sampler) const;

private:
    struct Chain {
        std::string name;
        gpu::Texture texture;
        /// One descriptor set for each level above the base.
        gpu::Pipeline pipeline = {};
    };

    void copy_base(const gpu::Texture& from, const gpu::Texture& to) const;
    void change_layouts(const vk::raii::CommandBuffer& commands, vk::ImageLayout from, vk::ImageLayout to) const;
    void record(const vk::raii::CommandBuffer& commands) const;

    const gpu::Device* device_;
    vk::raii::Sampler sampler_;
    std::vector<Chain> chains_;
    std::uint64_t bytes_ = 0;
};

/// As the filter asks for; the device must have what it asks for (unsupported_material).
vk::raii::Sampler make_material_sampler(const gpu::Device& device, const MaterialFilter& filter);

/// Why the device cannot filter so; empty where it can.
std::string unsupported_material(const gpu::Device& device, const MaterialFilter& filter);

}  // namespace reliefbench
