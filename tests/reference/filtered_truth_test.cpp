#include "reference/exact_tracer.hpp"
#include "reference/scrambled_points.hpp"
#include "reference/shading.hpp"
#include "reference/surface_shader.hpp"
#include "reference/truth.hpp"
#include "scene/shading_normal.hpp"
#include "scene/surface/generated_base.hpp"

#include <gtest/gtest.h>

#include <sched.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <set>
#include <thread>
#include <vector>

namespace reliefbench {
namespace {

using Colours = Image<std::array<float, 3>>;

HeightMap small_map(const char* name, int size) {
    HeightMapSource source;
    source.name = name;
    source.size = {size, size};
    return load_height_map(source, HeightFormat::r16);
}

Truth filtered(const HeightMap& map, const View& view, int samples, const Lighting& lighting = {},
               const SceneObject* object = nullptr) {
    return trace_exact_truth(map, load_albedo({}, map), view, lighting, {.samples = samples, .object = object});
}

double rms(const Image<float>& values) {
    double squares = 0;
    for (const float value : values.texels)
        squares += static_cast<double>(value) * value;
    return std::sqrt(squares / static_cast<double>(values.texels.size()));
}

/// Over pixels and channels.
double rms_difference(const Colours& first, const Colours& second) {
    double squares = 0;
    for (std::size_t pixel = 0; pixel < first.texels.size(); ++pixel) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double difference = first.texels[pixel][channel] - second.texels[pixel][channel];
            squares += difference * difference / 3;
        }
    }
    return std::sqrt(squares / static_cast<double>(first.texels.size()));
}

/// ±1 in turn, `width` texels each, repeating after `size` and interpolated between texel centres, from 0 to `texels`.
double integral_of_stripes(double texels, int size, int width) {
    const auto sign = [&](int texel) { return ((texel % size + size) % size) / width % 2 == 0 ? 1.0 : -1.0; };
    double integral = 0;
    // Between centres i − ½ and i + ½ lies a line.
    for (int i = 0; i - 0.5 < texels; ++i) {
        const double from = std::max(i - 0.5, 0.0);
        const double to = std::min(i + 0.5, texels);
        const double middle = (from + to) / 2 - (i - 0.5);
        integral += (to - from) * (sign(i - 1) * (1 - middle) + sign(i) * middle);
    }
    return integral;
}

TEST(FilteredTruth, APlanesPictureIsTheBoxFilteredChecker) {
    constexpr int size = 70;
    constexpr int width = 7;
    constexpr int contrast = 1;
    const HeightMap map = make_height_map(Image<float>({8, 8}, 1.0F), HeightFormat::r32f, "flat");
    Albedo checker{.texels = Image<std::array<float, 4>>({size, size}), .format = Albedo::Format::float32};
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const float white = (x / width + y / width) % 2 == 0 ? 1 : 0;
            checker.texels.at(x, y) = {white, white, white, 1};
        }
    }
    View view{.camera = {.projection = Projection::parallel}, .relief = {}, .resolution = {23, 17}};
    Lighting unlit;
    unlit.enabled = false;
    for (const int samples : {2, 3, 4, 16, 64, 100, 256, 1024}) {
        const Truth truth = trace_exact_truth(map, checker, view, unlit, {.samples = samples});
        ASSERT_EQ(truth.samples, samples);
        double largest = 0;
        for (int j = 0; j < view.resolution.height; ++j) {
            for (int i = 0; i < view.resolution.width; ++i) {
                const auto mean = [](int pixel, int pixels) {
                    const double texels = static_cast<double>(size) / pixels;
                    return (integral_of_stripes((pixel + 1) * texels, size, width) -
                            integral_of_stripes(pixel * texels, size, width)) /
                           texels;
                };
                const double exact = 0.5 + 0.5 * mean(i, view.resolution.width) *
                                               mean(view.resolution.height - 1 - j, view.resolution.height);
                largest = std::max(largest, std::abs(truth.colour.at(i, j)[1] - exact));
            }
        }
        // Where edges cross, halves of no power of two, or of few samples, do not cover corners as evenly.
        const double allowed = std::has_single_bit(static_cast<unsigned>(samples)) && samples >= 64 ? 2 : 4;
        EXPECT_LE(largest, allowed / samples * contrast) << samples << " samples";
    }
}

