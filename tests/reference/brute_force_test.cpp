// Heights, camera rays and hits are worked out here from their definitions alone: this file includes no header of the
// scene or reference layers, and reaches them through plain numbers only.
#include "reference/bridge.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace {

using Vector = std::array<double, 3>;

struct TestRay {
    Vector origin;
    Vector direction;
};

struct TestHit {
    double u, v, h, t;
};

struct TestMap {
    int width;
    int height;
    std::vector<float> heights;
    double height_scale;
    double tiling;
    bool repeat;

    bridge::Map plain() const { return {heights.data(), width, height, height_scale, tiling, repeat}; }
};

/// xorshift64*, so that not even the random numbers are shared.
class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : state_(seed) {}
    double operator()(double low, double high) {
        state_ ^= state_ >> 12;
        state_ ^= state_ << 25;
        state_ ^= state_ >> 27;
        return low + (high - low) * static_cast<double>((state_ * 2685821657736338717ull) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_;
};

/// h at patch coordinates: texel centres at (i + ½)/N of one tile, bilinear between them, repeating.
double height_at(const TestMap& map, double u, double v) {
    const double x = u * map.tiling * map.width - 0.5;
    const double y = v * map.tiling * map.height - 0.5;
    const auto texel = [&](double i, double j) {
        const double column = i - map.width * std::floor(i / map.width);
        const double row = j - map.height * std::floor(j / map.height);
        return static_cast<double>(map.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) +
                                               static_cast<std::size_t>(column)]);
    };
    const double i = std::floor(x);
    const double j = std::floor(y);
    const double a = x - i;
    const double b = y - j;
    return texel(i, j) * (1 - a) * (1 - b) + texel(i + 1, j) * a * (1 - b) + texel(i, j + 1) * (1 - a) * b +
           texel(i + 1, j + 1) * a * b;
}

/// Height of the ray above the surface, in world units.
double clearance(const TestMap& map, const TestRay& ray, double t) {
    const double x = ray.origin[0] + t * ray.direction[0];
    const double y = ray.origin[1] + t * ray.direction[1];
    const double z = ray.origin[2] + t * ray.direction[2];
    return z - (height_at(map, x + 0.5, y + 0.5) - 1) * map.height_scale;
}

struct Interval {
    double first;
    double last;
};

/// From the slab's top (or side) to just beneath its bottom; empty where the ray passes beside the clipped sheet.
Interval slab_interval(const TestMap& map, const TestRay& ray) {
    Interval slab{-ray.origin[2] / ray.direction[2], (-1.001 * map.height_scale - ray.origin[2]) / ray.direction[2]};
    for (int axis = 0; axis < 2 && !map.repeat; ++axis) {
        if (ray.direction[axis] == 0) {
            if (std::abs(ray.origin[axis]) > 0.5) slab.last = slab.first;
            continue;
        }
        const double to_low = (-0.5 - ray.origin[axis]) / ray.direction[axis];
        const double to_high = (0.5 - ray.origin[axis]) / ray.direction[axis];
        slab.first = std::max(slab.first, std::min(to_low, to_high));
        slab.last = std::min(slab.last, std::max(to_low, to_high));
    }
    return slab;
}

/// Marches through the slab in 100,000 steps; the first step that begins above the sheet and ends below it is bisected.
std::optional<TestHit> march(const TestMap& map, const TestRay& ray) {
    constexpr int steps = 100'000;
    const auto [first, last] = slab_interval(map, ray);
    if (first >= last) return std::nullopt;
    double above = first;
    bool was_above = clearance(map, ray, first) >= 0;
    for (int step = 1; step <= steps; ++step) {
        const double t = first + (last - first) * step / steps;
        const bool is_above = clearance(map, ray, t) >= 0;
        if (was_above && !is_above) {
            double below = t;
            for (int halving = 0; halving < 60; ++halving) {
                const double middle = (above + below) / 2;
                (clearance(map, ray, middle) >= 0 ? above : below) = middle;
            }
            const double u = ray.origin[0] + above * ray.direction[0] + 0.5;
            const double v = ray.origin[1] + above * ray.direction[1] + 0.5;
            return TestHit{u, v, 1 + (ray.origin[2] + above * ray.direction[2]) / map.height_scale, above};
        }
        was_above = is_above;
        above = t;
    }
    return std::nullopt;
}

