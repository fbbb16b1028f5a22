#include "test_scene.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <bit>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;

using PreparationOnDevice = DeviceTest;

const char* const maximum_chain_passes = R"(, "passes": [
    {"name": "leaves", "shader": "leaves.glsl", "writes": "chain"},
    {"name": "levels", "shader": "levels.glsl", "writes": "chain", "levels": "above_base"}])";

/// Reports the map's texel at level `lod` for pixels (i, j) inside it, through a trace that maps pixels to texels.
TemporaryTechnique::Files maximum_chain(const std::string& map_size) {
    const std::string maps = R"(, "maps": [{"name": "chain", "format": "r32f", "size": ")" + map_size +
                             R"(", "mip_chain": true, "linear_filter": false}])";
    const std::string parameters = R"({"name": "lod", "type": "integer", "default": 0, "range": [0, 16], "help": "h"})";
    return {{"technique.json", manifest_json(parameters, maps + maximum_chain_passes)},
            {"leaves.glsl", R"(
                void prepare(ivec2 texel) {
                    bool inside = all(lessThan(texel, height_map_size()));
                    write_map(vec4(inside ? tap_height_texel(texel) : 0.0));
                })"},
            // A level's last texel takes what is left over: a size of 2n + 1 leaves n texels above it.
            {"levels.glsl", R"(
                void prepare(ivec2 texel) {
                    float highest = 0.0;
                    for (int y = 0; y < 3; ++y)
                        for (int x = 0; x < 3; ++x) {
                            ivec2 child = 2 * texel + ivec2(x, y);
                            bool mine = (x < 2 || texel.x == map_size().x - 1) && (y < 2 || texel.y == map_size().y - 1);
                            if (mine) highest = max(highest, previous_level(child).r);
                        }
                    write_map(vec4(highest));
                })"},
            {"trace.glsl", R"(
                Trace trace(ReliefRay ray) {
                    ivec2 texel = ivec2(floor(ray.uv * 32.0));
                    if (any(greaterThanEqual(texel, textureSize(chain, lod)))) return miss(0);
                    return hit_off_ray(ray.uv, tap_map_texel(chain, texel, lod).r, 0);
                })"}};
}

/// Texels of the base that a texel of `level` stands for, along one axis: floor-halved sizes, the last takes the rest.
std::pair<int, int> span_of(int texel, int level, int size) {
    const int last = std::max(size >> level, 1) - 1;
    const int begin = texel << level;
    return {begin, texel == last ? size : std::min(begin + (1 << level), size)};
}

void expect_maximum_chain(const gpu::Device& device, const std::string& map_size, const HeightMap& map,
                          Resolution base) {
    const TemporaryTechnique folder(maximum_chain(map_size));
    const Technique technique = folder.load();
    const SceneOnDevice scene(device, map, grey_albedo());
    const View view = make_view(0, Projection::parallel, {32, 32});
    const int levels = std::bit_width(static_cast<unsigned>(std::max(base.width, base.height)));
    for (int level = 0; level < levels; ++level) {
        const Probe probe = make_renderer(device, technique, scene, view, {}, {{"lod", std::int64_t{level}}}).probe();
        for (int y = 0; y < std::max(base.height >> level, 1); ++y) {
            for (int x = 0; x < std::max(base.width >> level, 1); ++x) {
                float expected = 0;
                const auto [x_begin, x_end] = span_of(x, level, base.width);
                const auto [y_begin, y_end] = span_of(y, level, base.height);
                for (int j = y_begin; j < std::min(y_end, map.height()); ++j) {
                    for (int i = x_begin; i < std::min(x_end, map.width()); ++i)
                        expected = std::max(expected, map.texel(i, j));
                }
                ASSERT_EQ(probe.hits.at(x, 31 - y).h, expected) << map_size << ' ' << level << ' ' << x << ' ' << y;
            }
        }
    }
}

TEST_F(PreparationOnDevice, FillsEveryLevelAtOddSizes) {
    const HeightMap map = make_map(
        {23, 11}, [](int x, int y) { return ((x * 37 + y * 101) % 97) / 96.0; }, HeightFormat::r32f);
    expect_maximum_chain(device(), "height_map", map, {23, 11});
    expect_maximum_chain(device(), "next_power_of_two", map, {32, 16});
}

