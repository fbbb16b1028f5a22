#include "cone_maps.hpp"
#include "verify_test.hpp"

#include "core/random.hpp"
#include "scene/procedural.hpp"
#include "verify/promise_checks.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reliefbench::test {

namespace {

/// A step of the maps' 16 bits, and half of one for the rounding of floats.
constexpr double stored_step = 1.5 / 65535;

double mean(const Ratios& ratios) {
    return std::accumulate(ratios.texels.begin(), ratios.texels.end(), 0.0) / static_cast<double>(ratios.texels.size());
}

double largest_difference(const Ratios& a, const Ratios& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.texels.size(); ++i)
        largest = std::max(largest, std::abs(a.texels[i] - b.texels[i]));
    return largest;
}

class ConeMaps : public VerifyTest {
protected:
    /// Of cone_step: ratios as they are, not their square roots.
    static ParameterValues linear(const std::string& preparation) {
        return {{"preparation", preparation}, {"cone_encoding", "linear"}};
    }

    /// One channel of the map that the technique makes on the device, told by a copy of it that shows each texel.
    static Ratios made_on_device(const std::string& technique, const ParameterValues& changed, const HeightMap& map,
                                 const std::string& channel = "g") {
        const BrokenCopy shown(technique, "trace.glsl", "Trace trace(ReliefRay ray) {",
                               "Trace trace(ReliefRay ray) {\n"
                               "    ivec2 texel = ivec2(ray.uv * vec2(textureSize(cones, 0)));\n"
                               "    if (max_steps > 0) return hit_off_ray(ray.uv, tap_map_texel(cones, texel, 0)." +
                                   channel + ", 0);\n");
        const CoordinateScene scene(device(), map);
        View view = parallel_view(0);
        view.resolution = map.heights.size;
        const Manifest& manifest = shown.technique().manifest;
        Renderer renderer(device(), shown.technique(), with_values(manifest, changed), scene.on_device, view,
                          coordinate_lighting());
        renderer.prepare();
        const Probe probe = renderer.probe();
        Ratios ratios(map.heights.size);
        for (int y = 0; y < map.height(); ++y) {
            for (int x = 0; x < map.width(); ++x)
                ratios.at(x, y) = static_cast<double>(probe.hits.at(x, map.height() - 1 - y).h);
        }
        return ratios;
    }
};

}  // namespace

/// At 256² a search over all texels has 65,536 iterations, one more than lavapipe lets an invocation have: the slices
/// must neither leave out any of them nor search any twice.
TEST_F(ConeMaps, OfTheDeviceAreThoseOfTheProcessor) {
    const HeightMap map = procedural("rock", {256, 256});
    const Ratios conservative = stored(conservative_ratios(map));
    const Ratios falling_edges = stored(falling_edge_ratios(map));
    EXPECT_LE(largest_difference(made_on_device("cone_step", linear("pruned"), map), conservative), stored_step);
    EXPECT_LE(
        largest_difference(made_on_device("relaxed_cone", {{"preparation", "falling_edges"}}, map), falling_edges),
        stored_step);
    EXPECT_LE(largest_difference(made_on_device("robust_cone", {{"preparation", "falling_edges"}}, map),
                                 narrowest_around(falling_edges)),
              stored_step);
}

/// The search over all texels of a map that is neither square nor small: 16,384 iterations for each of 16,384 texels.
TEST_F(ConeMaps, AllThreeSearchesForConservativeConesAgree) {
    for (const Resolution size : {Resolution{256, 64}, Resolution{50, 84}}) {
        const HeightMap map = procedural("bricks", size);
        const Ratios exact = stored(conservative_ratios(map));
        EXPECT_LE(largest_difference(made_on_device("cone_step", linear("exact"), map), exact), stored_step);
        EXPECT_LE(largest_difference(made_on_device("cone_step", linear("pruned"), map), exact), stored_step);
        const Ratios quick = made_on_device("cone_step", linear("quick"), map);
        for (std::size_t i = 0; i < quick.texels.size(); ++i)
            ASSERT_LE(quick.texels[i], exact.texels[i] + stored_step) << "texel " << i << " of " << size.width;
        EXPECT_GT(mean(quick), 0.8 * mean(exact)) << size.width;
    }
}

TEST_F(ConeMaps, QuickConesAreConservativeAndNearlyAsWide) {
    for (const std::string name : {"rock", "cobbles", "spikes"}) {
        const HeightMap map = procedural(name, {256, 256});
        const Ratios exact = stored(conservative_ratios(map));
        const Ratios quick = made_on_device("cone_step", linear("quick"), map);
        for (std::size_t i = 0; i < quick.texels.size(); ++i)
            ASSERT_LE(quick.texels[i], exact.texels[i] + stored_step) << name << ", texel " << i;
        EXPECT_GT(mean(quick), 0.8 * mean(exact)) << name;
        EXPECT_LT(mean(quick), 0.999 * mean(exact)) << "these are others than the exact ones";
    }
}

