#include "reference/light_visibility.hpp"
#include "test_scene.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;

using SelfShadowing = DeviceTest;

const char* const parallax_manifest =
    R"({"title": "Test", "kind": "parallax", "citation": "none", "promises": [], "shape": "quad", "parameters": []})";

/// Broad hills, so that shadows do not hang on single texels.
const HeightMap& hills() {
    static const HeightMap map = make_map({48, 32}, [](int x, int y) {
        return 0.5 + 0.25 * std::sin(x * 2 * 3.14159265 * 3 / 48) + 0.25 * std::cos(y * 2 * 3.14159265 * 2 / 32);
    });
    return map;
}

View shadowed_view(SelfShadow::Mode mode, Boundary boundary = Boundary::repeat) {
    View view = make_view(40, Projection::parallel);
    view.relief.height_scale = 0.1;
    view.relief.tiling = 2;
    view.relief.boundary = boundary;
    view.self_shadow.mode = mode;
    return view;
}

Lighting lit_from(const std::vector<glm::dvec3>& directions) {
    Lighting lighting;
    lighting.lights.clear();
    for (const glm::dvec3& direction : directions)
        lighting.lights.push_back({direction});
    return lighting;
}

struct Disagreement {
    std::size_t compared = 0;
    std::size_t wrong = 0;
    std::size_t shadowed = 0;
};

/// Of hard shadows at a technique's own hits with exact light rays. A light below the horizon of the surface decides
/// itself within the bias: such pixels are left out.
Disagreement against_exact_rays(const Probe& probe, const View& view, const Lighting& lighting, const HeightMap& map) {
    const Image<std::array<float, 2>> derivatives = height_derivatives(map);
    const LightVisibility exact = trace_light_visibility(probe.hits, map, view, lighting);
    Disagreement result;
    for (std::size_t i = 0; i < probe.hits.texels.size(); ++i) {
        const Hit& hit = probe.hits.texels[i];
        if (!hit.is_hit()) continue;
        const glm::dvec3 to_light = lighting.lights.front().direction;
        const double to_world = view.relief.height_scale * view.relief.tiling;
        const double rise = 1e-4;
        const auto slope = [&](double du, double dv) {
            const double u = view.relief.tiling * hit.u;
            const double v = view.relief.tiling * hit.v;
            return to_world * (map.sample(u + du, v + dv) - map.sample(u - du, v - dv)) / (2 * rise);
        };
        if (to_light.z - slope(rise, 0) * to_light.x - slope(0, rise) * to_light.y <= 0.02) continue;
        ++result.compared;
        result.wrong += probe.light_visibility.texels[i][0] != exact.fractions.texels[i][0] ? 1 : 0;
        result.shadowed += exact.fractions.texels[i][0] == 0 ? 1 : 0;
    }
    return result;
}

// Both of a technique's own search and, where it has none, of the harness's march.
TEST_F(SelfShadowing, HardShadowsAreThoseOfExactRays) {
    const TemporaryTechnique marching(Files{{"trace.glsl", march_trace}});
    const TemporaryTechnique polygon(Files{{"trace.glsl", flat_trace}, {"technique.json", parallax_manifest}});
    const SceneOnDevice scene(device(), hills(), grey_albedo());
    for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
        View view = shadowed_view(SelfShadow::Mode::hard, boundary);
        view.self_shadow.min_steps = view.self_shadow.max_steps = 256;
        for (const glm::dvec3 direction : {glm::dvec3(-1, 0.3, 0.3), glm::dvec3(0.2, -1, 0.5), glm::dvec3(1, 0, 0.2)}) {
            const Lighting lighting = lit_from({direction});
            for (const TemporaryTechnique* folder : {&marching, &polygon}) {
                const Probe probe = make_renderer(device(), folder->load(), scene, view, lighting).probe();
                const Disagreement found = against_exact_rays(probe, view, lighting, hills());
                EXPECT_GT(found.compared, 1000U);
                EXPECT_GT(found.shadowed, found.compared / 50);
                // Pixels on the edge of a shadow.
                EXPECT_LE(found.wrong, found.compared / 100)
                    << to_string(boundary) << ' ' << direction.x << (folder == &marching ? " own" : " harness's");
            }
        }
    }
}

