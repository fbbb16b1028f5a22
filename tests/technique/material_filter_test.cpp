#include "metrics/image_errors.hpp"
#include "reference/truth.hpp"
#include "test_scene.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reliefbench {
namespace {

using namespace test;
using testing::HasSubstr;
using Files = TemporaryTechnique::Files;
using Kind = MaterialFilter::Kind;
using Gradients = MaterialFilter::Gradients;
using Colour = std::array<float, 4>;

/// What 16 bits round, by level, and once more when it is read.
constexpr double unorm16_step = 1.0 / 65535;

HeightMap flat_map(Resolution size) {
    return make_map(size, [](int, int) { return 1.0; });
}

/// Between `low` and `high`, in squares of `side` texels.
Albedo checkers(Resolution size, int side, float low = 0, float high = 1) {
    return make_albedo(size, [=](int x, int y) {
        const float value = (x / side + y / side) % 2 == 0 ? high : low;
        return Colour{value, value, value, 1};
    });
}

Albedo noise(Resolution size) {
    return make_albedo(size, [](int x, int y) {
        const auto channel = [&](int k) { return static_cast<float>((x * 37 + y * 101 + k * 53 + x * y) % 97) / 96; };
        return Colour{channel(0), channel(1), channel(2), 1};
    });
}

/// Means over areas of 1 / `size` of the map.
Albedo area_means(const Albedo& fine, Resolution size) {
    const double across = static_cast<double>(fine.texels.size.width) / size.width;
    const double up = static_cast<double>(fine.texels.size.height) / size.height;
    return make_albedo(size, [&](int i, int j) {
        std::array<double, 4> sum{};
        for (int y = 0; y < fine.texels.size.height; ++y) {
            for (int x = 0; x < fine.texels.size.width; ++x) {
                const double wide = std::min((i + 1) * across, x + 1.0) - std::max(i * across, double(x));
                const double high = std::min((j + 1) * up, y + 1.0) - std::max(j * up, double(y));
                if (wide <= 0 || high <= 0) continue;
                for (std::size_t channel = 0; channel < 4; ++channel)
                    sum[channel] += wide * high * static_cast<double>(fine.texels.at(x, y)[channel]);
            }
        }
        Colour mean;
        for (std::size_t channel = 0; channel < 4; ++channel)
            mean[channel] = static_cast<float>(sum[channel] / (across * up));
        return mean;
    });
}

View filtered(View view, Kind kind, Gradients gradients = Gradients::before_search, double mip_bias = 0) {
    view.material.kind = kind;
    view.material.gradients = gradients;
    view.material.mip_bias = mip_bias;
    return view;
}

/// Above a polygon that pixels cover evenly.
View above(Resolution resolution) {
    return make_view(0, Projection::parallel, resolution);
}

double largest_difference(const Image<std::array<float, 3>>& a, const Image<std::array<float, 3>>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.texels.size(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            largest = std::max(largest, std::abs(static_cast<double>(a.texels[i][channel]) -
                                                 static_cast<double>(b.texels[i][channel])));
    }
    return largest;
}

class MaterialFiltering : public DeviceTest {
protected:
    static const Technique& shipped(const std::string& id) {
        static const TechniqueLibrary library = find_techniques({default_technique_root()});
        return library.get(id);
    }
    static bool is_anisotropic() {
        const Technique& flat = shipped("flat");
        return unsupported_reason(device(), flat, flat.manifest.defaults(), filtered(above({8, 8}), Kind::anisotropic),
                                  {8, 8})
            .empty();
    }
    static Probe probe(const Technique& technique, const SceneOnDevice& scene, const View& view,
                       const ParameterValues& parameters = {}) {
        return make_renderer(device(), technique, scene, view, lights_off(), parameters).probe();
    }
};

// Each pixel is a square of 2^k texels, and its centre that of a texel of level k.
TEST_F(MaterialFiltering, AMipIsTheMeanOfItsTexels) {
    const Resolution size{64, 32};
    for (const Albedo::Format format : {Albedo::Format::float32, Albedo::Format::unorm16}) {
        Albedo albedo = noise(size);
        albedo.format = format;
        const SceneOnDevice scene(device(), flat_map(size), albedo);
        for (int k = 0; k <= 4; ++k) {
            const Resolution pixels{size.width >> k, size.height >> k};
            const Probe drawn = probe(shipped("flat"), scene, filtered(above(pixels), Kind::mip));
            const Albedo means = area_means(albedo, pixels);
            const double tolerance = format == Albedo::Format::float32 ? 2e-6 : (k + 1) * unorm16_step;
            for (int j = 0; j < pixels.height; ++j) {
                for (int i = 0; i < pixels.width; ++i) {
                    for (std::size_t channel = 0; channel < 3; ++channel)
                        ASSERT_NEAR(drawn.colour.at(i, j)[channel], means.texels.at(i, pixels.height - 1 - j)[channel],
                                    tolerance)
                            << "level " << k << " at " << i << ' ' << j;
                }
            }
        }
    }
}

// Levels of 13x9 texels have 6x4, 3x2 and 1x1 texels: whatever they cover in part, the mean stays.
TEST_F(MaterialFiltering, TheCoarsestMipIsTheMeanOfAnySize) {
    for (const Resolution size : {Resolution{13, 9}, Resolution{1, 7}, Resolution{48, 31}}) {
        const Albedo albedo = noise(size);
        const SceneOnDevice scene(device(), flat_map(size), albedo);
        const Probe drawn =
            probe(shipped("flat"), scene, filtered(above({4, 4}), Kind::mip, Gradients::before_search, 8));
        const Colour mean = area_means(albedo, {1, 1}).texels.at(0, 0);
        for (const std::array<float, 3>& colour : drawn.colour.texels) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                ASSERT_NEAR(colour[channel], mean[channel], 2e-6) << size.width << 'x' << size.height;
        }
    }
}

