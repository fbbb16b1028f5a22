#include "reference/base_entries.hpp"
#include "reference/curved_tracer.hpp"
#include "reference/diced_mesh.hpp"
#include "reference/truth.hpp"
#include "scene/shading_normal.hpp"
#include "scene/surface/charts.hpp"
#include "support/closed_cylinder.hpp"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench {
namespace {

using Kind = BaseSource::Kind;

HeightMap procedural(const std::string& name, int side) {
    HeightMapSource source;
    source.name = name;
    source.size = {side, side};
    return load_height_map(source, HeightFormat::r16);
}

HeightMap map_from(int side, const std::function<double(int, int)>& height) {
    Image<float> heights({side, side});
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column)
            heights.at(column, row) = static_cast<float>(height(column, row));
    }
    return make_height_map(heights, HeightFormat::r32f, "made");
}

HeightMap hills(int side) {
    return map_from(side, [&](int i, int j) {
        const double turn = 2 * std::numbers::pi / side;
        return 0.5 + 0.3 * std::sin(turn * i) + 0.15 * std::cos(2 * turn * j + 1);
    });
}

HeightMap constant(float height) {
    return map_from(4, [&](int, int) { return height; });
}

BaseSurface generated(Kind kind, double curvature, int segments = 48) {
    return load_base({.kind = kind, .curvature = curvature, .segments = segments});
}

/// One triangle for each three corners.
BaseSurface base_of(std::vector<MeshVertex> vertices, std::vector<std::uint32_t> charts) {
    auto mesh = std::make_shared<BaseMesh>();
    mesh->name = "made";
    mesh->vertices = std::move(vertices);
    for (std::uint32_t triangle = 0; triangle < charts.size(); ++triangle)
        mesh->triangles.push_back({3 * triangle, 3 * triangle + 1, 3 * triangle + 2});
    mesh->charts = std::move(charts);
    mesh->chart_periods.resize(mesh->triangles.size(), glm::vec2(0));
    return {MeshBase{std::move(mesh)}};
}

/// The flat unit square at a height, both of its triangles with charts of their own.
BaseSurface flat_square(const std::function<glm::vec2(int triangle, glm::vec2 place)>& chart, float z = 0,
                        float half = 0.5F) {
    std::vector<MeshVertex> vertices;
    const std::array<glm::vec2, 6> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}};
    for (int index = 0; index < 6; ++index) {
        const glm::vec2 place = corners[static_cast<std::size_t>(index)] * half;
        vertices.push_back({{place.x, place.y, z}, {0, 0, 1}, chart(index / 3, place)});
    }
    return base_of(std::move(vertices), {0, 1});
}

View view_of(BaseSurface base, double angle = 60, Resolution resolution = {40, 40}) {
    View view;
    view.camera.view_angle = angle;
    view.camera.azimuth = -70;
    view.resolution = resolution;
    view.relief.base = std::move(base);
    return view;
}

Truth truth_of(const HeightMap& map, const View& view, const Lighting& lighting = {}) {
    return trace_exact_truth(map, load_albedo({}, map), view, lighting);
}

double texels_between(const Hit& a, const Hit& b, const HeightMap& map) {
    return std::hypot((a.u - b.u) * static_cast<float>(map.width()), (a.v - b.v) * static_cast<float>(map.height()));
}

TEST(CurvedTruth, OfHardlyAnyCurvatureIsThatOfThePlane) {
    for (const char* name : {"rock", "bricks", "waves"}) {
        const HeightMap map = procedural(name, 64);
        for (const Kind kind : {Kind::cylinder, Kind::sphere, Kind::saddle}) {
            for (const double angle : {0.0, 45.0, 75.0}) {
                View view = view_of(generated(kind, 1e-6), angle);
                const Truth curved = truth_of(map, view);
                view.relief.base = {};
                const Truth flat = truth_of(map, view);
                int ties = 0;
                for (std::size_t pixel = 0; pixel < flat.hits.texels.size(); ++pixel) {
                    // What lies about the border is in F of the one or the other as rounding will have it.
                    ties += flat.footprint.texels[pixel] != curved.footprint.texels[pixel] ? 1 : 0;
                    if (flat.footprint.texels[pixel] != in_footprint || curved.footprint.texels[pixel] != in_footprint)
                        continue;
                    const Hit& hit = curved.hits.texels[pixel];
                    ASSERT_EQ(hit.is_hit(), flat.hits.texels[pixel].is_hit()) << name << " " << angle;
                    if (!hit.is_hit()) continue;
                    ASSERT_LT(texels_between(hit, flat.hits.texels[pixel], map), 1e-3) << name << " " << angle;
                    ASSERT_NEAR(hit.t, flat.hits.texels[pixel].t, 1e-5);
                }
                EXPECT_LE(ties, 3) << name << " " << angle;
            }
        }
    }
}

