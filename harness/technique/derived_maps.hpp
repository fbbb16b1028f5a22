#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"
#include "technique/program.hpp"
#include "technique/renderer.hpp"
#include "technique/scene_textures.hpp"

#include <optional>
#include <vector>

namespace reliefbench {

/// The textures that a technique derives from the height map, and the compute passes that fill them.
class DerivedMaps {
public:
    DerivedMaps(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
                const SceneOnDevice::Textures& scene);

    /// Runs all passes `samples` times in the manifest's order, timing each, and leaves the maps ready for draws.
    Preparation prepare(int samples);

    std::vector<gpu::Binding> draw_bindings() const;

private:
    struct Map {
        gpu::Texture texture;
        vk::raii::Sampler sampler;
    };
    struct Pass {
        std::string name;
        /// One descriptor set for each level written.
        gpu::Pipeline pipeline;
        std::uint32_t first_level;
        std::vector<vk::Extent2D> level_sizes;
        /// Of each level; 1 for a map of two dimensions.
        std::uint32_t slices;
    };

    void record_pass(const vk::raii::CommandBuffer& commands, const Pass& pass) const;
    Pass make_pass(const Technique& technique, const PassDeclaration& declaration, const ParameterValues& parameters,
                   const SceneOnDevice::Textures& scene) const;

    /// The height map in place of one that is idle.
    gpu::Binding bind_map(std::size_t index, vk::ImageLayout layout) const;

    const gpu::Device* device_;
    const SceneOnDevice::Textures* heights_;
    /// As in the manifest; empty where one is idle.
    std::vector<std::optional<Map>> maps_;
    std::vector<Pass> passes_;
};

/// How the images of maps are used.
inline constexpr auto map_usage =
    vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eTransferSrc;

vk::Format vulkan_format(const MapDeclaration& map);
vk::Extent2D map_extent(const MapDeclaration& map, Resolution height_map);

}  // namespace reliefbench
