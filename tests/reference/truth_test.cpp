#include "reference/truth.hpp"

#include "reference/mesh_tracer.hpp"
#include "reference/shading.hpp"
#include "scene/shading_normal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace reliefbench {
namespace {

HeightMap constant_map(float height) {
    return make_height_map(Image<float>({8, 8}, height), HeightFormat::r32f, "constant");
}

HeightMap hilly_map() {
    Image<float> heights({32, 24});
    for (int j = 0; j < 24; ++j) {
        for (int i = 0; i < 32; ++i)
            heights.at(i, j) = static_cast<float>(0.5 + 0.3 * std::sin(0.6 * i) * std::cos(0.8 * j) + 0.006 * i);
    }
    return make_height_map(heights, HeightFormat::r16, "hills");
}

Truth trace_truth(const HeightMap& map, const View& view, int subdivision = 0, const Lighting& lighting = {}) {
    const Albedo albedo = load_albedo({}, map);
    return subdivision == 0 ? trace_exact_truth(map, albedo, view, lighting)
                            : trace_mesh_truth(map, albedo, view, lighting, subdivision);
}

int count(const Image<std::uint8_t>& mask) {
    return std::accumulate(mask.texels.begin(), mask.texels.end(), 0);
}

TEST(Truth, FootprintOfParallelRaysIsThePicture) {
    const View view{{Projection::parallel, 70, 20}, {}, {40, 30}};
    EXPECT_EQ(count(trace_truth(constant_map(0.5f), view).footprint), 40 * 30);
}

TEST(Truth, FootprintHeadOnIsTheProjectedSquare) {
    // The square reaches to 0.5 / (1.5 tan 22.5°) = 0.8047 of half the picture: 80 of 100 pixel centres, squared.
    const View view{{Projection::perspective, 0, -90, 1.5, 45}, {}, {100, 100}};
    const Truth truth = trace_truth(constant_map(0.5f), view);
    EXPECT_EQ(count(truth.footprint), 80 * 80);
    EXPECT_EQ(truth.footprint.at(10, 10), 1);
    EXPECT_EQ(truth.footprint.at(9, 10), 0);
    EXPECT_EQ(truth.footprint.at(89, 89), 1);
    EXPECT_EQ(truth.footprint.at(89, 90), 0);
}

/// Clipped, the sheet h = 0 is the unit square at z = −H, seen outside the footprint as well; repeating, it fills the
/// footprint and nothing else.
TEST(Truth, OfASunkenPlane) {
    const HeightMap map = constant_map(0);
    const Resolution resolution{64, 48};
    const Camera camera{Projection::perspective, 65, -70, 1.5, 45};
    for (const int subdivision : {0, 2}) {
        for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
            const Truth truth = trace_truth(map, {camera, {0.1, 1, boundary}, resolution}, subdivision);
            int outside_footprint = 0;
            int misses_inside = 0;
            for (int j = 0; j < resolution.height; ++j) {
                for (int i = 0; i < resolution.width; ++i) {
                    const Ray ray = PixelRays(camera, resolution).at(i, j);
                    const bool in_footprint = footprint_entry(ray).has_value();
                    ASSERT_EQ(truth.footprint.at(i, j), in_footprint ? 1 : 0);
                    const double t = (-0.1 - ray.origin.z) / ray.direction.z;
                    const double u = ray.origin.x + t * ray.direction.x + 0.5;
                    const double v = ray.origin.y + t * ray.direction.y + 0.5;
                    const bool on_square = t > 0 && u >= 0 && u <= 1 && v >= 0 && v <= 1;
                    const Hit& hit = truth.hits.at(i, j);
                    ASSERT_EQ(hit.is_hit(), boundary == Boundary::clip ? on_square : in_footprint) << i << " " << j;
                    if (!hit.is_hit()) {
                        EXPECT_EQ(hit, Hit{});
                        misses_inside += in_footprint;
                        continue;
                    }
                    outside_footprint += !in_footprint;
                    // Single precision: t about 1.5, u and v magnified by 1/cosθ.
                    EXPECT_NEAR(hit.t, t, 1e-6);
                    EXPECT_NEAR(hit.u, u, 1e-6);
                    EXPECT_NEAR(hit.v, v, 1e-6);
                    EXPECT_NEAR(hit.h, 0, 1e-5);
                }
            }
            EXPECT_EQ(outside_footprint > 0, boundary == Boundary::clip);
            EXPECT_EQ(misses_inside > 0, boundary == Boundary::clip);
        }
    }
}

