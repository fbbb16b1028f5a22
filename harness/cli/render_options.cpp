#include "cli/render_options.hpp"

#include "cli/output_file.hpp"
#include "core/error.hpp"
#include "core/json.hpp"
#include "core/split.hpp"
#include "core/suggest.hpp"
#include "manifest/parameter_json.hpp"
#include "sweep/configuration.hpp"
#include "sweep/override.hpp"
#include "sweep/override_effects.hpp"
#include "sweep/settings.hpp"
#include "sweep/view_axes.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <utility>

namespace reliefbench {

namespace {

constexpr const char* picture_name = "picture";
constexpr const char* truth_name = "truth";

std::vector<std::string> names_to_show() {
    std::vector<std::string> names{picture_name, truth_name};
    for (const PixelMapScale& scale : pixel_map_scales()) {
        names.push_back(scale.name);
    }
    return names;
}

/// "--set name=value" by its first equals sign.
std::pair<std::string, std::string> split_setting(const std::string& argument) {
    const std::size_t equals = argument.find('=');
    if (equals == std::string::npos) fail("--set {}: expected parameter=value", argument);
    return {argument.substr(0, equals), argument.substr(equals + 1)};
}

ParameterValue parse_setting(const Parameter& parameter, const std::string& text, const std::string& argument) {
    ParameterValue value = parse_parameter_value(parameter, text);
    const std::string objection = check_parameter_value(parameter, value);
    if (!objection.empty()) fail("--set {}: {}", argument, objection);
    return value;
}

/// Techniques with the parameters set for them; each parameter must be one of at least one of them.
Json selections(const std::vector<const Manifest*>& manifests, const std::vector<std::string>& settings) {
    std::vector<Json> selected;
    for (const Manifest* manifest : manifests) {
        selected.push_back({{"technique", manifest->id}});
    }
    for (const std::string& argument : settings) {
        const auto [name, text] = split_setting(argument);
        std::vector<std::string> known;
        bool taken = false;
        for (std::size_t index = 0; index < manifests.size(); ++index) {
            for (const Parameter& parameter : manifests[index]->parameters) {
                known.push_back(parameter.name);
            }
            if (const Parameter* parameter = manifests[index]->find_parameter(name)) {
                selected[index]["parameters"][name] = to_json(parse_setting(*parameter, text, argument));
                taken = true;
            }
        }
        if (taken) continue;
        std::sort(known.begin(), known.end());
        known.erase(std::unique(known.begin(), known.end()), known.end());
        if (name == "preset")
            fail("--set {}: a preset is not a parameter but sets several; use -a {}", argument, argument);
        if (find_view_axis(name))
            fail("--set {0}: {1} is an axis of the view, not a parameter; use -a {0}", argument, name);
        fail("--set {}: {} parameter '{}'{}; there are: {}", argument,
             manifests.size() == 1 ? fmt::format("the technique '{}' has no", manifests.front()->id)
                                   : "none of the techniques has a",
             name, did_you_mean(name, known), known.empty() ? "none" : join(known));
    }
    return selected;
}

std::vector<const Manifest*> chosen_techniques(const RenderOptions& options, const TechniqueLibrary& library) {
    std::vector<const Manifest*> chosen;
    for (const std::string& argument : options.techniques) {
        const std::string option = "--technique " + argument;
        for (const Json& id : parse_values("technique", argument, option))
            chosen.push_back(&library.get(JsonView(id, option).string()).manifest);
    }
    if (chosen.empty() && options.contact_sheet) {
        for (const Technique& technique : library.techniques) {
            chosen.push_back(&technique.manifest);
        }
    }
    if (chosen.empty()) fail("--technique is required; `reliefbench list techniques` names those there are");
    if (chosen.size() > 1 && !options.contact_sheet) {
        fail("--technique names {} techniques, but one cell is drawn: choose one, or ask for a --contact-sheet",
             chosen.size());
    }
    return chosen;
}

/// The axes asked for, that of an animation included.
std::vector<Override> overrides_of(const RenderOptions& options) {
    std::vector<Override> overrides;
    for (const std::string& argument : options.axes)
        overrides.push_back(parse_override(argument));
    if (options.animation.empty()) return overrides;
    if (is_standard_output(options.output)) {
        fail("--animate {}: an animation is many files, but '-' is standard output; give a file name such as turn.png",
             options.animation);
    }
    if (options.contact_sheet) fail("--animate and --contact-sheet exclude each other: make one sheet per call");
    const Override animated = parse_override(options.animation, "--animate");
    if (animated.name == "resolution") {
        fail("--animate {}: frames of one animation have one resolution; animate another axis", options.animation);
    }
    if (animated.values.size() < 2) {
        fail("--animate {}: an animation takes at least two values, for example view_angle=[0:80:2]",
             options.animation);
    }
    for (const Override& given : overrides) {
        if (given.name == animated.name) {
            fail("{}: --animate gives the values of '{}' already", given.argument, animated.name);
        }
    }
    overrides.push_back(animated);
    return overrides;
}

void check_single_values(const RenderOptions& options) {
    if (options.contact_sheet) return;
    for (const std::string& argument : options.axes) {
        const std::size_t values = parse_override(argument).values.size();
        if (values == 1) continue;
        fail(
            "-a {}: render draws one cell, so that an axis takes one value, not {}; --contact-sheet draws a row for "
            "each, --animate a frame",
            argument, values);
    }
}

}  // namespace

Lighting lighting_of(const RenderOptions& options) {
    if (options.lighting.empty()) return {};
    const Json json = parse_json(options.lighting, "--lighting");
    return read_lighting(JsonView(json, "--lighting", ""));
}

std::optional<SceneObject> object_of(const RenderOptions& options) {
    if (options.object.empty()) return std::nullopt;
    const Json json = parse_json(options.object, "--object");
    return read_object(JsonView(json, "--object", ""));
}

std::vector<Shown> shown_by(const RenderOptions& options) {
    const char* const usual = options.contact_sheet ? "truth,picture,uv_error,flip,taps" : "picture,truth,uv_error";
    const std::string list = options.show.empty() ? usual : options.show;
    std::vector<Shown> shown;
    for (const std::string& name : split(list, ',')) {
        const std::vector<std::string> names = names_to_show();
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            fail("--show {}: there is no '{}'{}; there are {}", list, name, did_you_mean(name, names), join(names));
        }
        if (name == picture_name) {
            shown.push_back({Shown::Kind::picture});
        } else if (name == truth_name) {
            shown.push_back({Shown::Kind::truth});
        } else {
            shown.push_back({Shown::Kind::map, parse_pixel_map(name)});
        }
    }
    return shown;
}

