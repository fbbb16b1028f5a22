#include "metrics/wrong_surface.hpp"
#include "reference/truth.hpp"
#include "test_scene.hpp"

#include <glm/vec4.hpp>

#include <cmath>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;

using DepthWriting = DeviceTest;

const HeightMap& hills() {
    static const HeightMap map = make_map({24, 16}, [](int x, int y) {
        return 0.5 + 0.25 * std::sin(x * 2 * 3.14159265 * 3 / 24) + 0.25 * std::cos(y * 2 * 3.14159265 * 2 / 16);
    });
    return map;
}

View view_with(DepthWrite depth_write, Projection projection) {
    View view = make_view(55, projection);
    view.relief.height_scale = 0.2;
    view.depth_write = depth_write;
    return view;
}

double depth_of(const View& view, glm::dvec3 point) {
    const glm::dvec4 clip = clip_from_world(view) * glm::dvec4(point, 1);
    return clip.z / clip.w;
}

/// Through floats.
constexpr double depth_tolerance = 2e-5;

TEST_F(DepthWriting, IsThatOfTheReliefOrOfThePolygon) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const SceneOnDevice scene(device(), hills(), grey_albedo());
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        for (const DepthWrite depth_write : {DepthWrite::on, DepthWrite::off, DepthWrite::conservative}) {
            const View view = view_with(depth_write, projection);
            Renderer renderer = make_renderer(device(), folder.load(), scene, view);
            const Probe probe = renderer.probe();
            const TimedPicture timed = renderer.draw_timed(ColourTarget::linear_float);
            int hits = 0;
            for (int j = 0; j < view.resolution.height; ++j) {
                for (int i = 0; i < view.resolution.width; ++i) {
                    const Hit& hit = probe.hits.at(i, j);
                    if (!hit.is_hit()) {
                        // Discarded pixels leave no depth, the polygon's neither.
                        ASSERT_EQ(timed.depth.at(i, j), 1.0F);
                        continue;
                    }
                    ++hits;
                    const Ray ray = pixel_ray(view, i, j);
                    const double to_polygon = -ray.origin.z / ray.direction.z;
                    const double t = depth_write == DepthWrite::off ? to_polygon : static_cast<double>(hit.t);
                    ASSERT_NEAR(timed.depth.at(i, j), depth_of(view, ray.origin + t * ray.direction), depth_tolerance);
                }
            }
            EXPECT_GT(hits, 400);
        }
    }
}

// What is declared must hold, whatever a technique answers: nearer than the polygon, it is taken to lie on it.
TEST_F(DepthWriting, ConservativeIsNeverNearerThanThePolygon) {
    const TemporaryTechnique folder(Files{
        {"trace.glsl", "Trace trace(ReliefRay ray) { return hit_off_ray(ray.uv - 3.0 * ray.max_offset, 1.0, 0); }"}});
    const SceneOnDevice scene(device(), hills(), grey_albedo());
    View view = view_with(DepthWrite::conservative, Projection::perspective);
    view.relief.boundary = Boundary::repeat;
    const TimedPicture timed =
        make_renderer(device(), folder.load(), scene, view).draw_timed(ColourTarget::linear_float);
    view.depth_write = DepthWrite::off;
    const TimedPicture polygon =
        make_renderer(device(), folder.load(), scene, view).draw_timed(ColourTarget::linear_float);
    EXPECT_EQ(timed.depth.texels, polygon.depth.texels);
}

std::vector<SceneObject> objects() {
    SceneObject sphere;
    sphere.centre = {0.05, -0.1, -0.05};
    sphere.radius = 0.3;
    SceneObject box;
    box.shape = SceneObject::Shape::box;
    box.centre = {-0.1, 0.1, -0.1};
    box.half_size = {0.3, 0.2, 0.06};
    return {sphere, box};
}

TEST_F(DepthWriting, ObjectsCutThroughTheReliefWhereTheTruthSays) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const Albedo albedo = grey_albedo();
    const SceneOnDevice scene(device(), hills(), albedo);
    const Lighting lighting;
    for (const SceneObject& object : objects()) {
        for (const Projection projection : {Projection::perspective, Projection::parallel}) {
            for (const DepthWrite depth_write : {DepthWrite::on, DepthWrite::conservative, DepthWrite::off}) {
                const View view = view_with(depth_write, projection);
                const Technique technique = folder.load();
                Renderer renderer(device(), technique, technique.manifest.defaults(), scene, view, lighting, object);
                renderer.prepare();
                const Probe probe = renderer.probe();
                Truth truth = trace_exact_truth(hills(), albedo, view, lighting);
                show_object(truth, object, view, lighting);
                const double wrong = wrong_surface(*probe.front, *truth.front, truth.footprint);
                if (depth_write == DepthWrite::off) {
                    EXPECT_GT(wrong, 0.02);
                } else {
                    // Pixels on an outline.
                    EXPECT_LE(wrong, 0.003);
                }
                std::size_t shown = 0;
                for (std::size_t i = 0; i < truth.colour.texels.size(); ++i) {
                    if (probe.front->texels[i] != Front::object || truth.front->texels[i] != Front::object) continue;
                    ++shown;
                    for (std::size_t channel = 0; channel < 3; ++channel)
                        ASSERT_NEAR(probe.colour.texels[i][channel], truth.colour.texels[i][channel], 1.0 / 255);
                }
                // The box lies beneath the polygon, whose own depth hides it.
                if (depth_write != DepthWrite::off) {
                    EXPECT_GT(shown, 50U);
                }
            }
        }
    }
}

// Hits are the relief's alone, and nothing of the object is left in a scene without one.
TEST_F(DepthWriting, ObjectsChangeNoHits) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const SceneOnDevice scene(device(), hills(), grey_albedo());
    const View view = view_with(DepthWrite::on, Projection::perspective);
    const Technique technique = folder.load();
    Renderer with(device(), technique, technique.manifest.defaults(), scene, view, Lighting{}, objects().front());
    with.prepare();
    const Probe cut = with.probe();
    const Probe whole = make_renderer(device(), technique, scene, view).probe();
    EXPECT_EQ(cut.hits.texels, whole.hits.texels);
    EXPECT_NE(cut.colour.texels, whole.colour.texels);
    EXPECT_FALSE(whole.front);
}

}  // namespace
}  // namespace reliefbench
