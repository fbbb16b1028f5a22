#include "technique/blue_noise.hpp"
#include "technique/program.hpp"
#include "test_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;

/// Answers its noise for a coordinate.
std::string noise_trace(const std::string& noise) {
    return "#include \"pixel_noise.glsl\"\nTrace trace(ReliefRay ray) { return hit_off_ray(vec2(" + noise +
           "(), 0.0), 1.0, 0); }\n";
}

const char* const second_contract =
    R"({"title": "Test", "contract": 2, "kind": "march", "citation": "none", "promises": [], "shape": "quad", "parameters": []})";

double fraction(double x) {
    return x - std::floor(x);
}

/// Jimenez 2014.
double gradient_noise(int i, int j, int draw) {
    const double moved = 5.588238 * (draw % 64);
    return fraction(52.9829189 * fraction(0.06711056 * (i + moved) + 0.00583715 * (j + moved)));
}

/// Of two places on a circle of length 1.
double apart(double a, double b) {
    const double distance = std::abs(a - b);
    return std::min(distance, 1 - distance);
}

/// What single floats leave of the noise, which magnifies them.
constexpr double noise_tolerance = 5e-4;

class StartOffset : public DeviceTest {
protected:
    Renderer with_noise(const TemporaryTechnique& folder, const View& view, const std::filesystem::path& cache = {}) {
        const Technique technique = folder.load();
        Renderer renderer(device(), technique, technique.manifest.defaults(), scene_, view, lights_off());
        renderer.prepare({.cache = cache});
        return renderer;
    }

    Probe march(const std::string& technique, ParameterValues parameters, double height, const View& view) {
        const SceneOnDevice scene(device(),
                                  make_map(
                                      {8, 8}, [&](int, int) { return height; }, HeightFormat::r32f),
                                  grey_albedo());
        parameters["adaptive"] = false;
        return make_renderer(device(), techniques_.get(technique), scene, view, lights_off(), parameters).probe();
    }

    const TechniqueLibrary& techniques() const { return techniques_; }

    /// A ramp along u, over which colours tell coordinates.
    SceneOnDevice scene_{device(), make_map({8, 8}, [](int, int) { return 1.0; }),
                         make_albedo({1024, 1}, [](int x, int) {
                             return std::array<float, 4>{(float(x) + 0.5F) / 1024, 0, 0, 1};
                         })};

private:
    TechniqueLibrary techniques_ = find_techniques({default_technique_root()});
};

const View& noise_view() {
    static const View view = make_view(0, Projection::parallel, {96, 72});
    return view;
}

View repeating(double view_angle) {
    View view = make_view(view_angle, Projection::parallel, {40, 24});
    view.relief.boundary = Boundary::repeat;
    view.relief.height_scale = 0.1;
    return view;
}

ParameterValues layers(int count, const std::string& noise) {
    return {{"max_steps", std::int64_t{count}}, {"start_offset", noise}};
}

}  // namespace

TEST_F(StartOffset, GradientNoiseIsAsPublishedAndMovesFromFrameToFrame) {
    const TemporaryTechnique folder(
        Files{{"technique.json", second_contract}, {"trace.glsl", noise_trace("gradient_noise_of_pixel")}});
    Renderer renderer = with_noise(folder, noise_view());
    const auto expect = [&](const Probe& probe, int frame) {
        for (int j = 0; j < 72; ++j) {
            for (int i = 0; i < 96; ++i)
                ASSERT_LT(apart(probe.hits.at(i, j).u, gradient_noise(i, j, frame)), noise_tolerance) << i << " " << j;
        }
    };
    expect(renderer.probe(), 0);
    for (const int frame : {0, 1, 63, 65})
        expect(renderer.probe_from(noise_view().camera, frame), frame);
    EXPECT_EQ(renderer.probe().work.at(3, 4).taps, 0U);
}

