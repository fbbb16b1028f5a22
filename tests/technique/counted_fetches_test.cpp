#include "test_scene.hpp"

#include "support/error_message.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class CountedFetches : public DeviceTest {
protected:
    static Probe draw(const Files& files) {
        const TemporaryTechnique folder(files);
        const HeightMap map = make_map({8, 8}, [](int x, int y) { return (x ^ y) / 8.0; });
        const SceneOnDevice scene(device(), map, grey_albedo());
        return make_renderer(device(), folder.load(), scene, make_view(45, Projection::parallel)).probe();
    }

    static std::string refusal(const Files& files) {
        return error_message([&] { draw(files); });
    }

    /// Of a trace that answers a height.
    static std::string refusal_of(const std::string& functions, const std::string& height) {
        return refusal({{"trace.glsl", functions + "Trace trace(ReliefRay ray) {\n    return hit_off_ray(ray.uv, " +
                                           height + ", 1);\n}\n"}});
    }
};

/// A map of the height's own, and a pass that writes it.
std::string map_and_pass() {
    return manifest_json("", R"(, "maps": [{"name": "copy", "format": "r32f"}],
                                   "passes": [{"name": "copy", "shader": "copy.glsl", "writes": "copy"}])");
}

TEST_F(CountedFetches, AFetchOfTheHeightMapPastThemIsRefusedWithItsPlace) {
    const std::string message = refusal_of("", "textureLod(height_map, ray.uv, 0.0).r");
    EXPECT_THAT(message, AllOf(HasSubstr("trace.glsl:2: this fetch would count as no tap"),
                               HasSubstr("use tap_height(uv)"), Not(HasSubstr("surface.glsl"))));
    EXPECT_THAT(refusal_of("", "texelFetch(height_texels, ivec2(0), 0).r"),
                AllOf(HasSubstr("trace.glsl:2:"), HasSubstr("use tap_height_texel(texel)")));
    EXPECT_THAT(
        refusal_of("", "textureGather(height_texels, ray.uv, 0).r"),
        AllOf(HasSubstr("trace.glsl:2:"), HasSubstr("use tap_height_cell(cell), or tap_map_cell(map, cell, channel)")));
}

TEST_F(CountedFetches, SoIsOneOfShadingsMaps) {
    EXPECT_THAT(refusal_of("", "textureLod(albedo_map, ray.uv, 0.0).r"), HasSubstr("trace.glsl:2:"));
    EXPECT_THAT(refusal_of("", "textureLod(height_derivatives, ray.uv, 0.0).r"), HasSubstr("trace.glsl:2:"));
}

TEST_F(CountedFetches, AMacroOrAParameterHidesNone) {
    EXPECT_THAT(refusal_of("#define MAP height_map\n#define READ(uv) textureLod(MAP, uv, 0.0).r\n", "READ(ray.uv)"),
                HasSubstr("trace.glsl:4:"));
    EXPECT_THAT(refusal_of("float read(sampler2D map, vec2 uv) { return textureLod(map, uv, 0.0).r; }\n",
                           "read(height_map, ray.uv)"),
                HasSubstr("trace.glsl:1:"));
    EXPECT_THAT(refusal_of("#define tap_height(uv) textureLod(height_map, uv, 0.0).r\n", "tap_height(ray.uv)"),
                HasSubstr("trace.glsl:3:"));
}

TEST_F(CountedFetches, NorDoesAnIncludedFile) {
    EXPECT_THAT(refusal({{"trace.glsl",
                          "#include \"read.glsl\"\nTrace trace(ReliefRay ray) {\n"
                          "    return hit_off_ray(ray.uv, read(ray.uv), 1);\n}\n"},
                         {"read.glsl", "\nfloat read(vec2 uv) { return textureLod(height_map, uv, 0.0).r; }\n"}}),
                HasSubstr("read.glsl:2:"));
}

TEST_F(CountedFetches, NorIsOneHiddenFromTheProbedCompilation) {
    EXPECT_THAT(refusal_of("#ifdef RELIEFBENCH_PROBED\n#define READ(uv) 0.5\n#else\n"
                           "#define READ(uv) textureLod(height_map, uv, 0.0).r\n#endif\n",
                           "READ(ray.uv)"),
                HasSubstr("trace.glsl:7:"));
}