/// Mean distance in texels, of rays that hit both and do not jump from one part of the relief to another.
double mean_difference(const CurvedTracer& exact, const DicedMesh& diced, const HeightMap& map, const View& view) {
    double sum = 0;
    int compared = 0;
    const PixelRays rays = pixel_rays(view);
    for (int j = 0; j < view.resolution.height; ++j) {
        for (int i = 0; i < view.resolution.width; ++i) {
            const auto a = exact.trace(rays.at(i, j));
            const auto b = diced.trace(rays.at(i, j));
            if (!a || !b) continue;
            const double texels = view.relief.tiling *
                                  std::hypot((a->hit.u - b->hit.u) * map.width(), (a->hit.v - b->hit.v) * map.height());
            if (texels > 0.5) continue;
            sum += texels;
            ++compared;
        }
    }
    EXPECT_GT(compared, static_cast<int>(view.resolution.pixels()) / 4);
    return sum / compared;
}

TEST(DicedMesh, ComesToTheExactTruthAtSecondOrder) {
    const HeightMap map = hills(8);
    for (const auto& [kind, curvature] :
         {std::pair(Kind::saddle, 1.5), std::pair(Kind::sphere, -2.0), std::pair(Kind::cylinder, 1.0)}) {
        View view = view_of(generated(kind, curvature, 2), 55, {64, 64});
        view.relief.tiling = 1.5;
        view.relief.height_scale = 0.1;
        const CurvedTracer exact(map, view.relief);
        std::vector<double> means;
        for (const int subdivision : {2, 4, 8})
            means.push_back(mean_difference(exact, DicedMesh(map, view.relief, subdivision), map, view));
        EXPECT_NEAR(means[0] / means[1], 4, 0.6) << curvature;
        EXPECT_NEAR(means[1] / means[2], 4, 0.6) << curvature;
        EXPECT_LT(means[2], 0.01) << curvature;
        EXPECT_EQ(exact.unresolved(), 0U);
    }
}

TEST(CurvedTruth, BlocksOfManyCellsGiveTheHitsOfSingleCells) {
    const HeightMap map = procedural("rock", 96);
    const View view = view_of(generated(Kind::sphere, 2, 6), 60, {64, 64});
    const CurvedTracer cells(map, view.relief);
    const CurvedTracer blocks(map, view.relief, 1000);
    EXPECT_GT(cells.pieces(), 8U * blocks.pieces());
    const PixelRays rays = pixel_rays(view);
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 64; ++i) {
            const auto a = cells.trace(rays.at(i, j));
            const auto b = blocks.trace(rays.at(i, j));
            ASSERT_EQ(a.has_value(), b.has_value()) << i << " " << j;
            ASSERT_NEAR(a ? a->hit.t : 0, b ? b->hit.t : 0, 1e-11) << i << " " << j;
        }
    }
    EXPECT_EQ(blocks.unresolved(), 0U);
}

/// Of a flat square whose chart is affine: a march over z = (h − 1)·H, first step from above to below.
std::optional<double> marched(const HeightMap& map, const Relief& relief, const Ray& ray,
                              const std::function<glm::dvec2(glm::dvec2)>& chart) {
    constexpr int steps = 5'000;
    const double first = -ray.origin.z / ray.direction.z;
    const double last = (-1.01 * relief.height_scale - ray.origin.z) / ray.direction.z;
    const auto above = [&](double t) {
        const glm::dvec3 point = ray.origin + t * ray.direction;
        const glm::dvec2 uv = relief.tiling * chart(glm::dvec2(point));
        return point.z - (map.sample(uv.x, uv.y) - 1) * relief.height_scale;
    };
    for (int step = 0; step < steps; ++step) {
        double low = first + (last - first) * step / steps;
        double high = first + (last - first) * (step + 1) / steps;
        if (above(low) < 0 || above(high) >= 0) continue;
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = (low + high) / 2;
            (above(middle) >= 0 ? low : high) = middle;
        }
        const glm::dvec3 point = ray.origin + low * ray.direction;
        if (std::abs(point.x) > 0.5 || std::abs(point.y) > 0.5) return std::nullopt;
        return low;
    }
    return std::nullopt;
}

