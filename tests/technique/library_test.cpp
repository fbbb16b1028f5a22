#include "support/error_message.hpp"
#include "test_scene.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;
using testing::HasSubstr;

TEST(TechniqueLibrary, FolderIsTheTechnique) {
    const TemporaryTechnique folder(Files{{"trace.glsl", flat_trace}});
    const Technique technique = folder.load();
    EXPECT_EQ(technique.manifest.id, folder.folder().filename());
    EXPECT_EQ(technique.folder, folder.folder());
}

TEST(TechniqueLibrary, BrokenManifestSpoilsOnlyItsTechnique) {
    const TemporaryTechnique good(Files{{"trace.glsl", flat_trace}});
    const TemporaryTechnique bad(Files{{"trace.glsl", flat_trace}, {"technique.json", "{"}});
    const TechniqueLibrary library = find_techniques({good.root(), bad.root()});
    ASSERT_EQ(library.techniques.size(), 1u);
    ASSERT_EQ(library.broken.size(), 1u);
    const std::string bad_id = bad.folder().filename().string();
    EXPECT_THAT(error_message([&] { library.get(bad_id); }), HasSubstr("technique.json"));
}

TEST(TechniqueLibrary, UnknownNameIsSuggested) {
    const TemporaryTechnique folder(Files{{"trace.glsl", flat_trace}});
    const TechniqueLibrary library = find_techniques({folder.root()});
    const std::string id = folder.folder().filename().string();
    EXPECT_THAT(error_message([&] { library.get(id + "x"); }), HasSubstr("did you mean '" + id + "'"));
}

class TwoRoots : public testing::Test {
protected:
    TwoRoots() {
        copy_ = folder_.path() / "copy";
        std::filesystem::create_directory(copy_);
        std::filesystem::copy(technique_.folder(), copy_ / technique_.folder().filename());
    }

    std::filesystem::path link(const std::filesystem::path& to) const {
        const std::filesystem::path link = folder_.path() / "link";
        std::filesystem::create_directory_symlink(to, link);
        return link;
    }

    TemporaryFolder folder_;
    const TemporaryTechnique technique_{Files{{"trace.glsl", flat_trace}}};
    std::filesystem::path copy_;
};

TEST_F(TwoRoots, BesideTheFirstWithTheSameIdAreAnError) {
    EXPECT_THAT(error_message([&] {
                    find_techniques({default_technique_root(), technique_.root(), copy_});
                }),
                HasSubstr("rename one folder"));
}

TEST_F(TwoRoots, TheFirstGivesWay) {
    const TechniqueLibrary library = find_techniques({technique_.root(), copy_});
    ASSERT_EQ(library.techniques.size(), 1U);
    EXPECT_EQ(library.techniques[0].folder.parent_path(), copy_);
}

TEST_F(TwoRoots, ThatAreOneFolderCountOnce) {
    const std::filesystem::path root = technique_.root();
    for (const std::filesystem::path& again :
         {root, root / ".", root / technique_.folder().filename() / "..", link(root)})
        EXPECT_EQ(find_techniques({root, again}).techniques.size(), 1U) << again;
    std::filesystem::remove_all(copy_ / technique_.folder().filename());
    std::filesystem::create_directory_symlink(technique_.folder(), copy_ / technique_.folder().filename());
    EXPECT_EQ(find_techniques({root, copy_}).techniques.size(), 1U) << "a link to one technique";
}

TEST_F(TwoRoots, WhereTheLastWinsHaveItsTechnique) {
    const TechniqueLibrary library =
        find_techniques({default_technique_root(), technique_.root(), copy_}, shader_root(), SameId::last_wins);
    EXPECT_EQ(library.get(technique_.folder().filename().string()).folder.parent_path(), copy_);
}