/// A few pixels on edges of shadows have most of the noise, so that one picture tells little.
TEST(FilteredTruth, FewAndManySamplesDifferByWhatTheNoiseSays) {
    double found = 0;
    double expected = 0;
    for (const char* name : {"rock", "bricks", "waves"}) {
        const HeightMap map = small_map(name, 128);
        for (const double azimuth : {-90.0, -33.0, 17.0, 101.0}) {
            View view{.camera = {.view_angle = 60, .azimuth = azimuth}, .relief = {}, .resolution = {48, 32}};
            view.self_shadow.mode = SelfShadow::Mode::hard;
            const Truth few = filtered(map, view, 64);
            const Truth many = filtered(map, view, 1024);
            const double noise = std::hypot(rms(*few.standard_error), rms(*many.standard_error));
            const double difference = rms_difference(few.colour, many.colour);
            EXPECT_NEAR(difference / noise, 1, 0.4) << name << " " << azimuth;
            found += difference * difference;
            expected += noise * noise;
            EXPECT_NEAR(rms_difference(few.colour, *few.half_picture) / rms(*few.standard_error), 1, 1e-3);
            EXPECT_LT(rms(*many.standard_error), rms(*few.standard_error) / 4)
                << "it converges, and faster than chance";
        }
    }
    EXPECT_NEAR(std::sqrt(found / expected), 1, 0.1);
}

/// The mean of pictures of one sample through a grid of places in each pixel.
Colours mean_of_shifted(const View& view, int grid, const std::function<Truth(const View&)>& trace) {
    Image<glm::dvec3> sums(view.resolution, glm::dvec3(0));
    for (int down = 0; down < grid; ++down) {
        for (int across = 0; across < grid; ++across) {
            View shifted = view;
            shifted.camera.shift = glm::dvec2((across + 0.5) / grid - 0.5, (down + 0.5) / grid - 0.5) /
                                   glm::dvec2(view.resolution.width, view.resolution.height);
            const Truth truth = trace(shifted);
            for (std::size_t pixel = 0; pixel < sums.texels.size(); ++pixel) {
                const std::array<float, 3>& colour = truth.colour.texels[pixel];
                sums.texels[pixel] += glm::dvec3(colour[0], colour[1], colour[2]);
            }
        }
    }
    Colours mean(view.resolution);
    for (std::size_t pixel = 0; pixel < sums.texels.size(); ++pixel) {
        const glm::dvec3 colour = sums.texels[pixel] / static_cast<double>(grid * grid);
        mean.texels[pixel] = {static_cast<float>(colour.x), static_cast<float>(colour.y), static_cast<float>(colour.z)};
    }
    return mean;
}

struct Scene {
    const char* name;
    View view;
    Lighting lighting;
    std::optional<SceneObject> object;
};

/// With all that a picture may have: fog, several lights, borders of the patch and of the object in sight.
Scene full_scene(const char* name, Boundary boundary, SelfShadow::Mode shadows) {
    Scene scene{.name = name, .view = {}, .lighting = {}, .object = SceneObject{}};
    scene.view.camera = {.view_angle = 50, .azimuth = -70, .distance = 1.1};
    scene.view.relief.height_scale = 0.2;
    scene.view.relief.tiling = 1.5;
    scene.view.relief.boundary = boundary;
    scene.view.resolution = {18, 13};
    scene.view.self_shadow.mode = shadows;
    scene.lighting.lights = {{.direction = {-0.9, 0.3, 0.5}, .angular_radius = 8},
                             {.direction = {0.5, 0.8, 0.6}, .colour = {0.2, 0.3, 0.9}, .angular_radius = 3}};
    scene.lighting.shininess = 21;
    scene.lighting.fog = Fog{.start = 0.5, .range = 1.5, .colour = {0.6, 0.6, 0.9}};
    return scene;
}

