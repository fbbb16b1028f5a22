#include "compare/common_ids.hpp"

#include "core/json_lookup.hpp"
#include "store/stored_format.hpp"

#include <algorithm>
#include <string>
#include <unordered_set>
#include <utility>

namespace reliefbench {

namespace {

std::vector<const StoredRun*> from_oldest_to_newest(std::span<const StoredRun> runs) {
    std::vector<const StoredRun*> order;
    for (const StoredRun& run : runs)
        order.push_back(&run);
    const auto time = [](const StoredRun* run) { return text_of(value_at(run->run.run, {"environment", "time"})); };
    std::ranges::stable_sort(order, {}, time);
    return order;
}

/// `presets` of a run.json by technique and name, for each of them.
template <typename Visit>
void for_each_preset(const StoredRun& run, const Visit& visit) {
    const Json techniques = value_at(run.run.run, {"presets"});
    if (!techniques.is_object()) return;
    for (const auto& [technique, presets] : techniques.items()) {
        for (const auto& [name, preset] : presets.items())
            visit(technique, name, value_at(preset, {"parameters"}));
    }
}

/// Of each technique, of the axes and of each preset, as the newest run has them that records them; null where none
/// does.
Json newest_defaults(std::span<const StoredRun> runs) {
    Json newest;
    for (const StoredRun* run : from_oldest_to_newest(runs)) {
        const Json recorded = value_at(run->run.run, {"defaults"});
        if (!recorded.is_object()) continue;
        newest["axes"] = value_at(recorded, {"axes"});
        const Json techniques = value_at(recorded, {"parameters"});
        if (!techniques.is_object()) continue;
        for (const auto& [technique, parameters] : techniques.items())
            newest["parameters"][technique] = parameters;
        for_each_preset(*run, [&](const std::string& technique, const std::string& name, const Json& parameters) {
            newest["presets"][technique][name] = parameters;
        });
    }
    return newest;
}

/// " name=value" of each member that is not at its default, in the defaults' order; then of those that the defaults do
/// not know and `own`, those of the cell's run, do not explain.
void append_members(std::string& text, const Json& members, const Json& defaults, const Json& own) {
    const auto append = [&text](const std::string& name, const Json& value) {
        text += ' ' + name + '=' + scalar_text(value);
    };
    for (const auto& [name, default_value] : defaults.items()) {
        const auto member = members.find(name);
        if (member == members.end() || member->is_null() || *member == default_value) continue;
        append(name, *member);
    }
    for (const auto& [name, value] : members.items()) {
        if (defaults.contains(name) || value.is_null() || value_at(own, {name.c_str()}) == value) continue;
        append(name, value);
    }
}

/// Empty where the defaults do not tell.
std::string common_id(const CellResult& cell, const Json& defaults, const Json& own) {
    Json expected = value_at(defaults, {"parameters", cell.technique.c_str()});
    const Json axes = value_at(defaults, {"axes"});
    for (const Json* object : {&std::as_const(expected), &axes, &cell.parameters, &cell.axes}) {
        if (!object->is_object()) return {};
    }
    std::string technique = cell.technique;
    Json parameters = cell.parameters;
    if (!cell.preset.empty()) {
        technique += " preset=" + cell.preset;
        const Json preset = value_at(defaults, {"presets", cell.technique.c_str(), cell.preset.c_str()});
        for (const auto& [name, value] : preset.items()) {
            // One that the cell's run does not know was at its default, whatever the preset has since.
            if (!parameters.contains(name) && expected.contains(name)) parameters[name] = expected[name];
            expected[name] = value;
        }
    }
    append_members(technique, parameters, expected, value_at(own, {"parameters", cell.technique.c_str()}));
    std::string view;
    append_members(view, cell.axes, axes, value_at(own, {"axes"}));
    return technique + " |" + view;
}

/// Without any all ids stay as they are, and where all are the same they would.
bool has_other_defaults(std::span<const StoredRun> runs, const Json& newest) {
    if (newest.is_null()) return false;
    return std::ranges::any_of(runs, [&](const StoredRun& run) {
        const Json own = value_at(run.run.run, {"defaults"});
        if (!own.is_object() || value_at(own, {"axes"}) != value_at(newest, {"axes"})) return true;
        const Json techniques = value_at(own, {"parameters"});
        if (!techniques.is_object()) return true;
        bool has_other_presets = false;
        for_each_preset(run, [&](const std::string& technique, const std::string& name, const Json& parameters) {
            if (value_at(newest, {"presets", technique.c_str(), name.c_str()}) != parameters) has_other_presets = true;
        });
        return has_other_presets || std::ranges::any_of(techniques.items(), [&](const auto& item) {
                   return value_at(newest, {"parameters", item.key().c_str()}) != item.value();
               });
    });
}

}  // namespace

void give_common_ids(std::span<StoredRun> runs) {
    const Json newest = newest_defaults(runs);
    if (!has_other_defaults(runs, newest)) return;
    for (StoredRun& run : runs) {
        const Json own = defaults_of(run.run);
        std::unordered_set<std::string> ids;
        for (CellResult& cell : run.run.cells) {
            std::string id = common_id(cell, newest, own);
            // Where a run was resumed by force by another version, two of its cells may be the same now: each keeps its
            // own id then.
            if (!id.empty() && ids.insert(id).second) cell.cell = std::move(id);
        }
    }
}

}  // namespace reliefbench
