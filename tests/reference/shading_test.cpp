#include "reference/shading.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace reliefbench {
namespace {

constexpr glm::dvec3 up{0, 0, 1};

void expect_colour(glm::dvec3 colour, glm::dvec3 expected) {
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(colour[channel], expected[channel], 1e-12) << "channel " << channel;
}

TEST(Shading, OfALightOverhead) {
    Lighting lighting;
    lighting.lights = {{{0, 0, 5}, {1, 0.5, 0.25}}};
    // Albedo · (0.2 + 1 · light) + 0.15 · light, seen along the mirror direction: N·Hv = 1.
    expect_colour(shade(lighting, {0.5, 0.4, 0.8}, up, up, 0), {0.6 + 0.15, 0.28 + 0.075, 0.36 + 0.0375});
    // Half of the light arrives: half of the diffuse and specular light, all of the ambient.
    expect_colour(shade(lighting, {0.5, 0.4, 0.8}, up, up, 0, glm::dvec3(0.5)),
                  {0.35 + 0.075, 0.18 + 0.0375, 0.26 + 0.01875});
}

TEST(Shading, OfASlantedLight) {
    Lighting lighting;
    lighting.lights = {{{0.6, 0, 0.8}, {1, 1, 1}}};
    lighting.ambient = {0, 0, 0};
    lighting.shininess = 2;
    // N·L = 0.8. Half vector of L = (0.6, 0, 0.8) and V = (0, 0, 1): N·Hv² = (1 + 0.8)/2.
    expect_colour(shade(lighting, {1, 0.5, 0}, up, up, 0), {0.8 + 0.135, 0.4 + 0.135, 0.135});
}

TEST(Shading, LightsFromBehindGiveNothing) {
    Lighting lighting;
    lighting.lights = {{{0.1, 0, -1}, {9, 9, 9}}};
    lighting.specular = {1, 1, 1};
    lighting.shininess = 0;
    // Not even specular light, though the half vector may face the normal.
    expect_colour(shade(lighting, {0.5, 1, 0.25}, up, up, 0), {0.1, 0.2, 0.05});
}

TEST(Shading, LightsAddUp) {
    Lighting lighting;
    lighting.lights = {{{0, 0, 1}, {0.5, 0, 0}}, {{0, 0, 1}, {0, 0.25, 0}}, {{0, 0, 1}, {0, 0, 1}}};
    lighting.specular = {0, 0, 0};
    expect_colour(shade(lighting, {1, 1, 1}, up, up, 0), {0.7, 0.45, 1.2});
}

TEST(Shading, FogIsLinearInTheDistanceAndClamped) {
    Lighting lighting;
    lighting.lights.clear();
    lighting.ambient = {1, 1, 1};
    lighting.fog = Fog{1, 2, {0, 0.5, 1}};
    const glm::dvec3 albedo{1, 0.5, 0};
    expect_colour(shade(lighting, albedo, up, up, 0.5), {1, 0.5, 0});
    expect_colour(shade(lighting, albedo, up, up, 1.5), {0.75, 0.5, 0.25});
    expect_colour(shade(lighting, albedo, up, up, 9), {0, 0.5, 1});
}

TEST(Shading, WithLightingOffIsTheAlbedo) {
    Lighting lighting;
    lighting.enabled = false;
    lighting.fog = Fog{0, 1, {9, 9, 9}};
    expect_colour(shade(lighting, {0.1, 0.2, 0.3}, up, up, 5), {0.1, 0.2, 0.3});
}

}  // namespace
}  // namespace reliefbench
