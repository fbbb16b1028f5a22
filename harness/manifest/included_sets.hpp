#pragma once

#include "core/json.hpp"
#include "manifest/parameter.hpp"
#include "manifest/parse_parameter.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// A file beside the shared shaders with parameters, maps and passes for techniques to include.
struct IncludedSet {
    std::string name;
    std::string file;
    Json json;

    JsonView view() const { return {json, file}; }
};

/// Those that a manifest names under "include", and that of the manifest's shape where there is one. A name that
/// is no file of the folder `shared` is an Error.
std::vector<IncludedSet> read_included_sets(const JsonView& manifest, const std::filesystem::path& shared);

/// The technique's own parameters in their order, among which parameters of the sets may be changed; then the others of
/// the sets in theirs, so that a set that grows leaves cell ids alone.
std::vector<Parameter> parse_parameters(const JsonView& own, const std::vector<IncludedSet>& sets, GlslNames& names);

}  // namespace reliefbench
