#include "technique/preparation_pass.hpp"

#include "core/error.hpp"
#include "gpu/commands.hpp"
#include "gpu/loop_limit.hpp"
#include "gpu/timers.hpp"
#include "gpu/used_constants.hpp"
#include "technique/program.hpp"

#include <algorithm>
#include <cassert>

namespace reliefbench {

namespace {

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

/// Work groups of so many texels that cover them.
std::uint32_t groups(std::uint32_t texels, std::uint32_t texels_each) {
    return (texels + texels_each - 1) / texels_each;
}

}  // namespace

CompiledPass compile(const gpu::Device& device, const Technique& technique, const PassDeclaration& declaration,
                     const ParameterValues& parameters) {
    CompiledPass pass{
        &declaration, compile_pass(device, technique, parameters, declaration, Variant::timed), std::nullopt, {}, {}};
    if (gpu::loop_limit(device))
        pass.probed = compile_pass(device, technique, parameters, declaration, Variant::probed);
    const std::set<std::uint32_t> used = gpu::used_constants(*pass.shader.code);
    const auto declared = gpu::read_interface(*pass.shader.code, vk::ShaderStageFlagBits::eCompute).constants;
    for (const auto& [name, value] : parameter_constants(technique.manifest, parameters)) {
        const std::uint32_t id = declared.at(name);
        if (!used.contains(id)) continue;
        pass.constants.emplace(name, value);
        pass.values_by_id.emplace(id, value);
    }
    return pass;
}

PreparationPass::PreparationPass(const gpu::Device& device, const Technique& technique, const CompiledPass& compiled,
                                 const std::vector<std::optional<DerivedMap>>& maps,
                                 const SceneOnDevice::Textures& scene)
    : device_(&device), technique_(&technique), declaration_(compiled.declaration) {
    const Manifest& manifest = technique.manifest;
    const gpu::Texture& target = maps[index_of_map(manifest, declaration_->writes)]->texture;
    slices_ = std::max(target.slices, 1u);
    const bool above_base = declaration_->levels == PassDeclaration::Levels::above_base;
    first_level_ = above_base ? 1 : 0;
    const std::uint32_t end_level = above_base ? target.levels : 1;
    std::vector<std::vector<gpu::Binding>> sets;
    for (std::uint32_t level = first_level_; level < end_level; ++level) {
        std::vector<gpu::Binding>& bindings = sets.emplace_back(scene.height_bindings());
        bindings.push_back(gpu::storage_image("target_map", target.level_views[level]));
        if (above_base)
            bindings.push_back(gpu::sampled_image("previous_map", target.level_views[level - 1], scene.nearest_repeat,
                                                  vk::ImageLayout::eGeneral));
        for (const std::size_t map : maps_before(manifest, *declaration_))
            bindings.push_back(gpu::sampled_image(manifest.maps[map].name, maps[map]->texture.view, maps[map]->sampler,
                                                  vk::ImageLayout::eGeneral));
        level_sizes_.push_back(target.level_extent(level));
    }
    // A map of one texel has no level above its base.
    if (sets.empty()) return;
    gpu::ComputePipelineOptions options{.shader = compiled.shader, .constants = compiled.constants};
    pipeline_ = gpu::make_compute_pipeline(device, options, sets);
    if (pipeline_.interface().push_constant_bytes != sizeof(PassRange))
        fail("prepare.comp declares {} bytes of push constants; {} are pushed",
             pipeline_.interface().push_constant_bytes, sizeof(PassRange));
    if (!compiled.probed) return;
    WorkCounters work(device, 0);
    for (std::vector<gpu::Binding>& bindings : sets)
        bindings.push_back(gpu::storage_buffer(WorkCounters::name, work.buffer()));
    options.shader = *compiled.probed;
    probe_.emplace(Probe{gpu::make_compute_pipeline(device, options, sets), std::move(work)});
}

SlicePlan PreparationPass::plan(Resolution height_map) const {
    assert(declaration_->sliced && level_sizes_.size() == 1);
    const Slicing& slicing = *declaration_->sliced;
    const vk::Extent2D size = level_sizes_.front();
    const std::int64_t row = std::int64_t{size.width} * slices_;
    const std::uint32_t group_rows = pipeline_.interface().local_size[1];
    if (slicing.over == Slicing::Over::rows)
        return {groups(size.height, group_rows), row * group_rows, slicing.iterations};
    return {std::int64_t{height_map.width} * height_map.height, row * size.height, slicing.iterations};
}

double PreparationPass::run() const {
    return time({});
}

double PreparationPass::run(const Slice& slice) const {
    return time(range_of(slice));
}

void PreparationPass::warm_up() const {
    run(declaration_->sliced->over == Slicing::Over::sources ? Slice{} : Slice{0, 1});
}

void PreparationPass::probe() const {
    probe_range({});
}

void PreparationPass::probe(const Slice& slice) const {
    probe_range(range_of(slice));
}

PreparationPass::Range PreparationPass::range_of(const Slice& slice) const {
    if (declaration_->sliced->over == Slicing::Over::sources) return {slice, std::nullopt};
    return {{}, slice};
}

double PreparationPass::time(const Range& range) const {
    const gpu::Timestamps timestamps(*device_, 1);
    gpu::submit_and_wait(*device_, "prepare the derived maps", [&](const vk::raii::CommandBuffer& commands) {
        timestamps.reset(commands);
        timestamps.start(commands, 0);
        dispatch(commands, pipeline_, range);
        timestamps.end(commands, 0);
    });
    return timestamps.milliseconds().front();
}

void PreparationPass::dispatch(const vk::raii::CommandBuffer& commands, const gpu::Pipeline& pipeline,
                               const Range& range) const {
    const auto& [group_columns, group_rows, group_slices] = pipeline.interface().local_size;
    for (std::size_t i = 0; i < level_sizes_.size(); ++i) {
        const Slice rows = range.group_rows.value_or(Slice{0, groups(level_sizes_[i].height, group_rows)});
        const PassRange values{.level = static_cast<std::int32_t>(first_level_ + i),
                               .slice_begin = static_cast<std::int32_t>(range.sources.begin),
                               .slice_end = static_cast<std::int32_t>(range.sources.end),
                               .first_row = static_cast<std::int32_t>(rows.begin * group_rows)};
        pipeline.bind(commands, i);
        commands.pushConstants<PassRange>(pipeline.layout(), vk::ShaderStageFlagBits::eCompute, 0, values);
        commands.dispatch(groups(level_sizes_[i].width, group_columns),
                          static_cast<std::uint32_t>(rows.end - rows.begin), groups(slices_, group_slices));
        gpu::full_barrier(commands);
    }
}

void PreparationPass::probe_range(const Range& range) const {
    if (!probe_) return;
    gpu::submit_and_wait(*device_, "probe a preparation pass", [&](const vk::raii::CommandBuffer& commands) {
        probe_->work.clear(commands);
        dispatch(commands, probe_->pipeline, range);
    });
    if (probe_->work.stages().cuts == 0) return;
    fail("technique '{}': the pass '{}' does not come to its end, so that its map '{}' would be another one: {}; {}",
         technique_->manifest.id, declaration_->name, declaration_->writes, gpu::describe_loop_limit(*device_),
         remedy());
}

std::string PreparationPass::remedy() const {
    const std::string sooner = "give its loops an end that is sooner";
    if (!declaration_->sliced) return sooner + ", or cut its search into slices (\"sliced\" in technique.json)";
    if (declaration_->sliced->over == Slicing::Over::rows)
        return "slices of rows leave each texel all of its iterations: " + sooner +
               ", or cut the pass over \"sources\"";
    return fmt::format(
        "its slices are as long as \"iterations\": {} in technique.json allows, which must be as many as a texel "
        "searched takes at most",
        declaration_->sliced->iterations);
}

}  // namespace reliefbench