void expect_mean_of_shifted(const Scene& scene, int size, int grid, double tolerance) {
    const HeightMap map = small_map("rock", size);
    const SceneObject* const object = scene.object ? &*scene.object : nullptr;
    const auto trace = [&](const View& view) { return filtered(map, view, 1, scene.lighting, object); };
    const Colours mean = mean_of_shifted(scene.view, grid, trace);
    const Truth truth = filtered(map, scene.view, 1024, scene.lighting, object);
    EXPECT_LT(rms_difference(truth.colour, mean), tolerance) << scene.name;
    const Truth plain = trace(scene.view);
    EXPECT_GT(rms_difference(plain.colour, mean), 10 * tolerance) << scene.name << ": there is something to filter";
    // All but the picture is of the ray through the centre.
    EXPECT_EQ(truth.hits.texels, plain.hits.texels);
    EXPECT_EQ(truth.footprint.texels, plain.footprint.texels);
    EXPECT_EQ(truth.light_visibility.fractions.texels, plain.light_visibility.fractions.texels);
    EXPECT_EQ(truth.front.has_value(), object != nullptr);
    if (truth.front) {
        EXPECT_EQ(truth.front->texels, plain.front->texels);
    }
}

TEST(FilteredTruth, IsTheMeanOfPicturesOfOneSample) {
    expect_mean_of_shifted(full_scene("clipped", Boundary::clip, SelfShadow::Mode::hard), 32, 24, 2e-3);
    expect_mean_of_shifted(full_scene("repeating", Boundary::repeat, SelfShadow::Mode::hard), 32, 24, 2e-3);
    expect_mean_of_shifted(full_scene("soft", Boundary::clip, SelfShadow::Mode::soft), 32, 12, 3e-3);
    Scene parallel = full_scene("parallel", Boundary::clip, SelfShadow::Mode::hard);
    parallel.view.camera.projection = Projection::parallel;
    parallel.object.reset();
    expect_mean_of_shifted(parallel, 32, 24, 2e-3);
}

TEST(FilteredTruth, IsTheMeanOfPicturesOfOneSampleOverTriangles) {
    Scene curved = full_scene("sphere", Boundary::clip, SelfShadow::Mode::hard);
    curved.view.relief.base = load_base({.kind = BaseSource::Kind::sphere, .curvature = 1.5, .segments = 4});
    expect_mean_of_shifted(curved, 16, 16, 3e-3);
}

TEST(FilteredTruth, OfAMeshIsThatOfTheSurface) {
    const Scene scene = full_scene("mesh", Boundary::clip, SelfShadow::Mode::hard);
    const HeightMap map = small_map("rock", 32);
    const Albedo albedo = load_albedo({}, map);
    for (const bool flat : {true, false}) {
        View view = scene.view;
        if (!flat) view.relief.base = load_base({.kind = BaseSource::Kind::cylinder, .segments = 4});
        const TruthPicture picture{.samples = 64, .object = &*scene.object};
        const Truth exact = trace_exact_truth(map, albedo, view, scene.lighting, picture);
        const Truth mesh = trace_mesh_truth(map, albedo, view, scene.lighting, 8, picture);
        EXPECT_LT(rms_difference(exact.colour, mesh.colour), 3e-3) << flat;
        EXPECT_NE(exact.colour.texels, mesh.colour.texels) << "the mesh's own rays";
    }
}

TEST(FilteredTruth, WhereNothingIsSeenItIsTheBackground) {
    const HeightMap map = small_map("rock", 32);
    Lighting lighting;
    lighting.background = {0.1, 0.7, 1.0 / 3};
    const View view{.camera = {.view_angle = 60, .distance = 4}, .relief = {}, .resolution = {64, 64}};
    const Truth truth = filtered(map, view, 7, lighting);
    std::size_t shown = 0;
    for (std::size_t pixel = 0; pixel < truth.colour.texels.size(); ++pixel) {
        const bool is_background = truth.colour.texels[pixel] == truth.background;
        shown += is_background ? 0 : 1;
        EXPECT_FALSE(is_background && truth.standard_error->texels[pixel] != 0);
        EXPECT_FALSE(is_background && truth.hits.texels[pixel].is_hit());
    }
    EXPECT_GT(shown, 50U);
    EXPECT_LT(shown, 600U) << "pixels beyond the patch are exactly the background";
}

/// The bytes of a picture with its noise.
std::string bytes_of(const Truth& truth) {
    const auto bytes = [](const auto& texels) {
        return std::string(reinterpret_cast<const char*>(texels.data()), texels.size() * sizeof(texels[0]));
    };
    return bytes(truth.colour.texels) + bytes(truth.half_picture->texels) + bytes(truth.standard_error->texels);
}

