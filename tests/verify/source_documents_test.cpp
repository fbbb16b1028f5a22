#include "verify_test.hpp"

#include "metrics/error_maps.hpp"
#include "reference/shading.hpp"
#include "scene/image_file.hpp"
#include "scene/shading_normal.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

/// What the documents that describe parallax mapping claim, each claim held to the technique, or the parameters of one,
/// that stands for it: Luna, "Parallax Occlusion in Direct3D 11" (2012); Dykhta, "Parallax Occlusion Mapping in GLSL"
/// (2013); RiZ, "Parallax Mapping with D3D and HLSL" (2006); "Theory: Parallax Occlusion Mapping" (2015); PV227 GPU
/// Rendering, lesson 13 (2016).

namespace reliefbench::test {

namespace {

class SourceDocuments : public VerifyTest {
protected:
    SourceDocuments() : rock_(device(), procedural("rock", {64, 64})) {}

    /// Of a pixel over a map of h = 0, on which every ray takes all of its steps.
    static PixelWork work_through(const std::string& technique, const ParameterValues& changed, double angle) {
        const CoordinateScene floor(device(), map_of({16, 16}, [](int, int) { return 0.0; }));
        return compare(technique, changed, floor, repeating(parallel_view(angle))).probe.work.at(40, 40);
    }

    static View repeating(View view) {
        view.relief.boundary = Boundary::repeat;
        return view;
    }

    /// Texture coordinates from the ray's entry to the hit, for each hit.
    static std::vector<glm::dvec2> offsets(const TruthComparison& found, const View& view) {
        std::vector<glm::dvec2> all;
        for (int j = 0; j < view.resolution.height; ++j) {
            for (int i = 0; i < view.resolution.width; ++i) {
                const Hit& hit = found.probe.hits.at(i, j);
                if (!hit.is_hit()) continue;
                const glm::dvec2 entry = *footprint_entry(pixel_ray(view, i, j));
                all.push_back(view.relief.tiling * (glm::dvec2(hit.u, hit.v) - entry));
            }
        }
        return all;
    }

    static double longest(const std::vector<glm::dvec2>& vectors) {
        return std::accumulate(vectors.begin(), vectors.end(), 0.0,
                               [](double most, glm::dvec2 vector) { return std::max(most, glm::length(vector)); });
    }

    /// The march as the documents write it, on the CPU: the first of the samples i/n at or beneath the surface; −1
    /// where rounding may decide otherwise. `cross` makes the answer of the two samples around the crossing.
    template <typename Cross>
    static double march(const HeightMap& map, const View& view, int i, int j, int samples, const Cross& cross) {
        const Ray ray = pixel_ray(view, i, j);
        const glm::dvec2 entry = view.relief.tiling * *footprint_entry(ray);
        const glm::dvec2 u_max =
            view.relief.tiling * view.relief.height_scale / -ray.direction.z * glm::dvec2(ray.direction);
        double gap_before = 0;
        for (int sample = 0; sample <= samples; ++sample) {
            const double s = static_cast<double>(sample) / samples;
            const glm::dvec2 place = entry + s * u_max;
            const double gap = (1 - s) - map.sample(place.x, place.y);
            if (std::abs(gap) < 1e-4) return -1;
            if (gap < 0) return gap_before - gap < 0.02 ? -1 : cross(sample, gap_before, gap) / samples;
            gap_before = gap;
        }
        return 1;
    }

    template <typename Cross>
    void expect_marched(const std::string& technique, const Cross& cross) {
        constexpr int samples = 6;
        for (View view : {repeating(parallel_view(65, -70)), repeating(perspective_view(50, 25))}) {
            view.relief.tiling = 1.5;
            const TruthComparison found =
                compare(technique, {{"adaptive", false}, {"max_steps", std::int64_t{samples}}}, rock_, view);
            int compared = 0;
            for (int j = 0; j < view.resolution.height; ++j) {
                for (int i = 0; i < view.resolution.width; ++i) {
                    const Hit& hit = found.probe.hits.at(i, j);
                    if (!hit.is_hit()) continue;
                    const double s = march(rock_.map, view, i, j, samples, cross);
                    if (s < 0) continue;
                    ++compared;
                    // Texture coordinates are single floats, and rock rises by up to a texel's width and more.
                    ASSERT_NEAR(1 - hit.h, s, 1e-4) << technique << " at " << i << ", " << j;
                }
            }
            EXPECT_GT(compared, 2000) << technique;
        }
    }

