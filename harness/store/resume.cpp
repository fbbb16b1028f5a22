#include "store/resume.hpp"

#include "core/json_lookup.hpp"
#include "store/crashes.hpp"
#include "store/read_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace reliefbench {

namespace {

constexpr const char* cpu_device = "CPU";

/// Paths of files by their names: what a height map holds is compared by its hash.
Json without_folders(Json json) {
    if (json.is_structured()) {
        for (Json& element : json)
            element = without_folders(std::move(element));
    } else if (json.is_string()) {
        const std::filesystem::path path(json.get<std::string>());
        if (path.is_absolute()) json = path.filename().string();
    }
    return json;
}

/// The first places at which two configurations differ, as JSON pointers.
std::string places(const Json& recorded, const Json& now) {
    constexpr std::size_t most_told = 3;
    std::string text;
    std::size_t told = 0;
    for (const Json& step : Json::diff(recorded, now)) {
        if (told++ == most_told) return text + ", ...";
        text += (text.empty() ? "" : ", ") + step.at("path").get<std::string>();
    }
    return text;
}

}  // namespace

EarlierWork read_earlier_work(const std::filesystem::path& folder, const std::string& visited_pass) {
    EarlierWork earlier;
    for (CellResult& cell : read_run(folder).cells)
        earlier.finished.insert(std::move(cell.cell));
    read_samples(folder, [&](const RawSamples& samples) {
        if (samples.pass != visited_pass || earlier.finished.contains(samples.cell)) return;
        earlier.visits[samples.cell].push_back(samples);
    });
    for (auto& [cell, visits] : earlier.visits) {
        std::stable_sort(visits.begin(), visits.end(),
                         [](const RawSamples& a, const RawSamples& b) { return a.round < b.round; });
    }
    earlier.crashes = read_crashes(folder);
    earlier.crashed_preparations = read_crashed_preparations(folder);
    return earlier;
}

std::vector<std::string> resume_differences(const Json& recorded, const Json& now) {
    std::vector<std::string> differences;
    const Json before = without_folders(value_at(recorded, {"configuration"}));
    const Json after = without_folders(value_at(now, {"configuration"}));
    if (before != after) differences.push_back("the configuration differs at " + places(before, after));
    if (value_at(recorded, {"filters"}) != value_at(now, {"filters"})) differences.push_back("the filters differ");
    if (value_at(recorded, {"shard"}) != value_at(now, {"shard"})) differences.push_back("it is another shard");
    for (const auto& [what, key] : {std::pair("height maps", "height_maps"), std::pair("techniques", "techniques"),
                                    std::pair("shaders", "shaders")}) {
        const Json hashes_before = value_at(recorded, {key});
        const Json hashes_after = value_at(now, {key});
        if (hashes_before == hashes_after) continue;
        const bool named = hashes_before.is_structured() && hashes_after.is_structured();
        const bool of_sources_alone = std::string_view(key) == "height_maps" || recorded.contains("source_hashes");
        differences.push_back(fmt::format("the content of {} differs{}{}", what,
                                          named ? " at " + places(hashes_before, hashes_after) : "",
                                          of_sources_alone ? "" : ", or of other files in their folders"));
    }
    const auto compare = [&](const char* what, std::initializer_list<const char*> path) {
        const Json value_before = value_at(recorded, path);
        const Json value_after = value_at(now, path);
        if (value_before != value_after) {
            differences.push_back(
                fmt::format("{} was '{}' and is '{}'", what, text_of(value_before), text_of(value_after)));
        }
    };
    compare("the device", {"device", "name"});
    compare("the driver", {"device", "driver"});
    compare("the driver's version", {"device", "driver_version"});
    compare("the tool's version", {"environment", "tool_version"});
    if (value_at(now, {"device", "type"}) == cpu_device) compare("the CPU", {"environment", "cpu"});
    return differences;
}

}  // namespace reliefbench