std::optional<TestHit> trace_exact(const TestMap& map, const TestRay& ray) {
    double hit[4];
    if (!bridge::trace_exact(map.plain(), ray.origin.data(), ray.direction.data(), hit)) return std::nullopt;
    return TestHit{hit[0], hit[1], hit[2], hit[3]};
}

bool agree(const std::optional<TestHit>& a, const std::optional<TestHit>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    // Both solve in double; where the ray grazes the sheet, rounding of 1e-16 in the height grows by the square root.
    constexpr double tolerance = 1e-8;
    return std::abs(a->t - b->t) < tolerance && std::abs(a->u - b->u) < tolerance &&
           std::abs(a->v - b->v) < tolerance && std::abs(a->h - b->h) * 0.05 < tolerance;
}

using Tracer = std::function<std::optional<TestHit>(const TestMap&, const TestRay&)>;

struct Comparison {
    int rays = 0;
    int hits = 0;
    int disagreements = 0;
    int side_entries = 0;
    int from_beneath = 0;
    std::string first_disagreement;
};

std::string text(const std::optional<TestHit>& hit) {
    return hit ? fmt::format("({}, {}, {}) at {}", hit->u, hit->v, hit->h, hit->t) : "miss";
}

Comparison compare(const TestMap& map, const std::vector<TestRay>& rays, const Tracer& tracer) {
    Comparison result;
    for (const TestRay& ray : rays) {
        const auto expected = march(map, ray);
        const auto found = tracer(map, ray);
        ++result.rays;
        result.hits += expected.has_value();
        const double entry = slab_interval(map, ray).first;
        result.side_entries += entry > -ray.origin[2] / ray.direction[2];
        result.from_beneath += clearance(map, ray, entry) < -1e-9;
        if (agree(expected, found)) continue;
        if (result.disagreements++ == 0)
            result.first_disagreement = fmt::format("{} but traced {}", text(expected), text(found));
    }
    return result;
}

/// Rays through random points of the slab, every other one grazing: many of those enter through the slab's sides.
std::vector<TestRay> random_rays(int count, double height_scale, std::uint64_t seed) {
    Numbers number(seed);
    std::vector<TestRay> rays;
    for (int index = 0; index < count; ++index) {
        const double theta = (index % 2 == 0 ? number(78, 89) : number(0, 78)) * std::numbers::pi / 180;
        const double phi = number(-std::numbers::pi, std::numbers::pi);
        const Vector direction{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), -std::cos(theta)};
        const Vector target{number(-0.5, 0.5), number(-0.5, 0.5), -height_scale * number(0, 1)};
        const double back = (number(0.01, 1) - target[2]) / std::cos(theta);
        rays.push_back(
            {{target[0] - back * direction[0], target[1] - back * direction[1], target[2] - back * direction[2]},
             direction});
    }
    return rays;
}

TestMap random_map(int width, int height, double height_scale, double tiling, bool repeat, std::uint64_t seed) {
    Numbers number(seed);
    TestMap map{width, height, {}, height_scale, tiling, repeat};
    for (int texel = 0; texel < width * height; ++texel)
        map.heights.push_back(static_cast<float>(number(0, 1)));
    return map;
}

/// Hills with a cliff and single-texel towers on them.
TestMap built_map(int width, int height, double height_scale, double tiling, bool repeat) {
    TestMap map{width, height, {}, height_scale, tiling, repeat};
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const double x = 2 * std::numbers::pi * i / width;
            const double y = 2 * std::numbers::pi * j / height;
            double h = 0.4 + 0.2 * std::sin(x) * std::cos(2 * y) + (2 * i < width ? 0.2 : 0.0);
            if (i % 7 == 3 && j % 5 == 1) h = 1;
            map.heights.push_back(static_cast<float>(h));
        }
    }
    return map;
}

std::vector<TestMap> maps(bool repeat) {
    return {random_map(7, 5, 0.1, 1, repeat, 11), random_map(16, 16, 0.05, 3, repeat, 12),
            built_map(48, 31, 0.2, 1, repeat), built_map(20, 64, 0.05, 1.7, repeat),
            random_map(1, 3, 0.3, 2, repeat, 13)};
}