    CoordinateScene rock_;
};

std::vector<float> heights_of(const Probe& probe) {
    std::vector<float> heights;
    for (const Hit& hit : probe.hits.texels)
        heights.push_back(hit.h);
    return heights;
}

double cosine(double angle) {
    return std::cos(angle * std::numbers::pi / 180);
}

/// lerp(max, min, N·V)
double layers_by_angle(double most, double least, double angle) {
    return std::lerp(most, least, cosine(angle));
}

/// Cut off; where it is whole the last digit of a float decides.
double luna_count(double most, double least, double angle) {
    return std::floor(layers_by_angle(most, least, angle) + 1e-6);
}

/// Not cut off: so many steps until a layer lies at the floor or beneath it.
double dykhta_count(double most, double least, double angle) {
    return std::ceil(layers_by_angle(most, least, angle) - 1e-6);
}

/// As a file of 8 bits a channel, from the bottom row up.
RasterFile as_raster(const Image<float>& heights, std::vector<std::string> channels,
                     const std::function<void(float height, std::vector<float>& values)>& texel) {
    RasterFile raster;
    raster.size = heights.size;
    raster.channel_names = std::move(channels);
    for (int y = heights.size.height - 1; y >= 0; --y) {
        for (int x = 0; x < heights.size.width; ++x)
            texel(heights.at(x, y), raster.values);
    }
    return raster;
}

HeightMap stored_in_8_bits() {
    return map_of({32, 32}, [](int x, int y) { return ((x * 37 + y * 101) % 256) / 255.0; });
}

}  // namespace

// --- Luna -----------------------------------------------------------------------------------------------------------

/// Section 5.
TEST_F(SourceDocuments, LunaSampleCountIsTheLerpOfMaximumAndMinimumByNDotV) {
    const ParameterValues counts{{"min_steps", std::int64_t{10}}, {"max_steps", std::int64_t{51}}};
    for (const double angle : {0.0, 25.0, 50.0, 65.0, 80.0}) {
        const PixelWork work = work_through("pom", counts, angle);
        EXPECT_EQ(work.steps, luna_count(51, 10, angle)) << angle;
        EXPECT_EQ(work.taps, work.steps + 1) << "the entry's tap counts too";
    }
}

/// Section 3: u_max = −H·(ts/ws)·v_xy/v_z, here with five repeats of the texture over one unit of the world.
TEST_F(SourceDocuments, LunaRaysLeaveTheReliefAtTheMaximumOffset) {
    const CoordinateScene floor(device(), map_of({16, 16}, [](int, int) { return 0.0; }));
    View view = repeating(parallel_view(70, 25));
    view.relief.tiling = 5;
    const glm::dvec3 to_eye = -pixel_ray(view, 0, 0).direction;
    const glm::dvec2 u_max = -view.relief.height_scale * 5.0 / 1.0 * glm::dvec2(to_eye) / to_eye.z;
    // The lower end of the last interval, which is the floor; the middle lies above it.
    const std::vector<std::pair<std::string, ParameterValues>> techniques{
        {"steep", {}}, {"pom", {}}, {"relief", {{"binary_answer", std::string("beneath")}}}};
    for (const auto& [technique, values] : techniques) {
        for (const glm::dvec2 offset : offsets(compare(technique, values, floor, view), view)) {
            ASSERT_NEAR(offset.x, u_max.x, 1e-5) << technique;
            ASSERT_NEAR(offset.y, u_max.y, 1e-5) << technique;
        }
    }
}

/// Section 4: t = (h₋ − z₋) / (z − z₋ − h + h₋) of the way from the sample before the crossing to the one after.
TEST_F(SourceDocuments, LunaIntersectsSegmentWithSegment) {
    expect_marched("pom", [](int sample, double before, double after) {
        return sample == 0 ? 0 : sample - 1 + before / (before - after);
    });
}

/// Section 6: heights in the alpha channel of the normal map.
TEST_F(SourceDocuments, LunaHeightMayLieInTheNormalMapsAlpha) {
    const TemporaryFolder folder;
    const HeightMap heights = stored_in_8_bits();
    write_raster_file(folder / "normals.png",
                      as_raster(heights.heights, {"R", "G", "B", "A"}, [](float height, std::vector<float>& values) {
                          values.insert(values.end(), {0.5F, 0.5F, 1.0F, height});
                      }));
    HeightMapSource source;
    source.name = (folder / "normals.png").string();
    source.channel = "A";
    const HeightMap alpha = load_height_map(source, HeightFormat::r8);
    EXPECT_EQ(alpha.heights.texels, make_height_map(heights.heights, HeightFormat::r8, "").heights.texels);
}

/// Figure 7: finite steps miss peaks; the misses show in the error, and fall as steps rise.
TEST_F(SourceDocuments, LunaMissedPeaksShowAndFallAsStepsRise) {
    const CoordinateScene spikes(device(), procedural("spikes", {128, 128}));
    const View view = repeating(parallel_view(60, -70));
    const double stride = texels_through_relief(view, spikes.map, 0, 0);
    for (const std::string technique : {"steep", "relief", "pom"}) {
        std::vector<double> missed;
        for (const std::int64_t steps : {8, 16, 32, 64, 128}) {
            const TruthComparison found = compare(technique, {{"adaptive", false}, {"max_steps", steps}}, spikes, view);
            const Image<float> errors = uv_error_map(compared_hits(found, spikes.map, view.relief));
            // More than a step and a texel off: not imprecise, but another feature.
            const double another_feature = stride / static_cast<double>(steps) + 1;
            const auto count = std::ranges::count_if(errors.texels, [&](float e) { return e > another_feature; });
            missed.push_back(static_cast<double>(count) / static_cast<double>(errors.texels.size()));
        }
        EXPECT_GT(missed.front(), 0.02) << technique;
        EXPECT_LT(missed.back(), 0.25 * missed.front()) << technique;
        for (std::size_t i = 1; i < missed.size(); ++i)
            EXPECT_LT(missed[i], missed[i - 1]) << technique << " at " << (8 << i) << " steps";
    }
}

/// The alternative that parallax occlusion mapping stands in for.
TEST_F(SourceDocuments, LunaTessellationDisplacesToTheSameSurface) {
    const CoordinateScene waves(device(), procedural("waves", {64, 64}));
    const View view = perspective_view(50, -70);
    const TruthComparison pom = compare("pom", {{"adaptive", false}, {"max_steps", std::int64_t{128}}}, waves, view);
    const TruthComparison tessellated = compare("tessellation", {}, waves, view);
    EXPECT_LT(pom.errors.uv_texels->p95, 0.1);
    EXPECT_LT(tessellated.errors.uv_texels->p95, 0.1);
    const Image<float> apart =
        uv_error_map({pom.probe.hits, tessellated.probe.hits, pom.truth.footprint, waves.map, view.relief});
    const auto both = std::ranges::count_if(apart.texels, [](float texels) { return texels >= 0; });
    const auto close = std::ranges::count_if(apart.texels, [](float texels) { return texels >= 0 && texels < 0.25F; });
    EXPECT_GT(both, 1000);
    EXPECT_GT(static_cast<double>(close), 0.98 * static_cast<double>(both));
}

// --- Dykhta ---------------------------------------------------------------------------------------------------------

TEST_F(SourceDocuments, DykhtaOffsetLimitingBoundsTheOffsetByTheScale) {
    for (const double angle : {30.0, 60.0, 85.0, 89.0}) {
        const View view = repeating(parallel_view(angle, -70));
        const double limited = longest(offsets(compare("parallax", {{"offset_limiting", true}}, rock_, view), view));
        EXPECT_LE(limited, view.relief.height_scale) << angle;
        if (angle < 85) continue;
        const double unlimited = longest(offsets(compare("parallax", {{"offset_limiting", false}}, rock_, view), view));
        EXPECT_GT(unlimited, 2 * view.relief.height_scale) << "divided by V.z, at " << angle;
    }
}

/// The offset is V.xy·height, whatever V.z: it keeps the proportion of sin θ.
TEST_F(SourceDocuments, DykhtaOffsetLimitingDoesNotDivideByVz) {
    const CoordinateScene half(device(), map_of({16, 16}, [](int, int) { return 0.4; }));
    for (const double angle : {10.0, 45.0, 80.0, 89.0}) {
        const View view = repeating(parallel_view(angle, -70));
        const double expected = 0.6 * view.relief.height_scale * std::sin(angle * std::numbers::pi / 180);
        for (const glm::dvec2 offset : offsets(compare("parallax", {{"offset_limiting", true}}, half, view), view))
            ASSERT_NEAR(glm::length(offset), expected, 2e-6) << angle;
    }
}

TEST_F(SourceDocuments, DykhtaSteepTakesFiveToFifteenLayersByTheViewAngle) {
    for (const double angle : {0.0, 30.0, 60.0, 75.0, 85.0})
        EXPECT_EQ(work_through("steep", {}, angle).steps, dykhta_count(15, 5, angle)) << angle;
}

/// 10 to 15 layers and 5 halvings.
TEST_F(SourceDocuments, DykhtaReliefHalvesOneOfTenToFifteenLayersFiveTimes) {
    const ParameterValues published{{"min_steps", std::int64_t{10}},
                                    {"max_steps", std::int64_t{15}},
                                    {"adaptive", true},
                                    {"binary_steps", std::int64_t{5}}};
    for (const double angle : {0.0, 30.0, 60.0, 75.0, 85.0})
        EXPECT_EQ(work_through("relief", published, angle).steps, dykhta_count(15, 10, angle) + 5) << angle;
    // On ground at 0.4 the middle of that of the 2⁵ parts of a layer in which it lies.
    const CoordinateScene ground(device(), map_of({16, 16}, [](int, int) { return 0.4; }));
    const double parts = layers_by_angle(15, 10, 45) * 32;
    for (const float h : heights_of(compare("relief", published, ground, repeating(parallel_view(45))).probe))
        ASSERT_NEAR(1 - h, (std::ceil(0.6 * parts) - 0.5) / parts, 1e-6);
}

/// White = deep: an inverted map is the relief of the map turned over.
TEST_F(SourceDocuments, DykhtaDepthMapsAreInverted) {
    const TemporaryFolder folder;
    const HeightMap heights = make_height_map(stored_in_8_bits().heights, HeightFormat::r8, "heights");
    write_raster_file(folder / "depths.png",
                      as_raster(heights.heights, {"Y"},
                                [](float height, std::vector<float>& values) { values.push_back(1 - height); }));
    HeightMapSource source;
    source.name = (folder / "depths.png").string();
    source.invert = true;
    EXPECT_EQ(load_height_map(source, HeightFormat::r8).heights.texels, heights.heights.texels);
}

// --- RiZ ------------------------------------------------------------------------------------------------------------

/// Lit, on an albedo that encodes coordinates.
class Shaded : public SourceDocuments {
protected:
    static Probe draw_flat(bool normal_mapping, const CoordinateScene& scene, const View& view) {
        const Technique flat = shipped("flat");
        Renderer renderer(device(), flat, with_values(flat.manifest, {{"normal_mapping", normal_mapping}}),
                          scene.on_device, view, Lighting{});
        renderer.prepare();
        return renderer.probe();
    }

