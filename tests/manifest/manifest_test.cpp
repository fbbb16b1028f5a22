#include "manifest/manifest.hpp"

#include "complete_manifest.hpp"
#include "core/file.hpp"
#include "manifest/reserved_names.hpp"
#include "manifest/shader_names.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <regex>
#include <set>

namespace reliefbench {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;

TEST(Manifest, IsReadInFull) {
    const Manifest manifest = parse(complete());
    EXPECT_EQ(manifest.id, "test");
    EXPECT_EQ(manifest.title, "Test march");
    EXPECT_EQ(manifest.kind, "march");
    EXPECT_EQ(manifest.citation, "Nobody, 2024");
    ASSERT_GE(manifest.parameters.size(), 6U);
    EXPECT_EQ(manifest.parameters[0].name, "max_steps");
    EXPECT_EQ(manifest.parameters[0].maximum, 256);
    EXPECT_EQ(manifest.parameters[0].published, ParameterValue(std::int64_t{32}));
    EXPECT_EQ(manifest.parameters[3].default_value, ParameterValue(0.0));
    EXPECT_EQ(manifest.parameters[4].published, std::nullopt);
    EXPECT_THAT(manifest.parameters[5].choices, ElementsAre("linear", "exact"));
    EXPECT_EQ(manifest.sample_count, "max_steps");
    EXPECT_EQ(manifest.sample_count_minimum, "min_steps");
    EXPECT_THAT(manifest.search_cap, ElementsAre("max_steps", "min_steps"));
    EXPECT_THAT(parse(with("/search_cap", "binary_steps")).search_cap, ElementsAre("binary_steps"));
    EXPECT_THAT(manifest.features, ElementsAre("tessellationShader"));
    EXPECT_THAT(manifest.map_needs, ElementsAre(MapNeed::power_of_two, MapNeed::square));
    ASSERT_EQ(manifest.maps.size(), 2U);
    EXPECT_EQ(manifest.maps[0].size, MapDeclaration::Size::next_power_of_two);
    EXPECT_TRUE(manifest.maps[0].mip_chain);
    EXPECT_EQ(manifest.maps[1].size, MapDeclaration::Size::height_map);
    EXPECT_TRUE(manifest.maps[1].linear_filter);
    EXPECT_FALSE(manifest.maps[1].is_volume());
    ASSERT_EQ(manifest.passes.size(), 3U);
    EXPECT_EQ(manifest.passes[1].levels, PassDeclaration::Levels::above_base);
    EXPECT_EQ(manifest.passes[2].shader, "sub/search.glsl");
    EXPECT_EQ(manifest.shape.kind, "quad");
    ASSERT_EQ(manifest.promises.size(), 2U);
    EXPECT_EQ(manifest.promises[0].promise, Promise::order_1);
    EXPECT_EQ(manifest.promises[0].halvings, "binary_steps");
    EXPECT_EQ(manifest.promises[0].within, 0.5);
    EXPECT_EQ(manifest.promises[1].within, 1) << "a whole step where nothing is said";
    EXPECT_EQ(manifest.promises[1].with.at("bias"), ParameterValue(0.0));
    EXPECT_EQ(manifest.defaults().at("leaf"), ParameterValue(std::string("exact")));
}

TEST(Manifest, PatchesAreTrianglesWithTheValuesNamed) {
    Json json = with("/shape", parse_json(R"({"patches": {"parameter": "binary_steps",
                                             "triangles": {"leaf": "linear", "adaptive": true}}})",
                                          "test"));
    json["parameters"][5]["compile_time"] = true;
    const Manifest manifest = parse(json);
    EXPECT_TRUE(manifest.parameters[5].compile_time);
    EXPECT_FALSE(manifest.parameters[4].compile_time);
    ParameterValues values = manifest.defaults();
    EXPECT_EQ(manifest.shape.patch_corners(values), 4);
    values["leaf"] = std::string("linear");
    EXPECT_EQ(manifest.shape.patch_corners(values), 4);
    values["adaptive"] = true;
    EXPECT_EQ(manifest.shape.patch_corners(values), 3);
}

