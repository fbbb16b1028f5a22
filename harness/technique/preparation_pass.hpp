#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "technique/scene_textures.hpp"
#include "technique/slice_plan.hpp"
#include "technique/technique.hpp"

#include <optional>
#include <vector>

namespace reliefbench {

struct DerivedMap {
    gpu::Texture texture;
    vk::raii::Sampler sampler;
};

/// A pass of the preparation, compiled, with the parameters that it uses.
struct CompiledPass {
    const PassDeclaration* declaration = nullptr;
    gpu::CompiledStage shader;
    gpu::SpecializationValues constants;
};

CompiledPass compile(const gpu::Device& device, const Technique& technique, const PassDeclaration& declaration,
                     const ParameterValues& parameters);

/// A pass bound to the textures that it reads and writes, which are all in eGeneral while it runs.
class PreparationPass {
public:
    /// `maps` in the manifest's order; those that the pass may read or writes exist.
    PreparationPass(const gpu::Device& device, const Manifest& manifest, const CompiledPass& compiled,
                    const std::vector<std::optional<DerivedMap>>& maps, const SceneOnDevice::Textures& scene);

    const PassDeclaration& declaration() const { return *declaration_; }
    /// Over all its levels, in one submission, which is waited for. Milliseconds.
    double run() const;

    /// How a sliced pass is cut: over the texels of the height map or over rows of workgroups.
    SlicePlan plan(Resolution height_map) const;
    /// As `run`, one slice.
    double run(const Slice& slice) const;
    /// Lets the driver compile what it compiles at first use; what it writes the first slice writes again.
    void warm_up() const;

private:
    /// Rows of workgroups; nothing: all of each level.
    double dispatch(const Slice& sources, const std::optional<Slice>& group_rows) const;

    const gpu::Device* device_;
    const PassDeclaration* declaration_;
    /// One descriptor set for each level written.
    gpu::Pipeline pipeline_;
    std::uint32_t first_level_;
    std::vector<vk::Extent2D> level_sizes_;
    /// Of each level; 1 for a map of two dimensions.
    std::uint32_t slices_;
};

}  // namespace reliefbench
