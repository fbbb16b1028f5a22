#include "manifest/included_sets.hpp"

#include "manifest/shape.hpp"
#include "manifest/shared_shaders.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reliefbench {

namespace {

IncludedSet read_set(const std::string& name, const std::filesystem::path& file) {
    IncludedSet set{name, file.string(), read_json_file(file)};
    set.view().require_only({"parameters", "maps", "passes"});
    return set;
}

/// A parameter of a set that the technique has not changed yet.
struct SetParameter {
    Parameter parameter;
    JsonView view;
    const IncludedSet* set;
};

std::vector<SetParameter> parse_set_parameters(const std::vector<IncludedSet>& sets, GlslNames& names) {
    std::vector<SetParameter> parameters;
    for (const IncludedSet& set : sets) {
        for (const JsonView& item : set.view().at("parameters").items())
            parameters.push_back({parse_parameter(item, names), item, &set});
    }
    return parameters;
}

}  // namespace

std::vector<IncludedSet> read_included_sets(const JsonView& manifest, const std::filesystem::path& shared) {
    std::vector<IncludedSet> sets;
    if (manifest.has("include")) {
        for (const JsonView& item : manifest.at("include").items()) {
            const std::string name = item.string();
            const std::filesystem::path plain(name);
            const bool is_plain = plain.filename() == name && plain.extension() == ".json";
            const std::filesystem::path file = is_plain ? find_shared_file(shared, name) : std::filesystem::path();
            if (file.empty())
                item.fail_expected("a .json file that stands beside the shared shaders (harness/shaders/library)");
            const bool is_of_a_shape =
                std::ranges::find(shape_kinds(), name, &ShapeKind::parameter_set) != shape_kinds().end();
            if (is_of_a_shape || std::ranges::find(sets, name, &IncludedSet::name) != sets.end()) {
                item.fail_here(fmt::format("'{}' is included already", name));
            }
            sets.push_back(read_set(name, file));
        }
    }
    for (const ShapeKind& kind : shape_kinds()) {
        const std::filesystem::path file = find_shared_file(shared, kind.parameter_set);
        const Json& shape = manifest.at("shape").json();
        const bool is_named = shape == Json(kind.word) || (shape.is_object() && shape.contains(kind.word));
        if (is_named && !file.empty()) sets.push_back(read_set(kind.parameter_set, file));
    }
    return sets;
}

std::vector<Parameter> parse_parameters(const JsonView& own, const std::vector<IncludedSet>& sets, GlslNames& names) {
    std::vector<SetParameter> others = parse_set_parameters(sets, names);
    std::vector<Parameter> parameters;
    std::vector<JsonView> declarations;
    for (const JsonView& item : own.items()) {
        const std::string name = item.at("name").string();
        const auto found =
            std::ranges::find(others, name, [](const SetParameter& other) { return other.parameter.name; });
        if (found == others.end()) {
            parameters.push_back(parse_parameter(item, names));
            declarations.push_back(item);
        } else {
            parameters.push_back(parse_override(item, found->parameter, found->set->name));
            declarations.push_back(found->view);
            others.erase(found);
        }
    }
    for (const SetParameter& other : others) {
        parameters.push_back(other.parameter);
        declarations.push_back(other.view);
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (!declarations[i].has("only_with")) continue;
        const std::vector<Parameter> before(parameters.begin(), parameters.begin() + static_cast<std::ptrdiff_t>(i));
        parameters[i].only_with = parse_conditions(declarations[i].at("only_with"), before);
    }
    return parameters;
}

}  // namespace reliefbench
