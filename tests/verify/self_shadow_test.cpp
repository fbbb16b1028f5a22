#include "broken_shaders.hpp"
#include "verify_test.hpp"

#include "metrics/shadow_errors.hpp"

namespace reliefbench::test {

namespace {

/// Of a technique on a procedural map under one low light, and what it costs.
struct Shadowed {
    ShadowErrors errors;
    double taps_mean = 0;
};

class ShippedShadows : public VerifyTest {
protected:
    static Shadowed draw(const Technique& technique, const std::string& map_name, const SelfShadow& self_shadow,
                         const ParameterValues& changed = {}, double polygon_height = 1) {
        const HeightMap map = procedural(map_name, {64, 64});
        const Albedo albedo = load_albedo(HeightMapSource{}, map);
        const SceneOnDevice scene(device(), map, albedo);
        View view = parallel_view(50);
        view.resolution = {64, 64};
        view.relief.boundary = Boundary::repeat;
        view.self_shadow = self_shadow;
        set_polygon_height(view, polygon_height);
        Lighting lighting;
        lighting.lights = {{{-1, 0.4, 0.4}}};
        Renderer renderer(device(), technique, with_values(technique.manifest, changed), scene, view, lighting);
        renderer.prepare();
        const Probe probe = renderer.probe();
        const Truth truth = trace_exact_truth(map, albedo, view, lighting);
        Shadowed result;
        result.errors = compare_shadows(probe.light_visibility, truth.light_visibility.fractions,
                                        {probe.hits, truth.hits, truth.footprint, map, view.relief}, lighting);
        for (const std::uint32_t taps : probe.shadow_taps.texels)
            result.taps_mean += taps / static_cast<double>(probe.shadow_taps.texels.size());
        return result;
    }

    static SelfShadow hard() {
        SelfShadow self_shadow;
        self_shadow.mode = SelfShadow::Mode::hard;
        return self_shadow;
    }

    /// Exact searches need a bias for rounding only.
    static SelfShadow hard_and_exact() {
        SelfShadow self_shadow = hard();
        self_shadow.hard_bias = 1e-4;
        return self_shadow;
    }
};

const char* const maps[] = {"bricks", "cobbles", "rock"};

}  // namespace

TEST_F(ShippedShadows, OfExactSearchesAreThoseOfTheTruth) {
    for (const char* map : maps) {
        const Shadowed exact = draw(shipped("max_mip"), map, hard_and_exact());
        EXPECT_GT(exact.errors.compared, 1000U) << map;
        EXPECT_LE(exact.errors.false_shadow, 0.001) << map;
        EXPECT_LE(exact.errors.missed_shadow, 0.002) << map;
    }
}

/// Light reaches what lies above a polygon as it reaches what lies beneath it.
TEST_F(ShippedShadows, OfExactSearchesAreThoseOfTheTruthAbovePolygonsToo) {
    for (const double polygon_height : {0.5, 0.0}) {
        const Shadowed exact = draw(shipped("max_mip"), "rock", hard_and_exact(), {}, polygon_height);
        EXPECT_GT(exact.errors.compared, 1000U) << polygon_height;
        EXPECT_LE(exact.errors.false_shadow, 0.001) << polygon_height;
        EXPECT_LE(exact.errors.missed_shadow, 0.002) << polygon_height;
    }
}

TEST_F(ShippedShadows, OfMarchesImproveWithTheirSteps) {
    for (const char* map : maps) {
        const auto error = [&](std::int64_t steps) {
            const ParameterValues layers{{"max_steps", steps}, {"adaptive", false}};
            return draw(shipped("pom"), map, hard(), layers).errors.mean;
        };
        const double coarse = error(8);
        const double fine = error(256);
        EXPECT_LT(fine, 0.7 * coarse) << map;
        EXPECT_LT(fine, 0.05) << map;
    }
}

TEST_F(ShippedShadows, CostASecondSearch) {
    SelfShadow off;
    EXPECT_EQ(draw(shipped("steep"), "bricks", off).taps_mean, 0);
    EXPECT_GT(draw(shipped("steep"), "bricks", hard()).taps_mean, 3);
    // One tap has no search: the harness's own march takes its place.
    EXPECT_GT(draw(shipped("parallax"), "bricks", hard()).taps_mean, 3);
}

TEST_F(ShippedShadows, ALightFromTheWrongSideIsFound) {
    const BrokenShaders broken("self_shadow.glsl", "-height * to_light.xy / to_light.z",
                               "height * to_light.xy / to_light.z");
    EXPECT_GT(draw(broken.compile("max_mip"), "cobbles", hard_and_exact()).errors.mean, 0.05);
}

TEST_F(ShippedShadows, ABiasOfTheWrongSignIsFound) {
    const BrokenShaders broken("self_shadow.glsl", "s_point - self_shadow_bias;\n    if (s_end",
                               "s_point + self_shadow_bias;\n    if (s_end");
    EXPECT_GT(draw(broken.compile("max_mip"), "rock", hard_and_exact()).errors.false_shadow, 0.1);
}

TEST_F(ShippedShadows, ABiasOfHalfTheReliefIsFound) {
    const BrokenShaders broken("self_shadow.glsl", "s_point - self_shadow_bias;\n    if (s_end",
                               "s_point - 0.5;\n    if (s_end");
    EXPECT_GT(draw(broken.compile("max_mip"), "rock", hard_and_exact()).errors.missed_shadow, 0.05);
}

}  // namespace reliefbench::test
