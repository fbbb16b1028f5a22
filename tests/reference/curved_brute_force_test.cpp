// The smooth cylinder and sphere, their inverses and marched rays are worked out here from their definitions alone:
// this file includes no header of the scene or reference layers, and reaches them through plain numbers only.
#include "reference/bridge.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace {

using Point = std::array<double, 3>;
using Kind = bridge::Base::Kind;

constexpr double height_scale = 0.05;
constexpr int map_side = 24;
/// Rays along each side of a picture, and steps of each march.
constexpr int rays_a_side = 4;
constexpr int march_steps = 100'000;
/// The coarsest of three meshes, each with twice the segments of the one before. From some 500 segments on the facets'
/// sag is no more than what single precision leaves of their vertices, 1e-7, and falls no further.
constexpr int first_segments = 64;

struct CurvedMap {
    std::string name;
    std::vector<float> heights;

    bridge::Map plain() const { return {heights.data(), map_side, map_side, height_scale, 1, false}; }
};

CurvedMap map_of(const std::string& name, const std::function<double(int, int)>& height) {
    CurvedMap map{name, {}};
    for (int row = 0; row < map_side; ++row) {
        for (int column = 0; column < map_side; ++column)
            map.heights.push_back(static_cast<float>(height(column, row)));
    }
    return map;
}

std::vector<CurvedMap> three_maps() {
    constexpr double turn = 2 * std::numbers::pi / map_side;
    return {
        map_of("hills", [](int i, int j) { return 0.5 + 0.3 * std::sin(turn * i) + 0.15 * std::cos(2 * turn * j); }),
        map_of("hash",
               [](int i, int j) {
                   return static_cast<double>(
                              (static_cast<unsigned>(i) * 2654435761u + static_cast<unsigned>(j) * 40503u * 65537u) >>
                                  16 &
                              255u) /
                          255;
               }),
        map_of("tiles", [](int i, int j) { return i % 6 < 4 && j % 8 < 6 ? 1.0 : 0.25; })};
}

double map_height(const CurvedMap& map, double u, double v) {
    const double x = u * map_side - 0.5;
    const double y = v * map_side - 0.5;
    const double i = std::floor(x);
    const double j = std::floor(y);
    const auto texel = [&](double column, double row) {
        const int wrapped_column = (static_cast<int>(column) + map_side) % map_side;
        const int wrapped_row = (static_cast<int>(row) + map_side) % map_side;
        return static_cast<double>(map.heights[static_cast<std::size_t>(wrapped_row * map_side + wrapped_column)]);
    };
    const double a = x - i;
    const double b = y - j;
    return (texel(i, j) * (1 - a) + texel(i + 1, j) * a) * (1 - b) +
           (texel(i, j + 1) * (1 - a) + texel(i + 1, j + 1) * a) * b;
}

/// Patch coordinates and the signed distance along the normal.
struct Inverse {
    double u, v, w;
};

/// All that P + w·N can be on a smooth base lies at the distance |1/κ + w| from its axis or centre.
Inverse inverse_of(Kind kind, double curvature, const Point& point) {
    const double radius = 1 / curvature;
    const double sign = curvature > 0 ? 1 : -1;
    const double up = point[2] + radius;
    if (kind == Kind::cylinder) {
        const double angle = std::atan2(sign * point[1], sign * up);
        return {point[0] + 0.5, angle / curvature + 0.5, sign * std::hypot(point[1], up) - radius};
    }
    const double beside = std::hypot(point[0], point[1]);
    const double way = sign * std::atan2(beside, sign * up) / curvature;
    const double scale = beside > 0 ? way / beside : 1;
    return {point[0] * scale + 0.5, point[1] * scale + 0.5, sign * std::hypot(beside, up) - radius};
}

Point point_of(Kind kind, double curvature, double u, double v, double w) {
    const double a = u - 0.5;
    const double b = v - 0.5;
    const double out = 1 / curvature + w;
    if (kind == Kind::cylinder)
        return {a, out * std::sin(curvature * b), out * std::cos(curvature * b) - 1 / curvature};
    const double way = std::hypot(a, b);
    const double beside = way > 0 ? out * std::sin(curvature * way) / way : out * curvature;
    return {beside * a, beside * b, out * std::cos(curvature * way) - 1 / curvature};
}

/// Around all of the relief: its points on a grid, and what lies between them.
struct Bounds {
    Point low{1, 1, 1};
    Point high{-1, -1, -1};
};

