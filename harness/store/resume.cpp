#include "store/resume.hpp"

#include "core/json_lookup.hpp"
#include "core/suggest.hpp"
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

/// The first few of them.
std::string told(std::vector<std::string> differences) {
    constexpr std::size_t max_listed = 3;
    if (differences.size() > max_listed) {
        differences.resize(max_listed);
        differences.emplace_back("...");
    }
    return join(differences);
}

/// "0, 60" for a list; empty where it would be long or nested.
std::string short_text(const Json& value) {
    constexpr std::size_t longest = 60;
    if (value.is_null()) return "not set";
    std::vector<std::string> words;
    for (const Json& each : value.is_array() ? value : Json::array({value})) {
        if (each.is_structured()) return "";
        words.push_back(text_of(each));
    }
    const std::string text = words.empty() ? "none" : join(words);
    return text.size() <= longest ? text : "";
}

Json member_of(const Json& object, const std::string& name) {
    return object.contains(name) ? object.at(name) : Json();
}

/// Of both objects, each once.
std::vector<std::string> member_names(const Json& before, const Json& after) {
    std::vector<std::string> names;
    for (const Json* object : {&before, &after}) {
        for (const auto& [name, value] : object->items()) {
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        }
    }
    return names;
}

/// As people name them: "the axis view_angle was 0, 60 and is 0, 61", "sampling.rounds was 6 and is 5".
void append_setting(const std::string& name, const Json& before, const Json& after,
                    std::vector<std::string>& differences) {
    if (before == after) return;
    if (before.is_object() && after.is_object()) {
        const std::string prefix = name.empty() ? "" : name == "axes" ? "the axis " : name + ".";
        for (const std::string& member : member_names(before, after))
            append_setting(prefix + member, member_of(before, member), member_of(after, member), differences);
        return;
    }
    const std::string was = short_text(before);
    const std::string is = short_text(after);
    differences.push_back(was.empty() || is.empty() ? name + " differs"
                                                    : fmt::format("{} was {} and is {}", name, was, is));
}

/// Names of members with other values, or of the records of a list that only one side has.
std::vector<std::string> differing_names(const Json& before, const Json& after) {
    std::vector<std::string> names;
    if (before.is_object() && after.is_object()) {
        for (const std::string& name : member_names(before, after)) {
            if (member_of(before, name) != member_of(after, name)) names.push_back(name);
        }
    } else if (before.is_array() && after.is_array()) {
        for (const auto& [here, there] : {std::pair(&before, &after), std::pair(&after, &before)}) {
            for (const Json& record : *here) {
                if (std::find(there->begin(), there->end(), record) != there->end()) continue;
                const std::string name = text_of(value_at(record, {"name"}));
                if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
            }
        }
    }
    return names;
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
    if (before != after) {
        std::vector<std::string> settings;
        append_setting("", before, after, settings);
        differences.push_back("the configuration differs: " +
                              (settings.empty() ? "the order in it" : told(std::move(settings))));
    }
    if (value_at(recorded, {"filters"}) != value_at(now, {"filters"})) differences.push_back("the filters differ");
    // Of a run for advice; one that goes on with all that such a run left out has none.
    const Json asked_before = value_at(recorded, {"question"});
    const Json asked_now = value_at(now, {"question"});
    if (!asked_before.is_null() && !asked_now.is_null() && asked_before != asked_now)
        differences.push_back("it was measured for another question");
    if (value_at(recorded, {"shard"}) != value_at(now, {"shard"})) differences.push_back("it is another shard");
    for (const auto& [what, key] : {std::pair("height maps", "height_maps"), std::pair("bases", "bases"),
                                    std::pair("techniques", "techniques"), std::pair("shaders", "shaders")}) {
        const Json hashes_before = value_at(recorded, {key});
        const Json hashes_after = value_at(now, {key});
        if (hashes_before == hashes_after) continue;
        std::vector<std::string> names = differing_names(hashes_before, hashes_after);
        const bool is_input = std::string_view(key) == "height_maps" || std::string_view(key) == "bases";
        const bool of_sources_alone = is_input || recorded.contains("source_hashes");
        differences.push_back(fmt::format("the content of {} differs{}{}", what,
                                          names.empty() ? "" : " (" + told(std::move(names)) + ")",
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
