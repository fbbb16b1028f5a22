#include "verify_test.hpp"

#include "metrics/error_maps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reliefbench::test {

namespace {

/// Constant maps have closed forms; 0.4 is 26214/65535 exactly.
constexpr double level = 0.4;

class ConstantMap : public VerifyTest {
protected:
    ConstantMap() : scene_(device(), map_of({32, 32}, [](int, int) { return level; })) {}

    /// Checks that each hit of the technique lies on u0 + offset(direction), at the height given.
    void expect_offset(const std::string& technique, const ParameterValues& changed, double height, double tolerance,
                       const std::function<glm::dvec2(glm::dvec3 direction)>& offset) {
        for (View view : {parallel_view(60, -70), perspective_view(50, 25)}) {
            view.relief.tiling = 2;
            const Comparison found = compare(technique, changed, scene_, view);
            std::size_t hits = 0;
            for (int j = 0; j < view.resolution.height; ++j) {
                for (int i = 0; i < view.resolution.width; ++i) {
                    const Hit& hit = found.probe.hits.at(i, j);
                    if (!hit.is_hit()) continue;
                    ++hits;
                    const Ray ray = pixel_ray(view.camera, view.resolution, i, j);
                    const glm::dvec2 entry = *footprint_entry(ray);
                    const glm::dvec2 expected = entry + offset(ray.direction);
                    ASSERT_NEAR(hit.u, expected.x, tolerance) << technique << " at " << i << ", " << j;
                    ASSERT_NEAR(hit.v, expected.y, tolerance) << technique << " at " << i << ", " << j;
                    ASSERT_NEAR(hit.h, height, tolerance) << technique << " at " << i << ", " << j;
                }
            }
            EXPECT_GT(hits, 1000U) << technique;
        }
    }

    /// The offset of the ray's own point at depth `s`.
    static std::function<glm::dvec2(glm::dvec3)> on_ray(double s) {
        return [s](glm::dvec3 direction) {
            return s * parallel_view(0).relief.height_scale * glm::dvec2(direction) / -direction.z;
        };
    }

    CoordinateScene scene_;
};

/// Hits and offsets are single floats; the map's height is exact.
constexpr double float_tolerance = 2e-6;

ParameterValues fixed_steps(std::int64_t steps) {
    return {{"adaptive", false}, {"max_steps", steps}};
}

}  // namespace

TEST_F(ConstantMap, FlatHasNoOffset) {
    expect_offset("flat", {}, 1, float_tolerance, on_ray(0));
}

TEST_F(ConstantMap, OffsetLimitedParallaxIsTheViewTimesTheDepth) {
    expect_offset("parallax", {{"offset_limiting", true}}, level, float_tolerance, [](glm::dvec3 direction) {
        return (1 - level) * parallel_view(0).relief.height_scale * glm::dvec2(direction);
    });
}

TEST_F(ConstantMap, ParallaxScalesAndThenBiasesTheHeight) {
    // height·0.04 − 0.02 at a height scale of 0.1, as the README says: scale 0.4, bias 0.2.
    expect_offset("parallax", {{"offset_limiting", true}, {"scale", 0.4}, {"bias", 0.2}}, level, float_tolerance,
                  [](glm::dvec3 direction) { return -(0.04 * level - 0.02) * glm::dvec2(direction); });
}

TEST_F(ConstantMap, UnlimitedParallaxIsExact) {
    expect_offset("parallax", {{"offset_limiting", false}}, level, float_tolerance, on_ray(1 - level));
}

TEST_F(ConstantMap, SteepIsTheNextLayerBeneath) {
    expect_offset("steep", fixed_steps(16), 1 - 10.0 / 16, float_tolerance, on_ray(10.0 / 16));
}

TEST_F(ConstantMap, ReliefHalvesTheLayer) {
    // 9.6 layers down: 9.625 is the first eighth of a layer beneath.
    ParameterValues parameters = fixed_steps(16);
    parameters["binary_steps"] = std::int64_t{3};
    expect_offset("relief", parameters, 1 - 9.625 / 16, float_tolerance, on_ray(9.625 / 16));
}

TEST_F(ConstantMap, PomIsExact) {
    expect_offset("pom", fixed_steps(7), level, float_tolerance, on_ray(1 - level));
}

TEST_F(ConstantMap, QdmIsExact) {
    expect_offset("qdm", {{"leaf", "exact"}}, level, float_tolerance, on_ray(1 - level));
    expect_offset("qdm", {{"leaf", "linear"}}, level, float_tolerance, on_ray(1 - level));
}

class Marching : public VerifyTest {};

/// Luna 2012, figure 7: finite steps miss peaks; the misses show in the error, and fall as steps rise.
TEST_F(Marching, MissedFeaturesFallAsStepsRise) {
    const CoordinateScene spikes(device(), procedural("spikes", {128, 128}));
    View view = parallel_view(60, -70);
    view.relief.boundary = Boundary::repeat;
    const double stride = texels_through_relief(view, spikes.map, 0, 0);
    for (const std::string technique : {"steep", "relief", "pom"}) {
        std::vector<double> missed;
        for (const std::int64_t steps : {8, 16, 32, 64, 128}) {
            const Comparison found = compare(technique, fixed_steps(steps), spikes, view);
            const Image<float> errors = uv_error_map(found.probe.hits, found.truth.hits, spikes.map, view.relief);
            // More than a step and a texel off: not imprecise, but another feature.
            const double another_feature = stride / static_cast<double>(steps) + 1;
            const auto count = std::ranges::count_if(errors.texels, [&](float e) { return e > another_feature; });
            missed.push_back(static_cast<double>(count) / static_cast<double>(errors.texels.size()));
        }
        EXPECT_GT(missed.front(), 0.02) << technique;
        EXPECT_LT(missed.back(), 0.25 * missed.front()) << technique;
        for (std::size_t i = 1; i < missed.size(); ++i)
            EXPECT_LT(missed[i], missed[i - 1]) << technique << " at " << (8 << i) << " steps";
    }
}

/// Counts by view angle: int(mix(max, min, V.z)) layers, as published.
TEST_F(Marching, AdaptiveCountsFollowTheViewAngle) {
    const CoordinateScene zero(device(), map_of({16, 16}, [](int, int) { return 0.0; }));
    for (const double angle : {0.0, 40.0, 60.0, 80.0}) {
        View view = parallel_view(angle);
        view.relief.boundary = Boundary::repeat;
        const Comparison found =
            compare("pom", {{"min_steps", std::int64_t{10}}, {"max_steps", std::int64_t{51}}}, zero, view);
        // On the lowest map each ray takes all of its steps.
        const double expected = std::floor(51 + (10 - 51) * std::cos(angle * std::numbers::pi / 180) + 1e-9);
        EXPECT_EQ(found.probe.work.at(40, 40).steps, expected) << angle;
        EXPECT_EQ(found.probe.work.at(40, 40).taps, expected + 1) << "the entry's tap counts too";
    }
}

}  // namespace reliefbench::test