TEST(Manifest, DepthIsANumberOrAParameter) {
    EXPECT_EQ(parse(with("/maps/1/depth", 7)).maps[1].slices({}), 7);
    const MapDeclaration map = parse(with("/maps/1/depth", "max_steps")).maps[1];
    EXPECT_TRUE(map.is_volume());
    EXPECT_EQ(map.slices({{"max_steps", std::int64_t{9}}}), 9);
}

TEST(Manifest, PassesMayBeConditionalAndSliced) {
    Json json = with("/passes/2/only_with", parse_json(R"({"leaf": ["exact"], "adaptive": [true, false]})", "test"));
    json["passes"][2]["sliced"] = parse_json(R"({"iterations": 5, "ends_early": true})", "test");
    json["maps"][1]["scratch"] = true;
    const Manifest manifest = parse(json);
    EXPECT_TRUE(manifest.maps[1].scratch);
    EXPECT_FALSE(manifest.maps[0].scratch);
    EXPECT_EQ(manifest.passes[2].sliced->iterations, 5);
    EXPECT_TRUE(manifest.passes[2].sliced->ends_early);
    EXPECT_FALSE(manifest.passes[0].sliced);
    ParameterValues values = manifest.defaults();
    EXPECT_TRUE(all_hold(manifest.passes[2].only_with, values));
    values["leaf"] = std::string("linear");
    EXPECT_FALSE(all_hold(manifest.passes[2].only_with, values));
    EXPECT_TRUE(all_hold(manifest.passes[0].only_with, values));
}

TEST(Manifest, PatchesNameTheirParameterAndNeedTessellation) {
    Json json = complete();
    json.erase("features");
    json["shape"] = parse_json(R"({"patches": {"parameter": "binary_steps"}})", "test");
    const Manifest manifest = parse(json);
    EXPECT_EQ(manifest.shape.kind, "patches");
    EXPECT_EQ(manifest.shape.patches_parameter, "binary_steps");
    EXPECT_EQ(manifest.shape.texels_per_patch, 64);
    EXPECT_THAT(manifest.features, ElementsAre("tessellationShader"));
}

TEST(Manifest, WhoseSearchCastsHardShadowsIsSaidAndOfContract1MayHangOnTheKind) {
    const auto search_of = [](int contract, const std::string& kind, const std::string& said) {
        Json json = with("/kind", kind);
        json["contract"] = contract;
        if (!said.empty()) json["shadow_search"] = said;
        return parse(json).shadow_search;
    };
    for (const std::string kind : {"texture", "parallax", "march", "hierarchy", "cone", "geometry"}) {
        const bool searches = kind == "march" || kind == "hierarchy" || kind == "cone";
        EXPECT_EQ(search_of(1, kind, ""), searches ? ShadowSearch::own : ShadowSearch::uniform_layers) << kind;
        EXPECT_EQ(search_of(2, kind, ""), ShadowSearch::uniform_layers) << kind;
        for (const int contract : {1, 2}) {
            EXPECT_EQ(search_of(contract, kind, "own"), ShadowSearch::own) << kind;
            EXPECT_EQ(search_of(contract, kind, "uniform_layers"), ShadowSearch::uniform_layers) << kind;
        }
    }
    Json patches = with("/shape", parse_json(R"({"patches": {"parameter": "binary_steps"}})", "test"));
    EXPECT_EQ(parse(patches).shadow_search, ShadowSearch::uniform_layers);
    patches["shadow_search"] = "own";
    EXPECT_THAT(message_of(patches),
                HasSubstr("$.shadow_search: a technique of the shape \"patches\" searches nothing"));
}