TEST_F(TwoRoots, WhatIsNoRootSaysWhatToName) {
    EXPECT_EQ(complaint_of_root(copy_), "");
    EXPECT_EQ(complaint_of_root("/nowhere/at/all"), "") << "told when it is looked into";
    const std::string own = complaint_of_root(technique_.folder());
    EXPECT_THAT(own,
                HasSubstr("is one technique's folder; name the folder that holds it: " + technique_.root().string()));
    std::filesystem::create_directories(folder_.path() / "checkout/techniques");
    EXPECT_THAT(complaint_of_root(folder_.path() / "checkout"),
                testing::AllOf(HasSubstr("holds no technique folder"), HasSubstr("checkout/techniques?")));
    EXPECT_THAT(complaint_of_root(folder_.path() / "checkout/techniques"), HasSubstr("holds no technique folder"));
}

TEST(TechniqueLibrary, MissingRootIsAnError) {
    EXPECT_THAT(error_message([] { find_techniques({"/nowhere/at/all"}); }), HasSubstr("/nowhere/at/all"));
}

TEST(TechniqueLibrary, HashFollowsShadersButNotDocuments) {
    const TemporaryTechnique folder(Files{{"trace.glsl", std::string("#include \"helper.glsl\"\n") + flat_trace},
                                          {"helper.glsl", "// one"},
                                          {"README.md", "a"}});
    const std::string hash = folder.load().hash;
    write_text_file(folder.folder() / "README.md", "b");
    EXPECT_EQ(folder.load().hash, hash);
    write_text_file(folder.folder() / "helper.glsl", "// two");
    EXPECT_NE(folder.load().hash, hash);
}

TEST(TechniqueLibrary, DataFolderComesFromTheEnvironment) {
    ASSERT_EQ(setenv("RELIEFBENCH_DATA_DIR", "/elsewhere", 1), 0);
    EXPECT_EQ(default_technique_root(), "/elsewhere/techniques");
    EXPECT_EQ(shader_root(), "/elsewhere/harness/shaders");
    ASSERT_EQ(unsetenv("RELIEFBENCH_DATA_DIR"), 0);
    EXPECT_TRUE(std::filesystem::exists(shader_root() / "contract" / "relief.glsl"));
}

class Compilation : public DeviceTest {
protected:
    static std::string compile_error(const Files& files) {
        const TemporaryTechnique folder(files);
        const HeightMap map = make_map({2, 2}, [](int, int) { return 1.0; });
        const SceneOnDevice scene(device(), map, grey_albedo());
        return error_message(
            [&] { make_renderer(device(), folder.load(), scene, make_view(0, Projection::parallel)); });
    }
};

TEST_F(Compilation, ErrorNamesTechniqueFileAndLine) {
    const std::string message =
        compile_error({{"trace.glsl", "#include \"helper.glsl\"\nTrace trace(ReliefRay ray) { return help(ray); }\n"},
                       {"helper.glsl", "Trace help(ReliefRay ray) {\n\n    return nonsense;\n}\n"}});
    EXPECT_THAT(message, HasSubstr("technique 'technique_"));
    EXPECT_THAT(message, HasSubstr("helper.glsl:3:"));
    EXPECT_THAT(message, HasSubstr("nonsense"));
}

TEST_F(Compilation, IncludeCannotLeaveTheFolder) {
    const std::string message = compile_error({{"trace.glsl", "\n#include \"../other/trace.glsl\"\n"}});
    EXPECT_THAT(message, HasSubstr("trace.glsl:2:"));
    EXPECT_THAT(message, HasSubstr("leaves the folders"));
}

TEST_F(Compilation, HarnessFilesCannotBeReplaced) {
    EXPECT_THAT(compile_error({{"trace.glsl", flat_trace}, {"shading.glsl", ""}}), HasSubstr("rename one"));
}