TEST_F(MaterialFiltering, ABiasOfOneIsOneLevelUp) {
    const Resolution size{64, 32};
    const Albedo albedo = noise(size);
    const SceneOnDevice scene(device(), flat_map(size), albedo);
    const Resolution pixels{32, 16};
    for (const int bias : {-1, 1, 2}) {
        const Probe drawn =
            probe(shipped("flat"), scene, filtered(above(pixels), Kind::mip, Gradients::before_search, bias));
        const Albedo level = area_means(albedo, {size.width >> (1 + bias), size.height >> (1 + bias)});
        for (int j = 0; j < pixels.height; ++j) {
            for (int i = 0; i < pixels.width; ++i) {
                const auto expected = level.sample((i + 0.5) / pixels.width, 1 - (j + 0.5) / pixels.height);
                for (std::size_t channel = 0; channel < 3; ++channel)
                    ASSERT_NEAR(drawn.colour.at(i, j)[channel], expected[channel], 1.0 / 256)
                        << "bias " << bias << " at " << i << ' ' << j;
            }
        }
    }
}

// Slopes of ±1 a texel are flat from the first level on: the normal is the polygon's.
TEST_F(MaterialFiltering, SlopesAreAveragedAsColoursAre) {
    const Resolution size{64, 64};
    const HeightMap ridges = make_map(size, [](int x, int) { return x % 4 < 2 ? 1.0 : 0.8; });
    const SceneOnDevice scene(device(), ridges, grey_albedo());
    const SceneOnDevice plain(device(), flat_map(size), grey_albedo());
    const ParameterValues bumps{{"normal_mapping", true}};
    const auto lit = [&](const SceneOnDevice& on, Kind kind) {
        return make_renderer(device(), shipped("flat"), on, filtered(above({16, 16}), kind), Lighting{}, bumps).probe();
    };
    const Probe flat = lit(plain, Kind::lod0);
    EXPECT_LT(largest_difference(lit(scene, Kind::mip).colour, flat.colour), 1e-5);
    EXPECT_GT(largest_difference(lit(scene, Kind::lod0).colour, flat.colour), 0.01);
}