// Byte-identical shaders under any kind cast the same shadows: those of the search that the manifest names.
TEST_F(SelfShadowing, HardOnesAreOfTheSearchNamedWhateverTheKind) {
    const SceneOnDevice scene(device(), hills(), grey_albedo());
    View view = shadowed_view(SelfShadow::Mode::hard);
    view.self_shadow.min_steps = view.self_shadow.max_steps = 3;
    const auto visibility = [&](const std::string& kind, const std::string& search) {
        const TemporaryTechnique folder(
            Files{{"trace.glsl", march_trace},
                  {"technique.json", fmt::format(R"({{"title": "Test", "contract": 2, "kind": "{}", "citation": "none",
                "promises": [], "shape": "quad", "shadow_search": "{}", "parameters": []}})",
                                                 kind, search)}});
        const Lighting lighting = lit_from({{-1, 0.3, 0.3}});
        return make_renderer(device(), folder.load(), scene, view, lighting).probe().light_visibility.texels;
    };
    const auto own = visibility("march", "own");
    const auto of_layers = visibility("march", "uniform_layers");
    EXPECT_NE(own, of_layers) << "three layers are few";
    for (const char* kind : {"texture", "cone"}) {
        EXPECT_EQ(visibility(kind, "own"), own) << kind;
        EXPECT_EQ(visibility(kind, "uniform_layers"), of_layers) << kind;
    }
}

TEST_F(SelfShadowing, IsEachLightsOwn) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const SceneOnDevice scene(device(), hills(), grey_albedo());
    const std::vector<glm::dvec3> directions{{-1, 0.2, 0.3}, {1, 0.2, 0.3}, {0.3, 1, -0.2}};
    for (const SelfShadow::Mode mode : {SelfShadow::Mode::hard, SelfShadow::Mode::soft}) {
        const View view = shadowed_view(mode);
        const Probe together = make_renderer(device(), folder.load(), scene, view, lit_from(directions)).probe();
        for (std::size_t light = 0; light < directions.size(); ++light) {
            const Probe alone =
                make_renderer(device(), folder.load(), scene, view, lit_from({directions[light]})).probe();
            for (std::size_t i = 0; i < alone.hits.texels.size(); ++i)
                ASSERT_EQ(together.light_visibility.texels[i][light], alone.light_visibility.texels[i][0]);
        }
        // Below the polygon's horizon; 1 where nothing is hit.
        for (std::size_t i = 0; i < together.hits.texels.size(); ++i) {
            const float expected = together.hits.texels[i].is_hit() ? 0.0F : 1.0F;
            ASSERT_EQ(together.light_visibility.texels[i][2], expected);
        }
    }
}

/// Dykhta's algorithm as his text tells it, in double.
double dykhta(const HeightMap& map, const View& view, const Hit& hit, glm::dvec3 to_light) {
    const double tiling = view.relief.tiling;
    const auto depth_at = [&](glm::dvec2 place) { return 1 - map.sample(tiling * place.x, tiling * place.y); };
    const double layers = 30 + (15 - 30) * to_light.z;
    const double initial_depth = depth_at({hit.u, hit.v}) - 0.05;
    const glm::dvec2 full_offset = glm::dvec2(to_light) / to_light.z * view.relief.height_scale;
    double shadow = 0;
    for (int step = 1;; ++step) {
        const double layer_depth = initial_depth * (1 - step / layers);
        if (layer_depth <= 0) break;
        const glm::dvec2 place = glm::dvec2(hit.u, hit.v) + (initial_depth - layer_depth) * full_offset;
        shadow = std::max(shadow, (layer_depth - depth_at(place)) * (1 - step / layers));
    }
    return std::pow(1 - shadow, 4);
}

/// The shadow term of the DirectX SDK's sample.
double tatarchuk(const HeightMap& map, const View& view, const Hit& hit, glm::dvec3 to_light) {
    const double tiling = view.relief.tiling;
    const auto height_at = [&](glm::dvec2 place) { return map.sample(tiling * place.x, tiling * place.y); };
    const glm::dvec2 here(hit.u, hit.v);
    const glm::dvec2 full_offset = glm::dvec2(to_light) * view.relief.height_scale;
    double occlusion = 0;
    constexpr std::pair<double, double> blockers[] = {{0.88, 1}, {0.77, 2},  {0.66, 4}, {0.55, 6},
                                                      {0.44, 8}, {0.33, 10}, {0.22, 12}};
    for (const auto& [distance, weight] : blockers)
        occlusion = std::max(occlusion,
                             (height_at(here + distance * full_offset) - height_at(here) - distance) * weight * 0.58);
    return std::clamp((1 - occlusion) * 0.6 + 0.4, 0.0, 1.0);
}