TEST_F(Compilation, SweepOverParametersCompilesOnce) {
    const TemporaryTechnique folder(
        Files{{"technique.json",
               manifest_json(R"({"name": "depth", "type": "real", "default": 0.5, "range": [0, 1], "help": "h"})")},
              {"trace.glsl", "Trace trace(ReliefRay ray) { return hit_off_ray(ray.uv, depth, 0); }\n"}});
    const Technique technique = folder.load();
    const HeightMap map = make_map({2, 2}, [](int, int) { return 1.0; });
    const SceneOnDevice scene(device(), map, grey_albedo());
    const View view = make_view(0, Projection::parallel, {2, 2});
    const auto drawn_depth = [&](double depth) {
        return make_renderer(device(), technique, scene, view, {}, {{"depth", depth}}).probe().hits.at(0, 0).h;
    };
    EXPECT_EQ(drawn_depth(0.25), 0.25f);
    const int compilations = shader_compilations(device());
    EXPECT_EQ(drawn_depth(0.75), 0.75f);
    EXPECT_EQ(shader_compilations(device()), compilations);
}

TEST_F(Compilation, ParametersArriveByNameAndType) {
    const TemporaryTechnique folder(Files{{"technique.json", manifest_json(R"(
                   {"name": "count", "type": "integer", "default": 1, "range": [-5, 5], "help": "h"},
                   {"name": "factor", "type": "real", "default": 0.5, "range": [0, 1], "help": "h"},
                   {"name": "wanted", "type": "boolean", "default": false, "help": "h"},
                   {"name": "leaf", "type": "choice", "choices": ["linear", "exact"], "default": "linear",
                    "help": "h"})")},
                                          {"trace.glsl", R"(Trace trace(ReliefRay ray) {
                   bool right = count == -3 && factor == 0.125 && wanted && leaf == leaf_exact && leaf_linear == 0;
                   return right ? hit_on_ray(0.0, 0) : miss(0);
               })"}});
    const Technique technique = folder.load();
    const HeightMap map = make_map({2, 2}, [](int, int) { return 1.0; });
    const SceneOnDevice scene(device(), map, grey_albedo());
    const View view = make_view(0, Projection::parallel, {2, 2});
    const ParameterValues values{
        {"count", std::int64_t{-3}}, {"factor", 0.125}, {"wanted", true}, {"leaf", std::string("exact")}};
    EXPECT_TRUE(make_renderer(device(), technique, scene, view, {}, values).probe().hits.at(1, 1).is_hit());
    EXPECT_FALSE(make_renderer(device(), technique, scene, view).probe().hits.at(1, 1).is_hit());
}

/// Where the preprocessor decides there is one compilation for each value; other parameters still share it.
TEST_F(Compilation, ParametersOfCompileTimeReachThePreprocessor) {
    const std::string parameters =
        R"({"name": "form", "type": "choice", "choices": ["low", "high"], "default": "low", "compile_time": true, "help": "h"},
           {"name": "raised", "type": "boolean", "default": false, "compile_time": true, "help": "h"},
           {"name": "part", "type": "real", "default": 0.125, "range": [0, 1], "help": "h"})";
    const TemporaryTechnique folder(Files{{"technique.json", manifest_json(parameters)}, {"trace.glsl", R"(
        Trace trace(ReliefRay ray) {
            float h = part;
        #ifdef FORM_HIGH
            h += form == form_high ? 0.25 : 0.0;
        #endif
        #ifdef RAISED
            h += raised ? 0.5 : 0.0;
        #endif
            return hit_off_ray(ray.uv, h, 0);
        })"}});
    const Technique technique = folder.load();
    const SceneOnDevice scene(device(), make_map({4, 4}, [](int, int) { return 0.5; }), grey_albedo());
    const View view = make_view(0, Projection::parallel, {2, 2});
    const auto height = [&](const std::string& form, bool raised, double part) {
        const ParameterValues values{{"form", form}, {"raised", raised}, {"part", part}};
        return make_renderer(device(), technique, scene, view, {}, values).probe().hits.at(1, 1).h;
    };
    EXPECT_EQ(height("low", false, 0.125), 0.125f);
    EXPECT_EQ(height("high", false, 0.125), 0.375f);
    EXPECT_EQ(height("high", true, 0.125), 0.875f);
    EXPECT_EQ(height("low", true, 0.125), 0.625f);
    const int compilations = shader_compilations(device());
    EXPECT_EQ(height("low", true, 0.0625), 0.5625f);
    EXPECT_EQ(shader_compilations(device()), compilations);
}

TEST_F(Compilation, DeviceLimitsGiveAReason) {
    const TemporaryTechnique folder(Files{{"trace.glsl", flat_trace}});
    const Technique technique = folder.load();
    EXPECT_EQ(unsupported_reason(device(), technique, {}, make_view(0, Projection::parallel), {256, 256}), "");
    const View huge = make_view(0, Projection::parallel, {1 << 20, 16});
    EXPECT_THAT(unsupported_reason(device(), technique, {}, huge, {256, 256}), HasSubstr("on a side"));
}

TEST_F(Compilation, FeaturesThatTheDeviceLacksGiveAReason) {
    for (const std::string feature : {"shaderFloat64", "VK_EXT_mesh_shader", "VK_KHR_ray_query"}) {
        const TemporaryTechnique folder(
            Files{{"technique.json", manifest_json("", R"(, "features": [")" + feature + R"("])")},
                  {"trace.glsl", flat_trace}});
        const std::string reason =
            unsupported_reason(device(), folder.load(), {}, make_view(0, Projection::parallel), {64, 64});
        const gpu::DeviceInfo& info = device().info();
        EXPECT_EQ(reason, info.has_feature(feature) ? "" : info.name + " lacks the feature " + feature);
    }
    const TemporaryTechnique folder(Files{
        {"technique.json", manifest_json("", R"(, "features": ["VK_KHR_ray_queries"])")}, {"trace.glsl", flat_trace}});
    EXPECT_THAT(error_message([&] { folder.load(); }), HasSubstr("(did you mean 'VK_KHR_ray_query'?)"));
}

TEST_F(Compilation, LimitsOfThreeDimensionalMapsGiveAReason) {
    const std::string parameter =
        R"({"name": "slices", "type": "integer", "default": 4, "range": [1, 16384], "help": "h"})";
    const TemporaryTechnique folder(Files{{"technique.json", manifest_json(parameter, R"(,
            "maps": [{"name": "volume", "format": "r32f", "depth": "slices"}],
            "passes": [{"name": "fill", "shader": "fill.glsl", "writes": "volume"}])")},
                                          {"fill.glsl", "void prepare(ivec3 texel) { write_map(vec4(0.0)); }"},
                                          {"trace.glsl", flat_trace}});
    const Technique technique = folder.load();
    const View view = make_view(0, Projection::parallel);
    EXPECT_EQ(unsupported_reason(device(), technique, {{"slices", std::int64_t{4}}}, view, {64, 64}), "");
    EXPECT_THAT(unsupported_reason(device(), technique, {{"slices", std::int64_t{16384}}}, view, {64, 64}),
                HasSubstr("would be 64x64x16384"));
}

TEST_F(Compilation, WhatATechniqueNeedsOfItsMapGivesAReason) {
    const TemporaryTechnique folder(
        Files{{"technique.json", manifest_json("", R"(, "needs": {"map": ["square", "power_of_two", "untiled"]})")},
              {"trace.glsl", flat_trace}});
    const Technique technique = folder.load();
    const View view = make_view(0, Projection::parallel);
    const auto reason = [&](Resolution size, const View& seen) {
        return unsupported_reason(device(), technique, technique.manifest.defaults(), seen, size);
    };
    EXPECT_EQ(reason({64, 64}, view), "");
    EXPECT_EQ(reason({64, 32}, view), "the technique needs a square height map; this one is 64x32");
    EXPECT_EQ(reason({60, 60}, view),
              "the technique needs a height map whose sides are powers of two; this one is 60x60");
    View tiled = view;
    tiled.relief.tiling = 2;
    EXPECT_EQ(reason({64, 64}, tiled),
              "the technique needs the height map once on the patch (tiling 1, boundary clip); here the tiling is 2");
    View repeated = view;
    repeated.relief.boundary = Boundary::repeat;
    EXPECT_THAT(reason({64, 64}, repeated), HasSubstr("here the boundary is repeat"));
}

}  // namespace
}  // namespace reliefbench
