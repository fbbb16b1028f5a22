#include "sweep/settings.hpp"

#include "sweep/configuration_keys.hpp"

#include <fmt/format.h>

#include <limits>

namespace reliefbench {

namespace {

const std::vector<std::string> truth_kinds{"exact", "mesh"};
/// In the order of SamplingSettings::Rule.
const std::vector<std::string> sampling_rules{"precision", "fixed", "time"};

/// In the order of MotionSettings::Along.
const std::vector<std::string> motion_directions{"view_angle", "azimuth"};

/// In the order of SceneObject::Shape.
const std::vector<std::string> object_shapes{"sphere", "box"};

constexpr int largest_subdivision = 64;
/// As reference/truth.hpp has it.
constexpr int max_truth_samples = 1024;
constexpr int max_rounds = 100000;
constexpr int max_draws = 10000;
constexpr double longest_pass_ms = 10000;
constexpr double finest_precision = 1e-6;
constexpr double coarsest_precision = 1;
constexpr double longest_budget_s = 86400;
constexpr double longest_preparation_s = 1e7;
constexpr std::size_t max_lights = 3;
constexpr double largest_radiance = 1e6;
constexpr double largest_shininess = 1e5;
constexpr double largest_length = 1e6;
constexpr int max_frames = 1000;
constexpr double longest_step_degrees = 10;
constexpr double longest_arc_degrees = 60;
/// With 1 no frame would ever be seen.
constexpr double largest_history_weight = 0.999;
constexpr double largest_angular_radius = 45;
/// In patch sides; there are floats in the way.
constexpr double largest_object = 100;

glm::dvec3 read_vector(const JsonView& view, double minimum, double maximum) {
    const std::vector<JsonView> items = view.items();
    if (items.size() != 3) view.fail_expected("three numbers");
    return {items[0].number(minimum, maximum), items[1].number(minimum, maximum), items[2].number(minimum, maximum)};
}

glm::dvec3 read_colour(const JsonView& view) {
    return read_vector(view, 0, largest_radiance);
}

Json to_json(const glm::dvec3& vector) {
    return Json::array({vector.x, vector.y, vector.z});
}

DirectionalLight read_light(const JsonView& view) {
    view.require_only(configuration_keys::light());
    DirectionalLight light;
    if (view.has("direction")) {
        light.direction = read_vector(view.at("direction"), -largest_length, largest_length);
        if (light.direction == glm::dvec3(0)) view.at("direction").fail_expected("a direction that is not zero");
    }
    if (view.has("colour")) light.colour = read_colour(view.at("colour"));
    if (view.has("angular_radius")) light.angular_radius = view.at("angular_radius").number(0, largest_angular_radius);
    return light;
}

Fog read_fog(const JsonView& view) {
    view.require_only(configuration_keys::fog());
    Fog fog;
    if (view.has("start")) fog.start = view.at("start").number(0, largest_length);
    if (view.has("range")) {
        fog.range = view.at("range").number(0, largest_length);
        if (fog.range == 0) view.at("range").fail_expected("a length above 0");
    }
    if (view.has("colour")) fog.colour = read_colour(view.at("colour"));
    return fog;
}

}  // namespace

namespace configuration_keys {

const std::vector<std::string>& truth() {
    static const std::vector<std::string> keys{"kind", "subdivision", "samples"};
    return keys;
}

const std::vector<std::string>& sampling() {
    static const std::vector<std::string> keys{
        "rule", "rounds", "precision", "budget_s", "samples_per_visit", "warm_up", "minimum_pass_ms"};
    return keys;
}

const std::vector<std::string>& preparation() {
    static const std::vector<std::string> keys{"limit_s"};
    return keys;
}

const std::vector<std::string>& lighting() {
    static const std::vector<std::string> keys{"lights", "ambient", "specular",  "shininess",
                                               "fog",    "enabled", "background"};
    return keys;
}

const std::vector<std::string>& light() {
    static const std::vector<std::string> keys{"direction", "colour", "angular_radius"};
    return keys;
}

const std::vector<std::string>& object() {
    static const std::vector<std::string> keys{"shape", "centre", "radius", "half_size", "colour"};
    return keys;
}

const std::vector<std::string>& fog() {
    static const std::vector<std::string> keys{"start", "range", "colour"};
    return keys;
}

const std::vector<std::string>& motion() {
    static const std::vector<std::string> keys{"frames", "degrees", "along", "history_weight", "neighbourhood_clamp"};
    return keys;
}

}  // namespace configuration_keys

TruthSettings read_truth(const JsonView& view) {
    view.require_only(configuration_keys::truth());
    TruthSettings truth;
    if (view.has("kind")) truth.kind = static_cast<TruthSettings::Kind>(view.at("kind").choice(truth_kinds));
    if (view.has("subdivision")) {
        truth.subdivision = static_cast<int>(view.at("subdivision").integer(1, largest_subdivision));
    }
    if (view.has("samples")) truth.samples = static_cast<int>(view.at("samples").integer(1, max_truth_samples));
    return truth;
}

SamplingSettings read_sampling(const JsonView& view) {
    view.require_only(configuration_keys::sampling());
    SamplingSettings sampling;
    if (view.has("rule")) sampling.rule = static_cast<SamplingSettings::Rule>(view.at("rule").choice(sampling_rules));
    if (view.has("rounds")) {
        const JsonView rounds = view.at("rounds");
        sampling.rounds = static_cast<int>(rounds.integer(1, max_rounds));
        if (sampling.rule == SamplingSettings::Rule::precision &&
            sampling.rounds < SamplingSettings::rounds_for_interval) {
            rounds.fail_expected(
                fmt::format("at least {} rounds for the rule \"precision\" (fewer have no 95 % interval of the median; "
                            "\"rule\": \"fixed\" takes any number)",
                            SamplingSettings::rounds_for_interval));
        }
    }
    if (view.has("precision")) sampling.precision = view.at("precision").number(finest_precision, coarsest_precision);
    if (view.has("budget_s")) {
        sampling.budget_s = view.at("budget_s").number(0, longest_budget_s);
        if (sampling.budget_s == 0) view.at("budget_s").fail_expected("seconds above 0");
    }
    if (view.has("samples_per_visit")) {
        sampling.samples_per_visit = static_cast<int>(view.at("samples_per_visit").integer(1, max_draws));
    }
    if (view.has("warm_up")) sampling.warm_up = static_cast<int>(view.at("warm_up").integer(0, max_draws));
    if (view.has("minimum_pass_ms")) sampling.minimum_pass_ms = view.at("minimum_pass_ms").number(0, longest_pass_ms);
    return sampling;
}

PreparationLimit read_preparation(const JsonView& view) {
    view.require_only(configuration_keys::preparation());
    PreparationLimit preparation;
    if (view.has("limit_s")) preparation.limit_s = view.at("limit_s").number(0, longest_preparation_s);
    return preparation;
}

Lighting read_lighting(const JsonView& view) {
    view.require_only(configuration_keys::lighting());
    Lighting lighting;
    if (view.has("lights")) {
        lighting.lights.clear();
        for (const JsonView& item : view.at("lights").items())
            lighting.lights.push_back(read_light(item));
        if (lighting.lights.size() > max_lights) {
            view.at("lights").fail_expected(fmt::format("at most {} lights", max_lights));
        }
    }
    if (view.has("ambient")) lighting.ambient = read_colour(view.at("ambient"));
    if (view.has("specular")) lighting.specular = read_colour(view.at("specular"));
    if (view.has("shininess")) lighting.shininess = view.at("shininess").number(0, largest_shininess);
    if (view.has("fog")) lighting.fog = read_fog(view.at("fog"));
    if (view.has("enabled")) lighting.enabled = view.at("enabled").boolean();
    if (view.has("background")) lighting.background = read_colour(view.at("background"));
    return lighting;
}

MotionSettings read_motion(const JsonView& view) {
    view.require_only(configuration_keys::motion());
    MotionSettings motion;
    if (view.has("frames")) motion.frames = static_cast<int>(view.at("frames").integer(2, max_frames));
    if (view.has("degrees")) {
        motion.degrees = view.at("degrees").number(0, longest_step_degrees);
        if (motion.degrees == 0 && !view.has("history_weight")) {
            view.at("degrees").fail_expected(
                "degrees above 0 (a still camera has errors in motion with a history only)");
        }
    }
    if (view.has("along")) {
        motion.along = static_cast<MotionSettings::Along>(view.at("along").choice(motion_directions));
    }
    if (view.has("history_weight")) {
        motion.history_weight = view.at("history_weight").number(0, largest_history_weight);
    }
    if (view.has("neighbourhood_clamp")) {
        motion.neighbourhood_clamp = view.at("neighbourhood_clamp").boolean();
        if (!motion.history_weight) {
            view.at("neighbourhood_clamp").fail_expected("a history_weight beside it: there is no history to clamp");
        }
    }
    if ((motion.frames - 1) * motion.degrees > longest_arc_degrees) {
        view.fail_expected(fmt::format("an arc of at most {} degrees, (frames - 1) * degrees", longest_arc_degrees));
    }
    return motion;
}

Camera camera_in_motion(const Camera& camera, const MotionSettings& motion, int frame) {
    Camera moved = camera;
    const double degrees = frame * motion.degrees;
    if (motion.along == MotionSettings::Along::view_angle) {
        moved.view_angle -= degrees;
    } else {
        moved.azimuth += degrees;
    }
    return moved;
}

SceneObject read_object(const JsonView& view) {
    view.require_only(configuration_keys::object());
    SceneObject object;
    object.shape = static_cast<SceneObject::Shape>(view.at("shape").choice(object_shapes));
    const bool sphere = object.shape == SceneObject::Shape::sphere;
    const char* const other = sphere ? "half_size" : "radius";
    if (view.has(other)) view.at(other).fail_expected(sphere ? "no half_size of a sphere" : "no radius of a box");
    if (view.has("centre")) object.centre = read_vector(view.at("centre"), -largest_object, largest_object);
    if (view.has("radius")) {
        object.radius = view.at("radius").number(0, largest_object);
        if (object.radius == 0) view.at("radius").fail_expected("a radius above 0");
    }
    if (view.has("half_size")) {
        object.half_size = read_vector(view.at("half_size"), 0, largest_object);
        if (object.half_size.x == 0 || object.half_size.y == 0 || object.half_size.z == 0) {
            view.at("half_size").fail_expected("three lengths above 0");
        }
    }
    if (view.has("colour")) object.colour = read_colour(view.at("colour"));
    return object;
}

Json to_json(const SceneObject& object) {
    Json json = Json::object();
    json["shape"] = object_shapes[static_cast<std::size_t>(object.shape)];
    json["centre"] = to_json(object.centre);
    if (object.shape == SceneObject::Shape::sphere) json["radius"] = object.radius;
    if (object.shape == SceneObject::Shape::box) json["half_size"] = to_json(object.half_size);
    json["colour"] = to_json(object.colour);
    return json;
}

Json to_json(const TruthSettings& truth) {
    Json json{{"kind", truth_kinds[static_cast<std::size_t>(truth.kind)]}, {"subdivision", truth.subdivision}};
    // Runs made before truths had several have the same as those with one.
    if (truth.samples != TruthSettings{}.samples) json["samples"] = truth.samples;
    return json;
}

Json to_json(const SamplingSettings& sampling) {
    return {{"rule", sampling_rules[static_cast<std::size_t>(sampling.rule)]},
            {"rounds", sampling.rounds},
            {"precision", sampling.precision},
            {"budget_s", sampling.budget_s},
            {"samples_per_visit", sampling.samples_per_visit},
            {"warm_up", sampling.warm_up},
            {"minimum_pass_ms", sampling.minimum_pass_ms}};
}

Json to_json(const PreparationLimit& preparation) {
    return {{"limit_s", preparation.limit_s}};
}

Json to_json(const Lighting& lighting) {
    Json json = Json::object();
    json["lights"] = Json::array();
    for (const DirectionalLight& light : lighting.lights) {
        Json each{{"direction", to_json(light.direction)}, {"colour", to_json(light.colour)}};
        // Runs made before lights had one are under the same lighting as those with the default.
        if (light.angular_radius != DirectionalLight{}.angular_radius) each["angular_radius"] = light.angular_radius;
        json["lights"].push_back(std::move(each));
    }
    json["ambient"] = to_json(lighting.ambient);
    json["specular"] = to_json(lighting.specular);
    json["shininess"] = lighting.shininess;
    if (lighting.fog) {
        json["fog"] = {
            {"start", lighting.fog->start}, {"range", lighting.fog->range}, {"colour", to_json(lighting.fog->colour)}};
    }
    json["enabled"] = lighting.enabled;
    json["background"] = to_json(lighting.background);
    return json;
}

Json to_json(const MotionSettings& motion) {
    Json json = {{"frames", motion.frames},
                 {"degrees", motion.degrees},
                 {"along", motion_directions[static_cast<std::size_t>(motion.along)]}};
    // Without a history a run's record is as those of versions that know none.
    if (motion.history_weight) {
        json["history_weight"] = *motion.history_weight;
        json["neighbourhood_clamp"] = motion.neighbourhood_clamp;
    }
    return json;
}

}  // namespace reliefbench
