#include "reference/light_visibility.hpp"

#include "core/random.hpp"
#include "reference/scrambled_points.hpp"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace reliefbench {
namespace {

constexpr double height_scale = 0.1;

HeightMap map_of(Resolution size, const std::function<double(int x, int y)>& height) {
    Image<float> heights(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            heights.at(x, y) = static_cast<float>(height(x, y));
    }
    return make_height_map(heights, HeightFormat::r32f, "made");
}

/// A plateau at h = 1 with its last texel `last`, and a floor at h = 0 beside it.
HeightMap plateau(int texels, int last) {
    return map_of({texels, 1}, [&](int x, int) { return x <= last ? 1.0 : 0.0; });
}

View view_of(SelfShadow::Mode mode, Boundary boundary, double tiling = 1) {
    View view;
    view.relief = {height_scale, tiling, boundary};
    view.self_shadow.mode = mode;
    return view;
}

/// Hits at places of the patch; their own heights do not matter.
HitImage hits_at(const std::vector<glm::dvec2>& places) {
    HitImage hits(Resolution{static_cast<int>(places.size()), 1});
    for (std::size_t i = 0; i < places.size(); ++i)
        hits.texels[i] = {static_cast<float>(places[i].x), static_cast<float>(places[i].y), 0, 1};
    return hits;
}

Lighting lit_from(const std::vector<glm::dvec3>& directions, double angular_radius = 0.2665) {
    Lighting lighting;
    lighting.lights.clear();
    for (const glm::dvec3& direction : directions)
        lighting.lights.push_back({direction, glm::dvec3(1), angular_radius});
    return lighting;
}

TEST(LightVisibility, AStepsShadowIsAsLongAsItsLightIsLow) {
    const int texels = 1024;
    const HeightMap map = plateau(texels, 255);
    const double edge = 255.5 / texels;
    for (const double slope : {0.25, 0.5, 2.0}) {
        const double end = edge + height_scale / slope;
        const double floor = 257.0 / texels;
        std::vector<glm::dvec2> places{{0.1, 0.5}, {end - 1e-5, 0.5}, {end + 1e-5, 0.5}, {0.9, 0.5}};
        if (end > floor) places.emplace_back(floor, 0.5);
        const LightVisibility visibility = trace_light_visibility(
            hits_at(places), map, view_of(SelfShadow::Mode::hard, Boundary::clip), lit_from({{-1, 0, slope}}));
        EXPECT_EQ(visibility.fractions.at(0, 0)[0], 1) << "on the plateau";
        EXPECT_EQ(visibility.fractions.at(1, 0)[0], 0) << slope;
        EXPECT_EQ(visibility.fractions.at(2, 0)[0], 1) << slope;
        EXPECT_EQ(visibility.fractions.at(3, 0)[0], 1) << slope;
        if (end > floor) {
            EXPECT_EQ(visibility.fractions.at(4, 0)[0], 0) << slope;
        }
        EXPECT_FALSE(visibility.standard_error);
    }
}

/// The fraction of a small disc above a straight horizon that lies `above` radii over its centre's elevation.
double disc_above_horizon(double above) {
    if (above <= -1) return 1;
    if (above >= 1) return 0;
    return 0.5 - (above * std::sqrt(1 - above * above) + std::asin(above)) / std::numbers::pi;
}

// Of a wall, at every point of the floor: the width of the penumbra is 2·distance·tan(radius).
TEST(LightVisibility, AWallsPenumbraIsThatOfTheLightsDisc) {
    const int texels = 1024;
    const HeightMap map = plateau(texels, 255);
    const double edge = 255.5 / texels;
    const double elevation = std::atan(0.25);
    for (const double radius_degrees : {0.2665, 2.0}) {
        const double radius = radius_degrees * std::numbers::pi / 180;
        std::vector<glm::dvec2> places;
        std::vector<double> expected;
        for (double above = -1.2; above <= 1.21; above += 0.1) {
            const double horizon = elevation + above * radius;
            places.emplace_back(edge + height_scale / std::tan(horizon), 0.5);
            expected.push_back(disc_above_horizon(above));
        }
        const LightVisibility visibility =
            trace_light_visibility(hits_at(places), map, view_of(SelfShadow::Mode::soft, Boundary::clip),
                                   lit_from({{-std::cos(elevation), 0, std::sin(elevation)}}, radius_degrees));
        // Four of the standard errors that the sampling stops at.
        for (std::size_t i = 0; i < places.size(); ++i)
            EXPECT_NEAR(visibility.fractions.texels[i][0], expected[i], 4.0 / 255) << i << " of " << radius_degrees;
        ASSERT_TRUE(visibility.standard_error);
        EXPECT_LT(*visibility.standard_error, 1.0 / 255);
        EXPECT_GT(*visibility.standard_error, 0);
    }
}

/// By small steps up along the light's ray: how far above the surface all of it stays, as a fraction of its way, or how
/// deep beneath it some of it lies, which is negative.
struct Marched {
    double clearance = 1;
};

Marched march_up(const HeightMap& map, const Relief& relief, glm::dvec2 place, glm::dvec3 to_light) {
    const double h = map.sample(relief.tiling * place.x, relief.tiling * place.y);
    const glm::dvec2 way = glm::dvec2(to_light) * (relief.height_scale / to_light.z);
    Marched marched;
    constexpr int steps = 20000;
    for (int i = 1; i < steps; ++i) {
        const double risen = (1 - h) * i / steps;
        const glm::dvec2 at = place + risen * way;
        const bool outside = at.x < 0 || at.x > 1 || at.y < 0 || at.y > 1;
        if (relief.boundary == Boundary::clip && outside) break;
        const double clearance = h + risen - map.sample(relief.tiling * at.x, relief.tiling * at.y);
        marched.clearance = std::min(marched.clearance, clearance / (risen + 1e-4));
    }
    return marched;
}

// The patch's border cuts no rays off beneath the sheet here: the map's border is its lowest place.
TEST(LightVisibility, AgreesWithABruteForceMarch) {
    Random random(11);
    const HeightMap map = map_of({16, 12}, [&](int x, int y) {
        const bool border = x == 0 || y == 0 || x == 15 || y == 11;
        return border ? 0.0 : random.uniform();
    });
    int compared = 0;
    int shadowed = 0;
    for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
        const View view = view_of(SelfShadow::Mode::hard, boundary, boundary == Boundary::clip ? 1 : 2);
        for (int trial = 0; trial < 300; ++trial) {
            const glm::dvec2 place{static_cast<float>(random.uniform()), static_cast<float>(random.uniform())};
            const glm::dvec3 to_light =
                glm::normalize(glm::dvec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)});
            const Marched marched = march_up(map, view.relief, place, to_light);
            if (std::abs(marched.clearance) < 0.02) continue;
            const bool lit = marched.clearance > 0;
            const LightVisibility visibility =
                trace_light_visibility(hits_at({place}), map, view, lit_from({to_light}));
            EXPECT_EQ(visibility.fractions.at(0, 0)[0], lit ? 1 : 0)
                << place.x << ' ' << place.y << " to " << to_light.x << ' ' << to_light.y << ' ' << to_light.z;
            ++compared;
            shadowed += lit ? 0 : 1;
        }
    }
    EXPECT_GT(compared, 200);
    EXPECT_GT(shadowed, 50);
    EXPECT_GT(compared - shadowed, 50);
}

