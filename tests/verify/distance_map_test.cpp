#include "verify_test.hpp"

#include "core/random.hpp"
#include "scene/procedural.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reliefbench::test {

namespace {

constexpr double metric_height = 0.1;

class DistanceMap : public VerifyTest {
protected:
    /// Slice `slice` of the map: pixel (i, j) of a head-on picture of the map's size reports the voxel's value as its
    /// height.
    static HitImage stored_slice(const CoordinateScene& scene, std::int64_t slices, std::int64_t slice) {
        const BrokenCopy reader("distance_map", "trace.glsl", "    float s = 0.0;",
                                "    ivec3 voxel = ivec3(floor(ray.uv * vec2(height_map_size())), max_steps - 1);\n"
                                "    return hit_off_ray(ray.uv, tap_map_texel(surface_distances, voxel, 0).r, 0);\n"
                                "    float s = 0.0;");
        View view = parallel_view(0);
        view.resolution = scene.map.heights.size;
        const Technique& technique = reader.technique();
        const ParameterValues values = with_values(technique.manifest, {{"slices", slices}, {"max_steps", slice + 1}});
        return compare_with_truth(device(), technique, values, scene, view).probe.hits;
    }
};

/// The shortest way from the centre of a voxel to the boxes over all bilinear cells, less half the voxel's diagonal, as
/// a fraction of the metric's height: all cells looked at, in double.
double distance_by_brute_force(const HeightMap& map, int x, int y, double h, std::int64_t slices) {
    const double width = 1.0 / map.width();
    const double height = 1.0 / map.height();
    double nearest = metric_height * h;
    for (int j = 0; j < map.height(); ++j) {
        for (int i = 0; i < map.width(); ++i) {
            const double top =
                std::max({map.texel(i, j), map.texel(i + 1, j), map.texel(i, j + 1), map.texel(i + 1, j + 1)});
            // Cells to the right are 0, 1, ... texels on, those to the left 0, 1, ..., and the map repeats.
            const auto apart = [](int cell, int texel, int size) {
                const int right = ((cell - texel) % size + size) % size;
                return std::min(right, size - 1 - right);
            };
            nearest = std::min(nearest, std::hypot(apart(i, x, map.width()) * width, apart(j, y, map.height()) * height,
                                                   metric_height * std::max(h - top, 0.0)));
        }
    }
    const double diagonal = std::hypot(width, height, metric_height / static_cast<double>(slices));
    return std::max(nearest - diagonal / 2, 0.0) / metric_height;
}

}  // namespace

/// Rounded down twice to 16 bits, and computed in floats: never longer, and shorter by no more than two steps of it.
TEST_F(DistanceMap, IsTheOneMadeOnTheProcessor) {
    Random random(11);
    for (const auto& [name, size] : {std::pair{"spikes", Resolution{48, 20}}, {"rock", Resolution{256, 256}}}) {
        const CoordinateScene scene(device(), procedural(name, size));
        constexpr std::int64_t slices = 6;
        for (const std::int64_t slice : {0, 3, 5}) {
            const HitImage stored = stored_slice(scene, slices, slice);
            int above = 0;
            for (int sample = 0; sample < 150; ++sample) {
                const int x = static_cast<int>(random.uniform() * size.width);
                const int y = static_cast<int>(random.uniform() * size.height);
                const double h = (static_cast<double>(slice) + 0.5) / slices;
                const double expected = distance_by_brute_force(scene.map, x, y, h, slices);
                const double found = stored.at(x, size.height - 1 - y).h;
                constexpr double float_rounding = 1e-6;
                ASSERT_LE(found, expected + float_rounding) << name << ' ' << x << ' ' << y << ' ' << slice;
                ASSERT_GE(found, expected - 2.0 / 65535 - float_rounding)
                    << name << ' ' << x << ' ' << y << ' ' << slice;
                above += found > 0 ? 1 : 0;
            }
            EXPECT_GT(above, slice == 0 ? -1 : 20) << name << ' ' << slice;
        }
    }
}

/// Any number of steps, any height of the metric, any height scale: at most one pixel in a thousand is reported beyond
/// the first hit by more than half a texel.
TEST_F(DistanceMap, IsConservativeAtAnyStepCount) {
    constexpr double tolerated = 0.001;
    for (const auto& [name, size] : {std::pair{"spikes", Resolution{128, 128}}, {"cobbles", Resolution{96, 160}}}) {
        const CoordinateScene scene(device(), procedural(name, size));
        View view = parallel_view(75, -67);
        view.relief.height_scale = 0.15;
        view.relief.boundary = Boundary::repeat;
        const double texels_per_length = std::sin(75 * std::acos(-1.0) / 180) * std::max(size.width, size.height);
        for (const std::int64_t slices : {16, 48}) {
            double depth_before = INFINITY;
            for (const std::int64_t steps : {1, 8, 64}) {
                const TruthComparison found =
                    compare("distance_map", {{"max_steps", steps}, {"slices", slices}}, scene, view);
                std::size_t beyond = 0;
                for (std::size_t pixel = 0; pixel < found.truth.hits.texels.size(); ++pixel) {
                    const Hit& hit = found.probe.hits.texels[pixel];
                    const double past = (hit.t - found.truth.hits.texels[pixel].t) * texels_per_length;
                    if (!hit.is_hit() || past > 0.5) ++beyond;
                }
                EXPECT_LE(static_cast<double>(beyond), tolerated * static_cast<double>(view.resolution.pixels()))
                    << name << ", " << slices << " slices, " << steps << " steps";
                // More steps come nearer.
                ASSERT_TRUE(found.errors.depth);
                EXPECT_LT(found.errors.depth->rms, depth_before) << name << ' ' << slices << ' ' << steps;
                depth_before = found.errors.depth->rms;
            }
        }
    }
}

/// On a plane the distance is straight down. What is left of it at the end is half the voxel's diagonal, up to the next
/// slice below: between slices, distances are interpolated.
TEST_F(DistanceMap, StopsShortOfAPlaneByHalfAVoxel) {
    constexpr double plane = 0.25;
    constexpr int slices = 16;
    const CoordinateScene scene(device(), map_of({64, 64}, [](int, int) { return plane; }));
    const TruthComparison found =
        compare("distance_map", {{"max_steps", std::int64_t{512}}}, scene, parallel_view(60, -70));
    const double half_diagonal = std::hypot(1.0 / 64, 1.0 / 64, metric_height / slices) / 2;
    const double stop = plane + half_diagonal / metric_height;
    const double slice_below = (std::floor(stop * slices - 0.5) + 0.5) / slices;
    for (const Hit& hit : found.probe.hits.texels) {
        if (!hit.is_hit()) continue;
        ASSERT_NEAR(hit.h, slice_below, 1e-3);
    }
    EXPECT_GT(found.errors.compared, 5000U);
}

}  // namespace reliefbench::test