// Eight times as many texels as pixels upwards, one across: a mip as coarse as the longer side loses the stripes.
TEST_F(MaterialFiltering, AnisotropyKeepsTheDetailAcrossAFootprint) {
    if (!is_anisotropic()) GTEST_SKIP() << "the device has no anisotropy of 16 by gradients";
    const Resolution size{64, 64};
    const Albedo stripes = make_albedo(size, [](int x, int) {
        const float value = x % 4 < 2 ? 1 : 0;
        return Colour{value, value, value, 1};
    });
    const SceneOnDevice scene(device(), flat_map(size), stripes);
    const auto contrast = [&](Kind kind, int anisotropy) {
        View view = filtered(above({64, 8}), kind);
        view.material.anisotropy = anisotropy;
        const Probe drawn = probe(shipped("flat"), scene, view);
        float low = 1;
        float high = 0;
        for (const std::array<float, 3>& colour : drawn.colour.texels) {
            low = std::min(low, colour[0]);
            high = std::max(high, colour[0]);
        }
        return high - low;
    };
    EXPECT_LT(contrast(Kind::mip, 16), 0.01);
    EXPECT_GT(contrast(Kind::anisotropic, 16), 0.95);
    EXPECT_LT(contrast(Kind::anisotropic, 1), 0.01);
    EXPECT_LT(contrast(Kind::anisotropic, 2), contrast(Kind::anisotropic, 16));
}

BaseSurface generated(BaseSource::Kind kind, double curvature = 0.8) {
    return load_base({.kind = kind, .curvature = curvature, .segments = 4});
}

struct Drawn {
    const char* technique;
    BaseSurface base;
};

std::vector<Drawn> ways_to_draw() {
    return {{"relief", {}},
            {"relief", generated(BaseSource::Kind::sphere)},
            {"shell_march", {}},
            {"shell_march", generated(BaseSource::Kind::cylinder)}};
}

// On a map of ones nothing is searched for, and the three know the same.
TEST_F(MaterialFiltering, OverAFlatReliefAllGradientsAreThoseOfTheBase) {
    const Resolution size{256, 256};
    const SceneOnDevice scene(device(), flat_map(size), checkers(size, 2));
    for (const Drawn& drawn : ways_to_draw()) {
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            View view = make_view(65, projection, {40, 32});
            view.camera.azimuth = -70;
            view.relief.base = drawn.base;
            const auto picture = [&](Gradients gradients) {
                return probe(shipped(drawn.technique), scene, filtered(view, Kind::mip, gradients)).colour;
            };
            const auto before = picture(Gradients::before_search);
            // Over a bent base a map of ones has its own, which analytic gradients know on the entry's triangle only.
            EXPECT_LT(largest_difference(picture(Gradients::analytic), before), 2e-3) << drawn.technique;
            // Differences of rays that are not parallel are those half a pixel beside.
            const double between = largest_difference(picture(Gradients::from_result), before);
            EXPECT_LT(between, projection == Projection::parallel && is_flat(drawn.base) ? 2e-3 : 0.06)
                << drawn.technique;
        }
    }
}

/// Trilinear by the book, where the picture's own sampler is the device's.
double trilinear(const std::vector<Albedo>& levels, double u, double v, double level) {
    const double clamped = std::clamp(level, 0.0, static_cast<double>(levels.size() - 1));
    const auto finer = static_cast<std::size_t>(clamped);
    const std::size_t coarser = std::min(finer + 1, levels.size() - 1);
    return std::lerp(levels[finer].sample(u, v)[0], levels[coarser].sample(u, v)[0],
                     clamped - static_cast<double>(finer));
}

