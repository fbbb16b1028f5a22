#include "test_scene.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;
using Quantity = AnswerFault::Quantity;
using testing::AllOf;
using testing::HasSubstr;

const HeightMap& half_map() {
    static const HeightMap map = make_map({8, 4}, [](int, int) { return 0.5; });
    return map;
}

class AnswerRange : public DeviceTest {
protected:
    /// `body` is that of trace(); 8×4 pixels, parallel rays, one for each texel.
    static Probe probe(const std::string& body, Boundary boundary = Boundary::clip) {
        const TemporaryTechnique folder(Files{{"trace.glsl", "Trace trace(ReliefRay ray) {" + body + "}"}});
        const SceneOnDevice scene(device(), half_map(), grey_albedo());
        View view = make_view(30, Projection::parallel, {8, 4});
        view.relief.boundary = boundary;
        return make_renderer(device(), folder.load(), scene, view, lights_off()).probe();
    }

    static void expect_all_at_fault(const std::string& body, Quantity quantity, double value) {
        const Probe found = probe(body);
        ASSERT_EQ(found.faults.size(), 32u) << body;
        for (const AnswerFault& fault : found.faults) {
            EXPECT_EQ(fault.quantity, quantity) << body;
            if (std::isnan(value)) {
                EXPECT_TRUE(std::isnan(fault.value)) << body;
            } else {
                EXPECT_EQ(fault.value, value) << body;
            }
        }
        EXPECT_EQ(found.faults.front().pixel, (PixelPlace{0, 0}));
        EXPECT_EQ(found.faults.back().pixel, (PixelPlace{7, 3}));
    }
};

TEST_F(AnswerRange, RayParametersLieBetweenThePolygonAndTheFloor) {
    expect_all_at_fault("return hit_on_ray(-0.5, 1);", Quantity::s, -0.5);
    expect_all_at_fault("return hit_on_ray(1.5, 1);", Quantity::s, 1.5);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect_all_at_fault("return hit_on_ray(uintBitsToFloat(0x7fc00000u), 1);", Quantity::s, nan);
    expect_all_at_fault("return hit_on_ray(uintBitsToFloat(0x7f800000u), 1);", Quantity::s,
                        std::numeric_limits<double>::infinity());
}

TEST_F(AnswerRange, WhatRoundingLeavesIsInRangeAndAHit) {
    for (const char* s : {"uintBitsToFloat(0x3f800001u)", "-1e-6", "1.00005", "0.0", "1.0"}) {
        const Probe found = probe(std::string("return hit_on_ray(") + s + ", 1);", Boundary::repeat);
        EXPECT_TRUE(found.faults.empty()) << s;
        for (const Hit& hit : found.hits.texels)
            EXPECT_TRUE(hit.is_hit()) << s;
    }
}

TEST_F(AnswerRange, PointsBesideTheRayHaveAHeightOfTheRelief) {
    expect_all_at_fault("return hit_off_ray(ray.uv, -0.25, 1);", Quantity::h, -0.25);
    expect_all_at_fault("return hit_off_ray(ray.uv, 1.25, 1);", Quantity::h, 1.25);
    expect_all_at_fault("return hit_off_ray(vec2(ray.uv.x, uintBitsToFloat(0x7fc00000u)), 0.5, 1);", Quantity::uv,
                        std::numeric_limits<double>::quiet_NaN());
    expect_all_at_fault("return hit_off_ray(vec2(uintBitsToFloat(0xff800000u), ray.uv.y), 0.5, 1);", Quantity::uv,
                        -std::numeric_limits<double>::infinity());
}

// Beside the patch there is relief where it repeats, and a miss where it does not: both are answers.
TEST_F(AnswerRange, PointsBesideThePatchAreAllowed) {
    const std::string body = "return hit_off_ray(ray.uv + 7.0, 0.5, 1);";
    const Probe repeated = probe(body, Boundary::repeat);
    EXPECT_TRUE(repeated.faults.empty());
    EXPECT_TRUE(repeated.hits.at(0, 0).is_hit());
    const Probe clipped = probe(body);
    EXPECT_TRUE(clipped.faults.empty());
    EXPECT_FALSE(clipped.hits.at(0, 0).is_hit());
}

TEST_F(AnswerRange, StepsAreNoNegativeAndNoAbsurdNumber) {
    expect_all_at_fault("return hit_on_ray(0.5, -3);", Quantity::steps, -3);
    expect_all_at_fault("return miss(-1);", Quantity::steps, -1);
    expect_all_at_fault("return unconverged(hit_on_ray(0.5, (1 << 24) + 1));", Quantity::steps, (1 << 24) + 1);
    const Probe most = probe("return hit_on_ray(0.5, 1 << 24);");
    EXPECT_TRUE(most.faults.empty());
    EXPECT_EQ(most.work.at(0, 0).steps, 1u << 24);
}