TEST_F(PreparationOnDevice, IsTimedByPassAndSized) {
    const TemporaryTechnique folder(maximum_chain("height_map"));
    const Technique technique = folder.load();
    const SceneOnDevice scene(device(), make_map({16, 8}, [](int, int) { return 0.5; }), grey_albedo());
    Renderer renderer(device(), technique, technique.manifest.defaults(), scene, make_view(0, Projection::parallel),
                      Lighting{});
    const Preparation preparation = renderer.prepare({.samples = 3});
    ASSERT_EQ(preparation.pass_ms.size(), 2u);
    for (const auto& [pass, milliseconds] : preparation.pass_ms) {
        ASSERT_EQ(milliseconds.size(), 3u) << pass;
        for (const double value : milliseconds)
            EXPECT_GT(value, 0) << pass;
    }
    constexpr std::uint64_t texels = 16 * 8 + 8 * 4 + 4 * 2 + 2 * 1 + 1;
    EXPECT_GE(preparation.bytes, texels * sizeof(float));
}

TEST_F(PreparationOnDevice, PassReadsEarlierMapsThroughTheirFilter) {
    const TemporaryTechnique folder(
        Files{{"technique.json", manifest_json("", R"(,
                   "maps": [{"name": "base", "format": "rg32f", "linear_filter": true},
                            {"name": "twice", "format": "r16"}],
                   "passes": [{"name": "first", "shader": "first.glsl", "writes": "base"},
                              {"name": "second", "shader": "second.glsl", "writes": "twice"}])")},
              {"first.glsl", "void prepare(ivec2 texel) { write_map(vec4(texel, 0, 0)); }"},
              {"second.glsl", R"(void prepare(ivec2 texel) {
                   // Between texel centres 1 and 2 along x, at 2 along y: (1.5, 2).
                   vec2 between = tap_map(base, vec2(2.0, 2.5) / vec2(map_size()), 0.0).rg;
                   write_map(vec4(between.x / 2.0 == 0.75 && between.y == 2.0 ? 1.0 : 0.0));
               })"},
              {"trace.glsl",
               "Trace trace(ReliefRay ray) { return hit_off_ray(ray.uv, tap_map(twice, ray.uv, 0.0).r, 0); }"}});
    const SceneOnDevice scene(device(), make_map({8, 8}, [](int, int) { return 0.5; }), grey_albedo());
    const View view = make_view(0, Projection::parallel, {8, 8});
    const Probe probe = make_renderer(device(), folder.load(), scene, view).probe();
    EXPECT_EQ(probe.hits.at(3, 3).h, 1.0f);
}

/// A texel of a volume is told from its place by three numbers; `read` makes of uv what the trace reports.
TemporaryTechnique::Files volume(const std::string& depth, const std::string& format, const std::string& read) {
    return {{"technique.json",
             manifest_json(R"({"name": "slices", "type": "integer", "default": 5, "range": [1, 64], "help": "h"})",
                           R"(, "maps": [{"name": "places", "format": ")" + format + R"(", "depth": )" + depth +
                               R"(, "linear_filter": true}, {"name": "copy", "format": "r32f"}],
                           "passes": [{"name": "fill", "shader": "fill.glsl", "writes": "places"},
                                      {"name": "flatten", "shader": "flatten.glsl", "writes": "copy"}])")},
            {"fill.glsl", R"(void prepare(ivec3 texel) {
                 bool right_size = map_size() == ivec3(height_map_size(), slices);
                 write_map_at(texel, vec4(right_size ? float(texel.x + 8 * texel.y + 64 * texel.z) / 512.0 : 0.0));
             })"},
            {"flatten.glsl", R"(void prepare(ivec2 texel) {
                 write_map(vec4(tap_map_texel(places, ivec3(texel, min(texel.x, slices - 1)), 0).r));
             })"},
            {"trace.glsl", "Trace trace(ReliefRay ray) { return hit_off_ray(ray.uv, " + read + ", 0); }"}};
}