// The light enters through the patch's side beneath the plateau and leaves it through its back: the sheet, which begins
// half way up to the plateau, is higher there than the light's ray. Repeated, the plateau
// of the next patch stands in its way.
TEST(LightVisibility, BackFacesAreTransparentAndWhatLiesOutsideCastsNoShadow) {
    const HeightMap map = plateau(64, 15);
    const HitImage hits = hits_at({{0.5, 0.5}});
    const Lighting low = lit_from({{-1, 0, 0.06}});
    const auto visible = [&](Boundary boundary) {
        return trace_light_visibility(hits, map, view_of(SelfShadow::Mode::hard, boundary), low).fractions.at(0, 0)[0];
    };
    EXPECT_EQ(visible(Boundary::clip), 1);
    EXPECT_EQ(visible(Boundary::repeat), 0);
}

TEST(LightVisibility, IsEachLightsOwn) {
    const HeightMap map = plateau(64, 15);
    const HitImage hits = hits_at({{0.3, 0.5}});
    const Lighting lighting = lit_from({{-1, 0, 0.5}, {1, 0, 0.5}, {-1, 0, -0.1}});
    const LightVisibility visibility =
        trace_light_visibility(hits, map, view_of(SelfShadow::Mode::hard, Boundary::clip), lighting);
    EXPECT_EQ(visibility.fractions.at(0, 0)[0], 0) << "behind the wall";
    EXPECT_EQ(visibility.fractions.at(0, 0)[1], 1);
    EXPECT_EQ(visibility.fractions.at(0, 0)[2], 0) << "below the polygon's horizon";
}

TEST(LightVisibility, IsFullWithoutShadows) {
    const HeightMap map = plateau(64, 15);
    const HitImage hits = hits_at({{0.3, 0.5}});
    Lighting lighting = lit_from({{-1, 0, 0.5}});
    const auto visible = [&](SelfShadow::Mode mode) {
        return trace_light_visibility(hits, map, view_of(mode, Boundary::clip), lighting).fractions.at(0, 0)[0];
    };
    EXPECT_EQ(visible(SelfShadow::Mode::hard), 0);
    EXPECT_EQ(visible(SelfShadow::Mode::off), 1);
    lighting.enabled = false;
    EXPECT_EQ(visible(SelfShadow::Mode::hard), 1);
}

// Sobol' points form a (0, k, 2)-net: of the first 2^k, every box of area 2^-k on the grid of powers of two holds one.
TEST(ScrambledPoints, StratifyEveryBox) {
    constexpr int bits = 6;
    for (const std::uint64_t seed : {0U, 1U, 99U}) {
        for (int across = 0; across <= bits; ++across) {
            std::set<std::pair<int, int>> boxes;
            for (std::uint32_t index = 0; index < (1U << bits); ++index) {
                const glm::dvec2 point = scrambled_sobol_point(index, seed);
                ASSERT_TRUE(point.x >= 0 && point.x < 1 && point.y >= 0 && point.y < 1);
                boxes.emplace(static_cast<int>(point.x * (1 << across)),
                              static_cast<int>(point.y * (1 << (bits - across))));
            }
            EXPECT_EQ(boxes.size(), 1U << bits) << "seed " << seed << ", " << across;
        }
    }
}

TEST(ScrambledPoints, OfDifferentSeedsAreIndependent) {
    // The correlation of 4096 pairs of first points.
    double sum = 0;
    constexpr int pairs = 4096;
    for (std::uint64_t seed = 0; seed < pairs; ++seed) {
        const glm::dvec2 a = scrambled_sobol_point(3, 2 * seed);
        const glm::dvec2 b = scrambled_sobol_point(3, 2 * seed + 1);
        sum += 12 * (a.x - 0.5) * (b.x - 0.5);
    }
    EXPECT_NEAR(sum / pairs, 0, 4 / std::sqrt(pairs));
}

}  // namespace
}  // namespace reliefbench