Bounds bounds_of(Kind kind, double curvature) {
    constexpr int steps = 64;
    constexpr double margin = 0.01;
    Bounds bounds;
    for (int index = 0; index < (steps + 1) * (steps + 1) * 2; ++index) {
        const int place = index / 2;
        const Point point =
            point_of(kind, curvature, static_cast<double>(place % (steps + 1)) / steps,
                     static_cast<double>(place / (steps + 1)) / steps, index % 2 == 0 ? 0 : -height_scale);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            bounds.low[axis] = std::min(bounds.low[axis], point[axis] - margin);
            bounds.high[axis] = std::max(bounds.high[axis], point[axis] + margin);
        }
    }
    return bounds;
}

struct CurvedRay {
    Point origin;
    Point direction;

    Point at(double t) const {
        return {origin[0] + t * direction[0], origin[1] + t * direction[1], origin[2] + t * direction[2]};
    }
};

struct MarchedHit {
    double u, v, h, t;
};

class March {
public:
    March(const CurvedMap& map, Kind kind, double curvature)
        : map_(map), kind_(kind), curvature_(curvature), bounds_(bounds_of(kind, curvature)) {}

    /// The first step that begins above the sheet and ends below it, both over the unit square, halved.
    std::optional<MarchedHit> first_hit(const CurvedRay& ray) const {
        double first = 0;
        double last = 10;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double to_low = (bounds_.low[axis] - ray.origin[axis]) / ray.direction[axis];
            const double to_high = (bounds_.high[axis] - ray.origin[axis]) / ray.direction[axis];
            first = std::max(first, std::min(to_low, to_high));
            last = std::min(last, std::max(to_low, to_high));
        }
        if (first >= last) return std::nullopt;
        double before = first;
        bool was_above = is_above(ray, first).value_or(false);
        for (int step = 1; step <= march_steps; ++step) {
            const double t = first + (last - first) * step / march_steps;
            const std::optional<bool> above = is_above(ray, t);
            if (was_above && above && !*above) return halved(ray, before, t);
            was_above = above.value_or(false);
            before = t;
        }
        return std::nullopt;
    }

private:
    double clearance(const Inverse& at) const { return at.w - (map_height(map_, at.u, at.v) - 1) * height_scale; }

    /// Empty beside the unit square.
    std::optional<bool> is_above(const CurvedRay& ray, double t) const {
        const Inverse at = inverse_of(kind_, curvature_, ray.at(t));
        if (at.u < 0 || at.u > 1 || at.v < 0 || at.v > 1) return std::nullopt;
        return clearance(at) >= 0;
    }

    MarchedHit halved(const CurvedRay& ray, double above, double below) const {
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = (above + below) / 2;
            (clearance(inverse_of(kind_, curvature_, ray.at(middle))) >= 0 ? above : below) = middle;
        }
        const Inverse at = inverse_of(kind_, curvature_, ray.at(above));
        return {at.u, at.v, 1 + at.w / height_scale, above};
    }

    const CurvedMap& map_;
    Kind kind_;
    double curvature_;
    Bounds bounds_;
};

/// From an eye towards points of the base around its centre: fewer of those that lie behind its outline the more it is
/// curved.
std::vector<CurvedRay> rays_at(double view_angle, Kind kind, double curvature) {
    const double reach = 0.86 / std::max(1.0, std::abs(curvature));
    const double theta = view_angle * std::numbers::pi / 180;
    const double phi = -1.1;
    const Point eye{1.5 * std::sin(theta) * std::cos(phi), 1.5 * std::sin(theta) * std::sin(phi),
                    1.5 * std::cos(theta)};
    std::vector<CurvedRay> rays;
    for (int j = 0; j < rays_a_side; ++j) {
        for (int i = 0; i < rays_a_side; ++i) {
            const Point target = point_of(kind, curvature, 0.5 + reach * ((i + 0.53) / rays_a_side - 0.5),
                                          0.5 + reach * ((j + 0.47) / rays_a_side - 0.5), 0);
            Point along{};
            double squares = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                along[axis] = target[axis] - eye[axis];
                squares += along[axis] * along[axis];
            }
            for (double& component : along)
                component /= std::sqrt(squares);
            rays.push_back({eye, along});
        }
    }
    return rays;
}

