#include "scene/surface/generated_base.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cassert>
#include <cmath>
#include <numbers>

namespace reliefbench {

namespace {

struct SurfacePoint {
    glm::dvec3 position;
    glm::dvec3 normal;
};

/// sin(x)/x and (cos(x) − 1)/x, which for small x lose all their digits as they stand.
double sine_over(double x) {
    return x == 0 ? 1 : std::sin(x) / x;
}
double cosine_less_one_over(double x) {
    const double half = x / 2;
    return -std::sin(half) * sine_over(half);
}

SurfacePoint cylinder_point(double curvature, double a, double b) {
    const double angle = curvature * b;
    return {{a, b * sine_over(angle), b * cosine_less_one_over(angle)}, {0, std::sin(angle), std::cos(angle)}};
}

SurfacePoint sphere_point(double curvature, double a, double b) {
    const double r = std::hypot(a, b);
    const double angle = curvature * r;
    const double along = sine_over(angle);
    // sin(κr)·(a, b)/r.
    const double lean = curvature * along;
    return {{a * along, b * along, r * cosine_less_one_over(angle)}, {a * lean, b * lean, std::cos(angle)}};
}

SurfacePoint saddle_point(double curvature, double a, double b) {
    return {{a, b, curvature * (a * a - b * b) / 2}, glm::normalize(glm::dvec3(-curvature * a, curvature * b, 1.0))};
}

SurfacePoint point_of(const BaseSource& source, double a, double b) {
    switch (source.kind) {
        case BaseSource::Kind::cylinder:
            return cylinder_point(source.curvature, a, b);
        case BaseSource::Kind::sphere:
            return sphere_point(source.curvature, a, b);
        case BaseSource::Kind::saddle:
            return saddle_point(source.curvature, a, b);
        case BaseSource::Kind::plane:
            return {{a, b, 0}, {0, 0, 1}};
        case BaseSource::Kind::file:
            break;
    }
    assert(false);
    return {};
}

const char* word_of(BaseSource::Kind kind) {
    return kind == BaseSource::Kind::plane      ? "plane"
           : kind == BaseSource::Kind::cylinder ? "cylinder"
           : kind == BaseSource::Kind::sphere   ? "sphere"
                                                : "saddle";
}

}  // namespace

double max_curvature(BaseSource::Kind kind) {
    return kind == BaseSource::Kind::cylinder ? 2 * std::numbers::pi
           : kind == BaseSource::Kind::sphere ? std::numbers::pi * std::numbers::sqrt2
                                              : std::numeric_limits<double>::infinity();
}

std::string curvature_problem(const BaseSource& source) {
    const double largest = max_curvature(source.kind);
    if (!source.is_generated() || std::abs(source.curvature) <= largest) return {};
    return fmt::format("a {} of curvature {} would overlap itself; from {:.4f} to {:.4f} it does not",
                       word_of(source.kind), source.curvature, -largest, largest);
}

std::string folding_problem(const BaseSource& source, double height_scale) {
    if (!source.is_generated()) return {};
    const bool both_ways = source.kind == BaseSource::Kind::saddle;
    const double towards_floor = both_ways ? std::abs(source.curvature) : source.curvature;
    if (towards_floor * height_scale < 1) return {};
    return fmt::format(
        "a relief of height scale {} folds on a {} of curvature {}: their product has to stay below 1; lower either",
        height_scale, word_of(source.kind), source.curvature);
}

BaseMesh generate_base(const BaseSource& source) {
    assert(source.kind != BaseSource::Kind::file && source.segments > 0);
    BaseMesh mesh;
    mesh.name = word_of(source.kind);
    mesh.is_unit_square = true;
    const auto segments = static_cast<std::uint32_t>(source.segments);
    const std::uint32_t per_row = segments + 1;
    mesh.vertices.reserve(std::size_t{per_row} * per_row);
    for (std::uint32_t row = 0; row < per_row; ++row) {
        for (std::uint32_t column = 0; column < per_row; ++column) {
            const double u = static_cast<double>(column) / segments;
            const double v = static_cast<double>(row) / segments;
            const SurfacePoint point = point_of(source, u - 0.5, v - 0.5);
            mesh.vertices.push_back({glm::vec3(point.position), glm::vec3(point.normal), glm::vec2(u, v)});
        }
    }
    mesh.triangles.reserve(2 * std::size_t{segments} * segments);
    for (std::uint32_t row = 0; row < segments; ++row) {
        for (std::uint32_t column = 0; column < segments; ++column) {
            const std::uint32_t corner = row * per_row + column;
            mesh.triangles.push_back({corner, corner + 1, corner + per_row + 1});
            mesh.triangles.push_back({corner, corner + per_row + 1, corner + per_row});
        }
    }
    mesh.charts.assign(mesh.triangles.size(), 0);
    mesh.chart_periods.assign(1, glm::vec2(0));
    return mesh;
}

}  // namespace reliefbench
