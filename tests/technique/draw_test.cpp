#include "support/error_message.hpp"
#include "test_scene.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <numbers>
#include <sstream>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;

using Draw = DeviceTest;

const HeightMap& bumpy_map() {
    static const HeightMap map = make_map({13, 9}, [](int x, int y) { return ((x * 7 + y * 5) % 11) / 10.0; });
    return map;
}

// (8×4 texels, texel (5, 1) raised) At 8×4 pixels every pixel's centre is a texel's: only pixel (5, 2) stands up, for
// row 0 is the top and v = 0 the bottom.
TEST_F(Draw, RaisedTexelIsInItsPixel) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const Resolution size{8, 4};
    const auto raised = [](int x, int y) { return x == 5 && y == 1; };
    const HeightMap map = make_map(size, [&](int x, int y) { return raised(x, y) ? 1.0 : 0.0; });
    const Albedo albedo = make_albedo(size, [&](int x, int y) {
        return std::array<float, 4>{raised(x, y) ? 1.0f : 0.0f, 0, 0, 1};
    });
    const SceneOnDevice scene(device(), map, albedo);
    const View view = make_view(0, Projection::parallel, size);
    Renderer renderer = make_renderer(device(), folder.load(), scene, view, lights_off());
    const Probe probe = renderer.probe();
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) {
            const float expected = i == 5 && j == 2 ? 1.0f : 0.0f;
            EXPECT_NEAR(probe.hits.at(i, j).h, expected, 1e-6) << i << ' ' << j;
            EXPECT_EQ(probe.colour.at(i, j)[0], expected) << i << ' ' << j;
        }
    }
}

// h is c everywhere: a ray of angle θ goes (1 − c)·H·tanθ sideways and (1 − c)·H / cosθ along itself.
TEST_F(Draw, ConstantMapHasItsClosedForm) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const Technique technique = folder.load();
    const double c = 26214.0 / 65535.0;
    const HeightMap map = make_map({5, 3}, [&](int, int) { return c; });
    const SceneOnDevice scene(device(), map, grey_albedo());
    for (const double angle : {0.0, 45.0, 75.0}) {
        View view = make_view(angle, Projection::parallel, {32, 32});
        view.relief.height_scale = 0.1;
        view.relief.tiling = 3;
        const Probe probe = make_renderer(device(), technique, scene, view).probe();
        const double radians = angle * std::numbers::pi / 180;
        const double sideways = (1 - c) * 0.1 * std::tan(radians);
        for (int j = 0; j < 32; ++j) {
            const Hit& hit = probe.hits.at(10, j);
            const double entry_v = 1 - (j + 0.5) / 32;
            ASSERT_EQ(hit.is_hit(), entry_v + sideways <= 1) << angle << ' ' << j;
            if (!hit.is_hit()) continue;
            // The chord of the march is exact on a plane, up to float rounding in texture coordinates.
            EXPECT_NEAR(hit.u, 10.5 / 32, 1e-6);
            EXPECT_NEAR(hit.v, entry_v + sideways, 2e-6);
            EXPECT_NEAR(hit.h, c, 2e-6);
            EXPECT_NEAR(hit.t, (1 - c) * 0.1 / std::cos(radians), 2e-6);
        }
    }
}

TEST_F(Draw, HitsOnAndOffTheRayAreConvertedAlike) {
    const TemporaryTechnique on(Files{{"trace.glsl", "Trace trace(ReliefRay ray) { return hit_on_ray(0.5, 0); }"}});
    const TemporaryTechnique off(
        Files{{"trace.glsl", "Trace trace(ReliefRay ray) { return hit_off_ray(point_on_ray(ray, 0.5), 0.5, 0); }"}});
    const SceneOnDevice scene(device(), bumpy_map(), grey_albedo());
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        View view = make_view(60, projection);
        view.relief.tiling = 2;
        const Probe a = make_renderer(device(), on.load(), scene, view).probe();
        const Probe b = make_renderer(device(), off.load(), scene, view).probe();
        for (std::size_t i = 0; i < a.hits.texels.size(); ++i) {
            const Hit& p = a.hits.texels[i];
            const Hit& q = b.hits.texels[i];
            if (!p.is_hit() || !q.is_hit()) continue;
            EXPECT_NEAR(p.u, q.u, 1e-6);
            EXPECT_NEAR(p.v, q.v, 1e-6);
            EXPECT_EQ(p.h, q.h);
            EXPECT_NEAR(p.t, q.t, 2e-6);
        }
    }
}