std::vector<MarchedHit> traced(const CurvedMap& map, const bridge::Base& base, const std::vector<CurvedRay>& rays) {
    std::vector<double> numbers;
    for (const CurvedRay& ray : rays) {
        numbers.insert(numbers.end(), ray.origin.begin(), ray.origin.end());
        numbers.insert(numbers.end(), ray.direction.begin(), ray.direction.end());
    }
    std::vector<double> hits(4 * rays.size());
    bridge::trace_curved(map.plain(), base, numbers.data(), static_cast<int>(rays.size()), hits.data());
    std::vector<MarchedHit> found;
    for (std::size_t ray = 0; ray < rays.size(); ++ray)
        found.push_back({hits[4 * ray], hits[4 * ray + 1], hits[4 * ray + 2], hits[4 * ray + 3]});
    return found;
}

/// UV distances in texels of one ray from what the smooth surface shows, by mesh from the coarsest on.
using RayDifferences = std::array<double, 3>;

/// Empty where the ray meets nothing on any of them, or its hit comes, goes or jumps by more than half a texel: it
/// passes an outline, and the facets' outline is another.
std::optional<RayDifferences> differences_of(const std::optional<MarchedHit>& smooth,
                                             const std::array<MarchedHit, 3>& faceted) {
    RayDifferences differences{};
    for (std::size_t level = 0; level < faceted.size(); ++level) {
        const MarchedHit& hit = faceted[level];
        if (!smooth || hit.t < 0) return std::nullopt;
        differences[level] = std::hypot(smooth->u - hit.u, smooth->v - hit.v) * map_side;
        if (differences[level] > 0.5) return std::nullopt;
    }
    return differences;
}

/// Over rays, but for the twentieth that differ most: they are about to pass an outline, where differences go with the
/// root of the sag.
RayDifferences means_of(std::vector<RayDifferences> differences) {
    std::ranges::sort(differences, std::greater{}, [](const RayDifferences& ray) { return ray[0]; });
    const std::size_t left_out = differences.size() / 20;
    RayDifferences means{};
    for (std::size_t ray = left_out; ray < differences.size(); ++ray) {
        for (std::size_t level = 0; level < means.size(); ++level)
            means[level] += differences[ray][level] / static_cast<double>(differences.size() - left_out);
    }
    return means;
}

class CurvedBruteForce : public ::testing::TestWithParam<std::tuple<Kind, double>> {};

TEST_P(CurvedBruteForce, FacetsComeToTheSmoothSurfaceAtSecondOrder) {
    const auto [kind, curvature] = GetParam();
    std::vector<RayDifferences> compared;
    int outlines = 0;
    for (const CurvedMap& map : three_maps()) {
        std::vector<CurvedRay> rays;
        for (const double angle : {30.0, 60.0, 75.0}) {
            const std::vector<CurvedRay> of_angle = rays_at(angle, kind, curvature);
            rays.insert(rays.end(), of_angle.begin(), of_angle.end());
        }
        std::array<std::vector<MarchedHit>, 3> faceted;
        for (std::size_t level = 0; level < faceted.size(); ++level)
            faceted[level] = traced(map, {kind, curvature, first_segments << level}, rays);
        const March march(map, kind, curvature);
        for (std::size_t ray = 0; ray < rays.size(); ++ray) {
            const std::optional<MarchedHit> smooth = march.first_hit(rays[ray]);
            const std::array<MarchedHit, 3> hits{faceted[0][ray], faceted[1][ray], faceted[2][ray]};
            if (const auto differences = differences_of(smooth, hits)) {
                compared.push_back(*differences);
            } else {
                outlines += smooth || hits[0].t >= 0 || hits[1].t >= 0 || hits[2].t >= 0 ? 1 : 0;
            }
        }
    }
    ASSERT_GE(compared.size(), 90U);
    EXPECT_LE(outlines, 3) << "rays that pass an outline, of " << compared.size();
    const RayDifferences means = means_of(compared);
    for (std::size_t level = 0; level + 1 < means.size(); ++level) {
        EXPECT_NEAR(means[level] / means[level + 1], 4, 0.5)
            << "from " << (first_segments << level) << " segments on, of " << means[level] << " texels";
    }
    EXPECT_LE(std::abs(4 * means[2] - means[1]) / 3, 1e-4) << "texels, extrapolated";
}

INSTANTIATE_TEST_SUITE_P(Bases, CurvedBruteForce,
                         ::testing::Combine(::testing::Values(Kind::cylinder, Kind::sphere),
                                            ::testing::Values(-2.0, 1.0, 4.0)),
                         [](const auto& of) {
                             const double curvature = std::get<1>(of.param);
                             return fmt::format("{}{}{:.0f}Tenths",
                                                std::get<0>(of.param) == Kind::cylinder ? "Cylinder" : "Sphere",
                                                curvature < 0 ? "Minus" : "", std::abs(curvature) * 10);
                         });

}  // namespace
