#include "measure/shared_inputs.hpp"

#include "core/attempt.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/log.hpp"
#include "core/memory.hpp"
#include "measure/base_records.hpp"
#include "measure/memory_need.hpp"
#include "sweep/height_map_value.hpp"
#include "sweep/view_axes.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace reliefbench {

namespace {

bool same_map(const ViewKey& key, const HeightMapSource& source, HeightFormat format) {
    return key.height_map == source && key.height_format == format;
}

/// A warning says so.
bool is_too_large_to_inspect(const ViewKey& key, const InputSizes& sizes) {
    const std::uint64_t needed = loading_need(sizes, key.height_format).host;
    const std::uint64_t available = available_memory();
    if (needed <= available) return false;
    log_warning("height map '{}' of {}x{} takes about {} of memory to load, and {} is available", key.height_map.name,
                sizes.height_map.width, sizes.height_map.height, memory_text(needed), memory_text(available));
    return true;
}

/// Whether there was the memory for the work; a warning where not.
bool loads_in_memory(const HeightMapSource& source, const std::function<void()>& load) {
    if (fits_in_memory(load)) return true;
    log_warning("height map '{}' could not be loaded: {}", source.name, memory_used_up);
    return false;
}

void add_content(HeightMapRecord& record, const ViewKey& key) {
    const HeightMap map = load_height_map(key.height_map, key.height_format);
    const Albedo albedo = load_albedo(key.height_map, map);
    record.name = map.name;
    record.size = map.heights.size;
    record.hash = map.hash;
    record.albedo_hash = content_hash(std::as_bytes(std::span(albedo.texels.texels)));
    record.mapping = map.mapping;
    record.constant = map.constant;
}

HeightMapRecord inspect(const ViewKey& key) {
    const InputSizes sizes = input_sizes(key.height_map);
    HeightMapRecord record{.source = key.height_map, .format = key.height_format};
    HeightMapRecord loaded = record;
    const bool is_loaded =
        !is_too_large_to_inspect(key, sizes) && loads_in_memory(key.height_map, [&] { add_content(loaded, key); });
    if (is_loaded) return loaded;
    record.name = std::filesystem::path(key.height_map.name).filename().string();
    record.size = sizes.height_map;
    return record;
}

/// A view of each height map in each format.
std::vector<const ViewKey*> distinct_maps(const std::vector<Cell>& cells) {
    std::vector<const ViewKey*> maps;
    for (const Cell& cell : cells) {
        const bool known = std::ranges::any_of(
            maps, [&](const ViewKey* map) { return same_map(cell.view, map->height_map, map->height_format); });
        if (!known) maps.push_back(&cell.view);
    }
    return maps;
}

/// What the truth of a view does not depend on, at its default: views that differ in it alone share one truth. It has
/// hits, and how much of each light reaches them.
ViewKey truth_key(const ViewKey& view) {
    ViewKey key = hits_view(view);
    key.view.self_shadow.mode = view.view.self_shadow.mode;
    return key;
}

}  // namespace

std::vector<HeightMapRecord> inspect_height_maps(const std::vector<Cell>& cells,
                                                 const std::function<void(const std::string& map)>& on_map) {
    std::vector<HeightMapRecord> records;
    for (const ViewKey* map : distinct_maps(cells)) {
        if (on_map) on_map(map->height_map.name);
        records.push_back(inspect(*map));
    }
    return records;
}

void check_input_files(const std::vector<Cell>& cells) {
    inspect_bases(cells);
    for (const ViewKey* key : distinct_maps(cells)) {
        const HeightMapSource& source = key->height_map;
        if (is_too_large_to_inspect(*key, input_sizes(source))) continue;
        loads_in_memory(source, [&] {
            HeightMap map;
            if (!is_procedural(source.name)) map = load_height_map(source, key->height_format);
            if (!source.albedo.empty()) load_albedo(source, map);
        });
    }
}

LoadedMap::LoadedMap(const gpu::Device& device, const HeightMapSource& source, HeightFormat format)
    : map(load_height_map(source, format)),
      albedo(load_albedo(source, map)),
      albedo_content(content_of(albedo)),
      scene(device, map, albedo) {}

