#include "test_scene.hpp"

#include <cmath>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;

class Tessellation : public DeviceTest {
protected:
    void SetUp() override {
        DeviceTest::SetUp();
        if (!device().info().has_feature("tessellationShader")) GTEST_SKIP() << "the device cannot tessellate";
    }
};

TemporaryTechnique::Files patches() {
    const std::string parameters =
        R"({"name": "factor", "type": "integer", "default": 8, "range": [1, 64], "help": "h"},
           {"name": "patches", "type": "integer", "default": 0, "range": [0, 64], "help": "h"})";
    return {{"technique.json",
             manifest_json(parameters, "", R"({"patches": {"parameter": "patches", "texels_per_patch": 8}})")},
            {"control.tesc", R"(layout(vertices = 4) out;
                #include "patches.glsl"
                void main() {
                    pass_corner();
                    if (gl_InvocationID == 0) set_tessellation_factor(float(factor));
                })"},
            {"evaluation.tese", R"(
                #include "patches.glsl"
                layout(quads, equal_spacing, ccw) in;
                void main() { emit_surface(grid_coordinates(), tap_height(scene.tiling * grid_coordinates())); })"}};
}

// A plane at c seen from both cameras: its triangles face the eye, and every hit lies on the ray at height c.
TEST_F(Tessellation, ConstantMapHasItsClosedForm) {
    const TemporaryTechnique folder(patches());
    const Technique technique = folder.load();
    const double c = 26214.0 / 65535.0;
    const HeightMap map = make_map({20, 12}, [&](int, int) { return c; });
    const SceneOnDevice scene(device(), map, grey_albedo());
    for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
        for (const Projection projection : {Projection::perspective, Projection::parallel}) {
            for (const double angle : {0.0, 60.0}) {
                View view = make_view(angle, projection, {48, 32});
                view.camera.azimuth = -70;
                view.relief.height_scale = 0.2;
                view.relief.boundary = boundary;
                const Probe probe = make_renderer(device(), technique, scene, view).probe();
                int compared = 0;
                for (int j = 0; j < view.resolution.height; ++j) {
                    for (int i = 0; i < view.resolution.width; ++i) {
                        const Ray ray = pixel_ray(view, i, j);
                        const double t = (-(1 - c) * view.relief.height_scale - ray.origin.z) / ray.direction.z;
                        const double u = ray.origin.x + t * ray.direction.x + 0.5;
                        const double v = ray.origin.y + t * ray.direction.y + 0.5;
                        const double border = std::min({u, 1 - u, v, 1 - v});
                        const bool expected =
                            boundary == Boundary::clip ? border > 0 : footprint_entry(ray).has_value();
                        // Where the border passes within 1e-4 of the pixel's centre either answer is right.
                        if (boundary == Boundary::clip && std::abs(border) < 1e-4) continue;
                        const Hit& hit = probe.hits.at(i, j);
                        ASSERT_EQ(hit.is_hit(), expected) << i << ' ' << j << ' ' << angle;
                        if (!hit.is_hit()) continue;
                        ++compared;
                        // Rasterisers snap vertices to 1/256 of a pixel.
                        const double snapped = 2.0 / 256 / 32 / std::cos(angle * 3.14159 / 180) + 1e-5;
                        EXPECT_NEAR(hit.u, u, snapped);
                        EXPECT_NEAR(hit.v, v, snapped);
                        EXPECT_NEAR(hit.h, c, 1e-5);
                        EXPECT_NEAR(hit.t, t, snapped);
                    }
                }
                EXPECT_GT(compared, 100);
            }
        }
    }
}

TEST_F(Tessellation, BackFacesAreCulled) {
    const TemporaryTechnique good(patches());
    Files turned = patches();
    std::string& evaluation = turned["evaluation.tese"];
    evaluation.replace(evaluation.find("ccw"), 3, "cw");
    const TemporaryTechnique folder(turned);
    const SceneOnDevice scene(device(), make_map({8, 8}, [](int, int) { return 1.0; }), grey_albedo());
    const View view = make_view(30, Projection::perspective);
    const auto hits = [&](const TemporaryTechnique& technique) {
        const Probe probe = make_renderer(device(), technique.load(), scene, view).probe();
        return std::count_if(probe.hits.texels.begin(), probe.hits.texels.end(),
                             [](const Hit& hit) { return hit.is_hit(); });
    };
    EXPECT_GT(hits(good), 100);
    EXPECT_EQ(hits(folder), 0);
}