TEST_F(CountedFetches, OneComplaintALineAndAFewOfThem) {
    const std::string message = refusal_of(
        "float read(vec2 uv) {\n    float sum = textureLod(height_map, uv, 0.0).r + textureLod(height_map, uv, "
        "0.0).r;\n"
        "    return sum + textureLod(height_map, uv, 0.0).r;\n}\n",
        "read(ray.uv)");
    EXPECT_THAT(message, AllOf(HasSubstr("trace.glsl:2:"), HasSubstr("trace.glsl:3:")));
    EXPECT_EQ(message.find("trace.glsl:2:"), message.rfind("trace.glsl:2:"));
}

TEST_F(CountedFetches, DerivedMapsAreReadThroughThem) {
    Files files{{"technique.json", map_and_pass()},
                {"copy.glsl", "void prepare(ivec2 texel) { write_map(vec4(tap_height_texel(texel))); }"},
                {"trace.glsl",
                 "Trace trace(ReliefRay ray) { return hit_off_ray(ray.uv, texelFetch(copy, ivec2(0), 0).r, "
                 "1); }"}};
    EXPECT_THAT(refusal(files), AllOf(HasSubstr("trace.glsl:1:"), HasSubstr("tap_map_texel(map, texel, lod)")));
    files["trace.glsl"] =
        "Trace trace(ReliefRay ray) { return hit_off_ray(ray.uv, tap_map_texel(copy, ivec2(0), 0).r, 1); }";
    EXPECT_EQ(draw(files).work.at(3, 3).taps, 1U);
}

// Nothing is counted there, so that nothing can be hidden.
TEST_F(CountedFetches, PreparationPassesMayFetchAsTheyLike) {
    const Probe probe =
        draw({{"technique.json", map_and_pass()},
              {"copy.glsl", "void prepare(ivec2 texel) { write_map(texelFetch(height_texels, texel, 0)); }"},
              {"trace.glsl",
               "Trace trace(ReliefRay ray) { return hit_off_ray(ray.uv, tap_map(copy, ray.uv, "
               "0.0).r, 1); }"}});
    EXPECT_EQ(probe.work.at(3, 3).taps, 1U);
}

Files patches(const std::string& factor, const std::string& height) {
    const std::string parameters =
        R"({"name": "patches", "type": "integer", "default": 2, "range": [0, 8], "help": "h"})";
    return {
        {"technique.json", manifest_json(parameters, "", R"({"patches": {"parameter": "patches"}})")},
        {"control.tesc", "#include \"patches.glsl\"\nvoid main() {\n    pass_corner();\n    set_tessellation_factor(" +
                             factor + ");\n}\n"},
        {"evaluation.tese",
         "#include \"patches.glsl\"\nlayout(quads, equal_spacing, ccw) in;\nvoid main() {\n"
         "    emit_surface(grid_coordinates(), " +
             height + ");\n}\n"}};
}

TEST_F(CountedFetches, StagesOfATechniquesOwnAreHeldToThemToo) {
    if (!device().info().has_feature("tessellationShader")) GTEST_SKIP() << "the device cannot tessellate";
    EXPECT_THAT(refusal(patches("1.0", "textureLod(height_map, grid_coordinates(), 0.0).r")),
                HasSubstr("evaluation.tese:4: this fetch would count as no tap"));
    EXPECT_THAT(refusal(patches("1.0 + textureLod(height_map, vec2(0.5), 0.0).r", "0.5")),
                HasSubstr("control.tesc:4: this fetch would count as no tap"));
}

// 4 patches of 4 corners each: without a word of its author's the control stage's taps count like any others.
TEST_F(CountedFetches, TapsOfAControlStageCountByThemselves) {
    if (!device().info().has_feature("tessellationShader")) GTEST_SKIP() << "the device cannot tessellate";
    const Probe without = draw(patches("1.0", "0.5"));
    const Probe with = draw(patches("1.0 + 0.0 * tap_height(vec2(0.5))", "0.5"));
    EXPECT_EQ(without.stages.taps, 0U);
    EXPECT_EQ(with.stages.taps, 16U);
    EXPECT_EQ(with.stages.texels, 64U);
}

}  // namespace
}  // namespace reliefbench
