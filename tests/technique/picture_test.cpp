#include "reference/truth.hpp"
#include "scene/surface/base_source.hpp"
#include "test_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;
using Colours = Image<std::array<float, 3>>;

/// Vulkan's standard places of four samples in a pixel.
constexpr std::array<glm::dvec2, 4> standard_places{{{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}};

const HeightMap& hills() {
    static const HeightMap map = make_map({24, 16}, [](int x, int y) {
        return 0.5 + 0.25 * std::sin(x * 2 * 3.14159265 * 3 / 24) + 0.25 * std::cos(y * 2 * 3.14159265 * 2 / 16);
    });
    return map;
}

/// Texels of many colours, some of them beyond what a display shows.
Albedo patchwork() {
    return make_albedo({32, 32}, [](int x, int y) {
        return std::array<float, 4>{float((7 * x + 3 * y) % 11) / 5, float((5 * x + y) % 7) / 7, float((x + y) % 2), 1};
    });
}

SceneObject sphere() {
    SceneObject object;
    object.centre = {0.05, -0.1, -0.05};
    object.radius = 0.3;
    return object;
}

class Pictures : public DeviceTest {
protected:
    Renderer prepared(const std::string& technique, const View& view,
                      const std::optional<SceneObject>& object = std::nullopt) {
        const Technique shipped = techniques_.get(technique);
        Renderer renderer(device(), shipped, shipped.manifest.defaults(), scene_, view, lights_off(), object);
        renderer.prepare();
        return renderer;
    }

private:
    TechniqueLibrary techniques_ = find_techniques({default_technique_root()});
    SceneOnDevice scene_{device(), hills(), patchwork()};
};

View small_view(Projection projection) {
    View view = make_view(55, projection, {48, 40});
    view.relief.height_scale = 0.2;
    return view;
}

View with_samples(View view) {
    view.samples_per_pixel = 4;
    return view;
}

/// Of pictures of one sample at each of the places.
Colours mean_of_places(Renderer& renderer, const View& view) {
    Colours mean(view.resolution, {0, 0, 0});
    for (const glm::dvec2 place : standard_places) {
        Camera camera = view.camera;
        camera.shift = (place - 0.5) / glm::dvec2(view.resolution.width, view.resolution.height);
        const Colours colours = renderer.probe_from(camera, 0).colour;
        for (std::size_t i = 0; i < mean.texels.size(); ++i) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                mean.texels[i][channel] += colours.texels[i][channel] / 4;
        }
    }
    return mean;
}

/// Fraction of pixels.
double fraction_apart(const Colours& a, const Colours& b, float tolerance) {
    std::size_t apart = 0;
    for (std::size_t i = 0; i < a.texels.size(); ++i) {
        const auto differs = [&](std::size_t channel) {
            return !(std::abs(a.texels[i][channel] - b.texels[i][channel]) <= tolerance);
        };
        apart += differs(0) || differs(1) || differs(2);
    }
    return static_cast<double>(apart) / static_cast<double>(a.texels.size());
}

std::vector<std::uint32_t> taps_of(const Probe& probe) {
    std::vector<std::uint32_t> taps;
    for (const PixelWork& work : probe.work.texels)
        taps.push_back(work.taps);
    return taps;
}

/// A sample that rounding moves over an outline or a texel's edge changes its pixel by much, all others by rounding.
void expect_samples_at_their_places(Renderer& sampled, Renderer& plain, const View& view, const std::string& what) {
    const Probe probe = sampled.probe();
    const Probe centres = plain.probe();
    EXPECT_LE(fraction_apart(probe.colour, mean_of_places(plain, view), 2e-3F), 0.02) << what;
    EXPECT_GT(fraction_apart(probe.colour, centres.colour, 2e-3F), 0.1) << what;
    EXPECT_EQ(probe.hits.texels, centres.hits.texels) << what;
    EXPECT_EQ(taps_of(probe), taps_of(centres)) << what;
    EXPECT_EQ(probe.covered.texels, centres.covered.texels) << what;
}

}  // namespace

TEST_F(Pictures, EachSampleIsSearchedForAlongTheRayThroughItsPlace) {
    for (const char* technique : {"pom", "max_mip", "flat", "tessellation", "shell_march"}) {
        for (const Projection projection : {Projection::perspective, Projection::parallel}) {
            const View view = small_view(projection);
            Renderer sampled = prepared(technique, with_samples(view));
            Renderer plain = prepared(technique, view);
            expect_samples_at_their_places(sampled, plain, view, technique + (" " + to_string(projection)));
        }
    }
}

TEST_F(Pictures, SamplesOverCurvedBasesAreOfTheirOwnTriangle) {
    for (const char* technique : {"pom", "tessellation", "shell_march"}) {
        View view = small_view(Projection::perspective);
        view.relief.height_scale = 0.05;
        view.relief.base = load_base({.kind = BaseSource::Kind::sphere, .curvature = 2, .segments = 16});
        Renderer sampled = prepared(technique, with_samples(view));
        Renderer plain = prepared(technique, view);
        expect_samples_at_their_places(sampled, plain, view, technique);
    }
}

