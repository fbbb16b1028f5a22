#include "technique/cut_loops.hpp"

#include "gpu/loop_limit.hpp"
#include "support/error_message.hpp"
#include "test_scene.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

/// Loops without an end: for devices that end them only, as others would not come back.
class CutLoops : public DeviceTest {
protected:
    void SetUp() override {
        DeviceTest::SetUp();
        if (!gpu::loop_limit(device())) GTEST_SKIP() << "the device ends no loops";
    }

    static const HeightMap& map() {
        static const HeightMap map = make_map({8, 8}, [](int x, int y) { return (x ^ y) / 8.0; });
        return map;
    }

    static Probe draw(const Files& files, const Lighting& lighting = lights_off(),
                      SelfShadow::Mode shadows = SelfShadow::Mode::off) {
        const TemporaryTechnique folder(files);
        const SceneOnDevice scene(device(), map(), grey_albedo());
        View view = make_view(45, Projection::parallel, {32, 32});
        view.relief.boundary = Boundary::repeat;
        view.self_shadow.mode = shadows;
        return make_renderer(device(), folder.load(), scene, view, lighting).probe();
    }

    /// A trace that runs `loops` and answers whatever they left in `n`.
    static Probe draw_with(const std::string& loops) {
        return draw({{"trace.glsl", "Trace trace(ReliefRay ray) {\n    int n = 0;\n" + loops +
                                        "\n    return hit_on_ray(0.5, n);\n}\n"}});
    }

    static std::ptrdiff_t cut_pixels(const Probe& probe) {
        return std::ranges::count_if(probe.work.texels, [](const PixelWork& work) { return work.cut; });
    }
};

constexpr std::ptrdiff_t all_pixels = 32 * 32;

