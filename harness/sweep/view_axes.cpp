#include "sweep/view_axes.hpp"

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
constexpr int most_shadow_steps = 65536;
constexpr double largest_softening = 1000;

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

const ViewKey& plain_view() {
    static const ViewKey view;
    return view;
}

/// An axis that is one number of the view.
template <typename Read, typename Member>
ViewAxis number_axis(std::string name, Read read, Member member) {
    return {std::move(name),
            [read, member](const JsonView& json) -> ViewSetting {
                return [number = read(json), member](ViewKey& view) { member(view) = number; };
            },
            [member](const ViewKey& view) { return Json(member(view)); }, Json(member(plain_view()))};
}

/// An axis that is one of a few words, of an enumeration in the order of its enumerators.
template <typename Enumeration, typename Member>
ViewAxis word_axis(std::string name, std::vector<std::string> words, Member member) {
    return {std::move(name),
            [words, member](const JsonView& json) -> ViewSetting {
                const auto value = static_cast<Enumeration>(json.choice(words));
                return [value, member](ViewKey& view) { member(view) = value; };
            },
            [words, member](const ViewKey& view) { return Json(words[static_cast<std::size_t>(member(view))]); },
            Json(words[static_cast<std::size_t>(member(plain_view()))])};
}

/// Makes an axis one that only some views have.
ViewAxis only_where(bool (*has_use)(const View&), ViewAxis axis) {
    axis.value = [has_use, value = std::move(axis.value)](const ViewKey& view) {
        return has_use(view.view) ? value(view) : Json();
    };
    return axis;
}

ViewAxis moving_no_hits(ViewAxis axis) {
    axis.moves_hits = false;
    return axis;
}

bool is_perspective(const View& view) {
    return view.camera.projection == Projection::perspective;
}

bool has_hard_shadows(const View& view) {
    return view.self_shadow.mode == SelfShadow::Mode::hard;
}

bool has_soft_shadows(const View& view) {
    return view.self_shadow.mode == SelfShadow::Mode::soft;
}

bool has_dykhta_shadows(const View& view) {
    return has_soft_shadows(view) && view.self_shadow.soft == SelfShadow::Soft::dykhta;
}

bool has_tatarchuk_shadows(const View& view) {
    return has_soft_shadows(view) && view.self_shadow.soft == SelfShadow::Soft::tatarchuk;
}

bool has_shadow_steps(const View& view) {
    return has_hard_shadows(view) || has_dykhta_shadows(view);
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
            },
            Json(to_string(plain_view().height_map.size))};
}

ViewAxis resolution_axis() {
    return {"resolution",
            [](const JsonView& json) -> ViewSetting {
                return [size = read_resolution(json)](ViewKey& view) { view.view.resolution = size; };
            },
            [](const ViewKey& view) { return Json(to_string(view.view.resolution)); },
            Json(to_string(plain_view().view.resolution))};
}

int read_shadow_steps(const JsonView& view) {
    return static_cast<int>(view.integer(1, most_shadow_steps));
}

double read_fraction(const JsonView& view) {
    return view.number(0, 1);
}

std::vector<ViewAxis> self_shadow_axes() {
    std::vector<ViewAxis> axes;
    axes.push_back(word_axis<SelfShadow::Mode>(
        "self_shadow", {"off", "hard", "soft"}, [](auto& key) -> auto& { return key.view.self_shadow.mode; }));
    axes.push_back(only_where(has_soft_shadows, word_axis<SelfShadow::Soft>(
                                                    "soft_shadow", {"dykhta", "tatarchuk"},
                                                    [](auto& key) -> auto& { return key.view.self_shadow.soft; })));
    axes.push_back(only_where(has_hard_shadows, number_axis(
                                                    "hard_shadow_bias", read_fraction, [](auto& key) -> auto& {
                                                        return key.view.self_shadow.hard_bias;
                                                    })));
    axes.push_back(only_where(has_dykhta_shadows, number_axis(
                                                      "dykhta_bias", read_fraction, [](auto& key) -> auto& {
                                                          return key.view.self_shadow.dykhta_bias;
                                                      })));
    axes.push_back(only_where(has_shadow_steps, number_axis(
                                                    "shadow_min_steps", read_shadow_steps, [](auto& key) -> auto& {
                                                        return key.view.self_shadow.min_steps;
                                                    })));
    axes.push_back(only_where(has_shadow_steps, number_axis(
                                                    "shadow_max_steps", read_shadow_steps, [](auto& key) -> auto& {
                                                        return key.view.self_shadow.max_steps;
                                                    })));
    axes.push_back(
        only_where(has_tatarchuk_shadows,
                   number_axis(
                       "shadow_softening", [](const JsonView& json) { return json.number(0, largest_softening); },
                       [](auto& key) -> auto& { return key.view.self_shadow.softening; })));
    return axes;
}

/// What a method has no use for is left at its default.
void reset_unused(SelfShadow& self_shadow) {
    const SelfShadow given = self_shadow;
    self_shadow = SelfShadow{};
    self_shadow.mode = given.mode;
    const bool dykhta = given.mode == SelfShadow::Mode::soft && given.soft == SelfShadow::Soft::dykhta;
    if (given.mode == SelfShadow::Mode::soft) self_shadow.soft = given.soft;
    if (given.mode == SelfShadow::Mode::hard) self_shadow.hard_bias = given.hard_bias;
    if (dykhta) self_shadow.dykhta_bias = given.dykhta_bias;
    if (given.mode == SelfShadow::Mode::hard || dykhta) {
        self_shadow.min_steps = given.min_steps;
        self_shadow.max_steps = given.max_steps;
    }
    if (given.mode == SelfShadow::Mode::soft && !dykhta) self_shadow.softening = given.softening;
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
    axes.push_back(only_where(is_perspective, number_axis(
                                                  "distance", positive_to(largest_distance),
                                                  [](auto& key) -> auto& { return key.view.camera.distance; })));
    axes.push_back(only_where(is_perspective,
                              number_axis(
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
    for (ViewAxis& axis : self_shadow_axes())
        axes.push_back(moving_no_hits(std::move(axis)));
    axes.push_back(moving_no_hits(word_axis<DepthWrite>(
        "depth_write", {"on", "off", "conservative"}, [](auto& key) -> auto& { return key.view.depth_write; })));
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
    reset_unused(view.view.self_shadow);
    return view;
}

std::string view_id(const ViewKey& view) {
    std::string id;
    for (const ViewAxis& axis : view_axes()) {
        const Json value = axis.value(view);
        if (value.is_null() || value == axis.default_value) continue;
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