TEST_F(PreparationOnDevice, FillsThreeDimensionalMaps) {
    const SceneOnDevice scene(device(), make_map({8, 6}, [](int, int) { return 0.5; }), grey_albedo());
    const View view = make_view(0, Projection::parallel, {8, 6});
    const auto value = [](int x, int y, int z) { return static_cast<float>(x + 8 * y + 64 * z) / 512; };
    const std::string texel = "ivec3(ivec2(floor(ray.uv * vec2(8, 6))), 4)";
    for (const std::string depth : {"5", R"("slices")"}) {
        const TemporaryTechnique texels(volume(depth, "r32f", "tap_map_texel(places, " + texel + ", 0).r"));
        const Probe probe = make_renderer(device(), texels.load(), scene, view).probe();
        const TemporaryTechnique copied(volume(depth, "r32f", "tap_map(copy, ray.uv, 0.0).r"));
        const Probe copy = make_renderer(device(), copied.load(), scene, view).probe();
        for (int y = 0; y < 6; ++y) {
            for (int x = 0; x < 8; ++x) {
                ASSERT_EQ(probe.hits.at(x, 5 - y).h, value(x, y, 4)) << x << ' ' << y;
                ASSERT_EQ(copy.hits.at(x, 5 - y).h, value(x, y, std::min(x, 4))) << x << ' ' << y;
            }
        }
        EXPECT_EQ(probe.work.at(3, 3).taps, 1u);
        EXPECT_EQ(probe.work.at(3, 3).texels, 1u);
    }
}

/// Along u and v the map repeats, beyond the first and the last slice it goes on as they are.
TEST_F(PreparationOnDevice, ThreeDimensionalMapsFilterAcrossSlices) {
    const SceneOnDevice scene(device(), make_map({8, 6}, [](int, int) { return 0.5; }), grey_albedo());
    const View view = make_view(0, Projection::parallel, {8, 6});
    const auto read = [&](const std::string& u, const std::string& v, const std::string& h) {
        const TemporaryTechnique folder(
            volume("\"slices\"", "r32f", "tap_map(places, vec3(" + u + ", " + v + ", " + h + "), 0.0).r"));
        const Probe probe = make_renderer(device(), folder.load(), scene, view).probe();
        EXPECT_EQ(probe.work.at(0, 0).texels, 8u);
        return static_cast<double>(probe.hits.at(0, 0).h) * 512;
    };
    EXPECT_NEAR(read("2.0 / 8.0", "2.5 / 6.0", "3.0 / 5.0"), 1.5 + 8 * 2 + 64 * 2.5, 1e-3);
    EXPECT_NEAR(read("1.0", "0.5 / 6.0", "0.5 / 5.0"), 3.5, 1e-3);
    EXPECT_NEAR(read("0.5 / 8.0", "-0.5 / 6.0", "0.5 / 5.0"), 8 * 5, 1e-3);
    EXPECT_NEAR(read("0.5 / 8.0", "0.5 / 6.0", "2.0"), 64 * 4, 1e-3);
    EXPECT_NEAR(read("0.5 / 8.0", "0.5 / 6.0", "-1.0"), 0, 1e-3);
}

