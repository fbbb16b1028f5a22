#include "verify_test.hpp"

#include <cmath>
#include <optional>

namespace reliefbench::test {

namespace {

/// Constant maps have closed forms; 0.4 is 26214/65535 exactly.
constexpr double level = 0.4;

class ConstantMap : public VerifyTest {
protected:
    ConstantMap() : scene_(device(), map_of({32, 32}, [](int, int) { return level; })) {}

    /// Checks that each hit of the technique lies on u0 + offset(direction), at the height given where one is.
    void expect_offset(const std::string& technique, const ParameterValues& changed, std::optional<double> height,
                       double tolerance, const std::function<glm::dvec2(glm::dvec3 direction)>& offset) {
        for (View view : {parallel_view(60, -70), perspective_view(50, 25)}) {
            view.relief.tiling = 2;
            const TruthComparison found = compare(technique, changed, scene_, view);
            std::size_t hits = 0;
            for (int j = 0; j < view.resolution.height; ++j) {
                for (int i = 0; i < view.resolution.width; ++i) {
                    const Hit& hit = found.probe.hits.at(i, j);
                    if (!hit.is_hit()) continue;
                    ++hits;
                    const Ray ray = pixel_ray(view, i, j);
                    const glm::dvec2 entry = *footprint_entry(ray);
                    const glm::dvec2 expected = entry + offset(ray.direction);
                    ASSERT_NEAR(hit.u, expected.x, tolerance) << technique << " at " << i << ", " << j;
                    ASSERT_NEAR(hit.v, expected.y, tolerance) << technique << " at " << i << ", " << j;
                    ASSERT_NEAR(hit.h, height.value_or(hit.h), tolerance) << technique << " at " << i << ", " << j;
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

TEST_F(ConstantMap, ReliefHalvesTheLayerAndAnswersItsMiddle) {
    // 9.6 layers down: three halvings leave 9.5 to 9.625.
    for (const auto& [answer, layers] :
         {std::pair{"", 9.5625}, {"middle", 9.5625}, {"above", 9.5}, {"beneath", 9.625}}) {
        ParameterValues parameters = fixed_steps(16);
        parameters["binary_steps"] = std::int64_t{3};
        if (*answer != '\0') parameters["binary_answer"] = std::string(answer);
        expect_offset("relief", parameters, 1 - layers / 16, float_tolerance, on_ray(layers / 16));
    }
}

TEST_F(ConstantMap, PomIsExact) {
    expect_offset("pom", fixed_steps(7), level, float_tolerance, on_ray(1 - level));
}

TEST_F(ConstantMap, SecantIsExactFromItsFirstChordOn) {
    for (const std::int64_t chords : {1, 3}) {
        ParameterValues parameters = fixed_steps(7);
        parameters["secant_steps"] = chords;
        expect_offset("secant", parameters, level, float_tolerance, on_ray(1 - level));
    }
}

TEST_F(ConstantMap, ContactRefinementIsTheNextFinerLayerBeneath) {
    // 9.6 layers down: of the sixteen parts of the tenth layer ten reach beneath it.
    expect_offset("contact_refinement", fixed_steps(16), 1 - 154.0 / 256, float_tolerance, on_ray(154.0 / 256));
}

TEST_F(ConstantMap, IterativeParallaxApproachesByAPowerOfVz) {
    const auto offset = [](glm::dvec3 direction) {
        return on_ray((1 - level) * (1 - std::pow(1 + direction.z, 4)))(direction);
    };
    expect_offset("iterative_parallax", {}, std::nullopt, float_tolerance, offset);
}

TEST_F(ConstantMap, QdmIsExact) {
    expect_offset("qdm", {{"leaf", "exact"}}, level, float_tolerance, on_ray(1 - level));
    expect_offset("qdm", {{"leaf", "linear"}}, level, float_tolerance, on_ray(1 - level));
}

}  // namespace reliefbench::test