TEST(ExactTracerAgainstBruteForce, ClippedReliefAgrees) {
    int side_entries = 0;
    int from_beneath = 0;
    for (const TestMap& map : maps(false)) {
        const Comparison result = compare(map, random_rays(120, map.height_scale, 21), trace_exact);
        EXPECT_EQ(result.disagreements, 0) << map.width << "x" << map.height << ": " << result.first_disagreement;
        EXPECT_GT(result.hits, 40);
        EXPECT_LT(result.hits, result.rays);
        side_entries += result.side_entries;
        from_beneath += result.from_beneath;
    }
    EXPECT_GT(side_entries, 150);
    EXPECT_GT(from_beneath, 50);
}

TEST(ExactTracerAgainstBruteForce, RepeatingReliefAgrees) {
    for (const TestMap& map : maps(true)) {
        const Comparison result = compare(map, random_rays(90, map.height_scale, 22), trace_exact);
        EXPECT_EQ(result.disagreements, 0) << map.width << "x" << map.height << ": " << result.first_disagreement;
        EXPECT_EQ(result.hits, result.rays) << "the relief goes on for ever: every ray must hit it";
    }
}

/// A grazing ray passes over one tower's top and ends on the next hill: hit distances jump there.
TEST(ExactTracerAgainstBruteForce, SilhouettesAgree) {
    TestMap map = built_map(48, 31, 0.1, 1, true);
    std::vector<TestRay> rays;
    const double theta = 82 * std::numbers::pi / 180;
    const Vector direction{std::sin(theta), 0.0, -std::cos(theta)};
    const double tower_y = (1 + 0.5) / 31 - 0.5;
    for (int index = 0; index < 100; ++index) {
        // Past the tower's side, and over its top, by ever less.
        const double aside = std::pow(0.8, index / 2) / 31 * (index % 2 == 0 ? 1 : -1);
        rays.push_back({{-0.49 + 0.001 * index, tower_y + aside, 0.0}, direction});
    }
    const Comparison result = compare(map, rays, trace_exact);
    EXPECT_EQ(result.disagreements, 0) << result.first_disagreement;
}

TEST(ExactTracerAgainstBruteForce, MutationsAreNoticed) {
    for (const bool repeat : {false, true}) {
        const TestMap map = random_map(16, 12, 0.1, 1, repeat, 31);
        const std::vector<TestRay> rays = random_rays(60, map.height_scale, 32);
        ASSERT_EQ(compare(map, rays, trace_exact).disagreements, 0);

        const Tracer half_texel_shift = [](const TestMap& given, TestRay ray) {
            ray.origin[0] += 0.5 / given.width;
            auto hit = trace_exact(given, ray);
            if (hit) hit->u -= 0.5 / given.width;
            return hit;
        };
        EXPECT_GT(compare(map, rays, half_texel_shift).disagreements, 30);

        const Tracer flipped_v = [](const TestMap& given, const TestRay& ray) {
            TestMap flipped = given;
            for (int row = 0; row < given.height; ++row) {
                std::copy_n(given.heights.begin() + (given.height - 1 - row) * given.width, given.width,
                            flipped.heights.begin() + row * given.width);
            }
            return trace_exact(flipped, ray);
        };
        EXPECT_GT(compare(map, rays, flipped_v).disagreements, 30);
    }
}

/// A map inside a frame of one texel, and the ray squeezed so that it meets the inner part as it met the map.
std::optional<TestHit> trace_framed(const TestMap& map, const TestRay& ray, bool frame_wraps) {
    TestMap framed{map.width + 2, map.height + 2, {}, map.height_scale, 1, false};
    for (int j = -1; j <= map.height; ++j) {
        for (int i = -1; i <= map.width; ++i) {
            const int column = frame_wraps ? (i + map.width) % map.width : std::clamp(i, 0, map.width - 1);
            const int row = frame_wraps ? (j + map.height) % map.height : std::clamp(j, 0, map.height - 1);
            framed.heights.push_back(map.heights[static_cast<std::size_t>(row * map.width + column)]);
        }
    }
    const double squeeze_x = static_cast<double>(map.width) / framed.width;
    const double squeeze_y = static_cast<double>(map.height) / framed.height;
    TestRay squeezed = ray;
    squeezed.origin[0] *= squeeze_x;
    squeezed.origin[1] *= squeeze_y;
    squeezed.direction[0] *= squeeze_x;
    squeezed.direction[1] *= squeeze_y;
    auto hit = trace_exact(framed, squeezed);
    if (!hit) return std::nullopt;
    hit->u = (hit->u - 0.5) / squeeze_x + 0.5;
    hit->v = (hit->v - 0.5) / squeeze_y + 0.5;
    const bool inside = hit->u >= 0 && hit->u <= 1 && hit->v >= 0 && hit->v <= 1;
    return inside ? hit : std::nullopt;
}