/// What is left out because it can narrow no cone changes none: the plain search of GPU Gems 3, for some texels.
TEST_F(ConeMaps, PublishedRelaxedConesAreThoseOfThePlainSearch) {
    constexpr int search_steps = 128;
    const HeightMap map = procedural("rock", {96, 64});
    std::vector<Resolution> texels;
    Random random(3);
    for (int i = 0; i < 40; ++i)
        texels.push_back({static_cast<int>(random.below(96)), static_cast<int>(random.below(64))});
    const std::vector<double> plain = published_relaxed_ratios(map, search_steps, texels);
    const Ratios shortened = published_relaxed_ratios(map, search_steps);
    for (std::size_t i = 0; i < texels.size(); ++i)
        EXPECT_EQ(shortened.at(texels[i].width, texels[i].height), plain[i]) << i;

    // In floats a ray may come out a step earlier or later; most do not.
    const Ratios made = made_on_device("relaxed_cone", {{"preparation", "published"}}, map);
    std::size_t different = 0;
    for (std::size_t i = 0; i < made.texels.size(); ++i)
        different += std::abs(made.texels[i] - stored(shortened).texels[i]) > 2 * stored_step ? 1 : 0;
    EXPECT_LT(static_cast<double>(different), 0.01 * static_cast<double>(made.texels.size()));
}

/// Each quarter's cone is that of the texels in it, the texels beside it included, across repeats of the map.
TEST_F(ConeMaps, QuadConesAreThoseOfTheirQuarters) {
    const HeightMap map = procedural("bricks", {40, 64});
    const double margin = 1.0 / 40;
    const std::array<std::string, 4> channels{"r", "g", "b", "a"};
    for (std::size_t quarter = 0; quarter < channels.size(); ++quarter) {
        Ratios expected(map.heights.size, 1.0);
        for (int y = 0; y < map.height(); ++y) {
            for (int x = 0; x < map.width(); ++x) {
                const double apex = map.texel(x, y);
                for (int dy = -64; dy <= 64; ++dy) {
                    for (int dx = -40; dx <= 40; ++dx) {
                        const double u = dx / 40.0;
                        const double v = dy / 64.0;
                        const double along = quarter < 2 ? u : v;
                        const double across = quarter < 2 ? v : u;
                        const double onward = quarter % 2 == 0 ? along : -along;
                        const double h = map.texel(x + dx, y + dy);
                        if (onward < 0 || std::abs(across) > onward + margin || h <= apex) continue;
                        expected.at(x, y) = std::min(expected.at(x, y), std::hypot(u, v) / (h - apex));
                    }
                }
            }
        }
        const Ratios made = made_on_device("quad_cone", {}, map, channels[quarter]);
        std::size_t different = 0;
        for (std::size_t i = 0; i < made.texels.size(); ++i)
            different += std::abs(made.texels[i] - stored(expected).texels[i]) > stored_step ? 1 : 0;
        // Whether a texel on the margin counts is decided by the last bit of a float.
        EXPECT_LT(static_cast<double>(different), 0.01 * static_cast<double>(made.texels.size())) << channels[quarter];
    }
}

/// Cones from pairs of texels hold at texels' centres only. The narrowest of 3×3 holds between them too, to less than a
/// tenth of a texel where the surface is steepest.
TEST(ConeProofs, InterpolatedConservativeConesNeedTheNarrowestOfNine) {
    for (const std::string name : {"bricks", "rock", "spikes"}) {
        const HeightMap map = procedural(name, {128, 128});
        const Ratios ratios = stored(conservative_ratios(map));
        EXPECT_GT(prove_conservative(map, ratios, 3000).failed_fraction(), 0.05) << name;
        const ConeProof robust = prove_conservative(map, narrowest_around(ratios), 3000);
        EXPECT_LT(robust.failed_fraction(), 0.02) << name;
        EXPECT_LT(robust.deepest_texels, 0.1) << name;
    }
}

TEST(ConeProofs, InterpolatedRelaxedConesArePiercedAtMostOnce) {
    for (const std::string name : {"bricks", "rock", "spikes"}) {
        const HeightMap map = procedural(name, {128, 128});
        EXPECT_GT(prove_relaxed(map, stored(published_relaxed_ratios(map, 128)), 800).failed_fraction(), 0.1) << name;
        const Ratios ratios = stored(falling_edge_ratios(map));
        EXPECT_LT(prove_relaxed(map, ratios, 800).failed_fraction(), 0.15) << name;
        EXPECT_EQ(prove_relaxed(map, narrowest_around(ratios), 800).failures, 0U) << name;
    }
}

