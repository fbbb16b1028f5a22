#pragma once

#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/lighting.hpp"
#include "scene/relief.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace reliefbench {

/// Numbers of scrambled Sobol points (scrambled_points.hpp) on a light's disc: so many in each of several independent
/// scramblings, whose scatter tells the error.
struct LightSampling {
    int scrambles = 8;
    /// In each scrambling: 256 rays at least.
    int min_points = 32;
    /// And 2048 at most: the number is doubled for the whole penumbra until its mean standard error is at most
    /// `standard_error`.
    int max_points = 256;
    double standard_error = 1.0 / 255;
};

/// How much of each light reaches each hit past the relief.
struct LightVisibility {
    /// Of each light, in the lights' order, in [0, 1]; 1 where there is no hit and for lights that there are not.
    Image<std::array<float, 3>> fractions;
    /// Soft: the standard error of the mean over scramblings, averaged over every hit and light in the penumbra
    /// (neither dark nor lit with the least number of rays). Empty where nothing is.
    std::optional<double> standard_error;
};

/// A point of the relief that light may come to.
struct LitPoint {
    glm::dvec3 place{};
    /// Its height in the relief.
    double h = 0;
    /// The base's there.
    glm::dvec3 normal{0, 0, 1};
};

/// A direction in which light may come to a point; `to_light` is a unit vector.
struct LightWay {
    LitPoint point;
    glm::dvec3 to_light{};
};

/// The ways of light to the hits of a picture past one relief.
class LightPaths {
public:
    LightPaths() = default;
    LightPaths(const LightPaths&) = delete;
    LightPaths& operator=(const LightPaths&) = delete;
    virtual ~LightPaths() = default;

    /// Of a pixel that has a hit.
    virtual LitPoint point(std::size_t pixel) const = 0;
    /// 1 where light comes that way, else 0; as many `open` as `ways`. Quickest for many at once that lie close
    /// together.
    virtual void follow(std::span<const LightWay> ways, std::span<std::uint8_t> open) const = 0;
};

/// `SelfShadow::Mode::hard`: the one direction to the light. `soft`: the fraction of directions within the light's
/// angular radius, uniform over their solid angle. `off`, and lighting that is off: all 1.
LightVisibility trace_light_visibility(const HitImage& hits, const LightPaths& paths, const View& view,
                                       const Lighting& lighting, const LightSampling& sampling = {});

/// Over the plane. The light ray of a direction through a point enters the relief from the light's side and is traced
/// exactly (ExactTracer); the point is lit when that meets the sheet nowhere before it. So back faces are transparent,
/// and what lies outside of a clipped patch shadows nothing. A direction that does not rise above the polygon brings no
/// light. A hit stands for the surface over its (u, v), whatever its h.
LightVisibility trace_light_visibility(const HitImage& hits, const HeightMap& map, const View& view,
                                       const Lighting& lighting, const LightSampling& sampling = {});

}  // namespace reliefbench
