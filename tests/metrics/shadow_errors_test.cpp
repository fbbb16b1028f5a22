#include "metrics/shadow_errors.hpp"

#include <gtest/gtest.h>

using namespace reliefbench;

namespace {

const Hit hit{0.5F, 0.5F, 0.5F, 1};
const Hit miss{};

/// Rows of one height and a light of each direction, over a map whose normal is straight up.
ShadowErrors compare(const std::vector<std::array<float, 3>>& technique, const std::vector<Hit>& technique_hits,
                     const std::vector<std::array<float, 3>>& truth, const std::vector<Hit>& truth_hits,
                     const std::vector<std::uint8_t>& footprint, const std::vector<glm::dvec3>& directions) {
    const Resolution size{static_cast<int>(truth.size()), 1};
    const auto row = [&](const auto& texels) {
        Image<typename std::decay_t<decltype(texels)>::value_type> image(size);
        image.texels = texels;
        return image;
    };
    Lighting lighting;
    lighting.lights.clear();
    for (const glm::dvec3& direction : directions)
        lighting.lights.push_back({direction});
    const HeightMap map = make_height_map(Image<float>({2, 2}, 0.5F), HeightFormat::r32f, "flat");
    return compare_shadows(row(technique), row(truth),
                           {row(technique_hits), row(truth_hits), row(footprint), map, Relief{}}, lighting);
}

TEST(ShadowErrors, AreDifferencesOfVisibility) {
    // Too dark by 1, too light by 0.5 and by 0.25, right.
    const ShadowErrors errors = compare({{0, 1, 1}, {0.75F, 1, 1}, {0.5F, 1, 1}, {0.25F, 1, 1}}, {hit, hit, hit, hit},
                                        {{1, 1, 1}, {0.25F, 1, 1}, {0.25F, 1, 1}, {0.25F, 1, 1}}, {hit, hit, hit, hit},
                                        {1, 1, 1, 1}, {{0, 0, 1}});
    EXPECT_EQ(errors.compared, 4U);
    EXPECT_EQ(errors.mean, 1.75 / 4);
    EXPECT_EQ(errors.false_shadow, 0.25);
    EXPECT_EQ(errors.missed_shadow, 0.25);
}

TEST(ShadowErrors, CompareWhereBothHitWithinTheFootprint) {
    const ShadowErrors errors =
        compare({{0, 1, 1}, {0, 1, 1}, {0, 1, 1}, {1, 1, 1}}, {miss, hit, hit, hit},
                {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {hit, miss, hit, hit}, {1, 1, 0, 1}, {{0, 0, 1}});
    EXPECT_EQ(errors.compared, 1U);
    EXPECT_EQ(errors.mean, 0);
}

TEST(ShadowErrors, LeaveTiesOut) {
    const ShadowErrors errors = compare({{0, 1, 1}, {1, 1, 1}}, {hit, hit}, {{1, 1, 1}, {1, 1, 1}}, {hit, hit},
                                        {tie_in_footprint, in_footprint}, {{0, 0, 1}});
    EXPECT_EQ(errors.compared, 1U);
    EXPECT_EQ(errors.mean, 0);
}

TEST(ShadowErrors, CompareEachLightThatTheSurfaceFaces) {
    // The first is right, the second too dark, and the third lights the surface from behind.
    const ShadowErrors errors =
        compare({{1, 0, 0}}, {hit}, {{1, 1, 1}}, {hit}, {1}, {{0, 0, 1}, {1, 0, 0.5}, {0, 1, -0.1}});
    EXPECT_EQ(errors.compared, 2U);
    EXPECT_EQ(errors.mean, 0.5);
    EXPECT_EQ(errors.false_shadow, 0.5);
}

TEST(ShadowErrors, WithNothingToCompareAreNone) {
    const ShadowErrors errors = compare({{0, 0, 0}}, {hit}, {{1, 1, 1}}, {hit}, {1}, {});
    EXPECT_EQ(errors.compared, 0U);
    EXPECT_EQ(errors.mean, 0);
}

}  // namespace
