#include "core/random.hpp"
#include "reference/truth.hpp"
#include "test_scene.hpp"

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;

using ShadingOnDevice = DeviceTest;

glm::dvec3 random_vector(Random& random, double low, double high) {
    const double x = random.uniform(low, high);
    const double y = random.uniform(low, high);
    return {x, y, random.uniform(low, high)};
}

Lighting random_lighting(Random& random, int lights) {
    Lighting lighting;
    lighting.lights.clear();
    for (int i = 0; i < lights; ++i) {
        glm::dvec3 direction = random_vector(random, -2, 2);
        direction.z += 0.5;
        lighting.lights.push_back({direction, random_vector(random, 0, 1)});
    }
    lighting.ambient = random_vector(random, 0, 0.5);
    lighting.specular = random_vector(random, 0, 1);
    lighting.shininess = random.uniform(1, 64);
    lighting.background = random_vector(random, 0, 1);
    if (lights == 3) lighting.fog = Fog{0.5, 1.0, random_vector(random, 0, 1)};
    return lighting;
}

// The same points, shaded by GLSL and by C++.
TEST_F(ShadingOnDevice, AgreesWithTheReference) {
    Random random(7);
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const Technique technique = folder.load();
    const Resolution size{12, 9};
    const HeightMap map = make_map(size, [&](int, int) { return random.uniform(); });
    const Albedo albedo = make_albedo({5, 6}, [&](int, int) {
        const auto channel = [&] { return static_cast<float>(random.uniform()); };
        return std::array<float, 4>{channel(), channel(), channel(), 1};
    });
    const SceneOnDevice scene(device(), map, albedo);
    for (int lights = 0; lights <= 3; ++lights) {
        for (const Projection projection : {Projection::perspective, Projection::parallel}) {
            View view = make_view(random.uniform(0, 80), projection);
            view.camera.azimuth = random.uniform(-180, 180);
            view.relief.tiling = 2;
            view.relief.height_scale = 0.1;
            if (projection == Projection::parallel) view.self_shadow.mode = SelfShadow::Mode::hard;
            const Lighting lighting = random_lighting(random, lights);
            const Probe probe = make_renderer(device(), technique, scene, view, lighting).probe();
            const Image<std::array<float, 3>> expected =
                shade_hits(probe.hits, probe.light_visibility, map, albedo, view, lighting);
            for (std::size_t i = 0; i < expected.texels.size(); ++i) {
                for (std::size_t channel = 0; channel < 3; ++channel)
                    ASSERT_NEAR(probe.colour.texels[i][channel], expected.texels[i][channel], 1.0 / 255)
                        << "pixel " << i << ", " << lights << " lights";
            }
        }
    }
}

TEST_F(ShadingOnDevice, PolygonNormalIgnoresTheRelief) {
    const TemporaryTechnique folder(Files{{"trace.glsl", R"(
        Trace trace(ReliefRay ray) {
            Trace result = hit_off_ray(ray.uv, 1.0, 0);
            result.flat_normal = true;
            return result;
        })"}});
    const HeightMap map = make_map({6, 6}, [](int x, int) { return x % 2; });
    const HeightMap flat = make_map({6, 6}, [](int, int) { return 0.5; });
    const View view = make_view(20, Projection::parallel, {24, 24});
    const SceneOnDevice scene(device(), map, grey_albedo());
    const SceneOnDevice flat_scene(device(), flat, grey_albedo());
    const Probe with_relief = make_renderer(device(), folder.load(), scene, view).probe();
    const Probe without = make_renderer(device(), folder.load(), flat_scene, view).probe();
    EXPECT_EQ(with_relief.colour.texels, without.colour.texels);
}

TEST_F(ShadingOnDevice, TooManyLightsAreRefused) {
    const TemporaryTechnique folder(Files{{"trace.glsl", flat_trace}});
    const SceneOnDevice scene(device(), make_map({2, 2}, [](int, int) { return 0.5; }), grey_albedo());
    Lighting lighting;
    lighting.lights.resize(4);
    EXPECT_ANY_THROW(make_renderer(device(), folder.load(), scene, make_view(0, Projection::parallel), lighting));
}

}  // namespace
}  // namespace reliefbench