/// Both boundaries show the same relief where a hit lies on the patch, except where clipping lets a ray in at the side.
TEST(Truth, ClippedAndRepeatedReliefAgreeInside) {
    const HeightMap map = hilly_map();
    View view{{Projection::perspective, 60, -40, 1.5, 45}, {0.08, 2, Boundary::clip}, {80, 60}};
    const Truth clipped = trace_truth(map, view);
    view.relief.boundary = Boundary::repeat;
    const Truth repeated = trace_truth(map, view);
    int compared = 0;
    int beyond = 0;
    for (std::size_t index = 0; index < clipped.hits.texels.size(); ++index) {
        const Hit& hit = repeated.hits.texels[index];
        ASSERT_EQ(hit.is_hit(), repeated.footprint.texels[index] == 1);
        if (!hit.is_hit()) continue;
        const bool on_patch = hit.u >= 0 && hit.u <= 1 && hit.v >= 0 && hit.v <= 1;
        EXPECT_EQ(clipped.hits.texels[index], on_patch ? hit : Hit{});
        ++(on_patch ? compared : beyond);
    }
    EXPECT_GT(compared, 500);
    EXPECT_GT(beyond, 10);
}

TEST(Truth, ColoursItsOwnHits) {
    const HeightMap map = hilly_map();
    const Albedo albedo = load_albedo({}, map);
    Lighting lighting;
    lighting.fog = Fog{1, 3, {0.2, 0.3, 0.9}};
    const View view{{Projection::perspective, 50, -90, 1.5, 45}, {0.08, 2, Boundary::clip}, {40, 30}};
    const Truth truth = trace_exact_truth(map, albedo, view, lighting);
    const auto derivatives = height_derivatives(map);
    int hits = 0;
    for (int j = 0; j < 30; ++j) {
        for (int i = 0; i < 40; ++i) {
            const Hit& hit = truth.hits.at(i, j);
            glm::dvec3 expected = lighting.background;
            if (hit.is_hit()) {
                ++hits;
                const auto colour = albedo.sample(2 * hit.u, 2 * hit.v);
                expected = shade(lighting, {colour[0], colour[1], colour[2]},
                                 shading_normal(derivatives, view.relief, hit.u, hit.v),
                                 -pixel_ray(view, i, j).direction, hit.t);
            }
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(truth.colour.at(i, j)[channel], expected[channel], 1e-7);
        }
    }
    EXPECT_GT(hits, 300);
    EXPECT_LT(hits, 40 * 30);
    EXPECT_GT(truth.trace_ms, 0);
}

TEST(MeshTracer, TrianglesAndGridsAreTheSameSurface) {
    const HeightMap map = hilly_map();
    for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
        const View view{{Projection::perspective, 70, -60, 1.5, 45}, {0.1, 1.5, boundary}, {60, 60}};
        const MeshTracer grid(map, view, 2, MeshTracer::Geometry::grid);
        const MeshTracer triangles(map, view, 2, MeshTracer::Geometry::triangles);
        std::vector<double> differences;
        int coverage_differs = 0;
        for (int j = 0; j < 60; ++j) {
            for (int i = 0; i < 60; ++i) {
                const Ray ray = pixel_ray(view, i, j);
                if (boundary == Boundary::repeat && !footprint_entry(ray)) continue;
                const auto a = grid.trace(ray);
                const auto b = triangles.trace(ray);
                coverage_differs += a.has_value() != b.has_value();
                if (a && b) differences.push_back(std::abs(a->t - b->t));
            }
        }
        ASSERT_GT(differences.size(), 800u);
        // Embree cuts a grid's cells along the same diagonal; its two intersectors round differently.
        EXPECT_LT(*std::max_element(differences.begin(), differences.end()), 1e-6);
        EXPECT_EQ(coverage_differs, 0);
    }
}

TEST(MeshTracer, AnImpossibleMeshIsAnError) {
    const HeightMap map = hilly_map();
    EXPECT_THROW(MeshTracer(map, {{}, {0.05, 500, Boundary::clip}, {}}, 8), std::runtime_error);
    // Repeating relief at a grazing angle reaches far beyond the patch.
    EXPECT_THROW(MeshTracer(map, {{Projection::parallel, 89.9999, 0}, {0.1, 1, Boundary::repeat}, {}}, 8),
                 std::runtime_error);
}

}  // namespace
}  // namespace reliefbench