TEST_F(StartOffset, BlueNoiseIsTheTextureAndGoesOnByTheGoldenRatio) {
    const TemporaryFolder cache;
    const TemporaryTechnique folder(
        Files{{"technique.json", second_contract}, {"trace.glsl", noise_trace("blue_noise_of_pixel")}});
    Renderer renderer = with_noise(folder, noise_view(), cache.path());
    const Image<float> noise = load_blue_noise({});
    const Probe still = renderer.probe();
    const Probe seventh = renderer.probe_from(noise_view().camera, 7);
    for (int j = 0; j < 72; ++j) {
        for (int i = 0; i < 96; ++i) {
            const float value = noise.at(i % 64, j % 64);
            ASSERT_EQ(still.hits.at(i, j).u, value);
            ASSERT_LT(apart(seventh.hits.at(i, j).u, fraction(value + 7 * 0.6180339887)), 1e-5);
            ASSERT_EQ(still.work.at(i, j).taps, 1U);
        }
    }
}

TEST_F(StartOffset, BlueNoiseIsCachedAndMadeAnewWhereItIsDamaged) {
    const TemporaryFolder cache;
    const Image<float> made = load_blue_noise(cache.path());
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(cache.path()))
        files.push_back(entry.path());
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(load_blue_noise(cache.path()).texels, made.texels);
    EXPECT_EQ(load_blue_noise({}).texels, made.texels);
    std::string text = read_text_file(files.front());
    text[text.size() - 7] ^= 1;
    write_text_file(files.front(), text);
    testing::internal::CaptureStderr();
    EXPECT_EQ(load_blue_noise(cache.path()).texels, made.texels);
    EXPECT_NE(testing::internal::GetCapturedStderr(), "");
}

// Of a pixel with four samples each has a value of its own.
TEST_F(StartOffset, SamplesHaveNoiseOfTheirOwn) {
    View view = noise_view();
    view.samples_per_pixel = 4;
    const TemporaryTechnique folder(
        Files{{"technique.json", second_contract}, {"trace.glsl", noise_trace("gradient_noise_of_pixel")}});
    const Probe probe = with_noise(folder, view).probe();
    // Where the ramp meets itself again it is not even.
    const auto is_near_an_end = [](double u) { return u < 0.01 || u > 0.99; };
    int compared = 0;
    for (int j = 0; j < 72; ++j) {
        for (int i = 0; i < 96; ++i) {
            double mean = 0;
            bool is_even = true;
            for (int sample = 0; sample < 4; ++sample) {
                const double noise = gradient_noise(i, j, sample);
                is_even = is_even && !is_near_an_end(noise);
                mean += noise / 4;
            }
            if (!is_even) continue;
            ++compared;
            ASSERT_NEAR(probe.colour.at(i, j)[0], mean, 2e-3);
        }
    }
    EXPECT_GT(compared, 6000);
}

TEST_F(StartOffset, MovesAllLayersByAPartOfOne) {
    constexpr int count = 8;
    const View view = repeating(60);
    const Probe probe = march("steep", layers(count, "gradient_noise"), 0.5, view);
    const Probe floor = march("steep", layers(count, "gradient_noise"), 0, view);
    for (int j = 0; j < view.resolution.height; ++j) {
        for (int i = 0; i < view.resolution.width; ++i) {
            const double first = gradient_noise(i, j, 0);
            if (first < 1e-3 || first > 1 - 1e-3) continue;
            // The first layer at or beneath h = 1/2, where s is 1/2.
            const double layer = std::ceil(count / 2 - first) + first;
            ASSERT_NEAR(probe.hits.at(i, j).h, 1 - layer / count, 1e-4);
            // The entry, the layers, and the last of them at the ray's end.
            ASSERT_EQ(probe.work.at(i, j).taps, 2 + std::ceil(count / 2 - first));
            ASSERT_EQ(floor.work.at(i, j).steps, count + 1U);
            ASSERT_EQ(floor.hits.at(i, j).h, 0);
        }
    }
}

