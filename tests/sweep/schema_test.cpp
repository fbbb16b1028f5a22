#include "core/error.hpp"
#include "fake_techniques.hpp"
#include "json_schema.hpp"
#include "sweep/configuration.hpp"
#include "sweep/configuration_keys.hpp"
#include "sweep/height_map_value.hpp"
#include "sweep/view_axes.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <set>

namespace reliefbench {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;
using testing::UnorderedElementsAreArray;

const fs::path configs = fs::path(RELIEFBENCH_SOURCE_DIR) / "configs";
const fs::path shaders = fs::path(RELIEFBENCH_SOURCE_DIR) / "harness" / "shaders";

Json schema() {
    return read_json_file(configs / "schema.json");
}

std::vector<std::string> property_names(const std::string& pointer) {
    const Json root = schema();
    std::vector<std::string> names;
    for (const auto& [name, property] : root.at(Json::json_pointer(pointer)).at("properties").items()) {
        names.push_back(name);
    }
    return names;
}

std::vector<Manifest> shipped_techniques() {
    std::vector<Manifest> manifests;
    for (const fs::directory_entry& entry : fs::directory_iterator(configs.parent_path() / "techniques")) {
        if (fs::exists(entry.path() / "technique.json")) manifests.push_back(load_manifest(entry.path(), shaders));
    }
    return manifests;
}

std::vector<Cell> expand_shipped(const std::string& name) {
    const std::vector<Manifest> techniques = shipped_techniques();
    return expand(parse_configuration(read_json_file(configs / name), (configs / name).string(), {}, techniques),
                  techniques);
}

TEST(Schema, HasTheKeysThatTheParserTakes) {
    namespace keys = configuration_keys;
    EXPECT_THAT(property_names(""), UnorderedElementsAreArray(keys::top()));
    EXPECT_THAT(property_names("/$defs/technique"), UnorderedElementsAreArray(keys::technique()));
    EXPECT_THAT(property_names("/$defs/truth"), UnorderedElementsAreArray(keys::truth()));
    EXPECT_THAT(property_names("/$defs/sampling"), UnorderedElementsAreArray(keys::sampling()));
    EXPECT_THAT(property_names("/$defs/preparation"), UnorderedElementsAreArray(keys::preparation()));
    EXPECT_THAT(property_names("/$defs/lighting"), UnorderedElementsAreArray(keys::lighting()));
    EXPECT_THAT(property_names("/$defs/light"), UnorderedElementsAreArray(keys::light()));
    EXPECT_THAT(property_names("/$defs/fog"), UnorderedElementsAreArray(keys::fog()));
    EXPECT_THAT(property_names("/$defs/object"), UnorderedElementsAreArray(keys::object()));
    EXPECT_THAT(property_names("/$defs/motion"), UnorderedElementsAreArray(keys::motion()));
    EXPECT_THAT(property_names("/$defs/heightmap/oneOf/1"), UnorderedElementsAreArray(height_map_keys()));
    std::vector<std::string> axes{"sample_count"};
    for (const ViewAxis& axis : view_axes())
        axes.push_back(axis.name);
    EXPECT_THAT(property_names("/$defs/axes"), UnorderedElementsAreArray(axes));
}

TEST(Schema, StatesTheDefaultsOfTheParser) {
    const Json root = schema();
    const auto stated = [&](const std::string& pointer) { return root.at(Json::json_pointer(pointer + "/default")); };
    const Json text = parse_json(R"({"techniques": ["plain"], "axes": {"heightmap": "rock"}, "motion": {}})", "test");
    const Json expanded = parse_configuration(text, "test", {}, fake_techniques()).expanded;
    EXPECT_EQ(stated("/properties/seed"), expanded["seed"]);
    EXPECT_EQ(stated("/properties/images"), expanded["images"]);
    for (const auto& [key, value] : expanded["truth"].items()) {
        EXPECT_EQ(stated("/$defs/truth/properties/" + key), value) << key;
    }
    for (const auto& [key, value] : expanded["sampling"].items()) {
        EXPECT_EQ(stated("/$defs/sampling/properties/" + key), value) << key;
    }
    for (const auto& [key, value] : expanded["motion"].items()) {
        EXPECT_EQ(stated("/$defs/motion/properties/" + key), value) << key;
    }
    for (const auto& [key, value] : expanded["preparation"].items()) {
        EXPECT_EQ(stated("/$defs/preparation/properties/" + key), value) << key;
    }
    EXPECT_EQ(stated("/$defs/lighting/properties/shininess"), expanded["lighting"]["shininess"]);
    EXPECT_EQ(stated("/$defs/object/properties/radius"), SceneObject{}.radius);
    EXPECT_EQ(stated("/$defs/light/properties/angular_radius"), DirectionalLight{}.angular_radius);
    EXPECT_THAT(schema_complaints(root, root, expanded), IsEmpty());
}

TEST(Schema, AgreesWithTheParserAboutValues) {
    struct Case {
        const char* member;
        const char* value;
        bool valid;
    };
    const Case cases[] = {
        {"/axes/view_angle", "89.9", true},
        {"/axes/view_angle", "90", false},
        {"/axes/view_angle", "[0, -1]", false},
        {"/axes/view_angle", "[]", false},
        {"/axes/azimuth", "[-360, 360]", true},
        {"/axes/azimuth", "361", false},
        {"/axes/fov", "[1, 170]", true},
        {"/axes/fov", "0.5", false},
        {"/axes/distance", "1000", true},
        {"/axes/distance", "0", false},
        {"/axes/base", R"(["plane", "cylinder", "sphere", "saddle"])", true},
        {"/axes/base", R"("cone")", false},
        {"/axes/base", R"({"mesh": "a.glb"})", false},
        {"/axes/base", R"({"file": 3})", false},
        {"/axes/curvature", "[-1000, 0, 1000]", true},
        {"/axes/curvature", "1001", false},
        {"/axes/base_segments", "[1, 2048]", true},
        {"/axes/base_segments", "0", false},
        {"/axes/base_fit", R"(["unit", "none"])", true},
        {"/axes/base_fit", R"("patch")", false},
        {"/axes/height_scale", "[0.01, 10]", true},
        {"/axes/height_scale", "0", false},
        {"/axes/height_scale", "10.5", false},
        {"/axes/tiling", "1024", true},
        {"/axes/tiling", "1025", false},
        {"/axes/resolution", "[16384, \"1x16384\"]", true},
        {"/axes/resolution", "16385", false},
        {"/axes/resolution", "\"16x\"", false},
        {"/axes/heightmap_size", "\"64x32\"", true},
        {"/axes/heightmap_size", "0", false},
        {"/axes/height_format", "[\"r8\", \"r16\", \"r32f\"]", true},
        {"/axes/height_format", "\"r17\"", false},
        {"/axes/projection", "[\"parallel\", \"perspective\"]", true},
        {"/axes/projection", "\"orthographic\"", false},
        {"/axes/boundary", "[\"clip\", \"repeat\"]", true},
        {"/axes/boundary", "true", false},
        {"/axes/self_shadow", "[\"off\", \"hard\", \"soft\"]", true},
        {"/axes/self_shadow", "true", false},
        {"/axes/soft_shadow", "[\"dykhta\", \"tatarchuk\"]", true},
        {"/axes/soft_shadow", "\"pcf\"", false},
        {"/axes/hard_shadow_bias", "[0, 1]", true},
        {"/axes/hard_shadow_bias", "-0.1", false},
        {"/axes/dykhta_bias", "1.5", false},
        {"/axes/shadow_min_steps", "[1, 65536]", true},
        {"/axes/shadow_min_steps", "0", false},
        {"/axes/shadow_max_steps", "2.5", false},
        {"/axes/shadow_softening", "0.58", true},
        {"/axes/shadow_softening", "-1", false},
        {"/axes/depth_write", "[\"on\", \"off\", \"conservative\"]", true},
        {"/axes/depth_write", "true", false},
        {"/axes/material_filter", R"(["lod0", "mip", "anisotropic"])", true},
        {"/axes/material_filter", R"("trilinear")", false},
        {"/axes/anisotropy", "[1, 16]", true},
        {"/axes/anisotropy", "0", false},
        {"/axes/anisotropy", "1.5", false},
        {"/axes/anisotropy", "17", false},
        {"/axes/mip_bias", "[-16, -0.5, 16]", true},
        {"/axes/mip_bias", "16.5", false},
        {"/axes/material_gradients", R"(["before_search", "from_result", "analytic"])", true},
        {"/axes/material_gradients", R"("implicit")", false},
        {"/axes/samples_per_pixel", "[1, 2, 4, 8]", true},
        {"/axes/samples_per_pixel", "3", false},
        {"/axes/frames", "[1, 16]", true},
        {"/axes/frames", "17", false},
        {"/axes/polygon_height", "[0, 0.5, 1]", true},
        {"/axes/polygon_height", "1.5", false},
        {"/axes/sample_count", "[1, 256]", true},
        {"/axes/sample_count", "0", false},
        {"/axes/max_steps", "[1, 2]", true},
        {"/axes/max_steps", "{}", false},
        {"/axes/heightmap", R"([{"name": "rock", "size": 32, "seed": 0}, "bricks"])", true},
        {"/axes/heightmap", R"({"name": "rock", "file": "rock.png"})", false},
        {"/axes/heightmap", R"({"name": "rock", "sead": 0})", false},
        {"/techniques", "[]", false},
        {"/techniques", R"([{"technique": "march", "parameters": {"max_steps": [1, 2], "adaptive": true}}])", true},
        {"/techniques", R"([{"parameters": {}}])", false},
        {"/zip", "[[\"view_angle\"]]", false},
        {"/exclude", "[{}]", false},
        {"/exclude", R"([{"view_angle": [0, 60], "technique": "march"}])", true},
        {"/seed", "-1", false},
        {"/truth", R"({"kind": "mesh", "subdivision": 64})", true},
        {"/truth", R"({"subdivision": 65})", false},
        {"/truth", R"({"samples": 1024})", true},
        {"/truth", R"({"samples": 1025})", false},
        {"/sampling", R"({"rule": "fixed", "rounds": 100000, "samples_per_visit": 10000, "warm_up": 0})", true},
        {"/sampling", R"({"rule": "precision", "rounds": 6, "precision": 0.02, "budget_s": 0.5})", true},
        {"/sampling", R"({"rule": "time", "budget_s": 2})", true},
        {"/sampling", R"({"rule": "other"})", false},
        {"/preparation", R"({"limit_s": 0})", true},
        {"/preparation", R"({"limit_s": -1})", false},
        {"/preparation", R"({"limit": 1})", false},
        {"/sampling", R"({"precision": 2})", false},
        {"/sampling", R"({"budget_s": 0})", false},
        {"/sampling", R"({"minimum_pass_ms": -1})", false},
        {"/motion", R"({"frames": 2, "degrees": 10, "along": "azimuth"})", true},
        {"/motion", R"({"frames": 1})", false},
        {"/motion", R"({"degrees": 0})", false},
        {"/motion", R"({"degrees": 0, "history_weight": 0})", true},
        {"/motion", R"({"history_weight": 0.95, "neighbourhood_clamp": true})", true},
        {"/motion", R"({"history_weight": 1})", false},
        {"/motion", R"({"neighbourhood_clamp": false})", false},
        {"/motion", R"({"along": "fov"})", false},
        {"/motion", "true", false},
        {"/lighting", R"({"lights": [], "fog": {"start": 0, "range": 0.5}, "ambient": [0, 0, 0]})", true},
        {"/lighting", R"({"lights": [{}, {}, {}, {}]})", false},
        {"/lighting", R"({"lights": [{"angular_radius": 45}, {"angular_radius": 0}]})", true},
        {"/lighting", R"({"lights": [{"angular_radius": 46}]})", false},
        {"/lighting", R"({"background": [0, 0]})", false},
        {"/object", R"({"shape": "sphere", "centre": [0, -0.5, 0.1], "radius": 0.25, "colour": [0, 0, 1]})", true},
        {"/object", R"({"shape": "box", "half_size": [0.5, 0.01, 0.2]})", true},
        {"/object", R"({"radius": 0.25})", false},
        {"/object", R"({"shape": "sphere", "half_size": [1, 1, 1]})", false},
        {"/object", R"({"shape": "box", "radius": 0.25})", false},
        {"/object", R"({"shape": "sphere", "radius": 0})", false},
        {"/object", R"({"shape": "box", "half_size": [0.5, 0, 0.2]})", false},
        {"/object", R"({"shape": "cone"})", false},
        {"/lighting", R"({"fog": {"range": 0}})", false},
    };
    const Json root = schema();
    for (const Case& given : cases) {
        Json json = parse_json(R"({"techniques": ["march"], "axes": {"heightmap": "rock"}})", "test");
        json[Json::json_pointer(given.member)] = parse_json(given.value, "test");
        EXPECT_EQ(schema_complaints(root, root, json).empty(), given.valid) << given.member << " " << given.value;
        bool parsed = true;
        try {
            parse_configuration(json, "test", {}, fake_techniques());
        } catch (const Error&) {
            parsed = false;
        }
        EXPECT_EQ(parsed, given.valid) << given.member << " " << given.value;
    }
}

const char* const shipped[] = {"smoke.json",       "quick.json",     "curved.json",
                               "curved_cost.json", "filtering.json", "quality_vs_cost.json"};

TEST(ShippedConfigurations, ConformToTheSchema) {
    const Json root = schema();
    for (const char* name : shipped) {
        EXPECT_THAT(schema_complaints(root, root, read_json_file(configs / name)), IsEmpty()) << name;
    }
}

TEST(ShippedConfigurations, SmokeHasManyTechniquesInAHandfulOfCells) {
    const std::vector<Cell> cells = expand_shipped("smoke.json");
    std::set<std::string> techniques;
    for (const Cell& cell : cells) {
        techniques.insert(cell.technique);
        EXPECT_EQ(cell.skip_reason, "");
        EXPECT_LE(cell.view.view.resolution.pixels(), 64U * 64U);
    }
    // Not all that are shipped: adding a technique changes no configuration.
    EXPECT_GE(techniques.size(), 7U);
    EXPECT_LE(cells.size(), 20U);
}

TEST(ShippedConfigurations, QuickHasAtLeastSixtyCellsAndBothProjections) {
    const std::vector<Cell> cells = expand_shipped("quick.json");
    EXPECT_GE(cells.size(), 60U);
    EXPECT_LE(cells.size(), 80U);
    std::set<Projection> projections;
    for (const Cell& cell : cells) {
        projections.insert(cell.view.view.camera.projection);
        EXPECT_EQ(cell.skip_reason, "");
    }
    EXPECT_EQ(projections.size(), 2U);
}

/// Along texel rows the surface is straight within each cell, which flatters refinements.
TEST(ShippedConfigurations, SeeTheReliefOffItsAxes) {
    for (const char* name : shipped) {
        for (const Cell& cell : expand_shipped(name)) {
            const Camera& camera = cell.view.view.camera;
            if (camera.projection == Projection::perspective || camera.view_angle == 0) continue;
            EXPECT_NE(std::fmod(camera.azimuth, 90), 0) << name << ": " << cell.id;
        }
    }
}

TEST(ShippedConfigurations, ThoseThatCompareSkipNothing) {
    for (const char* name : {"curved.json", "curved_cost.json", "filtering.json", "quality_vs_cost.json"}) {
        for (const Cell& cell : expand_shipped(name))
            EXPECT_EQ(cell.skip_reason, "") << cell.id;
    }
}

TEST(ShippedConfigurations, CurvedHasEveryGeneratedBaseAndThePlaneOnce) {
    std::set<std::pair<std::string, double>> bases;
    for (const Cell& cell : expand_shipped("curved.json"))
        bases.emplace(axes_to_json(cell.view)["base"], cell.view.base.curvature);
    EXPECT_EQ(bases.size(), 1U + 3U * 3U);
}

}  // namespace
}  // namespace reliefbench