// A ramp is a plane that is tilted: hits of neighbouring pixels are where the truth has them, and their differences are
// the gradients, exactly.
TEST_F(MaterialFiltering, AnalyticGradientsAreDifferencesOfTheTruthsHits) {
    const Resolution size{256, 256};
    const Albedo albedo = checkers(size, 4);
    std::vector<Albedo> levels;
    for (int side = size.width; side >= 1; side /= 2)
        levels.push_back(area_means(albedo, {side, side}));
    for (const double rise : {0.7, -0.7}) {
        const HeightMap ramp = make_map(
            size, [&](int x, int) { return 0.5 + rise * (x - 127.5) / 256; }, HeightFormat::r32f);
        const SceneOnDevice scene(device(), ramp, albedo);
        View view = make_view(60, Projection::parallel, {64, 256});
        view.camera.azimuth = 180;
        view.relief.height_scale = 0.3;
        const Probe drawn = probe(shipped("qdm"), scene, filtered(view, Kind::mip, Gradients::analytic));
        const Probe published = probe(shipped("qdm"), scene, filtered(view, Kind::mip));
        const Truth truth = trace_exact_truth(ramp, albedo, view, lights_off());
        double worst = 0;
        double worst_published = 0;
        int compared = 0;
        for (int j = 1; j < 255; ++j) {
            for (int i = 1; i < 63; ++i) {
                const Hit& hit = truth.hits.at(i, j);
                const Hit& left = truth.hits.at(i - 1, j);
                const Hit& right = truth.hits.at(i + 1, j);
                // Beside where the map repeats.
                const auto inside = [](const Hit& at) { return at.is_hit() && at.u > 0.03f && at.u < 0.97f; };
                if (!inside(hit) || !inside(left) || !inside(right)) continue;
                const double along_u = (static_cast<double>(right.u) - static_cast<double>(left.u)) / 2 * 256;
                const double level = std::log2(std::max(std::abs(along_u), 1.0));
                const double expected =
                    trilinear(levels, static_cast<double>(hit.u), static_cast<double>(hit.v), level);
                worst = std::max(worst, std::abs(static_cast<double>(drawn.colour.at(i, j)[0]) - expected));
                worst_published =
                    std::max(worst_published, std::abs(static_cast<double>(published.colour.at(i, j)[0]) - expected));
                ++compared;
            }
        }
        EXPECT_GT(compared, 1000) << rise;
        EXPECT_LT(worst, 0.02) << rise;
        // The slope shortens or lengthens what the published gradients know.
        EXPECT_GT(worst_published, 0.1) << rise;
    }
}

// From the plateau's edge to the floor behind it neighbours' answers are far apart.
TEST_F(MaterialFiltering, DifferencesOfAnswersShowASeamAtAnEdgeOfHeights) {
    const Resolution size{64, 64};
    // Aslant, so that it passes between the pixels of quads.
    const HeightMap step = make_map(size, [](int x, int y) { return x < 16 + y / 3 ? 0.0 : 1.0; });
    const SceneOnDevice scene(device(), step, checkers(size, 1));
    View view = make_view(60, Projection::parallel, {64, 64});
    view.camera.azimuth = 0;
    view.relief.height_scale = 0.25;
    view.relief.boundary = Boundary::repeat;
    const auto picture = [&](Gradients gradients) {
        return probe(shipped("qdm"), scene, filtered(view, Kind::mip, gradients));
    };
    const Probe plain = probe(shipped("qdm"), scene, view);
    const Probe result = picture(Gradients::from_result);
    const Probe before = picture(Gradients::before_search);
    const Probe analytic = picture(Gradients::analytic);
    int seams = 0;
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 64; ++i) {
            const Hit& hit = plain.hits.at(i, j);
            const Hit& neighbour = plain.hits.at(i ^ 1, j);
            // Not on the wall itself, whose slope is a texel wide.
            if ((hit.h > 0.001f && hit.h < 0.999f) || std::abs(hit.u - neighbour.u) * 64 < 8) continue;
            const auto grey = [&](const Probe& drawn) { return drawn.colour.at(i, j)[0]; };
            ++seams;
            // Of checkers of one texel every level but the base is their mean.
            EXPECT_NEAR(grey(result), 0.5f, 1e-5f);
            EXPECT_EQ(grey(before), grey(plain));
            if (hit.h < 0.5f) {
                EXPECT_NEAR(grey(analytic), grey(plain), 1e-5f);
            }
        }
    }
    EXPECT_GT(seams, 20);
}