bool same_bits(float a, float b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// Albedo encodes (u, v), lights are off: coverage and colour must be equal bit for bit.
TEST_F(Draw, TimedAndProbedAgreeBitForBit) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const Technique technique = folder.load();
    const Resolution ramp{64, 64};
    const Albedo albedo = make_albedo(ramp, [](int x, int y) {
        return std::array<float, 4>{(float(x) + 0.5f) / 64, (float(y) + 0.5f) / 64, 0, 1};
    });
    const SceneOnDevice scene(device(), bumpy_map(), albedo);
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        const View view = make_view(70, projection, {80, 48});
        Renderer renderer = make_renderer(device(), technique, scene, view, lights_off());
        const Probe probe = renderer.probe();
        const TimedPicture timed = renderer.draw_timed(ColourTarget::linear_float);
        std::size_t covered = 0;
        std::size_t missed = 0;
        for (std::size_t i = 0; i < view.resolution.pixels(); ++i) {
            const bool hit = probe.hits.texels[i].is_hit();
            ASSERT_EQ(timed.colour.texels[i][3], hit ? 1.0f : 0.0f);
            ASSERT_EQ(timed.depth.texels[i] < 1.0f, hit);
            for (std::size_t channel = 0; channel < 3; ++channel)
                ASSERT_TRUE(same_bits(timed.colour.texels[i][channel], probe.colour.texels[i][channel]));
            covered += hit;
            missed += !hit;
        }
        EXPECT_GT(covered, 100u);
        EXPECT_GT(missed, 10u);
    }
}

TEST_F(Draw, DisplayTargetIsEncodedToSrgb) {
    const TemporaryTechnique folder(Files{{"trace.glsl", flat_trace}});
    const SceneOnDevice scene(device(), bumpy_map(), make_albedo({1, 1}, [](int, int) {
                                  return std::array<float, 4>{0.2f, 0.002f, 1, 1};
                              }));
    Lighting lighting = lights_off();
    lighting.background = {0.5, 0, 0};
    Renderer renderer = make_renderer(device(), folder.load(), scene, make_view(50, Projection::perspective), lighting);
    const TimedPicture picture = renderer.draw_timed(ColourTarget::display);
    // IEC 61966-2-1: 0.2 → 0.48453, 0.002 → 0.02584, 0.5 → 0.73536, each rounded to 8 bits.
    const std::array<float, 4> drawn{124.0f / 255, 7.0f / 255, 1, 1};
    const std::array<float, 4> background{188.0f / 255, 0, 0, 0};
    EXPECT_EQ(picture.colour.at(32, 32), drawn);
    EXPECT_EQ(picture.colour.at(0, 0), background);
}