OutputKind check_output(const std::string& path) {
    const std::filesystem::path file(path);
    if (is_standard_output(file)) {
        if (isatty(STDOUT_FILENO) == 1) {
            fail(
                "cannot render to '{}': standard output is a terminal; send it into a file or a program, or name a "
                "file",
                path);
        }
        return OutputKind::picture;
    }
    const std::string extension = file.extension().string();
    if (extension != ".png" && extension != ".exr") {
        fail(
            "cannot render to '{}': give a file name that ends in .png (pictures) or .exr (float layers), or - for a "
            "picture on standard output",
            path);
    }
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
        fail("cannot render to '{}': there is no folder '{}'; make it first", path, folder.string());
    }
    return extension == ".png" ? OutputKind::picture : OutputKind::layers;
}

std::vector<Cell> cells_to_render(const RenderOptions& options, const TechniqueLibrary& library) {
    check_single_values(options);
    Json configuration;
    configuration["name"] = "render";
    configuration["techniques"] = selections(chosen_techniques(options, library), options.parameters);
    configuration["axes"] = {
        {"heightmap", "bricks"}, {"resolution", options.contact_sheet ? "192x192" : "512x512"}, {"view_angle", 45}};
    const std::vector<Manifest> manifests = library.manifests();
    const Configuration parsed = configuration_with(configuration, "render", overrides_of(options), manifests);
    std::vector<Cell> cells = expand(parsed, manifests);
    warn_of_overrides(parsed, cells, manifests);
    if (!options.contact_sheet) {
        for (const Cell& cell : cells) {
            if (!cell.skip_reason.empty()) fail("{}: {}", cell.id, cell.skip_reason);
        }
    }
    return cells;
}

std::filesystem::path frame_path(const std::filesystem::path& output, std::size_t frame, std::size_t frames) {
    const std::size_t digits = std::max<std::size_t>(3, std::to_string(frames - 1).size());
    const std::string name =
        fmt::format("{}_{:0{}}{}", output.stem().string(), frame, digits, output.extension().string());
    return output.parent_path() / name;
}

}  // namespace reliefbench