// The relief has faded away, and the three with it.
TEST_F(MaterialFiltering, GradientsFadeWithTheRelief) {
    const Resolution size{128, 128};
    const HeightMap hills =
        make_map(size, [](int x, int y) { return 0.5 + 0.4 * std::sin(x * 0.4) * std::cos(y * 0.5); });
    const SceneOnDevice scene(device(), hills, checkers(size, 4));
    const View view = make_view(55, Projection::perspective, {48, 48});
    const ParameterValues faded{{"lod_fade", std::string("distance")}, {"lod_fade_end", 0.1}, {"lod_fade_width", 0.01}};
    const auto picture = [&](Gradients gradients) {
        return probe(shipped("relief"), scene, filtered(view, Kind::mip, gradients), faded).colour;
    };
    const auto before = picture(Gradients::before_search);
    EXPECT_EQ(picture(Gradients::analytic).texels, before.texels);
    EXPECT_LT(largest_difference(picture(Gradients::from_result), before), 0.05);
}

// Hits are the search's: whatever reads the material, they stay, and so does the work.
TEST_F(MaterialFiltering, TimedAndProbedAgreeAndHitsStay) {
    const Resolution size{40, 24};
    const HeightMap hills =
        make_map(size, [](int x, int y) { return 0.5 + 0.4 * std::sin(x * 0.6) * std::cos(y * 0.7); });
    const SceneOnDevice scene(device(), hills, noise(size));
    std::vector<Drawn> ways = ways_to_draw();
    ways.push_back({"tessellation", {}});
    ways.push_back({"tessellation", generated(BaseSource::Kind::saddle)});
    for (const Drawn& drawn : ways) {
        const Technique& technique = shipped(drawn.technique);
        View view = make_view(62, Projection::perspective, {56, 40});
        view.camera.azimuth = -50;
        view.relief.base = drawn.base;
        if (!unsupported_reason(device(), technique, technique.manifest.defaults(), view, size).empty()) continue;
        const Probe plain = make_renderer(device(), technique, scene, view).probe();
        for (const Kind kind : {Kind::mip, Kind::anisotropic}) {
            for (const Gradients gradients : {Gradients::before_search, Gradients::from_result, Gradients::analytic}) {
                const View other = filtered(view, kind, gradients);
                if (!unsupported_reason(device(), technique, technique.manifest.defaults(), other, size).empty())
                    continue;
                Renderer renderer = make_renderer(device(), technique, scene, other);
                const Probe probe = renderer.probe();
                EXPECT_EQ(probe.hits.texels, plain.hits.texels) << drawn.technique;
                EXPECT_EQ(probe.covered.texels, plain.covered.texels) << drawn.technique;
                for (std::size_t i = 0; i < probe.work.texels.size(); ++i)
                    ASSERT_EQ(probe.work.texels[i].taps, plain.work.texels[i].taps) << drawn.technique;
                EXPECT_NE(probe.colour.texels, plain.colour.texels) << drawn.technique;
                const TimedPicture timed = renderer.draw_timed(ColourTarget::linear_float);
                for (std::size_t i = 0; i < timed.colour.texels.size(); ++i) {
                    for (std::size_t channel = 0; channel < 3; ++channel)
                        ASSERT_EQ(timed.colour.texels[i][channel], probe.colour.texels[i][channel])
                            << drawn.technique << ' ' << static_cast<int>(gradients) << " pixel " << i;
                }
            }
        }
    }
}

TEST_F(MaterialFiltering, MipsAreTimedAndSizedWhereThereAreAny) {
    const Resolution size{64, 64};
    const SceneOnDevice scene(device(), flat_map(size), noise(size));
    const Technique& technique = shipped("flat");
    const auto prepared = [&](const View& view) {
        Renderer renderer(device(), technique, technique.manifest.defaults(), scene, view, lights_off());
        return renderer.prepare({.samples = 3});
    };
    const Preparation without = prepared(above({8, 8}));
    EXPECT_TRUE(without.pass_ms.empty());
    EXPECT_EQ(without.bytes, 0U);
    const Preparation with = prepared(filtered(above({8, 8}), Kind::mip));
    EXPECT_EQ(with.pass_ms.at("material_mips").size(), 3U);
    // A third of 8 and 16 bytes a texel; drivers round up.
    EXPECT_GE(with.bytes, 64U * 64 * 24 / 3);
    EXPECT_LE(with.bytes, 64U * 64 * 24);
}

