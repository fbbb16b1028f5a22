#include "sweep/view_axes.hpp"

#include "core/json_lookup.hpp"
#include "core/suggest.hpp"
#include "sweep/axis_kinds.hpp"
#include "sweep/base_axes.hpp"
#include "sweep/height_map_value.hpp"
#include "sweep/material_axes.hpp"
#include "sweep/picture_axes.hpp"
#include "sweep/self_shadow_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <utility>

namespace reliefbench {

namespace {

constexpr NumberRange view_angles{.minimum = 0, .maximum = 90, .below_maximum = true};
constexpr NumberRange azimuths{.minimum = -360, .maximum = 360};
constexpr NumberRange distances{.minimum = 0, .maximum = 1000, .above_minimum = true};
constexpr NumberRange fields_of_view{.minimum = 1, .maximum = 170};
constexpr NumberRange height_scales{.minimum = 0, .maximum = 10, .above_minimum = true};
constexpr NumberRange polygon_heights{.minimum = 0, .maximum = 1};
constexpr NumberRange tilings{.minimum = 0, .maximum = 1024, .above_minimum = true};

constexpr const char* no_albedo = "none";

ViewAxis moving_no_hits(ViewAxis axis) {
    axis.moves_hits = false;
    return axis;
}

bool is_perspective(const View& view) {
    return view.camera.projection == Projection::perspective;
}

std::string size_values() {
    return fmt::format("N or NxM, from 1 to {}", largest_side);
}

ViewAxis heightmap_axis() {
    return {"heightmap",
            {.unit = "",
             .values = "a name, a file or an object",
             .help = "what gives the relief its heights (`list heightmaps`); every configuration has it",
             .also_called = {"map", "maps", "texture", "image", "file", "input", "height_map", "displacement"}},
            [](const JsonView& json) -> ViewSetting {
                return [value = read_height_map_value(json)](ViewKey& view) {
                    const HeightMapSource swept = view.height_map;
                    view.height_map = value.source;
                    if (!value.has_own_size && is_procedural(value.source.name)) view.height_map.size = swept.size;
                    if (value.source.albedo.empty()) view.height_map.albedo = swept.albedo;
                };
            },
            [](const ViewKey& view) { return Json(height_map_label(view.height_map)); }};
}

ViewAxis heightmap_size_axis() {
    return {"heightmap_size",
            {.unit = "texels",
             .values = size_values(),
             .help = "sides of procedural height maps; files have their own",
             .also_called = {"size", "map_size", "texture_size", "texels"}},
            [](const JsonView& json) -> ViewSetting {
                return [size = read_resolution(json)](ViewKey& view) { view.height_map.size = size; };
            },
            [](const ViewKey& view) {
                return is_procedural(view.height_map.name) ? Json(to_string(view.height_map.size)) : Json();
            },
            Json(to_string(plain_view().height_map.size))};
}

ViewAxis albedo_axis() {
    ViewAxis axis{"albedo",
                  {.unit = "",
                   .values = "an image file, or none",
                   .help = "colours of the surface, sRGB; a height map's object may have its own",
                   .also_called = {"colour", "color", "diffuse", "base_color", "basecolor", "colormap"}},
                  [](const JsonView& json) -> ViewSetting {
                      const std::string file = json.string();
                      if (file.empty()) json.fail_expected("the path of an image file, or \"none\"");
                      return [file](ViewKey& view) { view.height_map.albedo = file == no_albedo ? "" : file; };
                  },
                  [](const ViewKey& view) {
                      const std::filesystem::path file = view.height_map.albedo;
                      return Json(file.empty() ? no_albedo : file.filename().string());
                  },
                  Json(no_albedo)};
    axis.part_of_height_map = true;
    return axis;
}

ViewAxis resolution_axis() {
    return {"resolution",
            {.unit = "pixels",
             .values = size_values(),
             .help = "of the image",
             .also_called = {"size", "width", "height", "res", "pixels", "image_size", "dimensions"}},
            [](const JsonView& json) -> ViewSetting {
                return [size = read_resolution(json)](ViewKey& view) { view.view.resolution = size; };
            },
            [](const ViewKey& view) { return Json(to_string(view.view.resolution)); },
            Json(to_string(plain_view().view.resolution))};
}

std::vector<ViewAxis> camera_axes() {
    std::vector<ViewAxis> axes;
    axes.push_back(number_axis(
        "view_angle",
        {.unit = "degrees",
         .help = "of the camera: 0 is head-on, towards 90 grazing",
         .also_called = {"angle", "angles", "theta", "elevation", "tilt", "view", "inclination", "grazing"}},
        view_angles, [](auto& key) -> auto& { return key.view.camera.view_angle; }));
    axes.push_back(number_axis(
        "azimuth",
        {.unit = "degrees",
         .help = "of the camera; -90 shows the map as in its file",
         .also_called = {"angle", "phi", "rotation", "yaw", "heading"}},
        azimuths, [](auto& key) -> auto& { return key.view.camera.azimuth; }));
    axes.push_back(word_axis<Projection>(
        "projection",
        {.help = "parallel rays have one angle and fill the image with relief",
         .also_called = {"camera", "orthographic", "ortho"}},
        {"perspective", "parallel"}, [](auto& key) -> auto& { return key.view.camera.projection; }));
    axes.push_back(
        only_where(is_perspective, number_axis(
                                       "distance",
                                       {.unit = "patch sides",
                                        .help = "from the eye to the patch's centre; perspective only",
                                        .also_called = {"zoom", "range", "dist"}},
                                       distances, [](auto& key) -> auto& { return key.view.camera.distance; })));
    axes.push_back(
        only_where(is_perspective, number_axis(
                                       "fov",
                                       {.unit = "degrees",
                                        .help = "vertical field of view; perspective only",
                                        .also_called = {"field_of_view", "fovy", "focal_length"}},
                                       fields_of_view, [](auto& key) -> auto& { return key.view.camera.fov; })));
    return axes;
}

std::vector<ViewAxis> relief_axes() {
    std::vector<ViewAxis> axes;
    axes.push_back(number_axis(
        "height_scale",
        {.unit = "patch sides",
         .help = "depth of the relief",
         .also_called = {"scale", "depth", "height", "amplitude", "parallax_scale", "bump_scale", "strength"}},
        height_scales, [](auto& key) -> auto& { return key.view.relief.height_scale; }));
    axes.push_back(number_axis(
        "tiling",
        {.unit = "",
         .help = "repeats of the height map per patch side",
         .also_called = {"repeats", "tiles", "uv_scale"}},
        tilings, [](auto& key) -> auto& { return key.view.relief.tiling; }));
    axes.push_back(word_axis<Boundary>(
        "boundary",
        {.help = "clip: a hit outside the patch is a miss; repeat: the relief goes on for ever",
         .also_called = {"wrap", "clip", "repeat", "address_mode", "border"}},
        {"clip", "repeat"}, [](auto& key) -> auto& { return key.view.relief.boundary; }));
    axes.push_back(number_axis(
        "polygon_height",
        {.unit = "",
         .help = "height at which the polygon lies: 1, and the relief is sunk into it; 0, and it stands on it",
         .also_called = {"base_height", "height_base", "height_map_base", "midlevel", "mid_level", "zero_level",
                         "base_plane", "displacement_bias"}},
        polygon_heights, [](auto& key) -> auto& { return key.view.relief.polygon_height; }));
    return axes;
}

std::vector<ViewAxis> make_view_axes() {
    std::vector<ViewAxis> axes;
    const auto append = [&axes](std::vector<ViewAxis> others) { std::ranges::move(others, std::back_inserter(axes)); };
    axes.push_back(heightmap_axis());
    axes.push_back(heightmap_size_axis());
    axes.push_back(albedo_axis());
    axes.push_back(word_axis<HeightFormat>(
        "height_format",
        {.help = "what heights are stored in for the device",
         .also_called = {"format", "bits", "bit_depth", "precision"}},
        {"r8", "r16", "r32f"}, [](auto& key) -> auto& { return key.height_format; }));
    append(camera_axes());
    append(base_axes());
    append(relief_axes());
    axes.push_back(resolution_axis());
    for (ViewAxis& axis : self_shadow_axes())
        axes.push_back(moving_no_hits(std::move(axis)));
    axes.push_back(moving_no_hits(word_axis<DepthWrite>(
        "depth_write",
        {.help =
             "depth left to what is drawn with it: the point's, the polygon's, or the point's declared conservative",
         .also_called = {"depth", "z_write", "zwrite", "early_z"}},
        {"on", "off", "conservative"}, [](auto& key) -> auto& { return key.view.depth_write; })));
    for (ViewAxis& axis : material_axes())
        axes.push_back(moving_no_hits(std::move(axis)));
    for (ViewAxis& axis : picture_axes())
        axes.push_back(moving_no_hits(std::move(axis)));
    return axes;
}

/// What is swept as the axes of the view are, and is a parameter of techniques.
const AxisDescription& sample_count_description() {
    static const AxisDescription description{
        .unit = "steps",
        .values = "integers from 1",
        .help = "the sample count of every technique that has one (`list techniques` marks it)",
        .also_called = {"samples", "sample", "steps", "step", "layers", "num_samples", "num_steps", "num_layers",
                        "iterations", "taps", "slices", "linear_steps", "step_count", "layer_count"}};
    return description;
}

Json axis_to_json(const std::string& name, const AxisDescription& description, const Json& default_value) {
    return {{"axis", name},
            {"unit", description.unit},
            {"default", default_value},
            {"values", description.values},
            {"description", description.help}};
}

}  // namespace

const std::vector<ViewAxis>& view_axes() {
    static const std::vector<ViewAxis> axes = make_view_axes();
    return axes;
}

Json axis_list_json() {
    Json json = Json::array();
    for (const ViewAxis& axis : view_axes())
        json.push_back(axis_to_json(axis.name, axis.description, axis.default_value));
    json.push_back(axis_to_json("sample_count", sample_count_description(), nullptr));
    return json;
}

std::vector<std::string> axes_also_called(const std::string& word) {
    std::string lower = word;
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::ranges::replace(lower, '-', '_');
    const auto has_word = [&](const AxisDescription& description) {
        return std::ranges::find(description.also_called, lower) != description.also_called.end();
    };
    std::vector<std::string> names;
    for (const ViewAxis& axis : view_axes()) {
        if (has_word(axis.description)) names.push_back(axis.name);
    }
    if (has_word(sample_count_description())) names.emplace_back("sample_count");
    return names;
}

const ViewAxis* find_view_axis(const std::string& name) {
    const auto found = std::ranges::find(view_axes(), name, &ViewAxis::name);
    return found == view_axes().end() ? nullptr : &*found;
}

ViewKey hits_view(ViewKey view) {
    for (const ViewAxis& axis : view_axes()) {
        if (!axis.moves_hits) axis.read(JsonView(axis.default_value, axis.name))(view);
    }
    return view;
}

ViewKey make_view(const std::vector<ViewChoice>& choices) {
    ViewKey view;
    const auto is_heightmap = [](const ViewChoice& choice) { return choice.axis == &view_axes().front(); };
    // The height map takes over the size swept, or else brings one of its own.
    for (const ViewChoice& choice : choices) {
        if (!is_heightmap(choice)) (*choice.setting)(view);
    }
    for (const ViewChoice& choice : choices) {
        if (is_heightmap(choice)) (*choice.setting)(view);
    }
    if (!is_procedural(view.height_map.name)) view.height_map.size = HeightMapSource{}.size;
    if (view.view.camera.projection == Projection::parallel) {
        view.view.camera.distance = Camera{}.distance;
        view.view.camera.fov = Camera{}.fov;
    }
    if (!view.base.is_generated()) {
        view.base.curvature = BaseSource{}.curvature;
        view.base.segments = BaseSource{}.segments;
    }
    if (view.base.kind != BaseSource::Kind::file) view.base.fit = BaseSource{}.fit;
    reset_unused(view.view.self_shadow);
    reset_unused(view.view.material);
    set_polygon_height(view.view, view.view.relief.polygon_height);
    return view;
}

std::string view_id(const ViewKey& view) {
    std::string id;
    for (const ViewAxis& axis : view_axes()) {
        const Json value = axis.value(view);
        if (axis.part_of_height_map || value.is_null() || value == axis.default_value) continue;
        if (!id.empty()) id += ' ';
        id += axis.name + '=' + scalar_text(value);
    }
    return id;
}

}  // namespace reliefbench
