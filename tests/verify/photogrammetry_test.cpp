// Promises on a real material: Gray Rocks, kept beside the repository and no part of it.

#include "verify_test.hpp"

#include "scene/height_map.hpp"
#include "verify/promise_checks.hpp"

#include <filesystem>

namespace reliefbench::test {

namespace {

constexpr int reduced_side = 128;
/// What tests measure with lavapipe's filter in r16 (docs/measurement.md).
constexpr double filter_deviation = 1e-6;

std::filesystem::path gray_rocks() {
    return std::filesystem::path(RELIEFBENCH_SOURCE_DIR) / "../shared/heightmaps/gray_rocks_height_1024.png";
}

/// The mean of each block of texels.
HeightMap reduced(const HeightMap& map) {
    const int block = map.width() / reduced_side;
    return map_of({reduced_side, reduced_side}, [&](int x, int y) {
        double sum = 0;
        for (int j = 0; j < block; ++j) {
            for (int i = 0; i < block; ++i)
                sum += static_cast<double>(map.heights.at(x * block + i, y * block + j));
        }
        return sum / (block * block);
    });
}

class Photogrammetry : public VerifyTest {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(gray_rocks())) GTEST_SKIP() << "there is no " << gray_rocks().string();
        VerifyTest::SetUp();
        HeightMapSource source;
        source.name = gray_rocks().string();
        map_ = load_height_map(source, HeightFormat::r16);
    }

    /// Fraction of the footprint in which the answer lies more than half a texel beyond the first hit.
    static double beyond(const std::string& technique, const ParameterValues& changed, const CoordinateScene& scene,
                         const View& view) {
        const TruthComparison found = compare(technique, changed, scene, view);
        return static_cast<double>(pixels_beyond(found, scene.map, view, filter_deviation)) /
               static_cast<double>(found.errors.footprint);
    }

    HeightMap map_;
};

TEST_F(Photogrammetry, ExactSearchesFindTheFirstHit) {
    const CoordinateScene scene(device(), map_);
    for (const double angle : {45.0, 75.0, 85.0}) {
        View view = perspective_view(angle, -67);
        view.relief.height_scale = 0.1;
        for (const auto& [technique, changed] :
             {std::pair<std::string, ParameterValues>{"max_mip", {}}, {"qdm", {{"leaf", "exact"}}}}) {
            const HitErrors errors = compare(technique, changed, scene, view).errors;
            ASSERT_TRUE(errors.uv_texels) << technique;
            EXPECT_LE(errors.uv_texels->p99, 0.01) << technique << ' ' << angle;
            // A ray that grazes an edge may be decided either way by rounding.
            EXPECT_LE(errors.missed + errors.false_hits, 0.001) << technique << ' ' << angle;
        }
    }
}

TEST_F(Photogrammetry, ConservativeSearchesNeverGoBeyondIt) {
    constexpr double tolerated = 0.001;
    const CoordinateScene scene(device(), reduced(map_));
    View view = parallel_view(75, -67);
    view.relief.boundary = Boundary::repeat;
    for (const std::int64_t steps : {1, 8, 64, 1024}) {
        EXPECT_LE(beyond("distance_map", {{"max_steps", steps}}, scene, view), tolerated) << steps;
        for (const char* preparation : {"pruned", "quick", "falling_edges"}) {
            EXPECT_LE(beyond("robust_cone", {{"max_steps", steps}, {"preparation", preparation}}, scene, view),
                      tolerated)
                << preparation << ' ' << steps;
        }
        EXPECT_LE(
            beyond("robust_cone", {{"max_steps", steps}, {"minimum_step", false}, {"refinement", "none"}}, scene, view),
            tolerated)
            << steps;
    }
}

}  // namespace

}  // namespace reliefbench::test