// The mesh stands up at the texel that the map says: texel (5, 1) of 8×4 is pixel (5, 2).
TEST_F(Tessellation, RaisedTexelIsInItsPixel) {
    const TemporaryTechnique folder(patches());
    const HeightMap map = make_map({8, 4}, [](int x, int y) { return x == 5 && y == 1 ? 1.0 : 0.0; });
    const SceneOnDevice scene(device(), map, grey_albedo());
    const View view = make_view(0, Projection::parallel, {8, 4});
    // Vertices at multiples of 1/16 of the patch: texel centres along u, half a texel of v apart.
    const Probe probe = make_renderer(device(), folder.load(), scene, view, {},
                                      {{"factor", std::int64_t{16}}, {"patches", std::int64_t{1}}})
                            .probe();
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 8; ++i)
            EXPECT_NEAR(probe.hits.at(i, j).h, i == 5 && j == 2 ? 1.0 : 0.0, 1e-2) << i << j;
    }
}

TEST_F(Tessellation, WorkOfStagesIsSummed) {
    const TemporaryTechnique folder(patches());
    const HeightMap map = make_map({8, 8}, [](int, int) { return 0.5; });
    const SceneOnDevice scene(device(), map, grey_albedo());
    const View view = make_view(20, Projection::parallel, {16, 16});
    Renderer renderer = make_renderer(device(), folder.load(), scene, view, {},
                                      {{"factor", std::int64_t{4}}, {"patches", std::int64_t{3}}});
    const Probe probe = renderer.probe();
    const PipelineStatistics statistics = renderer.pipeline_statistics();
    EXPECT_EQ(statistics.at("tessellation_control_shader_patches"), 9u);
    // Each of the 5×5 vertices of a patch at least once.
    EXPECT_GE(probe.stages.taps, 9u * 25u);
    EXPECT_EQ(probe.stages.taps, statistics.at("tessellation_evaluation_shader_invocations"));
    EXPECT_EQ(probe.stages.texels, 4 * probe.stages.taps);
    EXPECT_EQ(probe.work.at(8, 8).taps, 0u);
    for (const double value : renderer.time_draw(2))
        EXPECT_GT(value, 0);
}

TEST_F(Tessellation, OnePatchForSoManyTexelsByDefault) {
    const TemporaryTechnique folder(patches());
    const HeightMap map = make_map({20, 12}, [](int, int) { return 0.5; });
    const SceneOnDevice scene(device(), map, grey_albedo());
    View view = make_view(0, Projection::parallel, {16, 16});
    view.relief.tiling = 2;
    Renderer renderer = make_renderer(device(), folder.load(), scene, view);
    // 40×24 texels in patches of 8.
    EXPECT_EQ(renderer.pipeline_statistics().at("tessellation_control_shader_patches"), 5u * 3u);
}

TEST_F(Tessellation, TimedAndProbedAgreeBitForBit) {
    const TemporaryTechnique folder(patches());
    const HeightMap map = make_map({13, 9}, [](int x, int y) { return ((x * 7 + y * 5) % 11) / 10.0; });
    const Albedo albedo = make_albedo({64, 64}, [](int x, int y) {
        return std::array<float, 4>{(float(x) + 0.5f) / 64, (float(y) + 0.5f) / 64, 0, 1};
    });
    const SceneOnDevice scene(device(), map, albedo);
    View view = make_view(70, Projection::perspective, {80, 48});
    view.relief.height_scale = 0.2;
    Renderer renderer = make_renderer(device(), folder.load(), scene, view, lights_off());
    const Probe probe = renderer.probe();
    const TimedPicture timed = renderer.draw_timed(ColourTarget::linear_float);
    for (std::size_t i = 0; i < view.resolution.pixels(); ++i) {
        ASSERT_EQ(timed.colour.texels[i][3] == 1.0f, probe.hits.texels[i].is_hit());
        for (std::size_t channel = 0; channel < 3; ++channel)
            ASSERT_EQ(timed.colour.texels[i][channel], probe.colour.texels[i][channel]);
    }
}

}  // namespace
}  // namespace reliefbench
