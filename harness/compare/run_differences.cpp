#include "compare/run_differences.hpp"

#include "core/json_lookup.hpp"
#include "core/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>

namespace reliefbench {

namespace {

/// Of the configuration's `motion`, those that say what becomes of the frames.
constexpr std::array history_keys{"history_weight", "neighbourhood_clamp"};

using reliefbench::value_at;
Json value_at(const StoredRun& run, std::initializer_list<const char*> path) {
    return value_at(run.run.run, path);
}

/// Of `object` what `other` has too.
Json shared_members(const Json& object, const Json& other) {
    Json shared = Json::object();
    if (!object.is_object() || !other.is_object()) return shared;
    for (const auto& [name, value] : object.items()) {
        if (other.contains(name)) shared[name] = value;
    }
    return shared;
}

/// "<what> <name> changed from <base> to <new>" for each member of two objects that differs.
void append_member_differences(std::vector<std::string>& differences, const std::string& what, const Json& base,
                               const Json& changed) {
    std::vector<std::string> names;
    for (const Json* side : {&base, &changed}) {
        if (!side->is_object()) continue;
        for (const auto& [name, value] : side->items()) {
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        }
    }
    for (const std::string& name : names) {
        const Json before = value_at(base, {name.c_str()});
        const Json after = value_at(changed, {name.c_str()});
        if (before != after) {
            differences.push_back(
                fmt::format("{} {} changed from {} to {}", what, name, text_of(before), text_of(after)));
        }
    }
}

/// The record of the height map that the cell was drawn with; null when there is none.
Json height_map_of(const StoredRun& run, const CellResult& cell) {
    const Json size_axis = value_at(cell.axes, {"heightmap_size"});
    const Json maps = value_at(run, {"height_maps"});
    if (!maps.is_array()) return nullptr;
    for (const Json& map : maps) {
        if (value_at(map, {"name"}) != value_at(cell.axes, {"heightmap"})) continue;
        if (value_at(map, {"format"}) != value_at(cell.axes, {"height_format"})) continue;
        const Json size = value_at(map, {"size"});
        // A file's size is no axis.
        if (size_axis.is_string() && size.is_array() && size.size() == 2 &&
            size_axis.get<std::string>() != text_of(size[0]) + "x" + text_of(size[1])) {
            continue;
        }
        return map;
    }
    return nullptr;
}

/// The record of the mesh file that the cell lies on; null where it lies on none.
Json base_of(const StoredRun& run, const CellResult& cell) {
    const Json bases = value_at(run, {"bases"});
    if (!bases.is_array()) return nullptr;
    for (const Json& base : bases) {
        const bool is_base = value_at(base, {"name"}) == value_at(cell.axes, {"base"}) &&
                             value_at(base, {"base_fit"}) == value_at(cell.axes, {"base_fit"});
        if (is_base) return base;
    }
    return nullptr;
}

/// Of what is compiled and of nothing else (technique/source_identity.hpp): records of version 0.1.0 do not say so, and
/// have hashes of all files of a folder.
bool has_hashes_of_sources(const StoredRun& run) {
    return !value_at(run, {"source_hashes"}).is_null();
}

}  // namespace

std::string device_difference(const StoredRun& base, const StoredRun& changed) {
    for (const char* key : {"name", "type"}) {
        const Json before = value_at(base, {"device", key});
        const Json after = value_at(changed, {"device", key});
        if (before != after) {
            return fmt::format("{} ran on '{}' ({}), {} on '{}' ({})", base.name,
                               text_of(value_at(base, {"device", "name"})), text_of(value_at(base, {"device", "type"})),
                               changed.name, text_of(value_at(changed, {"device", "name"})),
                               text_of(value_at(changed, {"device", "type"})));
        }
    }
    const Json cpu_before = value_at(base, {"environment", "cpu"});
    const Json cpu_after = value_at(changed, {"environment", "cpu"});
    if (value_at(base, {"device", "type"}) == "CPU" && cpu_before != cpu_after) {
        return fmt::format("the device is a CPU, and {} ran on '{}', {} on '{}'", base.name, text_of(cpu_before),
                           changed.name, text_of(cpu_after));
    }
    return "";
}

bool same_truth(const StoredRun& base, const StoredRun& changed) {
    return value_at(base, {"configuration", "truth"}) == value_at(changed, {"configuration", "truth"});
}

bool same_lighting(const StoredRun& base, const StoredRun& changed) {
    return value_at(base, {"configuration", "lighting"}) == value_at(changed, {"configuration", "lighting"}) &&
           value_at(base, {"configuration", "object"}) == value_at(changed, {"configuration", "object"});
}

bool same_motion(const StoredRun& base, const StoredRun& changed) {
    const auto motion_of = [](const StoredRun& run) {
        Json motion = value_at(run, {"configuration", "motion"});
        for (const char* key : history_keys) {
            if (motion.is_object()) motion.erase(key);
        }
        return motion;
    };
    return motion_of(base) == motion_of(changed);
}

bool same_history(const StoredRun& base, const StoredRun& changed) {
    return std::ranges::all_of(history_keys, [&](const char* key) {
        return value_at(base, {"configuration", "motion", key}) == value_at(changed, {"configuration", "motion", key});
    });
}

bool same_source(const StoredRun& base, const StoredRun& changed, const std::string& technique) {
    const Json before = value_at(base, {"techniques", technique.c_str()});
    return !before.is_null() && before == value_at(changed, {"techniques", technique.c_str()});
}

bool same_code(const StoredRun& base, const StoredRun& changed, const std::string& technique) {
    const auto known_and_equal = [&](std::initializer_list<const char*> path) {
        const Json before = value_at(base, path);
        return !before.is_null() && before == value_at(changed, path);
    };
    const auto committed = [](const StoredRun& run) { return value_at(run, {"environment", "git_dirty"}) == false; };
    const bool same_shaders =
        value_at(base, {"shaders"}).is_null() || value_at(changed, {"shaders"}).is_null()
            ? known_and_equal({"environment", "git_revision"}) && committed(base) && committed(changed)
            : known_and_equal({"shaders"});
    return same_shaders && same_source(base, changed, technique) && known_and_equal({"device", "name"}) &&
           known_and_equal({"device", "driver"}) && known_and_equal({"device", "driver_version"}) &&
           known_and_equal({"environment", "cpu"}) && known_and_equal({"environment", "os"});
}

bool from_changed_tree(const StoredRun& run) {
    return value_at(run, {"environment", "git_dirty"}) == true;
}

std::vector<std::string> run_differences(const StoredRun& base, const StoredRun& changed) {
    std::vector<std::string> differences;
    const auto compare = [&](const char* what, std::initializer_list<const char*> path) {
        const Json before = value_at(base, path);
        const Json after = value_at(changed, path);
        if (before != after) {
            differences.push_back(fmt::format("{} changed from {} to {}", what, text_of(before), text_of(after)));
        }
    };
    compare("the driver", {"device", "driver"});
    compare("the driver's version", {"device", "driver_version"});
    compare("the tool's version", {"environment", "tool_version"});
    compare("the git revision", {"environment", "git_revision"});
    const bool hashes_tell = has_hashes_of_sources(base) && has_hashes_of_sources(changed);
    if (const Json before = value_at(base, {"shaders"}), after = value_at(changed, {"shaders"});
        !before.is_null() && !after.is_null() && before != after) {
        differences.push_back(hashes_tell
                                  ? "the shaders that all techniques share changed"
                                  : "the shaders that all techniques share, or other files beside them, changed");
    }
    std::vector<std::string> sources;
    const Json techniques = value_at(base, {"techniques"});
    for (const auto& [technique, hash] : techniques.items()) {
        const Json after = value_at(changed, {"techniques", technique.c_str()});
        if (!after.is_null() && after != hash) sources.push_back(technique);
    }
    if (!sources.empty()) {
        differences.push_back((hashes_tell
                                   ? "the sources of these techniques changed: "
                                   : "the sources of these techniques, or other files in their folders, changed "
                                     "(one of the runs has one hash for both): ") +
                              join(sources));
    }
    append_member_differences(differences, "sampling:", value_at(base, {"configuration", "sampling"}),
                              value_at(changed, {"configuration", "sampling"}));
    if (!same_truth(base, changed)) {
        append_member_differences(differences, "truth:", value_at(base, {"configuration", "truth"}),
                                  value_at(changed, {"configuration", "truth"}));
        differences.push_back("the truths differ, so errors and pictures are not compared");
    } else if (!same_lighting(base, changed)) {
        differences.push_back(
            "the lighting or the object differs, so pictures, shadows and what is in front are not compared");
    }
    if (!same_motion(base, changed) || !same_history(base, changed)) {
        append_member_differences(differences, "motion:", value_at(base, {"configuration", "motion"}),
                                  value_at(changed, {"configuration", "motion"}));
        differences.push_back(same_motion(base, changed)
                                  ? "the histories differ, so ghosting and flicker with history are not compared"
                                  : "the cameras move differently, so errors in motion are not compared");
    }
    compare("the CPU", {"environment", "cpu"});
    compare("the number of cores", {"environment", "cores"});
    compare("the operating system", {"environment", "os"});
    return differences;
}

std::string subject_difference(const StoredRun& base, const CellResult& base_cell, const StoredRun& changed,
                               const CellResult& changed_cell) {
    std::vector<std::string> differences;
    // A parameter or an axis that one side lacks is younger than that run, and at its default in the other: their ids
    // are the same.
    append_member_differences(differences, "the parameter",
                              shared_members(base_cell.parameters, changed_cell.parameters),
                              shared_members(changed_cell.parameters, base_cell.parameters));
    append_member_differences(differences, "the axis", shared_members(base_cell.axes, changed_cell.axes),
                              shared_members(changed_cell.axes, base_cell.axes));
    const Json map_before = height_map_of(base, base_cell);
    const Json map_after = height_map_of(changed, changed_cell);
    if (map_before.is_object() && map_after.is_object()) {
        const std::string name = text_of(value_at(map_before, {"name"}));
        if (value_at(map_before, {"hash"}) != value_at(map_after, {"hash"})) {
            differences.push_back(fmt::format("the content of its height map {} changed", name));
        }
        if (value_at(map_before, {"albedo_hash"}) != value_at(map_after, {"albedo_hash"})) {
            differences.push_back(fmt::format("the content of the albedo of its height map {} changed", name));
        }
    }
    const Json mesh_before = base_of(base, base_cell);
    const Json mesh_after = base_of(changed, changed_cell);
    if (mesh_before.is_object() && mesh_after.is_object() &&
        value_at(mesh_before, {"hash"}) != value_at(mesh_after, {"hash"})) {
        differences.push_back(
            fmt::format("the content of its base {} changed", text_of(value_at(mesh_before, {"name"}))));
    }
    return join(differences, "; ");
}

}  // namespace reliefbench
