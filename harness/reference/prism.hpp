#pragma once

#include "scene/ray.hpp"
#include "scene/surface/base_mesh.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace reliefbench {

/// How the height map lies on patch coordinates: texel i has its centre at X = i of X = u·columns − ½, likewise Y of v.
struct TexelScale {
    /// Texels of the map on a patch side: tiling times its size.
    double columns = 1;
    double rows = 1;
    /// H.
    double height_scale = 1;
};

/// A point of the relief's space over one triangle: (X, Y) in texels, Z = 1 + w/H where it lies w along N over the
/// base. Also what a ray does: how a point on it changes with t.
using PrismPoint = glm::dvec3;

/// The space over and under one triangle of the base: all P + w·N. With m = w/|M|, M the linear normal, a point of it
/// lies on the flat triangle of corners P_i + m·N_i, at the same barycentric coordinates as its foot on the base: in m,
/// β and γ everything is a polynomial, and m of a point is the root of a cubic. Double precision.
class Prism {
public:
    Prism(const BaseMesh& mesh, std::size_t triangle, const TexelScale& scale);

    /// Whether the triangle spans an area, in the world and in its chart: the others have no relief.
    bool has_area() const { return has_area_; }

    /// Whether it turns inside out at any m from `lowest` to 0.
    bool is_folded(double lowest) const;

    /// One ray's share in the cubic: a[k] + t·b[k] = (ray(t) − corner)·n[k], n(m) = n[0] + n[1]·m + n[2]·m² normal to
    /// the flat triangle at m.
    struct RayTerms {
        std::array<double, 3> a;
        std::array<double, 3> b;
    };
    RayTerms terms(const Ray& ray) const;

    /// t at which the ray meets the flat triangle's plane at m. Not for a ray along it.
    double t_at(const RayTerms& ray, double m) const;

    struct Along {
        double m = 0;
        PrismPoint point{};
        /// Per t.
        PrismPoint change{};
    };
    /// Where the ray is at t; `guess` of m. False where the search fails, or finds the space inside out there.
    bool locate(const Ray& ray, const RayTerms& terms, double t, double guess, Along& found) const;

    /// Positive within the triangle: the distance in texels of its chart from each of its three sides.
    const std::array<glm::dvec3, 3>& sides() const { return sides_; }

    /// P and N of the triangle's corners' combination with the weights 1 − β − γ, β, γ.
    glm::dvec3 foot(glm::dvec2 barycentric) const { return corner_ + barycentric.x * first_ + barycentric.y * second_; }
    glm::dvec3 linear_normal(glm::dvec2 barycentric) const {
        return normal_ + barycentric.x * first_normal_ + barycentric.y * second_normal_;
    }
    /// β and γ of a point of the chart, in texels.
    glm::dvec2 barycentric(glm::dvec2 texel) const;
    std::array<glm::dvec2, 3> texel_corners() const { return {texel_, texel_ + first_texel_, texel_ + second_texel_}; }

private:
    glm::dvec3 corner_;
    glm::dvec3 first_;
    glm::dvec3 second_;
    glm::dvec3 normal_;
    glm::dvec3 first_normal_;
    glm::dvec3 second_normal_;
    std::array<glm::dvec3, 3> across_;
    /// normal_·across_[k].
    std::array<double, 3> rise_;
    glm::dvec2 texel_;
    glm::dvec2 first_texel_;
    glm::dvec2 second_texel_;
    std::array<glm::dvec3, 3> sides_;
    double inverse_height_;
    bool has_area_;
};

}  // namespace reliefbench
