#include "manifest/search_advice.hpp"

#include "core/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace reliefbench {

namespace {

using Caps = std::vector<const Parameter*>;

std::int64_t value_of(const Parameter& parameter, const ParameterValues& values) {
    return std::get<std::int64_t>(values.at(parameter.name));
}

/// Those of the names that have an effect beside the others' values.
Caps in_effect(const Manifest& manifest, const std::vector<std::string>& names, const ParameterValues& values) {
    Caps caps;
    for (const std::string& name : names) {
        const Parameter* parameter = manifest.find_parameter(name);
        if (all_hold(parameter->only_with, values)) caps.push_back(parameter);
    }
    return caps;
}

/// As the manifest names them. Manifests of before there was such a key have their number of samples only.
Caps caps_of(const Manifest& manifest, const ParameterValues& values) {
    if (!manifest.search_cap.empty()) return in_effect(manifest, manifest.search_cap, values);
    if (!manifest.sample_count) return {};
    std::vector<std::string> names{*manifest.sample_count};
    if (manifest.sample_count_minimum) names.push_back(*manifest.sample_count_minimum);
    return in_effect(manifest, names, values);
}

std::vector<std::string> integer_parameters(const Manifest& manifest) {
    std::vector<std::string> names;
    for (const Parameter& parameter : manifest.parameters) {
        if (parameter.type == ParameterType::integer) names.push_back(parameter.name);
    }
    return names;
}

/// "max_steps (now 64, at most 4096)".
std::string with_values(const Caps& caps, const ParameterValues& values) {
    std::vector<std::string> words;
    for (const Parameter* cap : caps)
        words.push_back(fmt::format("{} (now {}, at most {})", cap->name, value_of(*cap, values),
                                    static_cast<std::int64_t>(cap->maximum)));
    return join(words, " or ");
}

std::string advise_without_cap(const Manifest& manifest, const ParameterValues& values) {
    const std::string unnamed = "technique.json names no parameter as its \"search_cap\"";
    const Caps integers = in_effect(manifest, integer_parameters(manifest), values);
    if (integers.empty()) return unnamed + ", and there is none that could be: the cap stands in its shaders";
    return fmt::format("{}: if one of them is, raise {}; else the cap stands in its shaders", unnamed,
                       with_values(integers, values));
}

}  // namespace

std::string advise_longer_search(const Manifest& manifest, const ParameterValues& values) {
    const Caps caps = caps_of(manifest, values);
    if (caps.empty()) return advise_without_cap(manifest, values);
    Caps open;
    std::ranges::copy_if(caps, std::back_inserter(open), [&](const Parameter* cap) {
        return static_cast<double>(value_of(*cap, values)) < cap->maximum;
    });
    if (!open.empty()) return "raise " + with_values(open, values);
    std::vector<std::string> words;
    for (const Parameter* cap : caps)
        words.push_back(fmt::format("{} = {}", cap->name, value_of(*cap, values)));
    return fmt::format(
        "{}, which caps it, is at its maximum: no number of steps of the technique's is enough here, if its search "
        "ends at all; choose a smaller height map or a steeper view, or give it a larger \"range\" in technique.json",
        join(words, " with "));
}

std::string advise_shorter_search(const Manifest& manifest, const ParameterValues& values) {
    std::string advice = "give each loop an end of its own that is sooner";
    const Caps caps = caps_of(manifest, values);
    std::vector<std::string> words;
    for (const Parameter* cap : caps)
        words.push_back(fmt::format("{} (now {})", cap->name, value_of(*cap, values)));
    if (!words.empty()) advice += fmt::format(", or lower {} if it is what caps them", join(words, " or "));
    return advice;
}

}  // namespace reliefbench