/// For each texel the number of the height map's texels that are higher, plus `bias` where it is asked for: a
/// search in slices, whose counts are folded by adding.
Files counting_search(int iterations, bool ends_early = false) {
    return {{"technique.json",
             manifest_json(R"({"name": "bias", "type": "integer", "default": 0, "range": [0, 99], "help": "h"},
                              {"name": "unused", "type": "integer", "default": 0, "range": [0, 99], "help": "h"},
                              {"name": "search", "type": "choice", "choices": ["count", "none"], "default": "count",
                               "help": "h"})",
                           R"(, "maps": [{"name": "counts", "format": "r32f", "scratch": true},
                                         {"name": "result", "format": "r32f"}],
                                "passes": [{"name": "count", "shader": "count.glsl", "writes": "counts",
                                            "only_with": {"search": ["count"]},
                                            "sliced": {"iterations": )" +
                               std::to_string(iterations) + R"(, "ends_early": )" + (ends_early ? "true" : "false") +
                               R"(}},
                                           {"name": "constant", "shader": "constant.glsl", "writes": "counts",
                                            "only_with": {"search": ["none"]}},
                                           {"name": "finish", "shader": "finish.glsl", "writes": "result"}])")},
            {"count.glsl", R"(
                void prepare(ivec2 texel) {
                    float higher = slice_begin() == 0 ? float(bias) : folded_map().r;
                    float here = tap_height_texel(texel);
                    ivec2 size = height_map_size();
                    for (int source = slice_begin(); source < slice_end(); ++source)
                        higher += tap_height_texel(ivec2(source % size.x, source / size.x)) > here ? 1.0 : 0.0;
                    write_map(vec4(higher));
                })"},
            {"constant.glsl", "void prepare(ivec2 texel) { write_map(vec4(7.0)); }"},
            {"finish.glsl", "void prepare(ivec2 texel) { write_map(tap_map_texel(counts, texel, 0) / 65536.0); }"},
            {"trace.glsl", R"(
                Trace trace(ReliefRay ray) {
                    return hit_off_ray(ray.uv, tap_map_texel(result, ivec2(ray.uv * 64.0), 0).r, 0);
                })"}};
}

class SlicedPreparation : public DeviceTest {
protected:
    /// 64x64 heights, all different, and 4096 of them higher or lower than any other.
    SlicedPreparation()
        : scene_(device(), make_map({64, 64}, [](int x, int y) { return ((x + 64 * y) * 1021 % 4096) / 4096.0; }),
                 grey_albedo()) {}

    Renderer renderer(const Technique& technique, const ParameterValues& changed = {}) const {
        ParameterValues parameters = technique.manifest.defaults();
        for (const auto& [name, value] : changed)
            parameters.at(name) = value;
        return Renderer(device(), technique, parameters, scene_, make_view(0, Projection::parallel), Lighting{});
    }

    /// Of texel (x, y), whose height's rank is known.
    static float expected(int x, int y, int bias = 0) {
        return static_cast<float>(4095 - (x + 64 * y) * 1021 % 4096 + bias) / 65536.0f;
    }

    static void expect_counts(Renderer& renderer, int bias = 0) {
        const Probe probe = renderer.probe();
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x)
                ASSERT_EQ(probe.hits.at(x, 63 - y).h, expected(x, y, bias)) << x << ' ' << y;
        }
    }

    SceneOnDevice scene_;
};

TEST_F(SlicedPreparation, FoldsWhatTheSlicesFound) {
    // 4096 texels searched: one slice where one costs an iteration, and ones of four where one is said to cost
    // 15,000.
    for (const int iterations : {1, 15000}) {
        const TemporaryTechnique folder(counting_search(iterations));
        const Technique technique = folder.load();
        Renderer drawn = renderer(technique);
        int told = 0;
        double fraction = 0;
        const auto on_progress = [&](const PreparationProgress& progress) {
            EXPECT_EQ(progress.pass, "count");
            EXPECT_GT(progress.fraction, fraction);
            fraction = progress.fraction;
            ++told;
        };
        const Preparation preparation = drawn.prepare({.on_progress = on_progress});
        EXPECT_EQ(fraction, 1);
        EXPECT_EQ(told > 100, iterations > 1) << told;
        EXPECT_EQ(preparation.pass_ms.size(), 2U);
        expect_counts(drawn);
    }
}

TEST_F(SlicedPreparation, WritesEveryRowOnce) {
    Files files = counting_search(1);
    const std::string manifest = files["technique.json"];
    const std::string finish = R"("finish.glsl", "writes": "result")";
    files["technique.json"] = std::string(manifest).replace(
        manifest.find(finish), finish.size(), finish + R"(, "sliced": {"over": "rows", "iterations": 32768})");
    const TemporaryTechnique folder(files);
    const Technique technique = folder.load();
    Renderer drawn = renderer(technique);
    int slices = 0;
    drawn.prepare({.on_progress = [&](const PreparationProgress& told) { slices += told.pass == "finish" ? 1 : 0; }});
    EXPECT_EQ(slices, 8) << "rows of workgroups of 8x8";
    expect_counts(drawn);
}