TEST(Manifest, TheSampleCountTakesTheAdaptiveMinimumAlong) {
    const Manifest manifest = parse(complete());
    ParameterValues values = manifest.defaults();
    set_sample_count(manifest, values, 128, manifest.defaults());
    EXPECT_EQ(values.at("max_steps"), ParameterValue(std::int64_t{128}));
    EXPECT_EQ(values.at("min_steps"), ParameterValue(std::int64_t{16}));
    set_sample_count(manifest, values, 12, manifest.defaults());  // 12 · 8/64 = 1.5
    EXPECT_EQ(values.at("min_steps"), ParameterValue(std::int64_t{2}));
    set_sample_count(manifest, values, 1, manifest.defaults());
    EXPECT_EQ(values.at("min_steps"), ParameterValue(std::int64_t{1}));
}

struct Broken {
    const char* pointer;
    const char* value;
    const char* message;
};

TEST(Manifest, WhatIsWrongIsNamedWithItsPlace) {
    const Broken cases[] = {
        {"/titel", "1", "technique.json: $: unknown key \"titel\" (did you mean 'title'?)"},
        {"/title", "\"\"", "technique.json: $.title: expected one line of text"},
        {"/contract", "3", "$.contract: this version of reliefbench knows the contracts 1 to 2, and not 3"},
        {"/contract", "0", "$.contract: expected an integer from 1"},
        {"/contract", "\"2\"", "$.contract: expected an integer"},
        {"/kind", "\"marsh\"", "(did you mean 'march'?)"},
        {"/shadow_search", "\"owns\"",
         "$.shadow_search: expected one of own, uniform_layers, found \"owns\" (did you mean 'own'?)"},
        {"/parameters/0/default", "0",
         "$.parameters[0].default: max_steps cannot be 0: it is an integer from 1 to 256"},
        {"/parameters/0/default", "1.5", "it is an integer from 1 to 256"},
        {"/parameters/0/published", "1000", "$.parameters[0].published"},
        {"/parameters/0/range", "[9, 1]", "$.parameters[0].range: expected a minimum that is not above the maximum"},
        {"/parameters/0/range", "[1, 2, 3]", "[minimum, maximum]"},
        {"/parameters/0/range", "[1, 4294967296]", "$.parameters[0].range[1]: expected an integer"},
        {"/parameters/0/type", "\"int\"", "$.parameters[0].type"},
        {"/parameters/0/choices", "[\"a\"]", "unknown key \"choices\""},
        {"/parameters/0/help", "\"two\\nlines\"", "$.parameters[0].help: expected one line of text"},
        {"/parameters/1/name", "\"max_steps\"", "$.parameters[1].name: the name 'max_steps' is given twice"},
        {"/parameters/1/name", "\"leaf_exact\"", "the name 'leaf_exact' is given twice"},
        {"/parameters/1/name", "\"while\"", "'while' is a name of GLSL"},
        {"/parameters/1/name", "\"gl_steps\"", "'gl_steps' is a name of GLSL"},
        {"/parameters/3/name", "\"trace\"", "$.parameters[3].name: 'trace' is a name that the harness's shaders use"},
        {"/parameters/1/name", "\"view_angle\"", "'view_angle' is an axis of a configuration"},
        {"/parameters/1/name", "\"minSteps\"", "'minSteps' is no usable name"},
        {"/parameters/5/choices", "[]", "$.parameters[5].choices: expected at least one choice"},
        {"/parameters/5/choices", "[\"exact\", \"exact\"]",
         "$.parameters[5].choices[1]: the name 'leaf_exact' is given"},
        {"/parameters/5/choices", "[\"exact\", \"not so\"]", "$.parameters[5].choices[1]: expected a word"},
        {"/parameters/5/default", "\"exat\"", "(did you mean 'exact'?)"},
        {"/sample_count", "\"max_step\"", "$.sample_count: no parameter 'max_step' (did you mean 'max_steps'?)"},
        {"/sample_count", "\"bias\"", "$.sample_count: the parameter 'bias' must be of type integer"},
        {"/sample_count", "\"binary_steps\"", "must begin at 1 or above"},
        {"/sample_count_minimum", "\"max_steps\"", "$.sample_count_minimum: it needs a \"sample_count\""},
        {"/search_cap", "\"bias\"", "$.search_cap: the parameter 'bias' must be of type integer"},
        {"/search_cap", "[\"max_steps\", \"max_step\"]", "$.search_cap[1]: no parameter 'max_step' (did you mean"},
        {"/search_cap", "[\"max_steps\", \"max_steps\"]", "$.search_cap[1]: the parameter 'max_steps' is given twice"},
        {"/features/0", "\"tesselationShader\"", "(did you mean 'tessellationShader'?)"},
        {"/features/0", "\"VK_NV_mesh_shader\"", "(did you mean 'VK_EXT_mesh_shader'?)"},
        {"/features/1", "\"tessellationShader\"", "$.features[1]: the feature 'tessellationShader' is given twice"},
        {"/needs", R"({"map": ["squared"]})", "$.needs.map[0]"},
        {"/needs", R"({"map": ["square", "square"]})", "$.needs.map[1]: 'square' is given twice"},
        {"/needs", R"({"maps": ["square"]})", "$.needs: unknown key \"maps\" (did you mean 'map'?)"},
        {"/maps/1/name", "\"tree\"", "$.maps[1].name: the name 'tree' is given twice"},
        {"/maps/1/name", "\"bias\"", "$.maps[1].name: the name 'bias' is given twice"},
        {"/parameters/5/name", "\"self_shadow\"", "'self_shadow' is an axis of a configuration"},
        {"/parameters/1/name", "\"vulkan\"", "'vulkan' is a name of GLSL"},
        {"/parameters/5", R"({"name": "tap_map", "type": "choice", "choices": ["a"], "default": "a", "help": "h"})",
         "$.parameters[5].name: 'tap_map' is a name that the harness's shaders use"},
        {"/parameters/5",
         R"({"name": "tap", "type": "choice", "choices": ["height", "b"], "default": "b", "help": "h"})",
         "$.parameters[5].choices[0]: 'tap_height' is a name that the harness's shaders use"},
        {"/maps/1/format", "\"r64\"", "$.maps[1].format"},
        {"/maps/2", R"({"name": "idle", "format": "r8"})", "no pass writes the map 'idle'"},
        {"/maps/1/mip_chain", "true", "no pass writes the levels above the base of the map 'cones'"},
        {"/maps/0/mip_chain", "false", "$.passes[1]: the map 'tree' has no level above its base"},
        {"/parameters/0/compile_time", "true", "$.parameters[0]"},
        {"/parameters/0/only_on", "\"sphere\"", "$.parameters[0].only_on"},
        {"/shape", R"({"patches": {"parameter": "binary_steps", "triangles": {"leave": "linear"}}})",
         "$.shape.patches.triangles.leave: no parameter 'leave'"},
        {"/shape", R"({"patches": {"parameter": "binary_steps", "triangles": {"leaf": "round"}}})",
         "$.shape.patches.triangles.leaf"},
        {"/maps/0/depth", "4", "$.maps[0].depth: a map of three dimensions has one level"},
        {"/maps/1/depth", "0", "$.maps[1].depth"},
        {"/maps/1/depth", "\"max_step\"", "no parameter 'max_step' (did you mean 'max_steps'?)"},
        {"/maps/1/depth", "\"adaptive\"", "the parameter 'adaptive' must be of type integer"},
        {"/maps/1/depth", "\"binary_steps\"", "the range of 'binary_steps' must lie within 1 and 16384"},
        {"/passes/0/writes", "\"tre\"", "$.passes[0].writes: no map 'tre' is declared (did you mean 'tree'?)"},
        {"/passes/0/levels", "\"above_base\"", "$.passes[0]: no earlier pass writes the base of the map 'tree'"},
        {"/passes/1/name", "\"leaves\"", "$.passes[1].name: the name 'leaves' is given twice"},
        {"/passes/1/name", "\"material_mips\"", "$.passes[1].name: 'material_mips' is a pass of the harness"},
        {"/passes/0/shader", "\"../other/leaves.glsl\"", "$.passes[0].shader: expected a file inside the technique's"},
        {"/passes/0/shader", "\"/etc/leaves.glsl\"", "$.passes[0].shader: expected a file inside the technique's"},
        {"/passes/0/shader", "\"\"", "$.passes[0].shader: expected a file inside the technique's"},
        {"/passes/2/only_with", R"({"leav": ["exact"]})", "$.passes[2].only_with.leav: no parameter 'leav'"},
        {"/passes/2/only_with", R"({"leaf": ["exat"]})", "$.passes[2].only_with.leaf[0]: leaf cannot be exat"},
        {"/passes/2/only_with", R"({"leaf": []})", "$.passes[2].only_with.leaf: expected at least one value"},
        {"/passes/0/sliced", "{}", "the map 'tree', which rounds them; give it a format of floats"},
        {"/passes/2/sliced", R"({"over": "columns"})", "$.passes[2].sliced.over: "},
        {"/passes/1/sliced", "{}", "$.passes[1].sliced: only a pass that writes the base"},
        {"/passes/2/sliced", R"({"iterations": 0})", "$.passes[2].sliced.iterations: expected an integer from 1"},
        {"/passes/2/sliced", R"({"iterations": 40000})", "$.passes[2].sliced.iterations: expected an integer from 1"},
        {"/shape", "\"quads\"", "$.shape: expected \"quad\""},
        {"/shape", R"({"patches": {"parameter": "bias"}})", "$.shape.patches.parameter: the parameter 'bias' must be"},
        {"/shape", R"({"patches": {"parameter": "max_steps", "texels_per_patch": 0}})", "texels_per_patch"},
        {"/promises/0/promise", "\"order1\"", "(did you mean 'order_1'?)"},
        {"/promises/0/with", R"({"adaptiv": false})", "no parameter 'adaptiv' (did you mean 'adaptive'?)"},
        {"/promises/1/with/leaf", "\"exat\"", "$.promises[1].with.leaf: leaf cannot be exat"},
        {"/promises/1/with/bias", "2", "$.promises[1].with.bias: bias cannot be 2"},
        {"/promises/0/halvings", "\"adaptive\"", "$.promises[0].halvings: the parameter 'adaptive' must be of type"},
        {"/promises/1/halvings", "\"binary_steps\"", "$.promises[1].halvings: it belongs to the promise order_1 only"},
        {"/promises/1/within", "0.5", "$.promises[1].within: it belongs to the promise order_1 only"},
        {"/promises/0/within", "0", "$.promises[0].within: no error is within no part of a step"},
        {"/promises/0/within", "1.5", "$.promises[0].within: expected a number from 0 to 1"},
    };
    for (const Broken& broken : cases) {
        EXPECT_THAT(message_of(with(broken.pointer, parse_json(broken.value, "test"))), HasSubstr(broken.message))
            << broken.pointer << " = " << broken.value;
    }
}

