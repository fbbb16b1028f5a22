#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"
#include "technique/preparation_pass.hpp"
#include "technique/program.hpp"
#include "technique/renderer.hpp"
#include "technique/scene_textures.hpp"

#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// The textures that a technique derives from the height map, and the compute passes that fill them. A map that no pass
/// writes under these parameters is a single texel. Technique and scene must outlive it.
class DerivedMaps {
public:
    DerivedMaps(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
                const SceneOnDevice::Textures& scene);

    /// Runs the passes in the manifest's order, timing each, or takes what was kept of an earlier preparation, and
    /// leaves the maps ready for draws.
    Preparation prepare(const PreparationSettings& settings);

    std::vector<gpu::Binding> draw_bindings() const;

    /// Identifies the content of the maps: the passes as compiled with the parameters that they use, the height map,
    /// and the device with its driver.
    std::string key() const;

private:
    /// Makes the maps `settings.samples` times. False when it was given up.
    bool make(const PreparationSettings& settings, Preparation& result);
    bool take_kept(const PreparationSettings& settings, Preparation& result);
    void keep(const PreparationSettings& settings, const Preparation& result) const;
    bool runs(const PassDeclaration& pass) const;
    bool is_written(const std::string& map) const;
    /// Conditions may leave out passes, but not some levels of a map that others write: that is an Error.
    void check_levels(const MapDeclaration& map) const;
    DerivedMap make_map(const MapDeclaration& declaration) const;
    /// Of all maps that there are.
    void change_layouts(vk::ImageLayout from, vk::ImageLayout to) const;
    /// False when it was given up.
    bool run_pass(const PreparationPass& pass, const PreparationSettings& settings, Preparation& result) const;

    const gpu::Device* device_;
    const Technique* technique_;
    const SceneOnDevice::Textures* scene_;
    ParameterValues parameters_;
    /// Those that run under the parameters.
    std::vector<CompiledPass> passes_;
    /// In the manifest's order; scratch maps exist only while others are made.
    std::vector<std::optional<DerivedMap>> maps_;
    /// Whether they have been made once with their passes' loops looked at.
    bool loops_probed_ = false;
};

/// How the images of maps are used.
inline constexpr auto map_usage = vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eStorage |
                                  vk::ImageUsageFlagBits::eTransferSrc | vk::ImageUsageFlagBits::eTransferDst;

vk::Format vulkan_format(const MapDeclaration& map);
vk::Extent2D map_extent(const MapDeclaration& map, Resolution height_map);

}  // namespace reliefbench