/// A map of floats that the pass `fill` writes, of which the trace shows what is stored at the lower left.
Files filled(const std::string& prepare, const std::string& sliced = "") {
    return {{"technique.json", manifest_json("", R"(, "maps": [{"name": "sums", "format": "r32f"}],
                                  "passes": [{"name": "fill", "shader": "fill.glsl", "writes": "sums")" +
                                                     sliced + "}]")},
            {"fill.glsl", prepare},
            {"trace.glsl",
             "Trace trace(ReliefRay ray) { return hit_off_ray(ray.uv, tap_map_texel(sums, ivec2(0), 0).r, 1); "
             "}"}};
}

TEST_F(CutLoops, OneWithoutAnEndIsSeenWhateverItDoes) {
    for (const char* loop : {"while (tap_height(ray.uv) > -1.0) ++n;", "while (n >= 0) n = (n + 1) & 1023;",
                             "for (float s = 0.0; s < 1.0; s += 0.0) ++n;"}) {
        const Probe probe = draw_with(loop);
        EXPECT_EQ(cut_pixels(probe), all_pixels) << loop;
        EXPECT_THAT(describe_cut_loops(device(), probe),
                    AllOf(HasSubstr("the device ended the loops of 100 % of the pixels"),
                          HasSubstr(std::to_string(*gpu::loop_limit(device())) + " iterations")));
    }
}

// What follows it is not run then, not even what counts pixels.
TEST_F(CutLoops, OneWithoutAWayOutIsSeenWhateverACompilerDrops) {
    for (const char* loop : {"for (;;) ++n;", "for (;;) n += int(tap_height(ray.uv) > 2.0);"})
        EXPECT_EQ(cut_pixels(draw_with(loop)), all_pixels) << loop;
    EXPECT_THAT(error_message([] {
                    draw(filled("void prepare(ivec2 texel) { int n = 0; for (;;) write_map_at(texel, vec4(n++)); }"));
                }),
                HasSubstr("the pass 'fill' does not come to its end"));
}

TEST_F(CutLoops, OnesThatEndWithinTheLimitAreNotCut) {
    const Probe probe = draw_with("for (int i = 0; i < 250; ++i) for (int j = 0; j < 250; ++j) n += i ^ j;");
    EXPECT_EQ(cut_pixels(probe), 0);
    EXPECT_THAT(describe_cut_loops(device(), probe), IsEmpty());
}

TEST_F(CutLoops, TheyCountTogether) {
    EXPECT_EQ(cut_pixels(draw_with("for (int i = 0; i < 260; ++i) for (int j = 0; j < 260; ++j) n += i ^ j;")),
              all_pixels);
    EXPECT_EQ(cut_pixels(draw_with("for (int i = 0; i < 40000; ++i) n ^= i; for (int j = 0; j < 40000; ++j) n ^= j;")),
              all_pixels);
}

// Each pixel's own loops are far from the limit: those that run side by side take turns, and what one of them counted
// would not tell.
TEST_F(CutLoops, SoDoThoseOfPixelsSideBySide) {
    const Probe probe = draw_with(R"(
        for (int k = 0; k < 4; ++k)
            if ((int(gl_FragCoord.x) & 3) == k) for (int i = 0; i < 20000; ++i) n ^= i;)");
    EXPECT_GT(cut_pixels(probe), 0);
}

TEST_F(CutLoops, OnlyThePixelsConcernedAreTold) {
    const Probe probe = draw_with("while (gl_FragCoord.x > 16.0 && n >= 0) n = (n + 1) & 1023;");
    EXPECT_EQ(cut_pixels(probe), all_pixels / 2);
    EXPECT_FALSE(probe.work.at(0, 0).cut);
    EXPECT_TRUE(probe.work.at(31, 0).cut);
    EXPECT_THAT(describe_cut_loops(device(), probe), HasSubstr("50 % of the pixels"));
}

TEST_F(CutLoops, AMissHidesNothing) {
    const Probe probe = draw({{"trace.glsl",
                               "Trace trace(ReliefRay ray) {\n    int n = 0;\n"
                               "    while (n >= 0) n = (n + 1) & 1023;\n    return miss(n);\n}\n"}});
    EXPECT_EQ(cut_pixels(probe), all_pixels);
}

// Rays of the view come at 45°, those of the light from nearly overhead.
TEST_F(CutLoops, SearchesOfShadowsCountToo) {
    const Files files{{"trace.glsl",
                       "Trace trace(ReliefRay ray) {\n    int n = 0;\n"
                       "    while (ray.to_eye.z > 0.9 && tap_height(ray.uv) > -1.0) ++n;\n"
                       "    return hit_on_ray(0.5, n);\n}\n"}};
    Lighting lighting;
    lighting.lights = {{{0.1, 0.1, 1}}};
    EXPECT_EQ(cut_pixels(draw(files, lighting)), 0);
    EXPECT_EQ(cut_pixels(draw(files, lighting, SelfShadow::Mode::hard)), all_pixels);
}

Files patches(const std::string& control_loop, const std::string& evaluation_loop) {
    const std::string parameters =
        R"({"name": "patches", "type": "integer", "default": 2, "range": [0, 8], "help": "h"})";
    return {{"technique.json", manifest_json(parameters, "", R"({"patches": {"parameter": "patches"}})")},
            {"control.tesc", "#include \"patches.glsl\"\nvoid main() {\n    pass_corner();\n    int n = 0;\n" +
                                 control_loop + "\n    set_tessellation_factor(n < 0 ? 2.0 : 1.0);\n}\n"},
            {"evaluation.tese",
             "#include \"patches.glsl\"\nlayout(quads, equal_spacing, ccw) in;\nvoid main() {\n    int n = 0;\n" +
                 evaluation_loop + "\n    emit_surface(grid_coordinates(), n < 0 ? 0.25 : 0.5);\n}\n"}};
}

TEST_F(CutLoops, ThoseOfTessellationStagesAreSeen) {
    const std::string endless = "    while (tap_height(vec2(0.5)) > -1.0) ++n;";
    EXPECT_THAT(describe_cut_loops(device(), draw(patches("", ""))), IsEmpty());
    for (const Files& files : {patches(endless, ""), patches("", endless)}) {
        EXPECT_THAT(describe_cut_loops(device(), draw(files)),
                    HasSubstr("the device ended the loops of a tessellation stage"));
    }
}

TEST_F(CutLoops, APassThatDoesNotEndIsAnErrorWithItsName) {
    const std::string message = error_message([] {
        draw(filled("void prepare(ivec2 texel) { int n = 0; while (n >= 0) n = (n + 1) & 1023; write_map(vec4(n)); }"));
    });
    EXPECT_THAT(message, AllOf(HasSubstr("the pass 'fill' does not come to its end"), HasSubstr("map 'sums'"),
                               HasSubstr("65535 iterations"), HasSubstr("\"sliced\"")));
}

/// Adds `turns` for each texel searched to what the slices before found.
std::string summing_pass(int turns) {
    return R"(void prepare(ivec2 texel) {
        float sum = slice_begin() == 0 ? 0.0 : folded_map().r;
        for (int i = slice_begin(); i < slice_end(); ++i)
            for (int turn = 0; turn < )" +
           std::to_string(turns) + R"(; ++turn) sum += tap_height_texel(ivec2(i, turn)) < -1.0 ? 1.0 : 1.0 / 262144.0;
        write_map(vec4(sum));
    })";
}

// 64 texels are searched: looking at the loops of a slice adds nothing to what it finds.
TEST_F(CutLoops, WhatAPassInSlicesFoldsIsFoldedOnce) {
    const Probe probe = draw(filled(summing_pass(2048), R"(, "sliced": {"iterations": 2049})"));
    EXPECT_EQ(probe.hits.at(3, 3).h, 0.5F);
}

TEST_F(CutLoops, APassOfMoreIterationsThanItTellsIsAnError) {
    const std::string message =
        error_message([] { draw(filled(summing_pass(4096), R"(, "sliced": {"iterations": 1})")); });
    EXPECT_THAT(message, AllOf(HasSubstr("the pass 'fill' does not come to its end"),
                               HasSubstr("\"iterations\": 1 in technique.json")));
    EXPECT_THAT(error_message([] {
                    draw(
                        filled("void prepare(ivec2 texel) { int n = 0; while (n >= 0) n = (n + 1) & 1023; "
                               "write_map(vec4(n)); }",
                               R"(, "sliced": {"over": "rows"})"));
                }),
                HasSubstr("slices of rows leave each texel all of its iterations"));
}

}  // namespace
}  // namespace reliefbench
