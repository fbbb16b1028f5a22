#pragma once

#include "scene/albedo.hpp"
#include "scene/height_map.hpp"
#include "scene/lighting.hpp"
#include "scene/relief.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace reliefbench {

/// Bilinear between texel centres and repeating, at texture coordinates. Weights and sums are single-precision numbers,
/// as the texels are, which computes all channels of a texel at once.
template <std::size_t channels>
std::array<float, channels> bilinear(const Image<std::array<float, channels>>& texels, double u, double v) {
    struct Between {
        std::ptrdiff_t first;
        std::ptrdiff_t second;
        float fraction;
    };
    const auto between = [](double position, int count) {
        auto below = static_cast<std::ptrdiff_t>(position);
        below -= position < static_cast<double>(below) ? 1 : 0;
        const auto fraction = static_cast<float>(position - static_cast<double>(below));
        if (below < 0 || below >= count) {
            below %= count;
            below += below < 0 ? count : 0;
        }
        return Between{below, below + 1 == count ? 0 : below + 1, fraction};
    };
    const Between x = between(u * texels.size.width - 0.5, texels.size.width);
    const Between y = between(v * texels.size.height - 0.5, texels.size.height);
    const std::array<float, channels>* const lower = texels.texels.data() + y.first * texels.size.width;
    const std::array<float, channels>* const upper = texels.texels.data() + y.second * texels.size.width;
    const float lower_left = (1 - x.fraction) * (1 - y.fraction);
    const float lower_right = x.fraction * (1 - y.fraction);
    const float upper_left = (1 - x.fraction) * y.fraction;
    const float upper_right = x.fraction * y.fraction;
    std::array<float, channels> sum;
    for (std::size_t channel = 0; channel < channels; ++channel) {
        sum[channel] = lower_left * lower[x.first][channel] + lower_right * lower[x.second][channel] +
                       upper_left * upper[x.first][channel] + upper_right * upper[x.second][channel];
    }
    return sum;
}

/// What shade() (reference/shading.hpp) makes of a relief's points, to a few units in the last place, for very many of
/// them: about 40 ns each. Refers to the albedo, which must outlive it.
class SurfaceShader {
public:
    SurfaceShader(const HeightMap& map, const Albedo& albedo, const Relief& relief, const Lighting& lighting);

    /// shading_slope() at patch coordinates.
    glm::dvec2 slope(glm::dvec2 uv) const {
        const auto found = bilinear(derivatives_, tiling_ * uv.x, tiling_ * uv.y);
        return slope_scale_ * glm::dvec2(found[0], found[1]);
    }

    /// Towards each light, unit vectors.
    const std::vector<glm::dvec3>& to_lights() const { return to_lights_; }

    /// Linear RGB of the point over the patch coordinates; the other arguments are shade()'s.
    glm::dvec3 shade(glm::dvec2 uv, const glm::dvec3& normal, const glm::dvec3& to_eye, double t,
                     const std::array<double, 3>& visibility) const {
        const auto sampled = bilinear(albedo_.texels, tiling_ * uv.x, tiling_ * uv.y);
        const glm::dvec3 albedo(sampled[0], sampled[1], sampled[2]);
        if (!lighting_.enabled) return albedo;
        glm::dvec3 diffuse = lighting_.ambient;
        glm::dvec3 specular{0.0};
        for (std::size_t i = 0; i < to_lights_.size(); ++i) {
            const double n_dot_l = glm::dot(normal, to_lights_[i]);
            if (n_dot_l <= 0) continue;
            const glm::dvec3 arriving = lighting_.lights[i].colour * visibility[i];
            diffuse += arriving * n_dot_l;
            const glm::dvec3 half_way = to_lights_[i] + to_eye;
            const double along = glm::dot(normal, half_way);
            if (along > 0) specular += arriving * shininess(along * along / glm::dot(half_way, half_way));
        }
        const glm::dvec3 colour = albedo * diffuse + lighting_.specular * specular;
        if (!lighting_.fog) return colour;
        const Fog& fog = *lighting_.fog;
        return glm::mix(colour, fog.colour, glm::clamp((t - fog.start) / fog.range, 0.0, 1.0));
    }

private:
    /// The cosine to the power of the exponent.
    double shininess(double squared_cosine) const {
        if (half_exponent_ == 0) return std::pow(squared_cosine, lighting_.shininess / 2);
        double power = 1;
        double factor = squared_cosine;
        for (std::uint32_t bits = half_exponent_; bits != 0; bits >>= 1) {
            if ((bits & 1) != 0) power *= factor;
            factor *= factor;
        }
        return power;
    }

    const Albedo& albedo_;
    Image<std::array<float, 2>> derivatives_;
    double tiling_;
    double slope_scale_;
    Lighting lighting_;
    std::vector<glm::dvec3> to_lights_;
    /// Half the exponent of the highlight where that is a whole number, and not large; else 0.
    std::uint32_t half_exponent_ = 0;
};

}  // namespace reliefbench
