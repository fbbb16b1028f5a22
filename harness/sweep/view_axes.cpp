#include "sweep/view_axes.hpp"

#include "scene/procedural.hpp"
#include "sweep/height_map_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace reliefbench {

namespace {

constexpr double largest_view_angle = 90;  // excluded
constexpr double full_turn = 360;
constexpr double largest_distance = 1000;
constexpr double smallest_fov = 1;
constexpr double largest_fov = 170;
constexpr double largest_height_scale = 10;
constexpr double largest_tiling = 1024;

/// Above 0 and up to the maximum.
double read_positive(const JsonView& view, double maximum) {
    const double number = view.number(0, maximum);
    if (number == 0) view.fail_expected(fmt::format("a number above 0, up to {}", maximum));
    return number;
}

double read_view_angle(const JsonView& view) {
    if (!view.json().is_number() || !(view.json().get<double>() < largest_view_angle)) {
        view.fail_expected("an angle in degrees from 0 to below 90");
    }
    return view.number(0, largest_view_angle);
}

/// An axis that is one number of the view.
template <typename Read, typename Member>
ViewAxis number_axis(std::string name, Read read, Member member) {
    return {std::move(name),
            [read, member](const JsonView& json) -> ViewSetting {
                return [number = read(json), member](ViewKey& view) { member(view) = number; };
            },
            [member](const ViewKey& view) { return Json(member(view)); }};
}

/// An axis that is one of a few words, of an enumeration in the order of its enumerators.
template <typename Enumeration, typename Member>
ViewAxis word_axis(std::string name, std::vector<std::string> words, Member member) {
    return {std::move(name),
            [words, member](const JsonView& json) -> ViewSetting {
                const auto value = static_cast<Enumeration>(json.choice(words));
                return [value, member](ViewKey& view) { member(view) = value; };
            },
            [words, member](const ViewKey& view) { return Json(words[static_cast<std::size_t>(member(view))]); }};
}

/// Makes an axis one that only perspective views have.
ViewAxis perspective_only(ViewAxis axis) {
    axis.value = [value = std::move(axis.value)](const ViewKey& view) {
        return view.view.camera.projection == Projection::perspective ? value(view) : Json();
    };
    return axis;
}

ViewAxis heightmap_axis() {
    return {"heightmap",
            [](const JsonView& json) -> ViewSetting {
                return [value = read_height_map_value(json)](ViewKey& view) {
                    const Resolution swept_size = view.height_map.size;
                    view.height_map = value.source;
                    if (!value.has_own_size && is_procedural(value.source.name)) view.height_map.size = swept_size;
                };
            },
            [](const ViewKey& view) { return Json(height_map_label(view.height_map)); }};
}

ViewAxis heightmap_size_axis() {
    return {"heightmap_size",
            [](const JsonView& json) -> ViewSetting {
                return [size = read_resolution(json)](ViewKey& view) { view.height_map.size = size; };
            },
            [](const ViewKey& view) {
                return is_procedural(view.height_map.name) ? Json(to_string(view.height_map.size)) : Json();
            }};
}

ViewAxis resolution_axis() {
    return {"resolution",
            [](const JsonView& json) -> ViewSetting {
                return [size = read_resolution(json)](ViewKey& view) { view.view.resolution = size; };
            },
            [](const ViewKey& view) { return Json(to_string(view.view.resolution)); }};
}

std::vector<ViewAxis> make_view_axes() {
    const auto positive_to = [](double maximum) {
        return [maximum](const JsonView& json) { return read_positive(json, maximum); };
    };
    std::vector<ViewAxis> axes;
    axes.push_back(heightmap_axis());
    axes.push_back(heightmap_size_axis());
    axes.push_back(word_axis<HeightFormat>(
        "height_format", {"r8", "r16", "r32f"}, [](auto& key) -> auto& { return key.height_format; }));
    axes.push_back(number_axis(
        "view_angle", read_view_angle, [](auto& key) -> auto& { return key.view.camera.view_angle; }));
    axes.push_back(number_axis(
        "azimuth", [](const JsonView& json) { return json.number(-full_turn, full_turn); },
        [](auto& key) -> auto& { return key.view.camera.azimuth; }));
    axes.push_back(word_axis<Projection>(
        "projection", {"perspective", "parallel"}, [](auto& key) -> auto& { return key.view.camera.projection; }));
    axes.push_back(perspective_only(number_axis(
        "distance", positive_to(largest_distance), [](auto& key) -> auto& { return key.view.camera.distance; })));
    axes.push_back(perspective_only(number_axis(
        "fov", [](const JsonView& json) { return json.number(smallest_fov, largest_fov); },
        [](auto& key) -> auto& { return key.view.camera.fov; })));
    axes.push_back(number_axis(
        "height_scale", positive_to(largest_height_scale),
        [](auto& key) -> auto& { return key.view.relief.height_scale; }));
    axes.push_back(number_axis(
        "tiling", positive_to(largest_tiling), [](auto& key) -> auto& { return key.view.relief.tiling; }));
    axes.push_back(word_axis<Boundary>(
        "boundary", {"clip", "repeat"}, [](auto& key) -> auto& { return key.view.relief.boundary; }));
    axes.push_back(resolution_axis());
    return axes;
}

}  // namespace

const std::vector<ViewAxis>& view_axes() {
    static const std::vector<ViewAxis> axes = make_view_axes();
    return axes;
}

const ViewAxis* find_view_axis(const std::string& name) {
    const auto found = std::ranges::find(view_axes(), name, &ViewAxis::name);
    return found == view_axes().end() ? nullptr : &*found;
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
    return view;
}

std::string view_id(const ViewKey& view) {
    static const std::vector<Json> defaults = [] {
        std::vector<Json> values;
        ViewKey plain;
        plain.height_map.name = procedural_maps().front().name;
        for (const ViewAxis& axis : view_axes())
            values.push_back(axis.value(plain));
        return values;
    }();
    std::string id;
    for (std::size_t index = 0; index < view_axes().size(); ++index) {
        const ViewAxis& axis = view_axes()[index];
        const Json value = axis.value(view);
        const bool always_shown = index == 0;
        if (value.is_null() || (!always_shown && value == defaults[index])) continue;
        if (!id.empty()) id += ' ';
        id += axis.name + '=' + scalar_text(value);
    }
    return id;
}

std::string scalar_text(const Json& scalar) {
    if (scalar.is_string()) return scalar.get<std::string>();
    if (scalar.is_number_float()) return fmt::format("{}", scalar.get<double>());
    return scalar.dump();
}

}  // namespace reliefbench