TEST(Manifest, WhatIsMissingIsNamed) {
    for (const char* key : {"title", "kind", "citation", "parameters", "shape", "promises"}) {
        Json json = complete();
        json.erase(key);
        EXPECT_THAT(message_of(json), AllOf(HasSubstr("technique.json: $"), HasSubstr(key))) << key;
    }
    Json json = complete();
    json.erase("sample_count");
    json.erase("sample_count_minimum");
    EXPECT_THAT(message_of(json), HasSubstr("$.promises[0].promise: it needs a \"sample_count\""));
}

TEST(Manifest, AnIdIsLowerCase) {
    EXPECT_THAT(message_of(complete(), "My technique"), HasSubstr("'My technique' cannot be a technique's id"));
    EXPECT_THAT(message_of(complete(), ""), HasSubstr("cannot be a technique's id"));
    EXPECT_NO_THROW(parse_manifest(complete(), "cone_step_2", "technique.json"));
}

/// That GLSL takes whatever name is accepted tests/technique asks the compiler.
TEST(Manifest, ANameIsAWordOfLowerCaseThatNeitherGlslNorAnAxisHas) {
    for (const char* name : {"max_steps", "factor", "h", "vec", "matter", "scale", "mat_5", "flatness"}) {
        EXPECT_EQ(check_glsl_name(name), "") << name;
    }
    for (const char* name : {"", "2d", "_a", "a__b", "Max", "a b", "a-b", "vec3", "mat2x3", "int", "sampler",
                             "target_map", "mix", "reliefbench_x", "sample_count", "gl_x", "flat"}) {
        EXPECT_NE(check_glsl_name(name), "") << name;
    }
}

