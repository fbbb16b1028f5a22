#pragma once

#include "core/json.hpp"
#include "manifest/parameter.hpp"

#include <string>
#include <vector>

namespace reliefbench {

struct Manifest;

/// The settings with which an engine or a publication ships the technique.
struct Preset {
    /// By which a configuration names it, "unity_hdrp"; of one technique alone.
    std::string name;
    /// One line: "Unity HDRP".
    std::string title;
    /// One line: repository, file and revision that were read.
    std::string source;
    /// Take the place of the defaults.
    ParameterValues parameters;
    /// One line: what its source does that no parameter says. Empty: nothing that changes a hit.
    std::string not_expressed;
};

/// "presets" of technique.json, behind its parameters. A value that has no effect beside the others, or only over
/// curved bases, is an Error, as are unknown parameters, values out of range and a name given twice.
std::vector<Preset> parse_presets(const JsonView& view, const Manifest& manifest);

/// Title, source, parameters and not_expressed, without its name.
Json to_json(const Preset& preset);

/// Null where the technique has none of that name.
const Preset* find_preset(const Manifest& manifest, const std::string& name);

/// The defaults with the preset's values in their place; those of the technique where `preset` is null.
ParameterValues values_of_preset(const Manifest& manifest, const Preset* preset);

}  // namespace reliefbench