TEST(CurvedTruth, StretchedSkewedAndMirroredChartsMoveTheReliefOnly) {
    const HeightMap map = procedural("rock", 32);
    const std::array<glm::dmat2, 4> charts{glm::dmat2(3, 0, 0, 1), glm::dmat2(1, 0.75, 0.5, 1.25),
                                           glm::dmat2(-1, 0, 0, 1), glm::dmat2(0, 2, 0.5, 0)};
    for (const glm::dmat2& chart : charts) {
        const auto uv = [&](glm::dvec2 place) { return chart * place + glm::dvec2(0.25, -0.5); };
        const View view =
            view_of(flat_square([&](int, glm::vec2 place) { return glm::vec2(uv(glm::dvec2(place))); }), 50);
        const Truth truth = truth_of(map, view);
        const PixelRays rays = pixel_rays(view);
        int compared = 0;
        for (int j = 0; j < view.resolution.height; ++j) {
            for (int i = 0; i < view.resolution.width; ++i) {
                if (truth.footprint.at(i, j) != in_footprint) continue;
                const Hit& hit = truth.hits.at(i, j);
                const auto expected = marched(map, view.relief, rays.at(i, j), uv);
                ASSERT_EQ(hit.is_hit(), expected.has_value()) << i << " " << j;
                if (!expected) continue;
                ++compared;
                ASSERT_NEAR(hit.t, *expected, 1e-6) << i << " " << j;
                const glm::dvec2 there = uv(glm::dvec2(rays.at(i, j).origin + *expected * rays.at(i, j).direction));
                ASSERT_NEAR(hit.u, there.x, 1e-6);
                ASSERT_NEAR(hit.v, there.y, 1e-6);
                // The normal of z = f(chart(x, y)): the slopes in (u, v) through the transposed chart.
                const glm::dvec2 slope =
                    glm::transpose(chart) * shading_slope(height_derivatives(map), view.relief, hit.u, hit.v);
                const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope.x, -slope.y, 1));
                const auto& of_truth = truth.curved->normals.at(i, j);
                ASSERT_NEAR(glm::dot(normal, glm::dvec3(of_truth[0], of_truth[1], of_truth[2])), 1, 1e-6);
            }
        }
        EXPECT_GT(compared, 300);
    }
}

TEST(CurvedTruth, WhatLiesOnAnotherChartThanTheEntryIsMarked) {
    const HeightMap map = procedural("rock", 32);
    // Whole repeats apart, so that the relief is the same.
    const View view = view_of(flat_square(
        [](int triangle, glm::vec2 place) { return place + 0.5F + static_cast<float>(triangle) * glm::vec2(4, -2); }));
    const Truth truth = truth_of(map, view);
    View whole = view;
    whole.relief.base = {};
    const Truth flat = truth_of(map, whole);
    int off_chart = 0;
    for (std::size_t pixel = 0; pixel < truth.hits.texels.size(); ++pixel) {
        if (truth.footprint.texels[pixel] != in_footprint || flat.footprint.texels[pixel] != in_footprint) continue;
        const Hit& hit = truth.hits.texels[pixel];
        ASSERT_NEAR(hit.t, flat.hits.texels[pixel].t, 1e-6);
        const bool is_on_first = hit.u < 2;
        const bool entered_first = truth.curved->entry_triangles.texels[pixel] == 0;
        ASSERT_EQ(truth.curved->off_chart.texels[pixel], hit.is_hit() && is_on_first != entered_first ? 1 : 0);
        off_chart += truth.curved->off_chart.texels[pixel];
    }
    EXPECT_GT(off_chart, 5);
}