TEST(ExactTracerAgainstBruteForce, ABorderThatDoesNotWrapIsNoticed) {
    const TestMap map = random_map(6, 4, 0.05, 1, false, 41);
    std::vector<TestRay> rays;
    Numbers number(42);
    for (int index = 0; index < 100; ++index) {
        const double u = index % 2 == 0 ? number(0, 0.08) : number(0.1, 0.9);
        const double v = index % 2 == 0 ? number(0.1, 0.9) : number(0.88, 1);
        rays.push_back({{u - 0.5, v - 0.5, 0.0}, {0.0, 0.0, -1.0}});
    }
    const auto wrapping = [](const TestMap& given, const TestRay& ray) { return trace_framed(given, ray, true); };
    const auto clamping = [](const TestMap& given, const TestRay& ray) { return trace_framed(given, ray, false); };
    EXPECT_EQ(compare(map, rays, wrapping).disagreements, 0);
    EXPECT_GT(compare(map, rays, clamping).disagreements, 50);
}

TEST(ExactTracerAnalytic, TiltedPlane) {
    // h = 0.125 + i/32 + j/64: a plane between the outermost texel centres.
    TestMap map{16, 16, {}, 0.2, 1, false};
    for (int j = 0; j < 16; ++j) {
        for (int i = 0; i < 16; ++i)
            map.heights.push_back(0.125f + static_cast<float>(i) / 32 + static_cast<float>(j) / 64);
    }
    // z = H (h − 1), h = 0.125 + (16 u − ½)/32 + (16 v − ½)/64
    const double per_u = 0.2 * 16 / 32;
    const double per_v = 0.2 * 16 / 64;
    const double at_centre = 0.2 * (0.125 + 7.5 / 32 + 7.5 / 64 - 1);
    int inside = 0;
    for (const TestRay& ray : random_rays(300, 0.2, 51)) {
        const auto& [o, d] = ray;
        const double t = (at_centre + per_u * o[0] + per_v * o[1] - o[2]) / (d[2] - per_u * d[0] - per_v * d[1]);
        const double u = o[0] + t * d[0] + 0.5;
        const double v = o[1] + t * d[1] + 0.5;
        const double entry_t = -o[2] / d[2];
        const auto on_plane = [](double coordinate) { return std::abs(coordinate) < 7.5 / 16; };
        if (!on_plane(u - 0.5) || !on_plane(v - 0.5)) continue;
        if (!on_plane(o[0] + entry_t * d[0]) || !on_plane(o[1] + entry_t * d[1])) continue;
        ++inside;
        const auto hit = trace_exact(map, ray);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, t, 1e-13);
        EXPECT_NEAR(hit->u, u, 1e-13);
        EXPECT_NEAR(hit->v, v, 1e-13);
        EXPECT_NEAR(hit->h, 1 + (o[2] + t * d[2]) / 0.2, 1e-12);
    }
    EXPECT_GT(inside, 60);
}