// The pixel whose texture coordinates are those of texel (5, 1) is in row 2, for row 0 is the top and v = 0 the bottom.
TEST_F(AnswerRange, TheWorstPixelIsNamed) {
    const Probe found = probe(
        "ivec2 texel = ivec2(ray.uv * vec2(8.0, 4.0));"
        "if (texel == ivec2(5, 1)) return hit_on_ray(-2.5, 1);"
        "if (texel.x == 6) return hit_on_ray(1.25, 1);"
        "return hit_on_ray(0.5, 1);");
    ASSERT_EQ(found.faults.size(), 5u);
    EXPECT_EQ(worst_fault(found.faults).pixel, (PixelPlace{5, 2}));
    EXPECT_THAT(reason_of_faults(found.faults, 32),
                AllOf(HasSubstr("5 of 32 pixels"), HasSubstr("s = -2.5 at pixel (5, 2)"), HasSubstr("[0, s_end]")));
}

TEST_F(AnswerRange, WhatIsNotFiniteIsTheWorst) {
    const std::vector<AnswerFault> faults{{Quantity::s, -100, PixelPlace{0, 0}},
                                          {Quantity::h, std::numeric_limits<double>::quiet_NaN(), PixelPlace{1, 0}}};
    EXPECT_EQ(worst_fault(faults).quantity, Quantity::h);
    EXPECT_EQ(reason_of_faults({}, 10), "");
}

// The light's ray is told from the eye's by its direction.
TEST_F(AnswerRange, AnswersForTheRaysOfLightsAreChecked) {
    const TemporaryTechnique folder(Files{{"trace.glsl",
                                           "Trace trace(ReliefRay ray) { return hit_on_ray(ray.to_eye.x > 0.7 ? -0.5 : "
                                           "1.0 - tap_height(ray.uv), 1); }"}});
    const SceneOnDevice scene(device(), half_map(), grey_albedo());
    View view = make_view(0, Projection::parallel, {8, 4});
    view.relief.boundary = Boundary::repeat;
    Lighting lighting;
    lighting.lights = {{glm::dvec3{0.8, 0, 0.6}}};
    const Technique technique = folder.load();
    EXPECT_TRUE(make_renderer(device(), technique, scene, view, lighting).probe().faults.empty());
    view.self_shadow.mode = SelfShadow::Mode::hard;
    const Probe found = make_renderer(device(), technique, scene, view, lighting).probe();
    ASSERT_EQ(found.faults.size(), 32u);
    EXPECT_EQ(found.faults.front().value, -0.5);
}

TEST_F(AnswerRange, VerticesOfRealGeometryHaveAHeightOfTheRelief) {
    if (!device().info().has_feature("tessellationShader")) GTEST_SKIP() << "the device cannot tessellate";
    const auto patches = [](const std::string& height) {
        const std::string parameters =
            R"({"name": "patches", "type": "integer", "default": 1, "range": [1, 64], "help": "h"})";
        return Files{{"technique.json", manifest_json(parameters, "", R"({"patches": {"parameter": "patches"}})")},
                     {"control.tesc", R"(layout(vertices = 4) out;
                        #include "patches.glsl"
                        void main() {
                            pass_corner();
                            if (gl_InvocationID == 0) set_tessellation_factor(4.0);
                        })"},
                     {"evaluation.tese", R"(
                        #include "patches.glsl"
                        layout(quads, equal_spacing, ccw) in;
                        void main() { emit_surface(grid_coordinates(), )" +
                                             height + "); }"}};
    };
    const SceneOnDevice scene(device(), half_map(), grey_albedo());
    const View view = make_view(30, Projection::parallel, {8, 4});
    const TemporaryTechnique good(patches("tap_height(grid_coordinates())"));
    EXPECT_TRUE(make_renderer(device(), good.load(), scene, view).probe().faults.empty());
    const TemporaryTechnique bad(patches("grid_coordinates().x > 0.6 ? -1.5 : 0.5"));
    const Probe found = make_renderer(device(), bad.load(), scene, view).probe();
    ASSERT_EQ(found.faults.size(), 1u);
    EXPECT_THAT(reason_of_faults(found.faults, 32), AllOf(HasSubstr("h = -1.5 at a vertex"), HasSubstr("[0, 1]")));
}

}  // namespace
}  // namespace reliefbench