Truth trace_truth(const LoadedMap& loaded, const View& view, const Lighting& lighting, const TruthSettings& settings,
                  const std::optional<SceneObject>& object) {
    const TruthPicture picture{.samples = settings.samples, .object = object ? &*object : nullptr};
    return settings.kind == TruthSettings::Kind::mesh
               ? trace_mesh_truth(loaded.map, loaded.albedo, view, lighting, settings.subdivision, picture)
               : trace_exact_truth(loaded.map, loaded.albedo, view, lighting, picture);
}

SharedInputs::SharedInputs(const gpu::Device& device, const Lighting& lighting, const TruthSettings& settings,
                           const std::optional<SceneObject>& object, std::filesystem::path cache)
    : device_(&device), lighting_(lighting), settings_(settings), object_(object), cache_(std::move(cache)) {}

const LoadedMap& SharedInputs::map(const ViewKey& key) {
    for (const KeyedMap& keyed : maps_) {
        if (same_map(key, keyed.source, keyed.format)) {
            return keyed.loaded;
        }
    }
    const InputSizes sizes = input_sizes(key.height_map);
    const std::string lacking =
        lacking_memory(*device_, fmt::format("loading the height map '{}'", key.height_map.name),
                       loading_need(sizes, key.height_format));
    if (!lacking.empty()) fail("{}", lacking);
    maps_.push_back({key.height_map, key.height_format, LoadedMap(*device_, key.height_map, key.height_format)});
    return maps_.back().loaded;
}

View SharedInputs::view(const ViewKey& key) {
    View view = key.view;
    const auto known = std::ranges::find(bases_, key.base, &KeyedBase::source);
    if (known == bases_.end()) bases_.push_back({key.base, load_base(key.base)});
    view.relief.base = known == bases_.end() ? bases_.back().loaded : known->loaded;
    return view;
}

bool SharedInputs::has_map(const ViewKey& key) const {
    return std::ranges::any_of(maps_, [&](const KeyedMap& keyed) { return same_map(key, keyed.source, keyed.format); });
}

bool SharedInputs::has_truth(const ViewKey& view) const {
    return truth_ && truth_->key == truth_key(view);
}

const Truth& SharedInputs::truth(const ViewKey& view) {
    if (!has_truth(view)) {
        const ViewKey key = truth_key(view);
        truth_.reset();
        truth_.emplace(KeyedTruth{key, trace(key, this->view(key), settings_), {}});
    }
    return truth_->truth;
}

const std::optional<TruthNoise>& SharedInputs::noise(const ViewKey& view) {
    const Truth& truth = this->truth(view);
    if (!truth_->noise && truth.standard_error) {
        truth_->noise =
            truth_noise(*truth.standard_error, *truth.half_picture, truth.colour, {truth.footprint, truth.background});
    }
    return truth_->noise;
}

Truth SharedInputs::truth_from(const ViewKey& key, const Camera& camera) {
    View view = this->view(key);
    view.camera = camera;
    view.self_shadow = SelfShadow{};
    TruthSettings settings = settings_;
    settings.samples = 1;
    return trace(key, view, settings);
}

Truth SharedInputs::trace(const ViewKey& key, const View& view, const TruthSettings& settings) {
    const LoadedMap& loaded = map(key);
    const std::string name = cache_.empty()
                                 ? std::string()
                                 : cache_key({loaded.map, loaded.albedo_content, view, lighting_, settings, object_});
    std::optional<Truth> truth = read_cached_truth(cache_, name);
    if (truth) {
        ++truths_.cached;
    } else {
        truth = trace_truth(loaded, view, lighting_, settings, object_);
        ++truths_.traced;
        cache_truth(cache_, name, *truth);
    }
    truths_.seconds += truth->trace_ms / 1000.0;
    return std::move(*truth);
}

void SharedInputs::keep_only(const std::vector<ViewKey>& views) {
    if (truth_ &&
        std::none_of(views.begin(), views.end(), [&](const ViewKey& view) { return truth_key(view) == truth_->key; })) {
        truth_.reset();
    }
    bases_.remove_if(
        [&](const KeyedBase& keyed) { return std::ranges::find(views, keyed.source, &ViewKey::base) == views.end(); });
    maps_.remove_if([&](const KeyedMap& keyed) {
        return std::none_of(views.begin(), views.end(),
                            [&](const ViewKey& key) { return same_map(key, keyed.source, keyed.format); });
    });
}

}  // namespace reliefbench