TEST_F(SlicedPreparation, RunsThePassesOfItsParameters) {
    const TemporaryTechnique folder(counting_search(1));
    const Technique technique = folder.load();
    Renderer none = renderer(technique, {{"search", std::string("none")}});
    const Preparation preparation = none.prepare();
    EXPECT_TRUE(preparation.pass_ms.contains("constant"));
    EXPECT_FALSE(preparation.pass_ms.contains("count"));
    EXPECT_EQ(none.probe().hits.at(5, 5).h, 7.0f / 65536.0f);
    // The scratch map is gone.
    EXPECT_LT(preparation.bytes, 2 * 64 * 64 * sizeof(float));
}

TEST_F(SlicedPreparation, KeptMapsAreThoseMade) {
    const TemporaryTechnique folder(counting_search(1));
    const Technique technique = folder.load();
    const TemporaryFolder cache;
    const PreparationSettings settings{.cache = cache.path()};
    Renderer made = renderer(technique);
    const Preparation first = made.prepare(settings);
    EXPECT_FALSE(first.kept);

    Renderer taken = renderer(technique, {{"unused", std::int64_t{5}}});
    const Preparation second = taken.prepare(settings);
    EXPECT_TRUE(second.kept) << "a parameter that no pass uses makes no other map";
    EXPECT_EQ(second.pass_ms, first.pass_ms) << "the times are those of making them";
    EXPECT_EQ(second.bytes, first.bytes);
    expect_counts(taken);

    Renderer other = renderer(technique, {{"bias", std::int64_t{3}}});
    EXPECT_FALSE(other.prepare(settings).kept);
    expect_counts(other, 3);
    EXPECT_FALSE(made.prepare({.cache = cache.path(), .take_kept = false}).kept);
    expect_counts(made);
    EXPECT_FALSE(renderer(technique).prepare().kept);
}

TEST_F(SlicedPreparation, ADamagedFileIsMadeAnew) {
    const TemporaryTechnique folder(counting_search(1));
    const Technique technique = folder.load();
    const TemporaryFolder cache;
    const PreparationSettings settings{.cache = cache.path()};
    renderer(technique).prepare(settings);
    const std::filesystem::path file = std::filesystem::directory_iterator(cache.path())->path();
    const std::string whole = read_text_file(file);
    write_text_file(file, whole.substr(0, whole.size() / 2));
    Renderer again = renderer(technique);
    EXPECT_FALSE(again.prepare(settings).kept);
    expect_counts(again);
    EXPECT_TRUE(renderer(technique).prepare(settings).kept);
}

TEST_F(SlicedPreparation, WhatTakesTooLongIsGivenUp) {
    for (const bool ends_early : {false, true}) {
        const TemporaryTechnique folder(counting_search(15000, ends_early));
        const Technique technique = folder.load();
        const TemporaryFolder cache;
        const std::string reason = renderer(technique).prepare({.limit_s = 0, .cache = cache.path()}).given_up;
        EXPECT_NE(reason.find("the pass 'count'"), std::string::npos) << reason;
        EXPECT_NE(reason.find("preparation.limit_s"), std::string::npos) << reason;
        EXPECT_TRUE(std::filesystem::is_empty(cache.path()));
    }
}