TEST_F(SelfShadowing, SoftShadowsFollowTheirPublishedFormulae) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const SceneOnDevice scene(device(), hills(), grey_albedo());
    for (const SelfShadow::Soft method : {SelfShadow::Soft::dykhta, SelfShadow::Soft::tatarchuk}) {
        View view = shadowed_view(SelfShadow::Mode::soft);
        view.relief.height_scale = 0.4;
        view.self_shadow.soft = method;
        for (const glm::dvec3 direction : {glm::dvec3(-1, 0.3, 0.4), glm::dvec3(0.2, -1, 1)}) {
            const glm::dvec3 to_light = glm::normalize(direction);
            const Probe probe = make_renderer(device(), folder.load(), scene, view, lit_from({direction})).probe();
            std::size_t shadowed = 0;
            for (std::size_t i = 0; i < probe.hits.texels.size(); ++i) {
                const Hit& hit = probe.hits.texels[i];
                if (!hit.is_hit()) continue;
                const double expected = method == SelfShadow::Soft::dykhta ? dykhta(hills(), view, hit, to_light)
                                                                           : tatarchuk(hills(), view, hit, to_light);
                // Floats, with heights of 16 bits filtered; Tatarchuk multiplies them by up to 12 · 0.58.
                ASSERT_NEAR(probe.light_visibility.texels[i][0], expected, 1e-4)
                    << static_cast<int>(method) << ' ' << i;
                shadowed += expected < 0.9 ? 1 : 0;
            }
            EXPECT_GT(shadowed, 100U);
        }
    }
}

// On h = 0 nothing shadows, so that every layer is looked at: 15 with the light overhead to 30 at the horizon, of which
// the last lies at the polygon. And one tap for the height under the point.
TEST_F(SelfShadowing, DykhtaTakesLayersByTheLightsAngle) {
    const TemporaryTechnique folder(Files{{"trace.glsl", flat_trace}});
    const SceneOnDevice scene(device(), make_map({4, 4}, [](int, int) { return 0; }), grey_albedo());
    View view = shadowed_view(SelfShadow::Mode::soft);
    for (const double sine : {1.0, 0.81, 0.6, 0.35, 0.1}) {
        const Lighting lighting = lit_from({{std::sqrt(1 - sine * sine), 0, sine}});
        const Probe probe = make_renderer(device(), folder.load(), scene, view, lighting).probe();
        const double layers = 30 + (15 - 30) * sine;
        EXPECT_EQ(probe.shadow_taps.at(20, 20), 1 + std::ceil(layers) - 1) << sine;
        EXPECT_EQ(probe.light_visibility.at(20, 20)[0], 1);
    }
    view.self_shadow.soft = SelfShadow::Soft::tatarchuk;
    const Probe probe = make_renderer(device(), folder.load(), scene, view, lit_from({{1, 0, 1}})).probe();
    EXPECT_EQ(probe.shadow_taps.at(20, 20), 1U + 7U);
}

TEST_F(SelfShadowing, WorkIsCountedApartFromTheSearch) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const SceneOnDevice scene(device(), hills(), grey_albedo());
    const Lighting lighting = lit_from({{1, 0, 1}, {-1, 0, 1}});
    const Probe without =
        make_renderer(device(), folder.load(), scene, shadowed_view(SelfShadow::Mode::off), lighting).probe();
    const Probe with =
        make_renderer(device(), folder.load(), scene, shadowed_view(SelfShadow::Mode::hard), lighting).probe();
    std::uint64_t taps = 0;
    for (std::size_t i = 0; i < with.hits.texels.size(); ++i) {
        ASSERT_EQ(with.work.texels[i].taps, without.work.texels[i].taps);
        ASSERT_EQ(with.hits.texels[i], without.hits.texels[i]);
        ASSERT_EQ(without.shadow_taps.texels[i], 0U);
        taps += with.shadow_taps.texels[i];
    }
    // Two more searches for nearly each pixel.
    EXPECT_GT(taps, with.hits.texels.size() * 100);
}

// As shipped, with the technique's own search compiled a second time.
TEST_F(SelfShadowing, TimedAndProbedAgree) {
    const TemporaryTechnique folder(Files{{"trace.glsl", march_trace}});
    const SceneOnDevice scene(device(), hills(), grey_albedo());
    const Lighting lighting = lit_from({{-1, 0.3, 0.3}});
    for (const SelfShadow::Mode mode : {SelfShadow::Mode::hard, SelfShadow::Mode::soft}) {
        Renderer renderer = make_renderer(device(), folder.load(), scene, shadowed_view(mode), lighting);
        const Probe probe = renderer.probe();
        const TimedPicture timed = renderer.draw_timed(ColourTarget::linear_float);
        for (std::size_t i = 0; i < probe.colour.texels.size(); ++i) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                ASSERT_EQ(probe.colour.texels[i][channel], timed.colour.texels[i][channel]) << i;
        }
    }
}

}  // namespace
}  // namespace reliefbench