/// The cones' test on the processor is itself tested on a surface whose cones are known.
TEST(ConeProofs, CountAKnownRidge) {
    // A ridge that rises from column 8 to its crest at column 16 and ends there in a cliff; flat along v.
    const HeightMap map = map_of({32, 32}, [](int x, int) { return x >= 8 && x <= 16 ? (x - 8) / 8.0 : 0.0; });
    const double texel = 1.0 / 32;
    constexpr double quantised = 1e-4;
    // From the floor before it, the slope is met first at the crest, nine texels on; and only the crest falls away.
    EXPECT_NEAR(conservative_ratios(map).at(7, 16), 9 * texel, quantised);
    EXPECT_NEAR(falling_edge_ratios(map).at(7, 16), 9 * texel, quantised);
    // From a quarter up, the crest is six texels on and three quarters higher.
    EXPECT_NEAR(falling_edge_ratios(map).at(10, 16), 6 * texel / 0.75, quantised);
    // From behind, the crest is one texel on, and falls away beyond.
    EXPECT_NEAR(conservative_ratios(map).at(17, 16), texel, quantised);
    EXPECT_NEAR(falling_edge_ratios(map).at(17, 16), texel, quantised);
}

class RobustCone : public VerifyTest {
protected:
    /// Fraction of the footprint in which the answer lies more than half a texel beyond the first hit.
    static double beyond(const Technique& technique, const ParameterValues& values, const CoordinateScene& scene,
                         const View& view, const PreparationSettings& preparation) {
        const TruthComparison found = compare_with_truth(device(), technique, values, scene, view, preparation);
        const double deviation = 1e-6;
        return static_cast<double>(pixels_beyond(found, scene.map, view, deviation)) /
               static_cast<double>(found.errors.footprint);
    }
};

/// Wherever the search is stopped, what it answers is no hit beyond the surface: with cones alone the ray stays above
/// it, and with the step to the cell's wall refinement comes back to it.
TEST_F(RobustCone, NeverGoesBeyondTheFirstHitAtAnyStepCount) {
    const Technique technique = shipped("robust_cone");
    const TemporaryFolder cache;
    const PreparationSettings preparation{.cache = cache.path()};
    for (const ProceduralMap& procedural_map : procedural_maps()) {
        const CoordinateScene scene(device(), procedural(procedural_map.name, {128, 128}));
        View view = parallel_view(75, -67);
        view.relief.boundary = Boundary::repeat;
        for (const std::int64_t steps : {1, 4, 16, 64, 1024}) {
            const ParameterValues alone = with_values(
                technique.manifest,
                {{"max_steps", steps}, {"preparation", "pruned"}, {"minimum_step", false}, {"refinement", "none"}});
            EXPECT_LE(beyond(technique, alone, scene, view, preparation), 0.001) << procedural_map.name << ' ' << steps;
            const ParameterValues refined =
                with_values(technique.manifest, {{"max_steps", steps}, {"preparation", "falling_edges"}});
            EXPECT_LE(beyond(technique, refined, scene, view, preparation), 0.001)
                << procedural_map.name << ' ' << steps;
        }
    }
}

/// Without halvings the step to the cell's wall is left, at most a cell long: its upper end lies before the surface,
/// its middle not always.
TEST_F(RobustCone, KeepsTheEndAboveTheSurfaceWhereAskedTo) {
    const Technique technique = shipped("robust_cone");
    const CoordinateScene scene(device(), procedural("rock", {128, 128}));
    View view = parallel_view(75, -67);
    view.relief.boundary = Boundary::repeat;
    const auto answering = [&](const std::string& answer) {
        return beyond(technique,
                      with_values(technique.manifest, {{"binary_steps", std::int64_t{0}}, {"binary_answer", answer}}),
                      scene, view, {});
    };
    EXPECT_LE(answering("above"), 0.001);
    EXPECT_GT(answering("middle"), 0.01);
    EXPECT_GT(answering("beneath"), answering("middle"));
}

/// Along the rows of texels the surface is straight within a cell; off them it bulges.
TEST_F(RobustCone, PassesBumpsWithinACellOffTheAxesWhereItDoesNotLookForThem) {
    const CoordinateScene scene(device(), procedural("spikes", {128, 128}));
    View view = parallel_view(75, -45);
    view.relief.boundary = Boundary::repeat;
    const auto fraction_beyond = [&](const TruthComparison& found) {
        return static_cast<double>(pixels_beyond(found, scene.map, view, 1e-6)) /
               static_cast<double>(found.errors.footprint);
    };
    const TruthComparison published = compare("robust_cone", {{"bump_check", false}}, scene, view);
    EXPECT_GT(fraction_beyond(published), 0.02);
    EXPECT_GT(published.errors.uv_texels->p99, 1);
    const TruthComparison checked = compare("robust_cone", {}, scene, view);
    EXPECT_LT(fraction_beyond(checked), 0.003);
    EXPECT_LT(checked.errors.uv_texels->p99, 0.01);
}

TEST_F(RobustCone, LooksForNoBumpsAlongTheAxes) {
    const CoordinateScene scene(device(), procedural("spikes", {128, 128}));
    const auto taps = [&](bool bump_check, double azimuth) {
        std::uint64_t sum = 0;
        const TruthComparison found =
            compare("robust_cone", {{"bump_check", bump_check}}, scene, parallel_view(75, azimuth));
        for (const PixelWork& work : found.probe.work.texels)
            sum += work.taps;
        return sum;
    };
    EXPECT_EQ(taps(true, -90), taps(false, -90));
    EXPECT_GT(taps(true, -67), taps(false, -67));
}

}  // namespace reliefbench::test
