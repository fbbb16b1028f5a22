#include "measure/run_record.hpp"

#include "core/statistics.hpp"
#include "gpu/device.hpp"
#include "manifest/parameter_json.hpp"
#include "measure/base_records.hpp"
#include "store/environment.hpp"
#include "store/figures.hpp"
#include "store/stored_format.hpp"
#include "sweep/view_axes.hpp"
#include "technique/renderer.hpp"
#include "technique/source_identity.hpp"

#include <map>
#include <set>

namespace reliefbench {

namespace {

Json device_record(const gpu::DeviceInfo& info) {
    Json json;
    json["name"] = info.name;
    json["type"] = to_string(info.type);
    json["driver"] = info.driver;
    json["driver_version"] = info.driver_version;
    json["api_version"] = info.api_version;
    json["vendor_id"] = info.vendor_id;
    json["device_id"] = info.device_id;
    json["timestamp_period_ns"] = info.timestamp_period_ns;
    json["timestamp_valid_bits"] = info.timestamp_valid_bits;
    return json;
}

std::set<std::string> techniques_of(const std::vector<Cell>& cells) {
    std::set<std::string> ids;
    for (const Cell& cell : cells)
        ids.insert(cell.technique);
    return ids;
}

Json technique_hashes(const TechniqueLibrary& library, const std::vector<Cell>& cells) {
    Json json = Json::object();
    for (const std::string& id : techniques_of(cells))
        json[id] = library.get(id).hash;
    return json;
}

/// What ids leave out.
Json defaults_record(const TechniqueLibrary& library, const std::vector<Cell>& cells) {
    Json parameters = Json::object();
    for (const std::string& id : techniques_of(cells)) {
        parameters[id] = Json::object();
        for (const Parameter& parameter : library.get(id).manifest.parameters)
            parameters[id][parameter.name] = to_json(parameter.default_value);
    }
    Json axes = Json::object();
    for (const ViewAxis& axis : view_axes()) {
        if (!axis.part_of_height_map) axes[axis.name] = axis.default_value;
    }
    return {{"parameters", std::move(parameters)}, {"axes", std::move(axes)}};
}

/// Of the cells' presets by technique and name, what they are: a run explains itself without the library.
Json preset_records(const TechniqueLibrary& library, const std::vector<Cell>& cells) {
    Json json;
    for (const Cell& cell : cells) {
        if (cell.preset.empty()) continue;
        Json& record = json[cell.technique][cell.preset];
        if (record.is_null()) record = to_json(*find_preset(library.get(cell.technique).manifest, cell.preset));
    }
    return json;
}

Json height_map_records(const std::vector<HeightMapRecord>& maps) {
    Json json = Json::array();
    for (const HeightMapRecord& map : maps) {
        Json entry;
        entry["name"] = map.name;
        entry["format"] = to_string(map.format);
        entry["size"] = {map.size.width, map.size.height};
        entry["hash"] = map.hash;
        entry["albedo_hash"] = map.albedo_hash;
        entry["mapping"] = map.mapping;
        json.push_back(std::move(entry));
    }
    return json;
}

Json filter_deviations(const gpu::Device& device, const std::vector<HeightMapRecord>& maps) {
    Json json = Json::object();
    for (const HeightMapRecord& map : maps) {
        const std::string format = to_string(map.format);
        if (!json.contains(format)) {
            json[format] = measure_filter_deviation(device, map.format);
        }
    }
    return json;
}

/// What timing costs by itself: a baseline that is reported, never subtracted.
Json empty_pass_record(const gpu::Device& device) {
    constexpr int samples = 21;
    const std::vector<double> milliseconds = time_empty_pass(device, samples);
    Json json;
    json["median_ms"] = median(milliseconds);
    json["mad_ms"] = median_absolute_deviation(milliseconds);
    json["n"] = samples;
    return json;
}

}  // namespace

Json make_run_record(const RunSubject& subject) {
    Json record;
    record["format"] = stored_run_format;
    record["configuration"] = subject.configuration.expanded;
    record["environment"] = environment_to_json();
    record["environment"]["shared_device"] = subject.shares_device;
    record["device"] = device_record(subject.device.info());
    record["techniques"] = technique_hashes(subject.library, subject.cells);
    record["shaders"] = hash_shared_shaders(shader_root());
    record["source_hashes"] = hashes_of_included_files;
    record["defaults"] = defaults_record(subject.library, subject.cells);
    if (Json presets = preset_records(subject.library, subject.cells); !presets.is_null())
        record["presets"] = std::move(presets);
    record["height_maps"] = height_map_records(subject.height_maps);
    if (Json bases = inspect_bases(subject.cells); !bases.empty()) record["bases"] = std::move(bases);
    record["empty_pass"] = empty_pass_record(subject.device);
    record["filter_deviation"] = filter_deviations(subject.device, subject.height_maps);
    record["figures"] = figures_to_json();
    return record;
}

}  // namespace reliefbench