TEST(CurvedTruth, TheSeamOfAChartThatMeetsItselfIsNoTie) {
    BaseMesh mesh = closed_cylinder(64, 1);
    for (MeshVertex& vertex : mesh.vertices) {
        // The seam uppermost.
        const auto turn = [](glm::vec3 v) { return glm::vec3(v.x, -v.z, v.y); };
        vertex.position = turn(vertex.position);
        vertex.normal = turn(vertex.normal);
    }
    find_charts(mesh);
    ASSERT_EQ(mesh.chart_periods, std::vector{glm::vec2(1, 0)});
    const HeightMap map = hills(16);
    // Whose middle row looks down on the seam.
    View view = view_of({MeshBase{std::make_shared<const BaseMesh>(mesh)}}, 0, {33, 33});
    view.camera.azimuth = -90;
    const auto ties_in_middle = [&] {
        const Truth truth = truth_of(map, view);
        int hits = 0;
        int ties = 0;
        for (int i = 0; i < view.resolution.width; ++i) {
            hits += truth.hits.at(i, 16).is_hit() ? 1 : 0;
            ties += truth.footprint.at(i, 16) == tie_in_footprint ? 1 : 0;
        }
        EXPECT_GT(hits, 20);
        return ties;
    };
    EXPECT_EQ(ties_in_middle(), 0);
    // Without its period the two sides of the seam are far apart.
    mesh.chart_periods = {glm::vec2(0)};
    view.relief.base = {MeshBase{std::make_shared<const BaseMesh>(mesh)}};
    EXPECT_GT(ties_in_middle(), 20);
}

TEST(CurvedTruth, AReliefThatFillsTheBaseIsHitWhereItIsEntered) {
    for (const double curvature : {-1.5, 3.0}) {
        const HeightMap map = constant(1);
        const View view = view_of(generated(Kind::sphere, curvature, 20), 70);
        const Truth truth = truth_of(map, view);
        const BaseEntries entries(curved_base(view.relief.base));
        const PixelRays rays = pixel_rays(view);
        int hits = 0;
        for (int j = 0; j < view.resolution.height; ++j) {
            for (int i = 0; i < view.resolution.width; ++i) {
                const auto entry = entries.find(rays.at(i, j));
                ASSERT_EQ(entry.has_value(), truth.hits.at(i, j).is_hit()) << i << " " << j;
                if (!entry) continue;
                ++hits;
                ASSERT_NEAR(truth.hits.at(i, j).t, entry->entry.t, 1e-6);
                ASSERT_EQ(truth.curved->entry_triangles.at(i, j), entry->triangle);
            }
        }
        EXPECT_GT(hits, 100);
    }
}

TEST(BaseEntries, NoRayPassesBetweenTriangles) {
    const BaseSurface base = generated(Kind::sphere, 2, 16);
    const BaseMesh& mesh = curved_base(base);
    const BaseEntries entries(mesh);
    const glm::dvec3 eye(0.1, -0.2, 3);
    const auto meets = [&](const glm::dvec3& place) {
        return entries.find({eye, glm::normalize(place - eye)}).has_value();
    };
    for (std::uint32_t row = 1; row < 16; ++row) {
        for (std::uint32_t column = 1; column < 16; ++column) {
            const glm::dvec3 vertex(mesh.vertices[row * 17 + column].position);
            const glm::dvec3 next(mesh.vertices[row * 17 + column + 1].position);
            const glm::dvec3 diagonal(mesh.vertices[row * 17 + column + 18].position);
            EXPECT_TRUE(meets(vertex));
            for (const double part : {0.1, 1.0 / 3, 0.77}) {
                EXPECT_TRUE(meets(glm::mix(vertex, next, part)));
                EXPECT_TRUE(meets(glm::mix(vertex, diagonal, part)));
            }
        }
    }
}

TEST(CurvedTruth, ABaseSmallerThanAPixelIsOneHitOrNone) {
    const HeightMap map = procedural("rock", 32);
    View view =
        view_of(flat_square([](int, glm::vec2 place) { return place * 1000.0F + 0.5F; }, 0, 0.0005F), 30, {33, 33});
    view.relief.height_scale = 0.00005;
    const Truth truth = truth_of(map, view);
    EXPECT_TRUE(truth.hits.at(16, 16).is_hit());
    EXPECT_EQ(std::ranges::count_if(truth.hits.texels, &Hit::is_hit), 1);
    EXPECT_EQ(std::ranges::count_if(truth.footprint.texels, [](std::uint8_t in) { return in != 0; }), 1);
}