TEST(ExactTracerAnalytic, OneCellHyperbolicParaboloid) {
    // Texels 1 0 / 0 1: between their centres h = 1 − a − b + 2ab with a = 2u − ½, b = 2v − ½.
    const TestMap map{2, 2, {1, 0, 0, 1}, 0.25, 1, false};
    const auto trace_from = [&](double a, double b, double da, double db) {
        const TestRay ray{{(a + 0.5) / 2 - 0.5, (b + 0.5) / 2 - 0.5, 0.0}, {da / 2, db / 2, -0.25}};
        const auto hit = trace_exact(map, ray);
        return hit ? hit->t : -1.0;  // t = s: the ray is at h = 1 − s
    };
    // Straight down: 1 − s = h.
    EXPECT_NEAR(trace_from(0.5, 0.5, 0, 0), 0.5, 1e-15);
    EXPECT_NEAR(trace_from(0.25, 0.75, 0, 0), 1 - (1 - 1 + 2 * 0.25 * 0.75), 1e-15);
    // Along a = s at b = ¼: h = ¾ − s/2 = 1 − s, s = ½.
    EXPECT_NEAR(trace_from(0, 0.25, 1, 0), 0.5, 1e-15);
    // Along the diagonal a = b = ¼ + s/4: h = 1 − 2a + 2a² = 1 − s, s² + 6s − 3 = 0.
    EXPECT_NEAR(trace_from(0.25, 0.25, 0.25, 0.25), -3 + std::sqrt(12.0), 1e-14);
    // Across it, a = ¼ + s/2, b = ¾ − s/2: h = 2ab = 1 − s, s² − 3s + 5/4 = 0.
    EXPECT_NEAR(trace_from(0.25, 0.75, 0.5, -0.5), 0.5, 1e-14);
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

TestRay expected_ray(const bridge::View& view, int i, int j) {
    const double theta = view.view_angle * std::numbers::pi / 180;
    const double phi = view.azimuth * std::numbers::pi / 180;
    const Vector forward{-std::sin(theta) * std::cos(phi), -std::sin(theta) * std::sin(phi), -std::cos(theta)};
    if (!view.perspective) {
        return {{(i + 0.5) / view.width - 0.5, 1 - (j + 0.5) / view.height - 0.5, 0.0}, forward};
    }
    const Vector up{-std::cos(theta) * std::cos(phi), -std::cos(theta) * std::sin(phi), std::sin(theta)};
    const Vector right = cross(forward, up);
    const double extent = std::tan(view.fov * std::numbers::pi / 360);
    const double x = (2 * (i + 0.5) / view.width - 1) * extent * view.width / view.height;
    const double y = (1 - 2 * (j + 0.5) / view.height) * extent;
    TestRay ray;
    double length = 0;
    for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = -view.distance * forward[axis];
        ray.direction[axis] = forward[axis] + x * right[axis] + y * up[axis];
        length += ray.direction[axis] * ray.direction[axis];
    }
    for (double& component : ray.direction)
        component /= std::sqrt(length);
    return ray;
}

TEST(CameraAgainstDefinition, PixelRaysAgree) {
    for (const bool perspective : {false, true}) {
        for (const double theta : {0.0, 37.0, 80.0}) {
            const bridge::View view{perspective, theta, theta == 0 ? -90.0 : 25.0, 1.3, 50, 33, 21};
            for (int j = 0; j < view.height; ++j) {
                for (int i = 0; i < view.width; ++i) {
                    double origin[3];
                    double direction[3];
                    bridge::pixel_ray(view, i, j, origin, direction);
                    const TestRay expected = expected_ray(view, i, j);
                    for (int axis = 0; axis < 3; ++axis) {
                        ASSERT_NEAR(origin[axis], expected.origin[axis], 1e-14) << i << " " << j;
                        ASSERT_NEAR(direction[axis], expected.direction[axis], 1e-14) << i << " " << j;
                    }
                }
            }
        }
    }
}

/// One texel of 8×4 raised from 0 to 1.
TestMap raised_texel(int column, int row) {
    TestMap map{8, 4, std::vector<float>(32, 0.0f), 0.05, 1, false};
    map.heights[static_cast<std::size_t>(row * 8 + column)] = 1;
    return map;
}

struct Pixel {
    int i = -1;
    int j = -1;
    bool operator==(const Pixel&) const = default;
};

Pixel highest_pixel(const TestMap& map, const bridge::View& view, int subdivision) {
    std::vector<float> hits(static_cast<std::size_t>(4 * view.width * view.height));
    bridge::truth_image(map.plain(), view, subdivision, hits.data());
    Pixel pixel;
    float highest = -1;
    for (int index = 0; index < view.width * view.height; ++index) {
        const auto at = static_cast<std::size_t>(4 * index);
        if (hits[at + 3] >= 0 && hits[at + 2] > highest) {
            highest = hits[at + 2];
            pixel = {index % view.width, index / view.width};
        }
    }
    return pixel;
}

