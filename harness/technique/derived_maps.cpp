#include "technique/derived_maps.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/number_text.hpp"
#include "gpu/commands.hpp"
#include "gpu/loop_limit.hpp"
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

/// Whether the slice of this number has its loops looked at, which takes as long as the slice: the first ones, of which
/// each is longer than the one before, and then an eighth.
bool is_probed(int slice) {
    constexpr int slices_that_grow = 8;
    constexpr int every = 8;
    return slice < slices_that_grow || slice % every == 0;
}

/// Empty while it may go on. Slices that get cheaper leave no estimate: only what has passed counts.
std::string reason_to_give_up(const PassDeclaration& pass, const SlicePlan& plan, double earlier_ms, double limit_s) {
    const bool over = earlier_ms + plan.elapsed_ms() > limit_s * ms_per_s;
    const bool will_be = plan.is_estimate_sound() && earlier_ms + plan.estimated_ms() > limit_s * ms_per_s;
    if (plan.is_done() || !(pass.sliced->ends_early ? over : over || will_be)) return {};
    return fmt::format(
        "preparing its maps would take {} {} s (the pass '{}' had done {:.3g} % after {} s), more than the limit of "
        "{:g} s; raise preparation.limit_s (--preparation-limit) to have it done",
        pass.sliced->ends_early ? "up to" : "about", figure_above((earlier_ms + plan.estimated_ms()) / ms_per_s),
        pass.name, 100 * plan.fraction(), figure_above((earlier_ms + plan.elapsed_ms()) / ms_per_s), limit_s);
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
    : device_(&device), technique_(&technique), scene_(&scene), parameters_(parameters) {
    for (const PassDeclaration& pass : technique.manifest.passes) {
        if (runs(pass)) passes_.push_back(compile(device, technique, pass, parameters));
    }
    for (const MapDeclaration& map : technique.manifest.maps) {
        check_levels(map);
        maps_.emplace_back();
        if (!map.scratch) maps_.back().emplace(make_map(map));
    }
}

bool DerivedMaps::runs(const PassDeclaration& pass) const {
    const auto& maps = technique_->manifest.maps;
    const auto target = std::ranges::find(maps, pass.writes, &MapDeclaration::name);
    return all_hold(pass.only_with, parameters_) && all_hold(target->only_with, parameters_);
}

bool DerivedMaps::is_written(const std::string& map) const {
    return std::ranges::any_of(passes_, [&](const CompiledPass& pass) { return pass.declaration->writes == map; });
}

void DerivedMaps::check_levels(const MapDeclaration& map) const {
    const auto writes = [&](PassDeclaration::Levels levels) {
        return std::ranges::any_of(passes_, [&](const CompiledPass& pass) {
            return pass.declaration->writes == map.name && pass.declaration->levels == levels;
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
    for (std::size_t map = 0; map < maps_.size(); ++map) {
        if (maps_[map] && is_written(technique_->manifest.maps[map].name)) result.bytes += maps_[map]->texture.bytes;
    }
    if (maps_.empty()) return result;
    const bool may_take_long =
        std::ranges::any_of(passes_, [](const CompiledPass& pass) { return pass.declaration->sliced.has_value(); });
    const bool keeps = may_take_long && !settings.cache.empty();
    if (keeps && settings.take_kept && take_kept(settings, result)) return result;
    if (make(settings, result) && keeps) keep(settings, result);
    return result;
}

bool DerivedMaps::make(const PreparationSettings& settings, Preparation& result) {
    for (std::size_t map = 0; map < maps_.size(); ++map) {
        const MapDeclaration& declaration = technique_->manifest.maps[map];
        if (declaration.scratch) maps_[map].emplace(make_map(declaration));
    }
    bool finished = true;
    {
        std::vector<PreparationPass> passes;
        for (const CompiledPass& pass : passes_)
            passes.emplace_back(*device_, *technique_, pass, maps_, *scene_);
        for (int sample = 0; sample < settings.samples && finished; ++sample) {
            change_layouts(vk::ImageLayout::eUndefined, vk::ImageLayout::eGeneral);
            finished = std::ranges::all_of(
                passes, [&](const PreparationPass& pass) { return run_pass(pass, settings, result); });
            change_layouts(vk::ImageLayout::eGeneral, vk::ImageLayout::eShaderReadOnlyOptimal);
            loops_probed_ = finished;
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
        if (!loops_probed_) pass.probe();
        return true;
    }
    // Of this preparation; earlier samples are not its cost.
    const double earlier_ms = result.pass_ms.contains(declaration.name) ? 0 : total_ms(result);
    SlicePlan plan = pass.plan(scene_->size);
    pass.warm_up();
    while (!plan.is_done()) {
        if (!loops_probed_ && is_probed(plan.slices())) pass.probe(plan.next());
        plan.took(pass.run(plan.next()));
        result.given_up = reason_to_give_up(declaration, plan, earlier_ms, settings.limit_s);
        if (!result.given_up.empty()) return false;
        if (settings.on_progress) {
            const double remaining_s = (plan.estimated_ms() - plan.elapsed_ms()) / ms_per_s;
            settings.on_progress(
                {declaration.name, plan.fraction(), declaration.sliced->ends_early ? -1 : remaining_s});
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
    // What was kept before loops were looked at may have been cut.
    if (gpu::loop_limit(*device_)) text += "loops probed\n";
    for (const MapDeclaration& map : technique_->manifest.maps)
        text += fmt::format("map {} {} {} {} {}\n", map.name, map.format, static_cast<int>(map.size), map.mip_chain,
                            map.slices(parameters_));
    for (const CompiledPass& pass : passes_) {
        text += fmt::format("pass {} {} {} {}", pass.declaration->name, pass.declaration->writes,
                            static_cast<int>(pass.declaration->levels),
                            content_hash(std::as_bytes(std::span(*pass.shader.code))));
        for (const auto& [constant, value] : pass.values_by_id)
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
}

std::vector<gpu::Binding> DerivedMaps::draw_bindings() const {
    std::vector<gpu::Binding> bindings;
    for (std::size_t i = 0; i < maps_.size(); ++i) {
        if (!maps_[i] || technique_->manifest.maps[i].scratch) continue;
        bindings.push_back(gpu::sampled_image(technique_->manifest.maps[i].name, maps_[i]->texture.view,
                                              maps_[i]->sampler, vk::ImageLayout::eShaderReadOnlyOptimal));
    }
    return bindings;
}

}  // namespace reliefbench