TEST(CurvedTruth, OnePartOfABaseShadowsAnother) {
    const HeightMap map = constant(1);
    // A small square floats over a larger one.
    const auto chart = [](int, glm::vec2 place) { return place + 0.5F; };
    std::vector<MeshVertex> vertices = curved_base(flat_square(chart)).vertices;
    const BaseSurface floating = flat_square(chart, 0.25F, 0.125F);
    const std::vector<MeshVertex>& upper = curved_base(floating).vertices;
    vertices.insert(vertices.end(), upper.begin(), upper.end());
    View view = view_of(base_of(std::move(vertices), {0, 0, 1, 1}), 20, {64, 64});
    view.self_shadow.mode = SelfShadow::Mode::hard;
    Lighting lighting;
    lighting.lights = {{.direction = {0.6, 0.3, 1}}};
    const Truth truth = truth_of(map, view, lighting);
    const PixelRays rays = pixel_rays(view);
    int dark = 0;
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 64; ++i) {
            const Hit& hit = truth.hits.at(i, j);
            if (!hit.is_hit()) continue;
            const glm::dvec3 place = rays.at(i, j).origin + static_cast<double>(hit.t) * rays.at(i, j).direction;
            const glm::dvec2 below = glm::dvec2(place) + 0.25 * glm::dvec2(0.6, 0.3);
            const double inside = 0.125 - std::max(std::abs(below.x), std::abs(below.y));
            if (std::abs(inside) < 1e-5) continue;
            const bool shadowed = place.z < 0.1 && inside > 0;
            ASSERT_EQ(truth.light_visibility.fractions.at(i, j)[0], shadowed ? 0 : 1) << i << " " << j;
            dark += shadowed ? 1 : 0;
        }
    }
    EXPECT_GT(dark, 50);
}

TEST(CurvedTruth, NoLightComesWhereTheBaseTurnsAwayAndNoPointShadowsItself) {
    const HeightMap map = constant(0.5);
    View view = view_of(generated(Kind::sphere, 2.5, 96), 30, {64, 64});
    view.self_shadow.mode = SelfShadow::Mode::hard;
    Lighting lighting;
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(1, 0.2, 0.3));
    lighting.lights = {{.direction = to_light}};
    const Truth truth = truth_of(map, view, lighting);
    int lit = 0;
    int dark = 0;
    for (std::size_t pixel = 0; pixel < truth.hits.texels.size(); ++pixel) {
        if (!truth.hits.texels[pixel].is_hit()) continue;
        const auto& normal = truth.curved->normals.texels[pixel];
        const double rise = glm::dot(glm::dvec3(normal[0], normal[1], normal[2]), to_light);
        // A chart's border has no walls: light comes in under it.
        if (std::abs(rise) < 0.02) continue;
        (rise > 0 ? lit : dark) += 1;
        ASSERT_EQ(truth.light_visibility.fractions.texels[pixel][0], rise > 0 ? 1 : 0);
    }
    EXPECT_GT(lit, 100);
    EXPECT_GT(dark, 100);
}

TEST(CurvedTruth, SoftShadowsOverHardlyCurvedBasesAreThoseOfThePlane) {
    const HeightMap map = procedural("bricks", 64);
    View view = view_of(generated(Kind::cylinder, 1e-6, 8), 20, {24, 24});
    view.self_shadow.mode = SelfShadow::Mode::soft;
    Lighting lighting;
    lighting.lights = {{.direction = {-1, 0.5, 0.6}, .angular_radius = 4}};
    const Truth curved = truth_of(map, view, lighting);
    view.relief.base = {};
    const Truth flat = truth_of(map, view, lighting);
    double sum = 0;
    int hits = 0;
    for (std::size_t pixel = 0; pixel < flat.hits.texels.size(); ++pixel) {
        if (flat.footprint.texels[pixel] != in_footprint || !flat.hits.texels[pixel].is_hit()) continue;
        ++hits;
        sum += std::abs(static_cast<double>(curved.light_visibility.fractions.texels[pixel][0]) -
                        static_cast<double>(flat.light_visibility.fractions.texels[pixel][0]));
    }
    EXPECT_LT(sum / hits, 1e-3);
}

TEST(CurvedTracer, PrismsThatTurnInsideOutAreCountedAndRaysEnd) {
    View view = view_of(generated(Kind::sphere, 4, 16), 40, {32, 32});
    EXPECT_EQ(CurvedTracer(hills(16), view.relief).folded_triangles(), 0U);
    view.relief.height_scale = 0.4;
    const HeightMap map = hills(16);
    const CurvedTracer folded(map, view.relief);
    EXPECT_EQ(folded.folded_triangles(), 2U * 16 * 16);
    const PixelRays rays = pixel_rays(view);
    for (int pixel = 0; pixel < 32 * 32; ++pixel) {
        const auto hit = folded.trace(rays.at(pixel % 32, pixel / 32));
        ASSERT_TRUE(!hit || std::isfinite(hit->hit.t));
    }
}

}  // namespace
}  // namespace reliefbench
