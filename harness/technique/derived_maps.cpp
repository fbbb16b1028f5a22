#include "technique/derived_maps.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"
#include "gpu/commands.hpp"
#include "technique/map_cache.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <span>
#include <utility>

namespace reliefbench {

namespace {

constexpr double ms_per_s = 1000;

double total_ms(const Preparation& preparation) {
    double sum = 0;
    for (const auto& [pass, samples] : preparation.pass_ms)
        sum = std::accumulate(samples.begin(), samples.end(), sum);
    return sum;
}

/// Empty while it may go on. Slices that get cheaper leave no estimate: only what has passed counts.
std::string reason_to_give_up(const PassDeclaration& pass, const SlicePlan& plan, double earlier_ms, double limit_s) {
    const bool over = earlier_ms + plan.elapsed_ms() > limit_s * ms_per_s;
    const bool will_be = plan.is_estimate_sound() && earlier_ms + plan.estimated_ms() > limit_s * ms_per_s;
    if (plan.is_done() || !(pass.sliced->ends_early ? over : over || will_be)) return {};
    return fmt::format(
        "preparing its maps would take {} {:.0f} s (the pass '{}' had done {:.3g} % after {:.1f} s), more than the "
        "limit of {:g} s; raise preparation.limit_s to have it done",
        pass.sliced->ends_early ? "up to" : "about", (earlier_ms + plan.estimated_ms()) / ms_per_s, pass.name,
        100 * plan.fraction(), (earlier_ms + plan.elapsed_ms()) / ms_per_s, limit_s);
}

}  // namespace

vk::Format vulkan_format(const MapDeclaration& map) {
    static const std::array<std::pair<std::string_view, vk::Format>, 8> formats{{
        {"r8", vk::Format::eR8Unorm},
        {"r16", vk::Format::eR16Unorm},
        {"rg16", vk::Format::eR16G16Unorm},
        {"r32f", vk::Format::eR32Sfloat},
        {"rg32f", vk::Format::eR32G32Sfloat},
        {"rgba8", vk::Format::eR8G8B8A8Unorm},
        {"rgba16", vk::Format::eR16G16B16A16Unorm},
        {"rgba32f", vk::Format::eR32G32B32A32Sfloat},
    }};
    for (const auto& [name, format] : formats) {
        if (name == map.format) return format;
    }
    fail("map '{}' has the unknown format '{}'", map.name, map.format);
}

vk::Extent2D map_extent(const MapDeclaration& map, Resolution height_map) {
    const auto width = static_cast<std::uint32_t>(height_map.width);
    const auto height = static_cast<std::uint32_t>(height_map.height);
    if (map.size == MapDeclaration::Size::height_map) return {width, height};
    return {std::bit_ceil(width), std::bit_ceil(height)};
}

DerivedMaps::DerivedMaps(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
                         const SceneOnDevice::Textures& scene)
<<<<<<< HEAD
    : device_(&device), heights_(&scene) {
    for (const MapDeclaration& map : technique.manifest.maps) {
        if (!all_hold(map.only_with, parameters)) {
            maps_.emplace_back();
            continue;
        }
        const vk::Extent2D extent = map_extent(map, scene.size);
        const std::uint32_t levels = map.mip_chain ? gpu::full_mip_chain(extent) : 1;
        const vk::Filter filter = map.linear_filter ? vk::Filter::eLinear : vk::Filter::eNearest;
        const auto slices = static_cast<std::uint32_t>(map.slices(parameters));
        maps_.emplace_back(Map{gpu::Texture(device, extent, vulkan_format(map), levels, map_usage, slices),
                               gpu::make_sampler(device, {.filter = filter})});
    }
    for (const PassDeclaration& pass : technique.manifest.passes) {
        if (maps_[index_of_map(technique.manifest, pass.writes)])
            passes_.push_back(make_pass(technique, pass, parameters, scene));
    }
}

DerivedMaps::Pass DerivedMaps::make_pass(const Technique& technique, const PassDeclaration& declaration,
                                         const ParameterValues& parameters,
                                         const SceneOnDevice::Textures& scene) const {
    const Manifest& manifest = technique.manifest;
    const Map& target = *maps_[index_of_map(manifest, declaration.writes)];
    const gpu::ComputePipelineOptions options{.shader = compile_pass(*device_, technique, parameters, declaration),
                                              .constants = parameter_constants(manifest, parameters),
                                              .push_constant_bytes = sizeof(std::int32_t)};
    const bool above_base = declaration.levels == PassDeclaration::Levels::above_base;
    const std::uint32_t first_level = above_base ? 1 : 0;
    const std::uint32_t end_level = above_base ? target.texture.levels : 1;
    std::vector<std::vector<gpu::Binding>> sets;
    std::vector<vk::Extent2D> sizes;
    for (std::uint32_t level = first_level; level < end_level; ++level) {
        std::vector<gpu::Binding>& bindings = sets.emplace_back(scene.height_bindings());
        bindings.push_back(gpu::storage_image(binding::target_map, target.texture.level_views[level]));
        if (above_base)
            bindings.push_back(gpu::sampled_image(binding::previous_map, target.texture.level_views[level - 1],
                                                  scene.nearest_repeat, vk::ImageLayout::eGeneral));
        for (const std::size_t map : maps_before(manifest, declaration))
            bindings.push_back(bind_map(map, vk::ImageLayout::eGeneral));
        sizes.push_back(target.texture.level_extent(level));
    }
    Pass pass{.name = declaration.name,
              .pipeline = {},
              .first_level = first_level,
              .level_sizes = sizes,
              .slices = std::max(target.texture.slices, 1u)};
    // A map of one texel has no level above its base.
    if (!sets.empty()) pass.pipeline = gpu::make_compute_pipeline(*device_, options, sets);
    return pass;
}

void DerivedMaps::record_pass(const vk::raii::CommandBuffer& commands, const Pass& pass) const {
    for (std::size_t i = 0; i < pass.level_sizes.size(); ++i) {
        const auto level = static_cast<std::int32_t>(pass.first_level + i);
        pass.pipeline.bind(commands, i);
        commands.pushConstants<std::int32_t>(pass.pipeline.layout(), vk::ShaderStageFlagBits::eCompute, 0, level);
        commands.dispatch(groups(pass.level_sizes[i].width), groups(pass.level_sizes[i].height), pass.slices);
        gpu::full_barrier(commands);
    }
}

Preparation DerivedMaps::prepare(int samples) {
    Preparation result;
    std::vector<const gpu::Texture*> textures;
    for (const std::optional<Map>& map : maps_) {
        if (!map) continue;
        textures.push_back(&map->texture);
        result.bytes += map->texture.bytes;
    }
    if (textures.empty()) return result;

    for (int sample = 0; sample < samples; ++sample) {
        const gpu::Timestamps timestamps(*device_,
                                         static_cast<std::uint32_t>(std::max<std::size_t>(passes_.size(), 1)));
        gpu::submit_and_wait(*device_, "prepare the derived maps", [&](const vk::raii::CommandBuffer& commands) {
            timestamps.reset(commands);
            for (const gpu::Texture* texture : textures)
                gpu::change_layout(commands, *texture->image, texture->all(), vk::ImageLayout::eUndefined,
                                   vk::ImageLayout::eGeneral);
            for (std::uint32_t i = 0; i < passes_.size(); ++i) {
                timestamps.start(commands, i);
                record_pass(commands, passes_[i]);
                timestamps.end(commands, i);
            }
            for (const gpu::Texture* texture : textures)
                gpu::change_layout(commands, *texture->image, texture->all(), vk::ImageLayout::eGeneral,
                                   vk::ImageLayout::eShaderReadOnlyOptimal);
=======
    : device_(&device), technique_(&technique), scene_(&scene), parameters_(parameters) {
    for (const PassDeclaration& pass : technique.manifest.passes) {
        if (pass.runs_with(parameters)) passes_.push_back(compile(device, technique, pass, parameters));
    }
    for (const MapDeclaration& map : technique.manifest.maps) {
        check_levels(map);
        maps_.emplace_back();
        if (!map.scratch) maps_.back().emplace(make_map(map));
    }
}

bool DerivedMaps::is_written(const std::string& map) const {
    return std::ranges::any_of(passes_, [&](const CompiledPass& pass) { return pass.declaration->writes == map; });
}

void DerivedMaps::check_levels(const MapDeclaration& map) const {
    const auto writes = [&](PassDeclaration::Levels levels) {
        return std::ranges::any_of(passes_, [&](const CompiledPass& pass) {
            return pass.declaration->writes == map.name && pass.declaration->levels == levels;
>>>>>>> a05bc10 (Preparation that takes long runs in slices, is limited, and is kept on disk)
        });
    };
    const bool base = writes(PassDeclaration::Levels::base);
    const bool above = writes(PassDeclaration::Levels::above_base);
    if (map.mip_chain ? base == above : !above) return;
    fail(
        "technique '{}': under these parameters its passes write only {} of the map '{}'; let both passes have the "
        "same \"only_with\"",
        technique_->manifest.id, base ? "the base" : "the levels above the base", map.name);
}

DerivedMap DerivedMaps::make_map(const MapDeclaration& declaration) const {
    const bool written = is_written(declaration.name);
    const vk::Extent2D extent = written ? map_extent(declaration, scene_->size) : vk::Extent2D{1, 1};
    const std::uint32_t levels = written && declaration.mip_chain ? gpu::full_mip_chain(extent) : 1;
    const vk::Filter filter = declaration.linear_filter ? vk::Filter::eLinear : vk::Filter::eNearest;
    const auto slices = static_cast<std::uint32_t>(written ? declaration.slices(parameters_) : declaration.is_volume());
    return {gpu::Texture(*device_, extent, vulkan_format(declaration), levels, map_usage, slices),
            gpu::make_sampler(*device_, {.filter = filter})};
}

Preparation DerivedMaps::prepare(const PreparationSettings& settings) {
    Preparation result;
    for (const std::optional<DerivedMap>& map : maps_) {
        if (map) result.bytes += map->texture.bytes;
    }
    if (maps_.empty()) return result;
    const bool may_take_long =
        std::ranges::any_of(passes_, [](const CompiledPass& pass) { return pass.declaration->sliced.has_value(); });
    const bool keeps = may_take_long && !settings.cache.empty();
    if (keeps && settings.take_kept && take_kept(settings, result)) return result;
    if (make(settings, result) && keeps) keep(settings, result);
    return result;
}

<<<<<<< HEAD
gpu::Binding DerivedMaps::bind_map(std::size_t index, vk::ImageLayout layout) const {
    const std::uint32_t place = binding::first_derived_map + static_cast<std::uint32_t>(index);
    const std::optional<Map>& map = maps_[index];
    if (map) return gpu::sampled_image(place, map->texture.view, map->sampler, layout);
    return gpu::sampled_image(place, heights_->heights.view, heights_->nearest_repeat,
                              vk::ImageLayout::eShaderReadOnlyOptimal);
=======
bool DerivedMaps::make(const PreparationSettings& settings, Preparation& result) {
    for (std::size_t map = 0; map < maps_.size(); ++map) {
        const MapDeclaration& declaration = technique_->manifest.maps[map];
        if (declaration.scratch) maps_[map].emplace(make_map(declaration));
    }
    bool finished = true;
    {
        std::vector<PreparationPass> passes;
        for (const CompiledPass& pass : passes_)
            passes.emplace_back(*device_, technique_->manifest, pass, maps_, *scene_);
        for (int sample = 0; sample < settings.samples && finished; ++sample) {
            change_layouts(vk::ImageLayout::eUndefined, vk::ImageLayout::eGeneral);
            finished = std::ranges::all_of(
                passes, [&](const PreparationPass& pass) { return run_pass(pass, settings, result); });
            change_layouts(vk::ImageLayout::eGeneral, vk::ImageLayout::eShaderReadOnlyOptimal);
        }
    }
    for (std::size_t map = 0; map < maps_.size(); ++map) {
        if (technique_->manifest.maps[map].scratch) maps_[map].reset();
    }
    return finished;
}

bool DerivedMaps::run_pass(const PreparationPass& pass, const PreparationSettings& settings,
                           Preparation& result) const {
    const PassDeclaration& declaration = pass.declaration();
    if (!declaration.sliced) {
        result.pass_ms[declaration.name].push_back(pass.run());
        return true;
    }
    // Of this preparation; earlier samples are not its cost.
    const double earlier_ms = result.pass_ms.contains(declaration.name) ? 0 : total_ms(result);
    SlicePlan plan = pass.plan(scene_->size);
    pass.warm_up();
    while (!plan.is_done()) {
        plan.took(pass.run(plan.next()));
        result.given_up = reason_to_give_up(declaration, plan, earlier_ms, settings.limit_s);
        if (!result.given_up.empty()) return false;
        if (settings.on_progress) {
            settings.on_progress(
                {declaration.name, plan.fraction(), (plan.estimated_ms() - plan.elapsed_ms()) / ms_per_s});
        }
    }
    result.pass_ms[declaration.name].push_back(plan.elapsed_ms());
    return true;
}

void DerivedMaps::change_layouts(vk::ImageLayout from, vk::ImageLayout to) const {
    gpu::submit_and_wait(*device_, "prepare the derived maps", [&](const vk::raii::CommandBuffer& commands) {
        for (const std::optional<DerivedMap>& map : maps_) {
            if (map) gpu::change_layout(commands, *map->texture.image, map->texture.all(), from, to);
        }
    });
}

std::string DerivedMaps::key() const {
    const gpu::DeviceInfo& device = device_->info();
    std::string text = fmt::format("height map {}\ndevice {} {} {}\n", scene_->height_map_hash, device.name,
                                   device.driver, device.driver_version);
    for (const MapDeclaration& map : technique_->manifest.maps)
        text += fmt::format("map {} {} {} {} {}\n", map.name, map.format, static_cast<int>(map.size), map.mip_chain,
                            map.slices(parameters_));
    for (const CompiledPass& pass : passes_) {
        text += fmt::format("pass {} {} {} {}", pass.declaration->name, pass.declaration->writes,
                            static_cast<int>(pass.declaration->levels),
                            content_hash(std::as_bytes(std::span(*pass.shader.code))));
        for (const auto& [constant, value] : pass.constants)
            text += fmt::format(" {}={}", constant, value);
        text += '\n';
    }
    return content_hash(text);
}

bool DerivedMaps::take_kept(const PreparationSettings& settings, Preparation& result) {
    const std::optional<KeptMaps> kept = read_kept_maps(settings.cache, key());
    if (!kept) return false;
    auto level = kept->levels.begin();
    for (const std::optional<DerivedMap>& map : maps_) {
        if (!map) continue;
        const auto count = std::min<std::ptrdiff_t>(map->texture.levels, kept->levels.end() - level);
        if (!gpu::upload_levels(*device_, map->texture, std::span(level, level + count))) return false;
        level += count;
    }
    result.pass_ms = kept->pass_ms;
    result.kept = true;
    return true;
}

void DerivedMaps::keep(const PreparationSettings& settings, const Preparation& result) const {
    KeptMaps kept{.pass_ms = result.pass_ms, .levels = {}};
    for (const std::optional<DerivedMap>& map : maps_) {
        for (std::uint32_t level = 0; map && level < map->texture.levels; ++level)
            kept.levels.push_back(
                gpu::read_texture(*device_, map->texture, level, vk::ImageLayout::eShaderReadOnlyOptimal));
    }
    write_kept_maps(settings.cache, key(), kept);
>>>>>>> a05bc10 (Preparation that takes long runs in slices, is limited, and is kept on disk)
}

std::vector<gpu::Binding> DerivedMaps::draw_bindings() const {
    std::vector<gpu::Binding> bindings;
<<<<<<< HEAD
    for (std::size_t i = 0; i < maps_.size(); ++i)
        bindings.push_back(bind_map(i, vk::ImageLayout::eShaderReadOnlyOptimal));
=======
    for (std::size_t i = 0; i < maps_.size(); ++i) {
        if (!maps_[i] || technique_->manifest.maps[i].scratch) continue;
        bindings.push_back(gpu::sampled_image(binding::first_derived_map + static_cast<std::uint32_t>(i),
                                              maps_[i]->texture.view, maps_[i]->sampler,
                                              vk::ImageLayout::eShaderReadOnlyOptimal));
    }
>>>>>>> a05bc10 (Preparation that takes long runs in slices, is limited, and is kept on disk)
    return bindings;
}

}  // namespace reliefbench
