#include "technique/preparation_pass.hpp"

#include "core/error.hpp"
#include "gpu/commands.hpp"
#include "gpu/timers.hpp"
#include "gpu/used_constants.hpp"
#include "technique/program.hpp"

#include <algorithm>
#include <cassert>

namespace reliefbench {

namespace {

/// Of prepare.comp, on each side.
constexpr std::uint32_t workgroup_side = 8;

/// The mirror of PassRange in prepare.comp.
struct PassRange {
    std::int32_t level = 0;
    std::int32_t slice_begin = 0;
    std::int32_t slice_end = 0;
    std::int32_t first_row = 0;
};

std::size_t index_of_map(const Manifest& manifest, const std::string& name) {
    for (std::size_t i = 0; i < manifest.maps.size(); ++i) {
        if (manifest.maps[i].name == name) return i;
    }
    fail("technique '{}' has no map '{}'", manifest.id, name);
}

std::uint32_t groups(std::uint32_t texels) {
    return (texels + workgroup_side - 1) / workgroup_side;
}

}  // namespace

CompiledPass compile(const gpu::Device& device, const Technique& technique, const PassDeclaration& declaration,
                     const ParameterValues& parameters) {
    CompiledPass pass{&declaration, compile_pass(device, technique, parameters, declaration), {}};
    const std::set<std::uint32_t> used = gpu::used_constants(*pass.shader.code);
    for (const auto& [id, value] : parameter_constants(technique.manifest, parameters)) {
        if (used.contains(id)) pass.constants.emplace(id, value);
    }
    return pass;
}

PreparationPass::PreparationPass(const gpu::Device& device, const Manifest& manifest, const CompiledPass& compiled,
                                 const std::vector<std::optional<DerivedMap>>& maps,
                                 const SceneOnDevice::Textures& scene)
    : device_(&device), declaration_(compiled.declaration) {
    const gpu::Texture& target = maps[index_of_map(manifest, declaration_->writes)]->texture;
    slices_ = std::max(target.slices, 1u);
    const bool above_base = declaration_->levels == PassDeclaration::Levels::above_base;
    first_level_ = above_base ? 1 : 0;
    const std::uint32_t end_level = above_base ? target.levels : 1;
    std::vector<std::vector<gpu::Binding>> sets;
    for (std::uint32_t level = first_level_; level < end_level; ++level) {
        std::vector<gpu::Binding>& bindings = sets.emplace_back(scene.height_bindings());
        bindings.push_back(gpu::storage_image(binding::target_map, target.level_views[level]));
        if (above_base)
            bindings.push_back(gpu::sampled_image(binding::previous_map, target.level_views[level - 1],
                                                  scene.nearest_repeat, vk::ImageLayout::eGeneral));
        for (const std::size_t map : maps_before(manifest, *declaration_))
            bindings.push_back(gpu::sampled_image(binding::first_derived_map + static_cast<std::uint32_t>(map),
                                                  maps[map]->texture.view, maps[map]->sampler,
                                                  vk::ImageLayout::eGeneral));
        level_sizes_.push_back(target.level_extent(level));
    }
    const gpu::ComputePipelineOptions options{
        .shader = compiled.shader, .constants = compiled.constants, .push_constant_bytes = sizeof(PassRange)};
    // A map of one texel has no level above its base.
    if (!sets.empty()) pipeline_ = gpu::make_compute_pipeline(device, options, sets);
}

SlicePlan PreparationPass::plan(Resolution height_map) const {
    assert(declaration_->sliced && level_sizes_.size() == 1);
    const Slicing& slicing = *declaration_->sliced;
    const vk::Extent2D size = level_sizes_.front();
    const std::int64_t row = std::int64_t{size.width} * slices_;
    if (slicing.over == Slicing::Over::rows) return {groups(size.height), row * workgroup_side, slicing.iterations};
    return {std::int64_t{height_map.width} * height_map.height, row * size.height, slicing.iterations};
}

double PreparationPass::run() const {
    return dispatch(Slice{}, std::nullopt);
}

double PreparationPass::run(const Slice& slice) const {
    return declaration_->sliced->over == Slicing::Over::sources ? dispatch(slice, std::nullopt)
                                                                : dispatch(Slice{}, slice);
}

void PreparationPass::warm_up() const {
    run(declaration_->sliced->over == Slicing::Over::sources ? Slice{} : Slice{0, 1});
}

double PreparationPass::dispatch(const Slice& sources, const std::optional<Slice>& group_rows) const {
    const gpu::Timestamps timestamps(*device_, 1);
    gpu::submit_and_wait(*device_, "prepare the derived maps", [&](const vk::raii::CommandBuffer& commands) {
        timestamps.reset(commands);
        timestamps.start(commands, 0);
        for (std::size_t i = 0; i < level_sizes_.size(); ++i) {
            const Slice rows = group_rows.value_or(Slice{0, groups(level_sizes_[i].height)});
            const PassRange range{.level = static_cast<std::int32_t>(first_level_ + i),
                                  .slice_begin = static_cast<std::int32_t>(sources.begin),
                                  .slice_end = static_cast<std::int32_t>(sources.end),
                                  .first_row = static_cast<std::int32_t>(rows.begin * workgroup_side)};
            pipeline_.bind(commands, i);
            commands.pushConstants<PassRange>(pipeline_.layout(), vk::ShaderStageFlagBits::eCompute, 0, range);
            commands.dispatch(groups(level_sizes_[i].width), static_cast<std::uint32_t>(rows.end - rows.begin),
                              slices_);
            gpu::full_barrier(commands);
        }
        timestamps.end(commands, 0);
    });
    return timestamps.milliseconds().front();
}

}  // namespace reliefbench