TEST_F(StartOffset, LeavesRefinementsExactWhereTheyAre) {
    const View view = repeating(60);
    for (const char* noise : {"gradient_noise", "blue_noise"}) {
        for (const char* technique : {"pom", "secant"}) {
            // Of the chord of a plane.
            const Probe probe = march(technique, layers(5, noise), 0.37, view);
            for (const Hit& hit : probe.hits.texels)
                ASSERT_NEAR(hit.h, 0.37, 1e-5) << technique << " " << noise;
        }
        for (const char* technique : {"relief", "contact_refinement"}) {
            const Probe probe = march(technique, layers(5, noise), 0.37, view);
            for (const Hit& hit : probe.hits.texels)
                ASSERT_NEAR(hit.h, 0.37, 0.2 / 5 + 1e-5) << technique << " " << noise;
        }
    }
    // A plateau at the entry is hit there.
    for (const Hit& hit : march("pom", layers(5, "blue_noise"), 1, view).hits.texels)
        ASSERT_EQ(hit.h, 1);
}

TEST_F(StartOffset, OfAFractionalNumberTheLastLayerIsAtTheRaysEnd) {
    const View view = repeating(60);
    ParameterValues values{{"max_steps", std::int64_t{11}},
                           {"min_steps", std::int64_t{4}},
                           {"start_offset", std::string("gradient_noise")},
                           {"step_rounding", std::string("fractional")},
                           {"adaptive", true}};
    const SceneOnDevice scene(device(), make_map({8, 8}, [](int, int) { return 0.0; }), grey_albedo());
    const Probe floor = make_renderer(device(), techniques().get("steep"), scene, view, lights_off(), values).probe();
    // mix(11, 4, cos 60 degrees)
    const double count = 7.5;
    for (int j = 0; j < view.resolution.height; ++j) {
        for (int i = 0; i < view.resolution.width; ++i) {
            const double first = gradient_noise(i, j, 0);
            if (apart(first, 0.5) < 1e-3 || apart(first, 0) < 1e-3) continue;
            ASSERT_EQ(floor.work.at(i, j).steps, std::ceil(count - first) + 1);
            ASSERT_EQ(floor.hits.at(i, j).h, 0);
        }
    }
}

TEST_F(StartOffset, LayersOfBentRaysEndWhereTheRayDoes) {
    const View view = repeating(60);
    ParameterValues values = layers(6, "gradient_noise");
    values["hand_curvature"] = std::string("constant");
    for (const double curvature : {-2.0, 1.0}) {
        values["curvature_along_u"] = curvature;
        // H tan^2(60 degrees) / 2 of it.
        const double bend = curvature * 0.1 * 3 / 2;
        const double end = 2 / (1 + std::sqrt(1 - 4 * bend));
        const Probe probe = march("steep", values, 0.5, view);
        const double s_hit = 1 / (1 + std::sqrt(1 - 2 * bend));
        for (int j = 0; j < view.resolution.height; ++j) {
            for (int i = 0; i < view.resolution.width; ++i) {
                const double first = gradient_noise(i, j, 0);
                const double layer = std::ceil(6 * s_hit / end - first) + first;
                if (apart(fraction(6 * s_hit / end), first) < 2e-3) continue;
                const double s = std::min(layer / 6, 1.0) * end;
                ASSERT_NEAR(probe.hits.at(i, j).h, 1 - s + bend * s * s, 2e-4) << curvature;
            }
        }
    }
}

TEST_F(StartOffset, OffLeavesNothingInTheShader) {
    const Technique pom = techniques().get("pom");
    const auto text_of = [&](const std::string& noise) {
        ParameterValues values = pom.manifest.defaults();
        values["start_offset"] = noise;
        std::string text;
        for (const gpu::CompiledStage& stage : compile_draw(device(), pom, values, Variant::timed, View{}))
            text.append(reinterpret_cast<const char*>(stage.code->data()), stage.code->size() * sizeof(std::uint32_t));
        return text;
    };
    for (const char* word : {"noise", "start_offset", "draw_of_pixel"}) {
        EXPECT_EQ(text_of("off").find(word), std::string::npos) << word;
        EXPECT_NE(text_of("blue_noise").find(word), std::string::npos) << word;
    }
}

}  // namespace reliefbench
