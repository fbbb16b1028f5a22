#include "reference/prism.hpp"

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

double cross_of(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// The line through two points as (x, y, 1)·line, the signed distance from it.
glm::dvec3 line_through(glm::dvec2 from, glm::dvec2 to) {
    const glm::dvec2 along = glm::normalize(to - from);
    return {-along.y, along.x, cross_of(from, along)};
}

}  // namespace

Prism::Prism(const BaseMesh& mesh, std::size_t triangle, const TexelScale& scale)
    : inverse_height_(1 / scale.height_scale) {
    const BaseMesh::Triangle& corners = mesh.triangles[triangle];
    const MeshVertex& corner = mesh.vertices[corners[0]];
    const MeshVertex& first = mesh.vertices[corners[1]];
    const MeshVertex& second = mesh.vertices[corners[2]];
    corner_ = glm::dvec3(corner.position);
    first_ = glm::dvec3(first.position) - corner_;
    second_ = glm::dvec3(second.position) - corner_;
    normal_ = glm::dvec3(corner.normal);
    first_normal_ = glm::dvec3(first.normal) - normal_;
    second_normal_ = glm::dvec3(second.normal) - normal_;
    across_ = {glm::cross(first_, second_), glm::cross(first_, second_normal_) + glm::cross(first_normal_, second_),
               glm::cross(first_normal_, second_normal_)};
    for (std::size_t k = 0; k < across_.size(); ++k)
        rise_[k] = glm::dot(normal_, across_[k]);
    const glm::dvec2 texels(scale.columns, scale.rows);
    texel_ = glm::dvec2(corner.uv) * texels - 0.5;
    first_texel_ = glm::dvec2(first.uv) * texels - 0.5 - texel_;
    second_texel_ = glm::dvec2(second.uv) * texels - 0.5 - texel_;
    const double area = cross_of(first_texel_, second_texel_);
    has_area_ = area != 0 && glm::dot(across_[0], across_[0]) > 0;
    if (!has_area_) return;
    const std::array<glm::dvec2, 3> places = texel_corners();
    const double turn = area > 0 ? 1 : -1;
    for (std::size_t side = 0; side < sides_.size(); ++side)
        sides_[side] = turn * line_through(places[side], places[(side + 1) % 3]);
}

bool Prism::is_folded(double lowest) const {
    for (const glm::dvec2 place : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)}) {
        const glm::dvec3 normal = linear_normal(place);
        const double at_base = glm::dot(across_[0], normal);
        const double first = glm::dot(across_[1], normal);
        const double second = glm::dot(across_[2], normal);
        // The control points of the quadratic bound it.
        const double half_way = at_base + first * lowest / 2;
        const double at_lowest = at_base + lowest * (first + lowest * second);
        if (std::min({at_base, half_way, at_lowest}) <= 0) return true;
    }
    return false;
}

Prism::RayTerms Prism::terms(const Ray& ray) const {
    const glm::dvec3 from_corner = ray.origin - corner_;
    return {{glm::dot(from_corner, across_[0]), glm::dot(from_corner, across_[1]), glm::dot(from_corner, across_[2])},
            {glm::dot(ray.direction, across_[0]), glm::dot(ray.direction, across_[1]),
             glm::dot(ray.direction, across_[2])}};
}

double Prism::t_at(const RayTerms& ray, double m) const {
    const double still = ray.a[0] + m * (ray.a[1] + m * ray.a[2]) - m * (rise_[0] + m * (rise_[1] + m * rise_[2]));
    return -still / (ray.b[0] + m * (ray.b[1] + m * ray.b[2]));
}

bool Prism::locate(const Ray& ray, const RayTerms& terms, double t, double guess, Along& found) const {
    const double c0 = terms.a[0] + t * terms.b[0];
    const double c1 = terms.a[1] + t * terms.b[1] - rise_[0];
    const double c2 = terms.a[2] + t * terms.b[2] - rise_[1];
    const double c3 = -rise_[2];
    double m = guess;
    double by_m = 0;
    bool converged = false;
    constexpr int max_steps = 30;
    for (int step = 0; step < max_steps && !converged; ++step) {
        by_m = c1 + m * (2 * c2 + m * 3 * c3);
        const double change = (c0 + m * (c1 + m * (c2 + m * c3))) / by_m;
        m -= change;
        converged = std::abs(change) <= 1e-9 * (std::abs(m) + 1e-7);
    }
    // Seen from its front a space that is not inside out has g falling with m; the last step has left an error of the
    // square of its own.
    if (!converged || !(by_m < 0)) return false;
    const glm::dvec3 first = first_ + m * first_normal_;
    const glm::dvec3 second = second_ + m * second_normal_;
    const glm::dvec3 normal = across_[0] + m * (across_[1] + m * across_[2]);
    const double inverse = 1 / glm::dot(normal, normal);
    const glm::dvec3 to_first = glm::cross(second, normal) * inverse;
    const glm::dvec3 to_second = glm::cross(normal, first) * inverse;
    const glm::dvec3 place = ray.origin - corner_ + t * ray.direction - m * normal_;
    const double beta = glm::dot(place, to_first);
    const double gamma = glm::dot(place, to_second);
    const glm::dvec3 linear = normal_ + beta * first_normal_ + gamma * second_normal_;
    const double length = glm::length(linear);

    const double m_change = -(terms.b[0] + m * (terms.b[1] + m * terms.b[2])) / by_m;
    const glm::dvec3 rest = ray.direction - m_change * linear;
    const double beta_change = glm::dot(rest, to_first);
    const double gamma_change = glm::dot(rest, to_second);
    const glm::dvec3 linear_change = beta_change * first_normal_ + gamma_change * second_normal_;
    found.m = m;
    found.point = {texel_.x + beta * first_texel_.x + gamma * second_texel_.x,
                   texel_.y + beta * first_texel_.y + gamma * second_texel_.y, 1 + m * length * inverse_height_};
    found.change = {beta_change * first_texel_.x + gamma_change * second_texel_.x,
                    beta_change * first_texel_.y + gamma_change * second_texel_.y,
                    (m_change * length + m * glm::dot(linear, linear_change) / length) * inverse_height_};
    return true;
}

glm::dvec2 Prism::barycentric(glm::dvec2 texel) const {
    const glm::dvec2 from_corner = texel - texel_;
    const double area = cross_of(first_texel_, second_texel_);
    return {cross_of(from_corner, second_texel_) / area, cross_of(first_texel_, from_corner) / area};
}

}  // namespace reliefbench
