#include "manifest/manifest.hpp"

#include "core/error.hpp"
#include "manifest/shared_shaders.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace reliefbench {

std::string to_string(Promise promise) {
    switch (promise) {
        case Promise::first_hit:
            return "first_hit";
        case Promise::order_1:
            return "order_1";
        case Promise::order_2:
            return "order_2";
        case Promise::conservative:
            return "conservative";
    }
    return {};
}

std::string to_string(MapNeed need) {
    switch (need) {
        case MapNeed::square:
            return "square";
        case MapNeed::power_of_two:
            return "power_of_two";
        case MapNeed::untiled:
            return "untiled";
    }
    return {};
}

int MapDeclaration::slices(const ParameterValues& values) const {
    return depth_parameter ? static_cast<int>(std::get<std::int64_t>(values.at(*depth_parameter))) : depth;
}

const Parameter* Manifest::find_parameter(const std::string& name) const {
    const auto found = std::ranges::find(parameters, name, &Parameter::name);
    return found == parameters.end() ? nullptr : &*found;
}

ParameterValues Manifest::defaults() const {
    ParameterValues values;
    for (const Parameter& parameter : parameters)
        values.emplace(parameter.name, parameter.default_value);
    return values;
}

void set_sample_count(const Manifest& manifest, ParameterValues& values, std::int64_t count,
                      const ParameterValues& from) {
    assert(manifest.sample_count);
    values[*manifest.sample_count] = count;
    if (!manifest.sample_count_minimum) return;
    const auto number = [&](const std::string& name) {
        return static_cast<double>(std::get<std::int64_t>(from.at(name)));
    };
    const double ratio = number(*manifest.sample_count_minimum) / number(*manifest.sample_count);
    values[*manifest.sample_count_minimum] =
        std::max<std::int64_t>(1, std::llround(static_cast<double>(count) * ratio));
}

void reset_idle(const Manifest& manifest, ParameterValues& values, bool on_flat_base) {
    for (const Parameter& parameter : manifest.parameters) {
        if (!has_effect(parameter, values, on_flat_base)) values.at(parameter.name) = parameter.default_value;
    }
}

Manifest load_manifest(const std::filesystem::path& folder, const std::filesystem::path& shared,
                       const std::vector<std::string>& known_features) {
    // "techniques/mine/" has an empty last component.
    const std::filesystem::path named = folder.has_filename() ? folder : folder.parent_path();
    const std::string id = std::filesystem::absolute(named).lexically_normal().filename().string();
    const std::filesystem::path file = folder / "technique.json";
    Manifest manifest = parse_manifest(read_json_file(file), id, file.string(), shared, folder, known_features);

    const auto require_file = [&](bool is_shared, const std::string& name, const std::string& why) {
        const bool found =
            is_shared ? !find_shared_file(shared, name).empty() : std::filesystem::is_regular_file(folder / name);
        if (!found) {
            fail("{}: {} needs the shader file '{}', which is not in the folder {}; add it", file.string(), why, name,
                 (is_shared ? shared : folder).string());
        }
    };
    for (const std::string& name : shape_kind(manifest.shape.kind).own_files)
        require_file(false, name, fmt::format("the shape \"{}\"", manifest.shape.kind));
    for (const PassDeclaration& pass : manifest.passes)
        require_file(pass.is_shared, pass.shader, "the pass '" + pass.name + "'");
    return manifest;
}

}  // namespace reliefbench