// Discarded pixels keep their work; what shading fetches is not counted.
TEST_F(Draw, TapsAreCountedLiterally) {
    const TemporaryTechnique folder(Files{{"trace.glsl", R"(
        Trace trace(ReliefRay ray) {
            float sum = tap_height(ray.uv) + tap_height(2.0 * ray.uv) + tap_height_texel(ivec2(1, 2));
            sum += tap_height_cell(ivec2(0, 0)).x;
            if (ray.uv.x < 0.5) return miss(7);
            Trace result = hit_off_ray(ray.uv, clamp(sum, 0.25, 0.75), 11);
            return ray.uv.y > 0.5 ? unconverged(result) : result;
        })"}});
    const SceneOnDevice scene(device(), bumpy_map(), grey_albedo());
    const View view = make_view(30, Projection::parallel, {8, 8});
    const Probe probe = make_renderer(device(), folder.load(), scene, view).probe();
    for (int j = 0; j < 8; ++j) {
        for (int i = 0; i < 8; ++i) {
            const bool left = i < 4;
            const bool upper = j < 4;
            const PixelWork& work = probe.work.at(i, j);
            EXPECT_EQ(work.taps, 4u);
            EXPECT_EQ(work.texels, 4u + 4u + 1u + 4u);
            EXPECT_EQ(work.steps, left ? 7u : 11u);
            EXPECT_EQ(work.unconverged, !left && upper ? 1u : 0u);
            EXPECT_EQ(probe.covered.at(i, j), 1);
            EXPECT_EQ(probe.hits.at(i, j).is_hit(), !left);
        }
    }
    EXPECT_EQ(probe.stages.taps, 0u);
}

// Rays come 0.2 further up in v on their way: with s = 1 two rows of ten have left the patch, and nothing is there to
// hit.
TEST_F(Draw, OnlyASearchThatCouldStillHitCountsAsUnconverged) {
    const TemporaryTechnique on_ray(
        Files{{"trace.glsl", "Trace trace(ReliefRay ray) { return unconverged(hit_on_ray(1.0, 0)); }"}});
    const TemporaryTechnique off_ray(Files{{"trace.glsl", R"(
        Trace trace(ReliefRay ray) { return unconverged(hit_off_ray(ray.uv + vec2(0.0, 0.2), 0.0, 0)); })"}});
    const SceneOnDevice scene(device(), bumpy_map(), grey_albedo());
    View clipped = make_view(45, Projection::parallel, {10, 10});
    clipped.relief.height_scale = 0.2;
    View repeated = clipped;
    repeated.relief.boundary = Boundary::repeat;
    // Half faded: drawn at s = 0.5, where one of the two rows is inside again; searched to s = 1 all the same.
    const ParameterValues half_faded{{"lod_fade", "distance"}, {"lod_fade_end", 1.0}, {"lod_fade_width", 2.0}};
    const auto probe = [&](const TemporaryTechnique& technique, const View& view, const ParameterValues& parameters) {
        return make_renderer(device(), technique.load(), scene, view, {}, parameters).probe();
    };
    const Probe left = probe(on_ray, clipped, {});
    const Probe faded = probe(on_ray, clipped, half_faded);
    const Probe endless = probe(on_ray, repeated, {});
    const Probe anywhere = probe(off_ray, clipped, {});
    for (int j = 0; j < 10; ++j) {
        EXPECT_EQ(left.work.at(5, j).unconverged, j >= 2 ? 1u : 0u) << j;
        EXPECT_EQ(left.hits.at(5, j).is_hit(), j >= 2) << j;
        EXPECT_EQ(faded.work.at(5, j).unconverged, j >= 2 ? 1u : 0u) << j;
        EXPECT_EQ(faded.hits.at(5, j).is_hit(), j >= 1) << j;
        EXPECT_EQ(endless.work.at(5, j).unconverged, 1u) << j;
        EXPECT_EQ(anywhere.work.at(5, j).unconverged, 1u) << j << ": who left the ray may come back";
    }
}

TEST_F(Draw, WhatATechniqueDiscardsKeepsItsWork) {
    const TemporaryTechnique folder(Files{{"trace.glsl", R"(
        Trace trace(ReliefRay ray) {
            float h = tap_height(ray.uv) + tap_height(2.0 * ray.uv);
            if (ray.uv.x < 0.5)
                discard;
            else
                h *= 0.5;
            return hit_off_ray(ray.uv, h, 1);
        })"}});
    const SceneOnDevice scene(device(), bumpy_map(), grey_albedo());
    const View view = make_view(30, Projection::parallel, {8, 8});
    const Probe probe = make_renderer(device(), folder.load(), scene, view).probe();
    for (int i = 0; i < 8; ++i) {
        EXPECT_EQ(probe.hits.at(i, 4).is_hit(), i >= 4);
        EXPECT_EQ(probe.covered.at(i, 4), 1);
        EXPECT_EQ(probe.work.at(i, 4).taps, 2u);
        EXPECT_FALSE(probe.work.at(i, 4).cut);
    }
}

TEST_F(Draw, CoveredIsTheFootprint) {
    const TemporaryTechnique folder(Files{{"trace.glsl", "Trace trace(ReliefRay ray) { return miss(0); }"}});
    const SceneOnDevice scene(device(), bumpy_map(), grey_albedo());
    const View view = make_view(40, Projection::perspective);
    const Probe probe = make_renderer(device(), folder.load(), scene, view).probe();
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 64; ++i) {
            const bool inside = footprint_entry(pixel_ray(view, i, j)).has_value();
            EXPECT_EQ(probe.covered.at(i, j), inside ? 1 : 0) << i << ' ' << j;
            EXPECT_EQ(probe.hits.at(i, j), Hit{});
        }
    }
}

TEST_F(Draw, BoundaryDecidesWhatHappensPastTheBorder) {
    const TemporaryTechnique folder(Files{{"trace.glsl", "Trace trace(ReliefRay ray) { return hit_on_ray(1.0, 0); }"}});
    const Technique technique = folder.load();
    const SceneOnDevice scene(device(), bumpy_map(), grey_albedo());
    View view = make_view(45, Projection::parallel, {10, 10});
    view.relief.height_scale = 0.2;
    const Probe clipped = make_renderer(device(), technique, scene, view).probe();
    view.relief.boundary = Boundary::repeat;
    const Probe repeated = make_renderer(device(), technique, scene, view).probe();
    for (int j = 0; j < 10; ++j) {
        // At the bottom of the relief the rays have come 0.2 further up in v: two rows of ten.
        EXPECT_EQ(clipped.hits.at(5, j).is_hit(), j >= 2) << j;
        EXPECT_NEAR(repeated.hits.at(5, j).v, 1 - (j + 0.5) / 10 + 0.2, 1e-6) << j;
    }
}

TEST_F(Draw, IndicesWrapAtAnySizeAndSign) {
    const Resolution size{7, 5};
    const HeightMap map = make_map(
        size, [](int x, int y) { return (x + 7 * y) / 34.0; }, HeightFormat::r32f);
    const SceneOnDevice scene(device(), map, grey_albedo());
    View view = make_view(0, Projection::parallel, {64, 64});
    view.relief.boundary = Boundary::repeat;
    // Three numbers at a time are handed out as a hit's u, v and h.
    const TemporaryTechnique folder(Files{{"technique.json", manifest_json(R"(
            {"name": "shift", "type": "integer", "default": 0, "range": [-100000, 100000], "help": "h"},
            {"name": "cells", "type": "boolean", "default": false, "help": "h"})")},
                                          {"trace.glsl", R"(
            Trace trace(ReliefRay ray) {
                ivec2 texel = ivec2(floor(ray.uv * 64.0)) + shift;
                vec4 corners = tap_height_cell(texel);
                if (cells) return hit_off_ray(corners.xy, corners.z, 0);
                return hit_off_ray(vec2(tap_height_texel(texel)), corners.w, 0);
            })"}});
    const Technique technique = folder.load();
    for (const int shift : {-32, -70001, 70001}) {
        const auto draw = [&](bool cells) {
            return make_renderer(device(), technique, scene, view, {},
                                 {{"shift", std::int64_t{shift}}, {"cells", cells}})
                .probe();
        };
        const Probe texels = draw(false);
        const Probe cells = draw(true);
        int wrong = 0;
        for (int j = 0; j < 64; ++j) {
            for (int i = 0; i < 64; ++i) {
                const int x = i + shift;
                const int y = 63 - j + shift;
                wrong += texels.hits.at(i, j).u != map.texel(x, y);
                wrong += cells.hits.at(i, j).u != map.texel(x, y);
                wrong += cells.hits.at(i, j).v != map.texel(x + 1, y);
                wrong += cells.hits.at(i, j).h != map.texel(x, y + 1);
                wrong += texels.hits.at(i, j).h != map.texel(x + 1, y + 1);
            }
        }
        EXPECT_EQ(wrong, 0) << "shift " << shift;
    }
}

TEST_F(Draw, EmptyPassIsTimed) {
    const std::vector<double> milliseconds = time_empty_pass(device(), 3);
    ASSERT_EQ(milliseconds.size(), 3u);
    for (const double value : milliseconds)
        EXPECT_GE(value, 0);
}

TEST_F(Draw, IsTimedAndCounted) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const SceneOnDevice scene(device(), bumpy_map(), grey_albedo());
    const View view = make_view(60, Projection::parallel, {32, 16});
    Renderer renderer = make_renderer(device(), folder.load(), scene, view);
    const std::vector<double> milliseconds = renderer.time_draw(3, 2);
    ASSERT_EQ(milliseconds.size(), 3u);
    for (const double value : milliseconds)
        EXPECT_GT(value, 0);
    const PipelineStatistics statistics = renderer.pipeline_statistics();
    EXPECT_EQ(statistics.at("vertex_shader_invocations"), 4u);
    // At least one for each of the pixels; devices also count those that help with derivatives.
    EXPECT_GE(statistics.at("fragment_shader_invocations"), 32u * 16u);
}

TEST_F(Draw, PushesNoConstants) {
    const std::string pushed = "layout(push_constant) uniform Pushed { mat4 pushed; };\n";
    const SceneOnDevice scene(device(), bumpy_map(), grey_albedo());
    const auto draw = [&](const std::string& trace) {
        const TemporaryTechnique folder(Files{{"trace.glsl", trace}});
        return make_renderer(device(), folder.load(), scene, make_view(45, Projection::parallel, {8, 8})).probe();
    };
    EXPECT_THAT(error_message([&] {
                    draw(pushed + "Trace trace(ReliefRay ray) { return hit_off_ray(ray.uv, pushed[0][0], 0); }\n");
                }),
                testing::HasSubstr("push constants"));
    EXPECT_EQ(draw(pushed + march_trace).hits.at(4, 4).h, draw(march_trace).hits.at(4, 4).h) << "nobody reads them";
}

TEST_F(Draw, TwoAreTimedAtOnceAndAgain) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const SceneOnDevice scene(device(), bumpy_map(), grey_albedo());
    const View view = make_view(60, Projection::parallel, {32, 16});
    Renderer first = make_renderer(device(), folder.load(), scene, view);
    Renderer second = make_renderer(device(), folder.load(), scene, view);
    for (int visit = 0; visit < 3; ++visit) {
        first.submit_draw(2, 3);
        second.submit_draw(1);
        EXPECT_EQ(first.collect_draw().size(), 2u);
        EXPECT_EQ(second.collect_draw().size(), 1u);
    }
    // Other numbers than those recorded.
    EXPECT_EQ(first.time_draw(4, 1).size(), 4u);
    EXPECT_EQ(first.time_draw(2, 3).size(), 2u);
}

TEST_F(Draw, MayBeGivenUpWhileItIsTimed) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const SceneOnDevice scene(device(), bumpy_map(), grey_albedo());
    Renderer renderer = make_renderer(device(), folder.load(), scene, make_view(60, Projection::parallel, {64, 64}));
    renderer.submit_draw(2);
}

// Timestamps that do not wait for the draw would leave most of the submission's time to no sample. A share of it, no
// time, and of a CPU device's only: elsewhere submitting may take longer than drawing.
TEST_F(Draw, SamplesHoldTheirDraws) {
    if (device().info().type != gpu::DeviceType::cpu) GTEST_SKIP() << "not a CPU device";
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const SceneOnDevice scene(device(), make_map({64, 64}, [](int, int) { return 0.1; }), grey_albedo());
    Renderer renderer = make_renderer(device(), folder.load(), scene, make_view(60, Projection::parallel, {128, 128}));
    renderer.time_draw(1);
    const auto start = std::chrono::steady_clock::now();
    double inside = 0;
    for (const double value : renderer.time_draw(8))
        inside += value;
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    EXPECT_GT(inside, 0.5 * wall.count());
    EXPECT_LE(inside, wall.count());
}

// AddressSanitizer keeps what was freed for a while.
#if !defined(__SANITIZE_ADDRESS__)
/// Resident memory of this process, from the kernel's count of 4 KiB pages.
double resident_mebibytes() {
    std::istringstream pages(read_text_file("/proc/self/statm"));
    double in_all = 0;
    double resident = 0;
    pages >> in_all >> resident;
    return resident * 4096 / (1 << 20);
}

// lavapipe compiled shaders anew at every draw, and kept them, for values that scene_block now keeps from it: 1 MB
// each.
TEST_F(Draw, DrawingAgainTakesNoMoreMemory) {
    constexpr int draws = 100;
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const SceneOnDevice scene(device(), bumpy_map(), grey_albedo());
    Renderer renderer = make_renderer(device(), folder.load(), scene, make_view(45, Projection::perspective, {16, 16}));
    renderer.time_draw(draws);
    const double before = resident_mebibytes();
    renderer.time_draw(draws);
    EXPECT_LT(resident_mebibytes() - before, 0.1 * draws);
}
#endif

}  // namespace
}  // namespace reliefbench
