#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "technique/scene_textures.hpp"
#include "technique/slice_plan.hpp"
#include "technique/technique.hpp"
#include "technique/work_counters.hpp"

#include <map>
#include <optional>
#include <string>
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
    /// Where the device ends loops.
    std::optional<gpu::CompiledStage> probed;
    gpu::SpecializationValues constants;
    /// The same by their constant_id, in whose order the key of the maps has them.
    std::map<std::uint32_t, std::uint32_t> values_by_id;
};

CompiledPass compile(const gpu::Device& device, const Technique& technique, const PassDeclaration& declaration,
                     const ParameterValues& parameters);

/// A pass bound to the textures that it reads and writes, which are all in eGeneral while it runs.
class PreparationPass {
public:
    /// `maps` in the manifest's order; those that the pass may read or writes exist.
    PreparationPass(const gpu::Device& device, const Technique& technique, const CompiledPass& compiled,
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

    /// Does the work of `run` without writing anything. Throws Error where the device ended its loops, which makes the
    /// map another one than the pass's; where the device ends none, it does nothing. With a slice: before that is run.
    void probe() const;
    void probe(const Slice& slice) const;

private:
    /// The work of a dispatch: texels searched, and rows of workgroups (nothing: all of each level).
    struct Range {
        Slice sources;
        std::optional<Slice> group_rows;
    };
    struct Probe {
        gpu::Pipeline pipeline;
        WorkCounters work;
    };

    Range range_of(const Slice& slice) const;
    double time(const Range& range) const;
    void dispatch(const vk::raii::CommandBuffer& commands, const gpu::Pipeline& pipeline, const Range& range) const;
    void probe_range(const Range& range) const;
    std::string remedy() const;

    const gpu::Device* device_;
    const Technique* technique_;
    const PassDeclaration* declaration_;
    /// One descriptor set for each level written.
    gpu::Pipeline pipeline_;
    std::optional<Probe> probe_;
    std::uint32_t first_level_;
    std::vector<vk::Extent2D> level_sizes_;
    /// Of each level; 1 for a map of two dimensions.
    std::uint32_t slices_;
};

}  // namespace reliefbench