/// Each global name of the files compiled with every technique of its shape, as the scan finds them; whether the
/// compiler has more is looked at in tests/technique.
TEST(ManifestNames, ThoseOfTheShadersAreRefused) {
    const Manifest manifest = parse(complete());
    const std::set<std::string> names = names_of_shaders(manifest, shared_shaders, {});
    EXPECT_THAT(names, IsSupersetOf({"point_on_ray", "tap_map_gradients", "count_stage", "shadow_layers", "max_lights",
                                     "lod_fade_at", "scene", "colour_target", "write_map_at", "prepare", "trace",
                                     "ReliefRay", "counted_taps", "discard"}));
    std::size_t refused = 0;
    for (const std::string& name : names) {
        if (!check_glsl_name(name).empty()) continue;
        ++refused;
        EXPECT_THAT(
            message_of(with("/parameters/3/name", name)),
            HasSubstr("$.parameters[3].name: '" + name + "' is a name that the harness's shaders use; choose another"));
    }
    EXPECT_GT(refused, 90U);
    Json json = with("/maps/1/name", "height_map");
    json["passes"][2]["writes"] = "height_map";
    EXPECT_THAT(message_of(json),
                HasSubstr("$.maps[1].name: 'height_map' is a name that the harness's shaders use; choose another"));
}