TEST_F(Pictures, SamplesHaveDepthsOfTheirOwn) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        for (const DepthWrite depth_write : {DepthWrite::on, DepthWrite::conservative, DepthWrite::off}) {
            View view = small_view(projection);
            view.depth_write = depth_write;
            Renderer sampled = prepared("pom", with_samples(view), sphere());
            Renderer plain = prepared("pom", view, sphere());
            const std::string what = to_string(projection) + " " + std::to_string(static_cast<int>(depth_write));
            expect_samples_at_their_places(sampled, plain, view, what);
            EXPECT_EQ(sampled.probe().front->texels, plain.probe().front->texels) << what;
        }
    }
    View view = small_view(Projection::perspective);
    const Colours on = prepared("pom", with_samples(view), sphere()).probe().colour;
    view.depth_write = DepthWrite::conservative;
    EXPECT_EQ(fraction_apart(prepared("pom", with_samples(view), sphere()).probe().colour, on, 0), 0);
    view.depth_write = DepthWrite::off;
    EXPECT_GT(fraction_apart(prepared("pom", with_samples(view), sphere()).probe().colour, on, 2e-3F), 0.02);
}

// What a display would be sent: the same mean, then clamped and encoded.
TEST_F(Pictures, WhatIsTimedIsResolvedInLinearLight) {
    const View view = with_samples(small_view(Projection::perspective));
    Renderer renderer = prepared("pom", view);
    const TimedPicture linear = renderer.draw_timed(ColourTarget::linear_float);
    const TimedPicture display = renderer.draw_timed(ColourTarget::display);
    EXPECT_TRUE(linear.depth.texels.empty());
    int mixed = 0;
    for (std::size_t i = 0; i < view.resolution.pixels(); ++i) {
        // Samples beyond 1 are clamped before they are averaged: only the blue ones are all within.
        const float blue = linear.colour.texels[i][2];
        const double encoded = blue <= 0.0031308F ? 12.92 * blue : 1.055 * std::pow(blue, 1 / 2.4) - 0.055;
        ASSERT_NEAR(display.colour.texels[i][2], encoded, 1.6 / 255) << i;
        mixed += blue > 0.2F && blue < 0.8F;
    }
    EXPECT_GT(mixed, 100);
    EXPECT_GT(renderer.time_draw(1).front(), 0);
}

TEST_F(Pictures, DevicesWithoutTargetsOfSoManySamplesAreSkippedWithTheReason) {
    const Technique pom = find_techniques({default_technique_root()}).get("pom");
    View view = small_view(Projection::parallel);
    const auto reason = [&](int samples) {
        view.samples_per_pixel = samples;
        return unsupported_reason(device(), pom, pom.manifest.defaults(), view, {24, 16});
    };
    EXPECT_EQ(reason(1), "");
    EXPECT_EQ(reason(4), "");
    // No CPU device has these.
    EXPECT_EQ(reason(2), device().info().name + " has no targets of 2 samples per pixel; of these it has 1, 4");
    EXPECT_EQ(reason(8), device().info().name + " has no targets of 8 samples per pixel; of these it has 1, 4");
}

TEST_F(Pictures, FramesAreAveragedInLinearLight) {
    for (const int samples : {1, 4}) {
        for (const bool has_object : {false, true}) {
            View view = small_view(Projection::perspective);
            view.samples_per_pixel = samples;
            const auto object = has_object ? std::optional(sphere()) : std::nullopt;
            Renderer one = prepared("pom", view, object);
            view.frames = 5;
            Renderer renderer = prepared("pom", view, object);
            const Probe probe = renderer.probe();
            Image<std::array<double, 3>> sum(view.resolution);
            for (int frame = 0; frame < view.frames; ++frame) {
                Camera camera = view.camera;
                camera.shift = frame_shift(frame, view.frames, view.resolution, samples);
                const Probe drawn = one.probe_from(camera, frame);
                for (std::size_t i = 0; i < sum.texels.size(); ++i) {
                    for (std::size_t channel = 0; channel < 3; ++channel)
                        sum.texels[i][channel] += static_cast<double>(drawn.colour.texels[i][channel]);
                }
            }
            for (std::size_t i = 0; i < sum.texels.size(); ++i) {
                for (std::size_t channel = 0; channel < 3; ++channel)
                    ASSERT_EQ(probe.colour.texels[i][channel],
                              static_cast<float>(sum.texels[i][channel] / view.frames));
            }
            const Probe centred = one.probe();
            EXPECT_EQ(probe.hits.texels, centred.hits.texels);
            EXPECT_EQ(taps_of(probe), taps_of(centred));
            EXPECT_EQ(probe.light_visibility.texels, centred.light_visibility.texels);
            EXPECT_EQ(probe.front.has_value(), has_object);
            if (has_object) {
                EXPECT_EQ(probe.front->texels, centred.front->texels);
            }
            EXPECT_GT(fraction_apart(probe.colour, centred.colour, 2e-3F), 0.1);
        }
    }
}

TEST_F(Pictures, OfSeveralFramesTheFirstIsTimed) {
    View view = small_view(Projection::perspective);
    view.frames = 4;
    Renderer renderer = prepared("pom", view);
    Camera camera = view.camera;
    camera.shift = frame_shift(0, 4, view.resolution);
    const Probe first = renderer.probe_from(camera, 0);
    const TimedPicture timed = renderer.draw_timed(ColourTarget::linear_float);
    for (std::size_t i = 0; i < view.resolution.pixels(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            ASSERT_EQ(timed.colour.texels[i][channel], first.colour.texels[i][channel]);
    }
    view.frames = 1;
    Renderer plain = prepared("pom", view);
    if (device().info().has_feature("pipelineStatisticsQuery")) {
        EXPECT_LE(renderer.pipeline_statistics().at("fragment_shader_invocations"),
                  1.2 * static_cast<double>(plain.pipeline_statistics().at("fragment_shader_invocations")));
    }
}

}  // namespace reliefbench