TEST_F(MaterialFiltering, WhatADeviceCannotDoIsToldWithItsLimit) {
    const gpu::DeviceInfo& info = device().info();
    const Technique& technique = shipped("flat");
    const auto reason = [&](const MaterialFilter& material) {
        View view = above({8, 8});
        view.material = material;
        return unsupported_reason(device(), technique, technique.manifest.defaults(), view, {64, 64});
    };
    EXPECT_EQ(reason({.kind = Kind::mip, .mip_bias = info.max_lod_bias}), "");
    EXPECT_THAT(reason({.kind = Kind::mip, .mip_bias = -info.max_lod_bias - 1}), HasSubstr("to either side"));
    if (!info.has_feature("samplerAnisotropy")) return;
    EXPECT_THAT(reason({.kind = Kind::anisotropic, .anisotropy = static_cast<int>(info.max_anisotropy) + 1}),
                HasSubstr("has up to"));
    if (!info.has_feature("tessellationShader")) return;
    View view = filtered(above({8, 8}), Kind::mip, Gradients::analytic);
    const Technique& patches = shipped("tessellation");
    EXPECT_THAT(unsupported_reason(device(), patches, patches.manifest.defaults(), view, {64, 64}),
                HasSubstr("no search"));
}

/// The picture at eight times the resolution, averaged in linear light: what `lod0` comes to where pixels are small
/// enough.
Image<std::array<float, 3>> supersampled(const Image<std::array<float, 3>>& fine, Resolution size) {
    const int factor = fine.size.width / size.width;
    Image<std::array<float, 3>> mean(size);
    for (int j = 0; j < fine.size.height; ++j) {
        for (int i = 0; i < fine.size.width; ++i) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                mean.at(i / factor, j / factor)[channel] +=
                    fine.at(i, j)[channel] / static_cast<float>(factor * factor);
        }
    }
    return mean;
}

TEST_F(MaterialFiltering, MipsAreNearerToWhatAPlayerSeesAndAnisotropyIsNearerStill) {
    const Resolution size{128, 128};
    const HeightMap hills =
        make_map(size, [](int x, int y) { return 0.7 + 0.3 * std::sin(x * 0.1963495) * std::cos(y * 0.1472622); });
    const SceneOnDevice scene(device(), hills, checkers(size, 4, 0.05f, 0.8f));
    View view = make_view(75, Projection::perspective, {96, 96});
    view.relief.tiling = 4;
    view.relief.height_scale = 0.02;
    View fine = view;
    fine.resolution = {768, 768};
    const Technique& technique = shipped("qdm");
    const auto draw = [&](const View& from) {
        return make_renderer(device(), technique, scene, from, Lighting{}).probe();
    };
    const auto reference = supersampled(draw(fine).colour, view.resolution);
    const Probe plain = draw(view);
    const glm::vec3 background(Lighting{}.background);
    const Footprint footprint{plain.covered, {background.r, background.g, background.b}};
    const auto flip = [&](const Probe& drawn) {
        return *compare_images(drawn.colour, drawn.hits, reference, plain.hits, footprint).footprint.flip;
    };
    const double lod0 = flip(plain);
    const double mip = flip(draw(filtered(view, Kind::mip)));
    EXPECT_LT(mip, 0.6 * lod0);
    EXPECT_LT(flip(draw(filtered(view, Kind::mip, Gradients::analytic))), mip);
    if (!is_anisotropic()) return;
    const double anisotropic = flip(draw(filtered(view, Kind::anisotropic)));
    EXPECT_LT(anisotropic, 0.9 * mip);
    EXPECT_LT(flip(draw(filtered(view, Kind::anisotropic, Gradients::analytic))), anisotropic);
}

}  // namespace
}  // namespace reliefbench