TEST(FilteredTruth, HasTheSameBytesWhateverThreadsTraceIt) {
    const Scene scene = full_scene("threads", Boundary::clip, SelfShadow::Mode::soft);
    const HeightMap map = small_map("rock", 32);
    const auto trace = [&] { return bytes_of(filtered(map, scene.view, 24, scene.lighting, &*scene.object)); };
    const std::string expected = trace();
    std::vector<std::string> found(6);
    {
        std::vector<std::jthread> threads;
        for (std::string& each : found)
            threads.emplace_back([&] { each = trace(); });
    }
    // On one core, threads take turns.
    cpu_set_t all;
    ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    found.push_back(trace());
    ASSERT_EQ(sched_setaffinity(0, sizeof all, &all), 0);
    for (const std::string& each : found)
        EXPECT_TRUE(each == expected);
}

TEST(SurfaceShader, ShadesAsShadeDoes) {
    const HeightMap map = small_map("bricks", 32);
    const Albedo albedo = load_albedo({}, map);
    const Image<std::array<float, 2>> derivatives = height_derivatives(map);
    for (const double shininess : {0.0, 1.0, 32.0, 33.0, 77.5}) {
        Scene scene = full_scene("shader", Boundary::repeat, SelfShadow::Mode::off);
        scene.lighting.shininess = shininess;
        const SurfaceShader shader(map, albedo, scene.view.relief, scene.lighting);
        for (std::uint32_t index = 0; index < 2000; ++index) {
            // Beyond the unit square, too, and along texel borders.
            const glm::dvec2 uv = index < 4 ? glm::dvec2(index, 0) : 8.0 * scrambled_sobol_point(index, 3) - 4.0;
            const double tiling = scene.view.relief.tiling;
            const auto sampled = albedo.sample(tiling * uv.x, tiling * uv.y);
            const glm::dvec3 normal = shading_normal(derivatives, scene.view.relief, uv.x, uv.y);
            const glm::dvec3 to_eye = glm::normalize(glm::dvec3(0.3, -0.6, 0.4));
            const glm::dvec3 expected =
                shade(scene.lighting, {sampled[0], sampled[1], sampled[2]}, normal, to_eye, 0.9, {0.25, 1, 1});
            const glm::dvec3 found =
                shader.shade(uv, relief_normal(Plane{}, uv, shader.slope(uv)), to_eye, 0.9, {0.25, 1, 1});
            for (glm::length_t channel = 0; channel < 3; ++channel)
                ASSERT_NEAR(found[channel], expected[channel], 2e-5) << uv.x << " " << uv.y << " " << shininess;
        }
    }
}

TEST(ScrambledPoints, AreThoseMadeOneByOne) {
    const ScrambledPoints points(100);
    for (const std::uint64_t seed : {0U, 1U, 77U}) {
        std::vector<glm::dvec2> filled(90);
        points.fill(seed, filled);
        for (std::uint32_t index = 0; index < filled.size(); ++index) {
            EXPECT_EQ(filled[index], scrambled_sobol_point(index, seed));
            EXPECT_EQ(points.at(index, seed), scrambled_sobol_point(index, seed));
        }
    }
}

TEST(ScrambledPoints, IndicesAreShuffledWithinTheirBlocks) {
    constexpr std::uint32_t count = 64;
    std::set<std::vector<std::uint32_t>> orders;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        std::vector<std::uint32_t> order;
        for (std::uint32_t index = 0; index < count; ++index)
            order.push_back(scrambled_index(index, count, seed));
        EXPECT_EQ(std::set<std::uint32_t>(order.begin(), order.end()).size(), count);
        EXPECT_LT(*std::max_element(order.begin(), order.end()), count);
        for (std::uint32_t index = 0; index < count; index += 8) {
            for (std::uint32_t other = index; other < index + 8; ++other)
                EXPECT_EQ(order[index] / 8, order[other] / 8);
        }
        orders.insert(order);
    }
    EXPECT_GT(orders.size(), 10U);
    EXPECT_EQ(scrambled_index(0, 1, 5), 0U);
}

}  // namespace
}  // namespace reliefbench
