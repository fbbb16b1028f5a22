#include "reference/exact_tracer.hpp"

#include "core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace reliefbench {
namespace {

HeightMap random_map(Resolution size, std::uint64_t seed) {
    Random random(seed);
    Image<float> heights(size);
    for (float& height : heights.texels)
        height = static_cast<float>(random.uniform());
    return make_height_map(heights, HeightFormat::r32f, "random");
}

HeightMap constant_map(Resolution size, float height) {
    return make_height_map(Image<float>(size, height), HeightFormat::r32f, "constant");
}

glm::dvec3 direction(double theta, double phi) {
    theta *= std::numbers::pi / 180;
    phi *= std::numbers::pi / 180;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), -std::cos(theta)};
}

double clearance(const HeightMap& map, const Relief& relief, const Ray& ray, double t) {
    const glm::dvec3 point = ray.origin + t * ray.direction;
    return point.z / relief.height_scale + 1 -
           map.sample(relief.tiling * (point.x + 0.5), relief.tiling * (point.y + 0.5));
}

/// With Boundary::repeat every descending ray that starts at z = 0 has a hit, on the surface, with no part of its way
/// below the surface before.
void expect_first_crossing(const ExactTracer& tracer, const HeightMap& map, const Relief& relief, const Ray& ray) {
    const auto hit = tracer.trace(ray);
    ASSERT_TRUE(hit) << "leaked from " << ray.origin.x << " " << ray.origin.y << " along " << ray.direction.x << " "
                     << ray.direction.y;
    EXPECT_GE(hit->t, 0);
    EXPECT_GE(hit->h, 0);
    EXPECT_LE(hit->h, 1);
    EXPECT_NEAR(clearance(map, relief, ray, hit->t), 0, 1e-11);
    for (int step = 0; step < 64; ++step)
        EXPECT_GT(clearance(map, relief, ray, hit->t * step / 64), -1e-11);
}

class AnySize : public testing::TestWithParam<Resolution> {};

TEST_P(AnySize, NoRayLeaksWhereCellsMeet) {
    const HeightMap map = random_map(GetParam(), 5);
    for (const double tiling : {1.0, 2.5}) {
        const Relief relief{0.1, tiling, Boundary::repeat};
        const ExactTracer tracer(map, relief);
        const double cell_x = 1 / (tiling * map.width());
        const double cell_y = 1 / (tiling * map.height());
        for (const double theta : {0.0, 20.0, 60.0, 85.0}) {
            // Along cell borders, through their crossings, and as little off them as doubles can tell.
            for (const double phi :
                 {0.0, 90.0, 180.0, 270.0, 45.0, -135.0, 17.0, std::atan2(cell_y, cell_x) * 180 / std::numbers::pi}) {
                for (int k = -2; k < 3; ++k) {
                    const glm::dvec3 corner{(k + 0.5) * cell_x - 0.5, (k + 2.5) * cell_y - 0.5, 0};
                    for (const double nudge : {0.0, 1e-16, -1e-16, 1e-13, -1e-13, 0.5 * cell_x}) {
                        expect_first_crossing(tracer, map, relief,
                                              {corner + glm::dvec3(nudge, 0, 0), direction(theta, phi)});
                    }
                    expect_first_crossing(tracer, map, relief,
                                          {corner, glm::dvec3(theta == 0 ? 0 : 1, 0, 0) + glm::dvec3(0, 0, -1)});
                }
            }
        }
    }
}

TEST_P(AnySize, RandomRaysHitTheirFirstCrossing) {
    const HeightMap map = random_map(GetParam(), 6);
    const Relief relief{0.07, 1.3, Boundary::repeat};
    const ExactTracer tracer(map, relief);
    Random random(7);
    for (int index = 0; index < 400; ++index) {
        const glm::dvec3 entry{random.uniform(-3, 3), random.uniform(-3, 3), 0};
        expect_first_crossing(tracer, map, relief, {entry, direction(random.uniform(0, 89), random.uniform(0, 360))});
    }
}

INSTANTIATE_TEST_SUITE_P(ExactTracer, AnySize,
                         testing::Values(Resolution{1, 1}, Resolution{2, 2}, Resolution{1, 7}, Resolution{5, 3},
                                         Resolution{17, 9}, Resolution{64, 64}, Resolution{100, 33}),
                         [](const auto& size) {
                             return std::to_string(size.param.width) + "x" + std::to_string(size.param.height);
                         });

TEST(ExactTracer, ConstantMapsAreHitWhereThePlaneIs) {
    const glm::dvec3 down = direction(70, 33);
    for (const float height : {0.0f, 0.25f, 1.0f}) {
        const HeightMap map = constant_map({5, 4}, height);
        const ExactTracer tracer(map, {0.05, 2, Boundary::repeat});
        const auto hit = tracer.trace({{0.1, -0.2, 0}, down});
        ASSERT_TRUE(hit);
        const double t = 0.05 * (1 - height) / -down.z;
        EXPECT_NEAR(hit->t, t, 1e-15);
        EXPECT_NEAR(hit->h, height, 1e-14);
        EXPECT_NEAR(hit->u, 0.6 + t * down.x, 1e-15);
        EXPECT_NEAR(hit->v, 0.3 + t * down.y, 1e-15);
    }
}

