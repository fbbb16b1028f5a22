// What frames are for: many cheap ones come to what a good one shows, as players see it, filtered.

#include "metrics/image_errors.hpp"
#include "reference/truth.hpp"
#include "technique/test_scene.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

using Colours = Image<std::array<float, 3>>;

/// The exact truth at so many times the resolution along both sides, averaged in linear light.
Colours filtered_truth(const HeightMap& map, const Albedo& albedo, View view, const Lighting& lighting) {
    constexpr int finer = 8;
    const Resolution size = view.resolution;
    view.resolution = {finer * size.width, finer * size.height};
    const Truth fine = trace_exact_truth(map, albedo, view, lighting);
    Colours mean(size, {0, 0, 0});
    for (int j = 0; j < view.resolution.height; ++j) {
        for (int i = 0; i < view.resolution.width; ++i) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                mean.at(i / finer, j / finer)[channel] += fine.colour.at(i, j)[channel] / (finer * finer);
        }
    }
    return mean;
}

class FramesOrder : public test::DeviceTest {
protected:
    struct Scene {
        HeightMap map;
        Albedo albedo;
        SceneOnDevice on_device;
        View view;
        Truth truth;
        Colours filtered;
    };

    Scene make_scene(const std::string& name, double view_angle) {
        HeightMapSource source;
        source.name = name;
        source.size = {128, 128};
        HeightMap map = load_height_map(source, HeightFormat::r16);
        Albedo albedo = load_albedo(source, map);
        View view = test::make_view(view_angle, Projection::parallel, {128, 128});
        view.relief.height_scale = 0.05;
        view.relief.boundary = Boundary::repeat;
        Truth truth = trace_exact_truth(map, albedo, view, lighting_);
        Colours filtered = filtered_truth(map, albedo, view, lighting_);
        SceneOnDevice on_device(device(), map, albedo);
        return {std::move(map), std::move(albedo), std::move(on_device), view, std::move(truth), std::move(filtered)};
    }

    /// What a picture is the mean of, and how it is marched.
    struct March {
        std::string technique = "pom";
        int layers = 8;
        int frames = 1;
        std::string start_offset = "off";
        int samples = 1;
        ParameterValues more = {};
    };

    /// Footprint FLIP against the filtered truth.
    double flip(const Scene& scene, const March& march) {
        View view = scene.view;
        view.frames = march.frames;
        view.samples_per_pixel = march.samples;
        ParameterValues parameters = march.more;
        parameters["max_steps"] = std::int64_t{march.layers};
        parameters["adaptive"] = false;
        parameters["start_offset"] = march.start_offset;
        const Technique technique = techniques_.get(march.technique);
        const Probe probe =
            test::make_renderer(device(), technique, scene.on_device, view, lighting_, parameters).probe();
        return *compare_images(probe.colour, probe.hits, scene.filtered, scene.truth.hits,
                               {scene.truth.footprint, scene.truth.background})
                    .footprint.flip;
    }

private:
    Lighting lighting_;
    TechniqueLibrary techniques_ = find_techniques({default_technique_root()});
};

TEST_F(FramesOrder, SixteenJitteredFramesOfEightLayersBeatOneAndComeWithinTwiceOneOfSixtyFour) {
    for (const char* map : {"rock", "cobbles", "waves"}) {
        const Scene scene = make_scene(map, 60);
        const double few = flip(scene, {});
        const double many = flip(scene, {.layers = 64});
        for (const char* noise : {"gradient_noise", "blue_noise"}) {
            const double frames = flip(scene, {.frames = 16, .start_offset = noise});
            EXPECT_LT(frames, few) << map << " " << noise;
            EXPECT_LT(frames, 2 * many) << map << " " << noise;
            const double both = flip(scene, {.frames = 4, .start_offset = noise, .samples = 4});
            EXPECT_LT(both, 1.2 * frames) << map << " " << noise;
        }
        EXPECT_LT(flip(scene, {.samples = 4}), few) << map;
    }
}

// A chord of a wall's two sides lies beside the wall, by less than a layer but always: frames average away noise and
// aliasing, and leave what all of them have in common. Halving finds the wall with as few layers.
TEST_F(FramesOrder, NoNumberOfFramesMakesUpForChordsOfWallsThinnerThanALayer) {
    const Scene scene = make_scene("bricks", 70);
    const double few = flip(scene, {});
    const double many = flip(scene, {.layers = 64});
    const double chords = flip(scene, {.frames = 16, .start_offset = "blue_noise"});
    EXPECT_LT(chords, few);
    EXPECT_GT(chords, 0.8 * few);
    EXPECT_GT(chords, 2 * many);
    EXPECT_LT(flip(scene, {.technique = "relief", .frames = 16, .start_offset = "blue_noise"}), 2 * many);
}

// Without halvings relief answers the middle of the layer, which is as often too high as too low once its layers move.
TEST_F(FramesOrder, MovingLayersIsWorthItWhereTheAnswerIsUnbiased) {
    const ParameterValues middle{{"binary_steps", std::int64_t{0}}};
    for (const char* map : {"rock", "waves"}) {
        const Scene scene = make_scene(map, 60);
        const double still = flip(scene, {.technique = "relief", .frames = 16, .more = middle});
        for (const char* noise : {"gradient_noise", "blue_noise"}) {
            const double moving =
                flip(scene, {.technique = "relief", .frames = 16, .start_offset = noise, .more = middle});
            EXPECT_LT(moving, 0.5 * still) << map << " " << noise;
        }
    }
}

}  // namespace
}  // namespace reliefbench