TEST_F(SlicedPreparation, AMapWithoutSomeOfItsLevelsIsAnError) {
    const TemporaryTechnique folder(
        {{"technique.json", manifest_json(R"({"name": "deep", "type": "boolean", "default": false, "help": "h"})",
                                          R"(, "maps": [{"name": "chain", "format": "r32f", "mip_chain": true}],
                             "passes": [{"name": "a", "shader": "p.glsl", "writes": "chain"},
                                        {"name": "b", "shader": "p.glsl", "writes": "chain", "levels": "above_base",
                                         "only_with": {"deep": [true]}}])")},
         {"p.glsl", "void prepare(ivec2 texel) { write_map(vec4(1.0)); }"},
         {"trace.glsl", flat_trace}});
    const Technique technique = folder.load();
    EXPECT_NO_THROW(renderer(technique, {{"deep", true}}));
    EXPECT_THROW(renderer(technique), Error);
}

// lavapipe interpolates r16 and r32f in float, and rounds what it filters from r8 to 8 bits.
TEST_F(PreparationOnDevice, FilterDeviationIsSmall) {
    const bool cpu = device().info().type == gpu::DeviceType::cpu;
    // GPUs weigh texels in steps of 1/256, along both axes.
    const double weights = cpu ? 1e-5 : 2.0 / 256;
    EXPECT_LT(measure_filter_deviation(device(), HeightFormat::r32f), weights);
    EXPECT_LT(measure_filter_deviation(device(), HeightFormat::r16), weights);
    const double r8 = measure_filter_deviation(device(), HeightFormat::r8);
    EXPECT_LT(r8, 2.0 / 255 + weights);
    EXPECT_GT(r8, 0);
}

/// One map of three channels, 5x3 and its levels, each texel of level 0 with numbers of its own.
Files numbered_map(const std::string& trace) {
    return {{"technique.json",
             manifest_json(
                 "", R"(, "maps": [{"name": "numbers", "format": "rgba32f", "mip_chain": true, "linear_filter": true}],
                                    "passes": [{"name": "base", "shader": "base.glsl", "writes": "numbers"},
                                               {"name": "levels", "shader": "levels.glsl", "writes": "numbers",
                                                "levels": "above_base"}])")},
            {"base.glsl",
             "void prepare(ivec2 texel) {\n    float n = float(texel.y * map_size().x + texel.x);\n"
             "    write_map(vec4(n, n + 100.0, n + 200.0, n + 300.0));\n}\n"},
            {"levels.glsl", "void prepare(ivec2 texel) { write_map(previous_level(texel)); }\n"},
            {"trace.glsl", trace}};
}

// Neighbours ask for different levels; lavapipe's textureSize gives them one of their sizes.
TEST_F(PreparationOnDevice, EachPixelGetsTheSizeOfItsOwnLevel) {
    const TemporaryTechnique folder(numbered_map(R"(
        Trace trace(ReliefRay ray) {
            ivec2 pixel = ivec2(gl_FragCoord.xy);
            ivec2 size = map_size(numbers, (pixel.x + pixel.y) % 4);
            return hit_off_ray(ray.uv, float(10 * size.x + size.y) / 100.0, 0);
        })"));
    const SceneOnDevice scene(device(), make_map({5, 3}, [](int, int) { return 1.0; }), grey_albedo());
    const Probe probe =
        make_renderer(device(), folder.load(), scene, make_view(0, Projection::parallel, {8, 8})).probe();
    const float sizes[] = {0.53F, 0.21F, 0.11F, 0.11F};
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x)
            EXPECT_FLOAT_EQ(probe.hits.at(x, y).h, sizes[(x + y) % 4]) << x << ' ' << y;
    }
}

TEST_F(PreparationOnDevice, AGatherOfADerivedMapIsItsFourTexelsAndOneTap) {
    const TemporaryTechnique folder(numbered_map(R"(
        ivec2 wrapped(ivec2 texel) { return (texel % ivec2(5, 3) + ivec2(5, 3)) % ivec2(5, 3); }
        Trace trace(ReliefRay ray) {
            ivec2 cell = ivec2(gl_FragCoord.xy) - 7;
            int channel = (cell.x + cell.y + 14) % 4;
            vec4 found = tap_map_cell(numbers, cell, channel);
            vec4 expected;
            for (int i = 0; i < 4; ++i) {
                ivec2 texel = wrapped(cell + ivec2(i & 1, i >> 1));
                expected[i] = float(texel.y * 5 + texel.x + 100 * channel);
            }
            return hit_off_ray(ray.uv, found == expected ? 1.0 : 0.0, 0);
        })"));
    const SceneOnDevice scene(device(), make_map({5, 3}, [](int, int) { return 1.0; }), grey_albedo());
    const Probe probe =
        make_renderer(device(), folder.load(), scene, make_view(0, Projection::parallel, {16, 16})).probe();
    for (std::size_t i = 0; i < probe.hits.texels.size(); ++i) {
        EXPECT_EQ(probe.hits.texels[i].h, 1.0F) << i;
        EXPECT_EQ(probe.work.texels[i].taps, 1U);
        EXPECT_EQ(probe.work.texels[i].texels, 4U);
    }
}

}  // namespace
}  // namespace reliefbench
