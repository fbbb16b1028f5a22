#include "core/parallel.hpp"
#include "core/random.hpp"
#include "core/statistics.hpp"
#include "reference/exact_tracer.hpp"
#include "reference/mesh_tracer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

constexpr int ray_count = 20'000;

HeightMap procedural_map(const std::string& name, int side) {
    HeightMapSource source;
    source.name = name;
    source.size = {side, side};
    return load_height_map(source, HeightFormat::r16);
}

/// A checkerboard of hills and hollows: every cell is a saddle, which two triangles miss by 0.2·H in its middle.
///
/// Few and wide cells keep its flanks (0.2·2√2·8·H) flatter than the most grazing ray below. On steeper twisted maps
/// the mesh obeys the same law wherever ray and mesh meet on the same flank, but at silhouettes it is the *number* of
/// rays whose hit jumps to the next hill that falls with k, not the length of the jump: the 99th percentile then shows
/// nothing until fewer than one ray in a hundred jumps.
HeightMap twisted_map() {
    constexpr int side = 8;
    Image<float> heights({side, side});
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const double swell = 0.1 * std::sin(2 * std::numbers::pi * (i + 2 * j) / side);
            heights.at(i, j) = static_cast<float>(0.5 + swell + ((i + j) % 2 == 0 ? 0.2 : -0.2));
        }
    }
    return make_height_map(heights, HeightFormat::r16, "twisted");
}

/// Parallel rays through random points of the footprint, so that no regular pattern of pixels falls in step with the
/// mesh.
std::vector<Ray> random_rays(const Camera& camera) {
    Random random(3);
    std::vector<Ray> rays;
    for (int index = 0; index < ray_count; ++index) {
        const double x = random.uniform(-0.5, 0.5);
        const double y = random.uniform(-0.5, 0.5);
        rays.push_back({{x, y, 0}, camera_frame(camera).forward});
    }
    return rays;
}

struct Difference {
    double p50 = 0;
    double p99 = 0;
    int coverage = 0;
};

Difference difference(const ExactTracer& exact, const MeshTracer& mesh, const std::vector<Ray>& rays) {
    std::vector<std::optional<ExactHit>> from_exact(rays.size());
    std::vector<std::optional<ExactHit>> from_mesh(rays.size());
    parallel_for(rays.size(), 1000, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            from_exact[index] = exact.trace(rays[index]);
            from_mesh[index] = mesh.trace(rays[index]);
        }
    });
    Difference result;
    std::vector<double> distances;
    for (std::size_t index = 0; index < rays.size(); ++index) {
        result.coverage += from_exact[index].has_value() != from_mesh[index].has_value();
        if (from_exact[index] && from_mesh[index])
            distances.push_back(std::abs(from_exact[index]->t - from_mesh[index]->t));
    }
    result.p50 = median(distances);
    result.p99 = quantile(distances, 0.99);
    return result;
}

/// A bilinear cell's two triangles are off by its twist; k² smaller cells have a k²-th of it. The maps are rough enough
/// that Embree's single precision (some 1e-8 here) plays no part down to k = 8.
void expect_convergence(const HeightMap& map, double height_scale) {
    for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
        for (const double theta : {0.0, 45.0, 75.0}) {
            const View view{{Projection::parallel, theta, 27}, {height_scale, 1, boundary}, {}};
            const ExactTracer exact(map, view.relief);
            const std::vector<Ray> rays = random_rays(view.camera);
            std::optional<Difference> coarser;
            for (const int subdivision : {1, 2, 4, 8}) {
                SCOPED_TRACE(map.name + " " + to_string(boundary) + " " + std::to_string(theta) +
                             " k = " + std::to_string(subdivision));
                const Difference finer = difference(exact, MeshTracer(map, view, subdivision), rays);
                if (coarser) {
                    EXPECT_GT(coarser->p50 / finer.p50, 3.5);
                    EXPECT_LT(coarser->p50 / finer.p50, 4.5);
                    if (subdivision > 2) {
                        EXPECT_GT(coarser->p99 / finer.p99, 3.5);
                        EXPECT_LT(coarser->p99 / finer.p99, 4.5);
                    }
                }
                coarser = finer;
            }
            EXPECT_LE(coarser->coverage, ray_count / 1000);
        }
    }
}

TEST(MeshConvergesToExact, OnRock) {
    expect_convergence(procedural_map("rock", 128), 0.1);
}

TEST(MeshConvergesToExact, OnWaves) {
    expect_convergence(procedural_map("waves", 64), 0.1);
}

TEST(MeshConvergesToExact, OnTwistedCells) {
    expect_convergence(twisted_map(), 0.05);
}

/// The check must be able to fail: half a texel beside itself, the mesh converges to another surface.
TEST(MeshConvergesToExact, ButNotWhenShiftedByHalfATexel) {
    const HeightMap map = procedural_map("waves", 64);
    const View view{{Projection::parallel, 45, 27}, {0.1, 1, Boundary::repeat}, {}};
    const ExactTracer exact(map, view.relief);
    const std::vector<Ray> rays = random_rays(view.camera);
    const Difference right = difference(exact, MeshTracer(map, view, 4), rays);
    HeightMap shifted = map;
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 64; ++i)
            shifted.heights.at(i, j) = (map.texel(i, j) + map.texel(i + 1, j)) / 2;
    }
    const Difference wrong = difference(exact, MeshTracer(shifted, view, 4), rays);
    EXPECT_GT(wrong.p50, 100 * right.p50);
}

}  // namespace
}  // namespace reliefbench
