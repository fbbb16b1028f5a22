#include "test_scene.hpp"

#include <cmath>

namespace reliefbench {
namespace {

using namespace test;

using CameraOnDevice = DeviceTest;
using Files = TemporaryTechnique::Files;

// float32 in the shader against double: the entry of a ray at 80° is known to about 1e-6 of the patch.
constexpr double entry_tolerance = 1e-5;

TEST_F(CameraOnDevice, AgreesWithTheScenes) {
    const TemporaryTechnique folder(Files{{"trace.glsl", flat_trace}});
    const Technique technique = folder.load();
    const HeightMap map = make_map({4, 4}, [](int, int) { return 1.0; });
    const SceneOnDevice scene(device(), map, grey_albedo());
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        for (const double angle : {0.0, 45.0, 80.0}) {
            View view = make_view(angle, projection, {96, 64});
            view.camera.azimuth = -60;
            Renderer renderer(device(), technique, technique.manifest.defaults(), scene, view, Lighting{});
            renderer.prepare();
            const Probe probe = renderer.probe();
            int compared = 0;
            for (int j = 0; j < view.resolution.height; ++j) {
                for (int i = 0; i < view.resolution.width; ++i) {
                    const Hit& hit = probe.hits.at(i, j);
                    const Ray ray = pixel_ray(view, i, j);
                    const auto entry = footprint_entry(ray);
                    EXPECT_EQ(hit.is_hit(), entry.has_value()) << i << ' ' << j << ' ' << angle;
                    if (!hit.is_hit() || !entry) continue;
                    ++compared;
                    EXPECT_NEAR(hit.u, entry->x, entry_tolerance);
                    EXPECT_NEAR(hit.v, entry->y, entry_tolerance);
                    EXPECT_EQ(hit.h, 1.0f);
                    EXPECT_NEAR(hit.t, -ray.origin.z / ray.direction.z, entry_tolerance);
                }
            }
            EXPECT_GT(compared, 100) << angle;
        }
    }
}

TEST_F(CameraOnDevice, AProbeFromAnotherCameraIsTheOneOfItsView) {
    const TechniqueLibrary shipped = find_techniques({default_technique_root()});
    const HeightMap map = make_map({16, 16}, [](int x, int y) { return 0.05 * ((3 * x + 5 * y) % 17); });
    const SceneOnDevice scene(device(), map, grey_albedo());
    // Patches cover what the camera sees, which with a relief that goes on for ever is more towards grazing.
    for (const char* technique : {"steep", "tessellation"}) {
        View view = make_view(20, Projection::perspective);
        view.relief.boundary = Boundary::repeat;
        view.relief.height_scale = 0.2;
        Renderer renderer = make_renderer(device(), shipped.get(technique), scene, view);
        const Probe before = renderer.probe();
        view.camera.view_angle = 75;
        const Probe moved = renderer.probe_from(view.camera);
        const Probe expected = make_renderer(device(), shipped.get(technique), scene, view).probe();
        EXPECT_EQ(moved.hits.texels, expected.hits.texels) << technique;
        EXPECT_EQ(moved.colour.texels, expected.colour.texels) << technique;
        EXPECT_NE(moved.hits.texels, before.hits.texels);
        EXPECT_EQ(renderer.probe().hits.texels, before.hits.texels) << "the renderer's own view moved";
    }
}

TEST_F(CameraOnDevice, AFramesShiftMovesItsRaysAndItsTriangles) {
    const TechniqueLibrary shipped = find_techniques({default_technique_root()});
    const HeightMap map = make_map({16, 16}, [](int x, int y) { return 0.05 * ((3 * x + 5 * y) % 17); });
    const SceneOnDevice scene(device(), map, grey_albedo());
    for (const char* technique : {"flat", "tessellation"}) {
        for (const Projection projection : {Projection::perspective, Projection::parallel}) {
            View view = make_view(35, projection, {48, 32});
            view.camera.azimuth = -60;
            Renderer renderer = make_renderer(device(), shipped.get(technique), scene, view);
            const Probe centred = renderer.probe_from(view.camera, 0);
            EXPECT_EQ(centred.hits.texels, renderer.probe().hits.texels)
                << "without a shift it is the picture by itself";
            // Whole pixels: what was at (3, 2) is at (0, 0).
            view.camera.shift = {3.0 / 48, 2.0 / 32};
            const Probe shifted = renderer.probe_from(view.camera, 1);
            int compared = 0;
            for (int j = 0; j < 30; ++j) {
                for (int i = 0; i < 45; ++i) {
                    const Hit& hit = shifted.hits.at(i, j);
                    const Hit& expected = centred.hits.at(i + 3, j + 2);
                    if (!hit.is_hit() || !expected.is_hit()) continue;
                    ++compared;
                    EXPECT_NEAR(hit.u, expected.u, entry_tolerance) << technique;
                    EXPECT_NEAR(hit.v, expected.v, entry_tolerance) << technique;
                }
            }
            EXPECT_GT(compared, 100) << technique;
        }
    }
}

}  // namespace
}  // namespace reliefbench