    /// Checks every pixel against the shading function on the CPU, with the normal that `normal_of` gives its entry.
    static void expect_shaded(const Probe& probe, const View& view, const Resolution& map,
                              const std::function<glm::dvec3(glm::dvec2 entry)>& normal_of) {
        for (int j = 0; j < view.resolution.height; ++j) {
            for (int i = 0; i < view.resolution.width; ++i) {
                const Ray ray = pixel_ray(view, i, j);
                const glm::dvec2 entry = *footprint_entry(ray);
                // Where bilinear albedo wraps at the border it encodes no coordinates.
                const glm::dvec2 texel = entry * glm::dvec2(map.width, map.height);
                if (texel.x < 1 || texel.y < 1 || texel.x > map.width - 1 || texel.y > map.height - 1) continue;
                const glm::dvec3 expected =
                    shade(Lighting{}, {entry.x, entry.y, 0}, normal_of(entry), -ray.direction, 0);
                for (int channel = 0; channel < 3; ++channel)
                    ASSERT_NEAR(probe.colour.at(i, j)[static_cast<std::size_t>(channel)], expected[channel], 2e-5)
                        << i << ", " << j;
            }
        }
    }
};

TEST_F(Shaded, RizTextureMappingShowsThePolygonOnly) {
    const View view = parallel_view(50, 25);
    expect_shaded(draw_flat(false, rock_, view), view, rock_.map.heights.size,
                  [](glm::dvec2) { return glm::dvec3(0, 0, 1); });
}

TEST_F(Shaded, RizNormalMappingLightsThePolygonWithTheReliefsNormals) {
    const View view = parallel_view(50, 25);
    const Image<std::array<float, 2>> derivatives = height_derivatives(rock_.map);
    expect_shaded(draw_flat(true, rock_, view), view, rock_.map.heights.size,
                  [&](glm::dvec2 entry) { return shading_normal(derivatives, view.relief, entry.x, entry.y); });
}

/// look·(height·0.04 − 0.02): a scale of 0.04, half of it out of the polygon.
TEST_F(SourceDocuments, RizParallaxScalesByFourHundredthsAndBiasesByTwo) {
    View view = repeating(parallel_view(55, 25));
    view.relief.height_scale = 0.04;
    const TruthComparison found =
        compare("parallax", {{"offset_limiting", true}, {"scale", 1.0}, {"bias", 0.5}}, rock_, view);
    for (int j = 0; j < view.resolution.height; ++j) {
        for (int i = 0; i < view.resolution.width; ++i) {
            const Ray ray = pixel_ray(view, i, j);
            const glm::dvec2 entry = *footprint_entry(ray);
            const glm::dvec2 look = -glm::dvec2(ray.direction);
            const glm::dvec2 expected = entry + look * (rock_.map.sample(entry.x, entry.y) * 0.04 - 0.02);
            ASSERT_NEAR(found.probe.hits.at(i, j).u, expected.x, 2e-6);
            ASSERT_NEAR(found.probe.hits.at(i, j).v, expected.y, 2e-6);
        }
    }
}

/// Tangent along u, binormal along v, normal out of the polygon: an eye over +u sees the relief shifted along u alone.
TEST_F(SourceDocuments, RizLookVectorsAreInTheTangentFrame) {
    const auto mean_offset = [&](double azimuth) {
        const View view = repeating(parallel_view(45, azimuth));
        const std::vector<glm::dvec2> all = offsets(compare("pom", {}, rock_, view), view);
        return std::accumulate(all.begin(), all.end(), glm::dvec2(0)) / static_cast<double>(all.size());
    };
    const glm::dvec2 from_u = mean_offset(0);
    const glm::dvec2 from_v = mean_offset(90);
    EXPECT_LT(from_u.x, -0.01) << "the ray runs away from the eye";
    EXPECT_NEAR(from_u.y, 0, 1e-6);
    EXPECT_LT(from_v.y, -0.01);
    EXPECT_NEAR(from_v.x, 0, 1e-6);
}

// --- "Theory: Parallax Occlusion Mapping" ---------------------------------------------------------------------------

/// ratio = delta / (delta + delta before); offset = ratio·(offset before) + (1 − ratio)·offset.
TEST_F(SourceDocuments, TheoryCrossingIsTheRatioOfTheTwoHeightDifferences) {
    expect_marched("pom", [](int sample, double before, double after) {
        const double delta = -after;
        const double ratio = delta / (delta + before);
        return sample == 0 ? 0 : ratio * (sample - 1) + (1 - ratio) * sample;
    });
}

// --- PV227 ----------------------------------------------------------------------------------------------------------

/// Task 1: the first of the samples i/#samples that is deeper than the surface.
TEST_F(SourceDocuments, Pv227FirstIntersectionIsTheFirstSampleBeneath) {
    expect_marched("steep", [](int sample, double, double) { return static_cast<double>(sample); });
}

/// Task 2: better with fewer samples.
TEST_F(SourceDocuments, Pv227MorePreciseIntersectionNeedsFewerSamples) {
    const CoordinateScene waves(device(), procedural("waves", {256, 256}));
    const View view = repeating(parallel_view(60, -70));
    const auto median = [&](const std::string& refinement, std::int64_t samples) {
        const ParameterValues values{{"adaptive", false}, {"max_steps", samples}, {"refinement", refinement}};
        return compare("steep", values, waves, view).errors.uv_texels->p50;
    };
    EXPECT_LT(median("linear", 16), median("none", 64));
}

/// Task 3, without the other objects: the depth that is written is that of the displaced point.
TEST_F(SourceDocuments, Pv227DepthIsThatOfTheDisplacedPoint) {
    const View view = perspective_view(55, 25);
    const Technique pom = shipped("pom");
    Renderer renderer(device(), pom, pom.manifest.defaults(), rock_.on_device, view, coordinate_lighting());
    renderer.prepare();
    const Probe probe = renderer.probe();
    const TimedPicture timed = renderer.draw_timed(ColourTarget::display);
    const glm::dmat4 clip_from_world = reliefbench::clip_from_world(view);
    int behind_polygon = 0;
    for (int j = 0; j < view.resolution.height; ++j) {
        for (int i = 0; i < view.resolution.width; ++i) {
            const Hit& hit = probe.hits.at(i, j);
            if (!hit.is_hit()) continue;
            const glm::dvec3 displaced{hit.u - 0.5, hit.v - 0.5, (hit.h - 1.0) * view.relief.height_scale};
            const glm::dvec4 clip = clip_from_world * glm::dvec4(displaced, 1);
            ASSERT_NEAR(timed.depth.at(i, j), clip.z / clip.w, 1e-5);
            const Ray ray = pixel_ray(view, i, j);
            const glm::dvec2 entry = *footprint_entry(ray);
            const glm::dvec4 polygon = clip_from_world * glm::dvec4(entry.x - 0.5, entry.y - 0.5, 0, 1);
            if (timed.depth.at(i, j) > polygon.z / polygon.w + 1e-5) ++behind_polygon;
        }
    }
    EXPECT_GT(behind_polygon, 1000);
}

/// A texture laid twice over the patch is the relief of a map that holds it twice over each side.
TEST_F(SourceDocuments, Pv227TextureSpaceHasAScaleOfItsOwn) {
    const auto height = [](int x, int y) { return 0.5 + 0.5 * std::sin(x * 0.7) * std::cos(y * 0.4 + x * 0.2); };
    const CoordinateScene once(device(), map_of({32, 32}, height));
    const CoordinateScene twice(device(), map_of({64, 64}, [&](int x, int y) { return height(x % 32, y % 32); }));
    View view = repeating(parallel_view(60, -70));
    const Probe whole = compare("pom", {}, twice, view).probe;
    view.relief.tiling = 2;
    const Probe tiled = compare("pom", {}, once, view).probe;
    for (std::size_t i = 0; i < whole.hits.texels.size(); ++i) {
        ASSERT_NEAR(tiled.hits.texels[i].u, whole.hits.texels[i].u, 1e-5);
        ASSERT_NEAR(tiled.hits.texels[i].h, whole.hits.texels[i].h, 1e-4);
    }
}

}  // namespace reliefbench::test