/// A surface that touches h = 1 is hit at the entry only by rays that go below it there.
TEST(ExactTracer, EntryOnTheSurfaceIsAHit) {
    // A ridge of h = 1 on texel centre 1, falling to 0 on either side: by one per quarter of the patch.
    Image<float> heights({4, 1}, 0.0f);
    heights.at(1, 0) = 1;
    const HeightMap map = make_height_map(heights, HeightFormat::r32f, "ridge");
    const ExactTracer tracer(map, {0.05, 1, Boundary::clip});
    const double ridge = 1.5 / 4 - 0.5;
    // Steeper than the flank (0.05 per 0.25): below at once.
    const auto steep = tracer.trace({{ridge, 0, 0}, {0.2, 0, -0.05}});
    ASSERT_TRUE(steep);
    EXPECT_NEAR(steep->t, 0, 1e-15);
    EXPECT_EQ(steep->h, 1);
    // Flatter than the flank, which it would stay above: it touches the ridge, and that is where it enters.
    const auto touch = tracer.trace({{ridge, 0, 0}, {0.7, 0, -0.05}});
    ASSERT_TRUE(touch);
    EXPECT_EQ(touch->t, 0);
    // A little beside the ridge it stays above the flank until the valley, and leaves the patch before reaching its
    // floor, or comes down to it inside the patch.
    const double beside = ridge + 1e-5;
    EXPECT_FALSE(tracer.trace({{beside, 0, 0}, {0.7, 0, -0.05}}));
    const auto floor = tracer.trace({{beside, 0, 0}, {0.5, 0, -0.05}});
    ASSERT_TRUE(floor);
    EXPECT_NEAR(floor->t, 1, 1e-14);
    EXPECT_NEAR(floor->h, 0, 1e-14);
}

TEST(ExactTracer, RaysFromBeneathTheSheetMustComeUpFirst) {
    // h = 1 for u < ½ and 0 beyond, a cliff one texel wide between: 15/32 to 17/32.
    Image<float> heights({16, 1}, 0.0f);
    for (int i = 0; i < 8; ++i)
        heights.at(i, 0) = 1;
    const HeightMap map = make_height_map(heights, HeightFormat::r32f, "cliff");
    const ExactTracer tracer(map, {0.1, 1, Boundary::clip});
    // Enters through the side u = 0 (where the border wraps to h = ½) at h = 0.4, beneath the sheet, leaves the cliff
    // from behind, and falls to the floor beyond it.
    const double slope = 0.04 / 0.8;  // meets h = 0 at u = 0.8
    const auto through = tracer.trace({{-0.5 - 0.5, 0, -0.06 + 0.5 * slope}, {1, 0, -slope}});
    ASSERT_TRUE(through);
    EXPECT_NEAR(through->u, 0.8, 1e-12);
    EXPECT_NEAR(through->h, 0, 1e-12);
    // The same, but still beneath the sheet when the slab ends.
    EXPECT_FALSE(tracer.trace({{-0.5 - 0.5, 0, -0.06 + 0.5 * 0.2}, {1, 0, -0.2}}));
    // From the other side it meets the cliff's face.
    const auto face = tracer.trace({{0.5 + 0.5, 0, -0.06 + 0.5 * slope}, {-1, 0, -slope}});
    ASSERT_TRUE(face);
    EXPECT_NEAR(clearance(map, {0.1, 1, Boundary::clip}, {{1, 0, -0.06 + 0.5 * slope}, {-1, 0, -slope}}, face->t), 0,
                1e-12);
    EXPECT_GT(face->u, 15.0 / 32);
    EXPECT_LT(face->u, 17.0 / 32);
}

TEST(ExactTracer, RaysThatDoNotDescendMiss) {
    const HeightMap map = constant_map({4, 4}, 0.5f);
    const ExactTracer tracer(map, {0.05, 1, Boundary::repeat});
    EXPECT_FALSE(tracer.trace({{0, 0, 0}, {1, 0, 0}}));
    EXPECT_FALSE(tracer.trace({{0, 0, -0.04}, {0, 0, 1}}));
}

TEST(ExactTracer, RepeatedHitsAreNotWrapped) {
    const HeightMap map = random_map({9, 4}, 8);
    const ExactTracer tracer(map, {0.05, 1, Boundary::repeat});
    const glm::dvec3 down = direction(50, 10);
    const auto here = tracer.trace({{0.123, 0.234, 0}, down});
    const auto there = tracer.trace({{0.123 + 5, 0.234 - 3, 0}, down});
    ASSERT_TRUE(here && there);
    EXPECT_NEAR(there->u, here->u + 5, 1e-12);
    EXPECT_NEAR(there->v, here->v - 3, 1e-12);
    EXPECT_NEAR(there->t, here->t, 1e-12);
}

}  // namespace
}  // namespace reliefbench
