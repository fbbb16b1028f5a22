#include "store/stored_format.hpp"

#include "core/json_lookup.hpp"
#include "core/split.hpp"
#include "store/run_folder.hpp"

#include <algorithm>
#include <limits>

namespace reliefbench {

namespace {

/// "max_steps" of "pom max_steps=16 | heightmap=bricks".
bool id_names_parameter(const std::string& id, const std::string& parameter) {
    const std::vector<std::string> words = split(id.substr(0, id.find(" | ")), ' ');
    return std::ranges::any_of(words, [&](const std::string& word) { return word.starts_with(parameter + "="); });
}

Json defaults_seen_in_cells(const std::vector<CellResult>& cells) {
    Json defaults = Json::object();
    for (const CellResult& cell : cells) {
        if (!cell.parameters.is_object()) continue;
        Json& known = *defaults.emplace(cell.technique, Json::object()).first;
        for (const auto& [name, value] : cell.parameters.items()) {
            if (!known.contains(name) && !id_names_parameter(cell.cell, name)) known[name] = value;
        }
    }
    return defaults;
}

}  // namespace

int format_of(const JsonView& record) {
    if (!record.has("format")) return 1;
    const std::int64_t format = record.at("format").integer(1, std::numeric_limits<int>::max());
    if (format > stored_run_format) {
        record.at("format").fail_here(fmt::format(
            "a later version of reliefbench wrote this run: it has format {}, and this version reads formats "
            "up to {}; use a version that is not older than the run",
            format, stored_run_format));
    }
    return static_cast<int>(format);
}

Json defaults_of(const Run& run) {
    const Json recorded = value_at(run.run, {"defaults"});
    if (recorded.is_object()) return recorded;
    return {{"parameters", defaults_seen_in_cells(run.cells)}, {"axes", Json::object()}};
}

}  // namespace reliefbench
