#include "verify_test.hpp"

#include <fmt/format.h>

namespace reliefbench::test {
namespace {

/// Maps of plateaus at h = 1 seen at as many pixels as texels, or twice as many: rays enter exactly over their edges.
class Ties : public VerifyTest {
protected:
    struct Subject {
        std::string technique;
        ParameterValues parameters;
    };

    static std::vector<Subject> exact_techniques() {
        return {{"max_mip", {}}, {"qdm", {{"leaf", "exact"}, {"max_steps", std::int64_t{4096}}}}};
    }

    void expect_no_false_hits(const CoordinateScene& scene, const View& view, const std::string& what) {
        for (const Subject& subject : exact_techniques()) {
            const TruthComparison found = compare(subject.technique, subject.parameters, scene, view);
            const std::string where =
                fmt::format("{} on {}, {} pixels to {} texels, at {}°, azimuth {}, {}", subject.technique, what,
                            view.resolution.width, scene.map.width(), view.camera.view_angle, view.camera.azimuth,
                            to_string(view.relief.boundary));
            EXPECT_LE(found.errors.ties, 0.5) << where;
            EXPECT_LE(found.errors.missed + found.errors.false_hits, 0.001) << where;
            if (!found.errors.uv_texels) continue;
            EXPECT_LT(found.errors.uv_texels->p99, 0.01) << where;
        }
    }

    void sweep(const CoordinateScene& scene, const std::string& what, Resolution resolution) {
        int turn = 0;
        for (int azimuth = -180; azimuth < 180; azimuth += 15) {
            for (const double angle : {0.0, 30.0, 60.0, 75.0, 89.0}) {
                // Both boundaries at every angle and azimuth, one by one: neighbours take turns.
                View view = parallel_view(angle, azimuth);
                view.relief.boundary = turn++ % 2 == 0 ? Boundary::clip : Boundary::repeat;
                view.resolution = resolution;
                expect_no_false_hits(scene, view, what);
            }
        }
    }
};

/// Of a side that is no power of two, too: texture coordinates of texel edges are then no floats, and rounding puts
/// rays on either side of them.
TEST_F(Ties, PlateausOnTheTexelGrid) {
    for (const int side : {32, 40}) {
        const CoordinateScene scene(
            device(), map_of({side, side}, [](int x, int y) { return x % 8 < 6 && y % 8 < 6 ? 1.0 : 0.2; }));
        sweep(scene, "tiles", {side, side});
        sweep(scene, "tiles", {2 * side, 2 * side});
    }
}

TEST_F(Ties, CheckerboardsOnTheTexelGrid) {
    for (const int side : {8, 10}) {
        const CoordinateScene scene(device(), map_of({side, side}, [](int x, int y) { return (x + y) % 2; }));
        sweep(scene, "checkerboard", {side, side});
        sweep(scene, "checkerboard", {3 * side, 3 * side});
    }
}

}  // namespace
}  // namespace reliefbench::test