TEST(RaisedTexel, IsInItsPixelOfAPictureAsLargeAsTheMap) {
    const TestMap map = raised_texel(6, 1);
    const bridge::View view{false, 0, -90, 1.5, 45, 8, 4};
    for (const int subdivision : {0, 1, 4}) {
        std::vector<float> hits(4 * 32);
        bridge::truth_image(map.plain(), view, subdivision, hits.data());
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 8; ++i) {
                const auto at = static_cast<std::size_t>(4 * (j * 8 + i));
                // Row 1 from the bottom is row 2 from the top.
                const float h = i == 6 && j == 2 ? 1.0f : 0.0f;
                // The mesh counts in single precision, over a height scale of 0.05.
                const float tolerance = subdivision == 0 ? 1e-7f : 2e-6f;
                EXPECT_NEAR(hits[at], (static_cast<float>(i) + 0.5f) / 8, 1e-7f);
                EXPECT_NEAR(hits[at + 1], 1 - (static_cast<float>(j) + 0.5f) / 4, 1e-7f);
                EXPECT_NEAR(hits[at + 2], h, tolerance) << i << " " << j << " subdivision " << subdivision;
                EXPECT_NEAR(hits[at + 3], (1 - h) * 0.05f, tolerance);
            }
        }
    }
}

/// The pixel whose ray passes nearest to the raised texel's tip.
Pixel projected_tip(const bridge::View& view, int column, int row) {
    const Vector tip{(column + 0.5) / 8 - 0.5, (row + 0.5) / 4 - 0.5, 0.0};
    Pixel nearest;
    double least = 1e9;
    for (int j = 0; j < view.height; ++j) {
        for (int i = 0; i < view.width; ++i) {
            const auto [o, d] = expected_ray(view, i, j);
            const Vector away = cross({tip[0] - o[0], tip[1] - o[1], tip[2] - o[2]}, d);
            const double distance = std::hypot(away[0], away[1], away[2]);
            if (distance < least) {
                least = distance;
                nearest = {i, j};
            }
        }
    }
    return nearest;
}

TEST(RaisedTexel, IsWhereTheCameraProjectsIt) {
    for (const bool perspective : {false, true}) {
        for (const int subdivision : {0, 1, 4}) {
            const bridge::View view{perspective, 40, -60, 1.5, 45, 88, 68};
            EXPECT_EQ(highest_pixel(raised_texel(6, 1), view, subdivision), projected_tip(view, 6, 1))
                << perspective << " " << subdivision;
        }
    }
}

TEST(RaisedTexel, ReachesAcrossTheBorder) {
    // Raised at the right border; the first of 32 pixels lies at x = −⅜, and the last at x = 7⅜.
    const bridge::View view{false, 0, -90, 1.5, 45, 32, 4};
    for (const int subdivision : {0, 1, 4}) {
        std::vector<float> hits(4 * 32 * 4);
        bridge::truth_image(raised_texel(7, 1).plain(), view, subdivision, hits.data());
        const float* row = hits.data() + 4 * 32 * 2;
        EXPECT_NEAR(row[2], 0.375, 2e-6) << "a border that does not wrap gives 0";
        EXPECT_NEAR(row[4 * 31 + 2], 0.625, 2e-6) << "a border that does not wrap gives 1";
    }
}

TEST(RaisedTexel, IsElsewhereInMutatedTruths) {
    const bridge::View view{false, 0, -90, 1.5, 45, 88, 68};
    const Pixel expected = projected_tip(view, 6, 1);
    TestMap half_texel_shift = raised_texel(6, 1);
    half_texel_shift.heights[8 + 5] = 0.5f;
    half_texel_shift.heights[8 + 6] = 0.5f;
    for (const int subdivision : {0, 1}) {
        EXPECT_EQ(highest_pixel(raised_texel(6, 1), view, subdivision), expected);
        EXPECT_NE(highest_pixel(raised_texel(6, 2), view, subdivision), expected) << "flipped v";
        EXPECT_NE(highest_pixel(half_texel_shift, view, subdivision), expected);
    }
}

}  // namespace