/// Two macros alike would be one.
TEST(ManifestNames, MacrosOfCompileTimeAreHeldToTheSame) {
    Json json = with("/parameters/5/compile_time", true);
    json["parameters"][4] = parse_json(
        R"({"name": "leaf_up", "type": "boolean", "default": true, "compile_time": true, "help": "h"})", "test");
    json["promises"] = Json::array();
    EXPECT_NO_THROW(parse(json));
    json["parameters"][5]["choices"] = parse_json(R"(["exact", "Up"])", "test");
    EXPECT_THAT(message_of(json), HasSubstr("$.parameters[5].choices[1]: the name 'LEAF_UP' is given twice"));
}

TEST(ManifestDocument, ItsExampleIsAValidManifest) {
    const std::string page = read_text_file(fs::path(RELIEFBENCH_SOURCE_DIR) / "docs" / "adding_a_technique.md");
    const std::size_t begin = page.find("```jsonc\n") + 9;
    const std::string example = page.substr(begin, page.find("```", begin) - begin);
    const std::string json = std::regex_replace(example, std::regex("//[^\n]*"), "");
    const Manifest manifest =
        parse_manifest(parse_json(json, "adding_a_technique.md"), "example", "adding_a_technique.md", shared_shaders);
    EXPECT_EQ(manifest.parameters.size(), 17U) << "with those of quad.json";
    EXPECT_EQ(manifest.map_needs.size(), 2U);
    EXPECT_EQ(manifest.passes.size(), 2U);
}

TEST(ShippedTechniques, HaveValidManifests) {
    std::size_t count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(RELIEFBENCH_SOURCE_DIR) / "techniques")) {
        if (!entry.is_directory()) continue;
        EXPECT_NO_THROW(load_manifest(entry.path(), shared_shaders)) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 7U);
}

}  // namespace
}  // namespace reliefbench