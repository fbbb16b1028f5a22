// What engines do at outlines: parameters of every technique that searches, and a curvature given by hand.

#include "technique/program.hpp"

#include "test_scene.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;

class SilhouetteParameters : public DeviceTest {
protected:
    static constexpr double height_scale = 0.1;
    static constexpr double view_angle = 70;

    Probe probe(const View& view, const ParameterValues& parameters) const {
        return make_renderer(device(), to_floor_, flat_floor(), view, Lighting{}, parameters).probe();
    }
    static View grazing_view(double azimuth = -90) {
        View view = make_view(view_angle, Projection::parallel, {32, 32});
        view.camera.azimuth = azimuth;
        view.relief.height_scale = height_scale;
        view.relief.boundary = Boundary::repeat;
        return view;
    }
    static const SceneOnDevice& flat_floor() {
        static const HeightMap map = make_map(
            {4, 4}, [](int, int) { return 0.3; }, HeightFormat::r32f);
        static const SceneOnDevice scene(device(), map, grey_albedo());
        return scene;
    }
    /// (u, v) where the ray of the middle pixel enters the plane.
    static glm::dvec2 entry(const View& view) { return *footprint_entry(pixel_ray(view, 16, 16)); }

    const TemporaryTechnique folder_{
        Files{{"trace.glsl", R"(
Trace trace(ReliefRay ray) {
#ifdef RELIEFBENCH_BENT_RAY
    if (leaves_above(ray)) return miss(1);
#endif
    return hit_on_ray(s_at_height(ray, 0.3), 1);
}
)"},
              {"technique.json", manifest_json("", R"(, "contract": 2, "include": ["ray_model.json"])")}}};
    const Technique to_floor_ = folder_.load();
    const double slope_ = std::tan(view_angle * std::numbers::pi / 180);
};

TEST_F(SilhouetteParameters, ThatAreOffLeaveNoConstant) {
    ParameterValues values = to_floor_.manifest.defaults();
    EXPECT_FALSE(parameter_constants(to_floor_.manifest, values).contains("grazing_max_slope"));
    EXPECT_FALSE(parameter_constants(to_floor_.manifest, values).contains("curvature_along_u"));
    values.at("grazing") = std::string("limit");
    EXPECT_TRUE(parameter_constants(to_floor_.manifest, values).contains("grazing_max_slope"));
}

TEST_F(SilhouetteParameters, LimitTheSlopeOfRaysThatGraze) {
    const View view = grazing_view();
    const Ray ray = pixel_ray(view, 16, 16);
    for (const double limit : {0.5, 2.0, 100.0}) {
        const Hit hit = probe(view, {{"grazing", std::string("limit")}, {"grazing_max_slope", limit}}).hits.at(16, 16);
        EXPECT_NEAR(hit.v - entry(view).y, 0.7 * height_scale * std::min(slope_, limit), 1e-5) << limit;
        EXPECT_NEAR(hit.h, 0.3, 1e-5);
        const glm::dvec3 point = surface_point(view.relief, hit.u, hit.v, hit.h);
        EXPECT_NEAR(hit.t, glm::dot(point - ray.origin, ray.direction), 1e-5) << limit;
    }
}

/// 1 divides by nothing, 0 by N·V, as a straight ray does.
TEST_F(SilhouetteParameters, DampTheDivisionByTheCosine) {
    const View view = grazing_view();
    const Ray ray = pixel_ray(view, 16, 16);
    const double z = std::cos(view_angle * std::numbers::pi / 180);
    const double xy = std::sin(view_angle * std::numbers::pi / 180);
    for (const double damp : {0.0, 0.3, 1.0}) {
        const Hit hit = probe(view, {{"grazing", std::string("damp")}, {"grazing_damping", damp}}).hits.at(16, 16);
        EXPECT_NEAR(hit.v - entry(view).y, 0.7 * height_scale * xy / (z * (1 - damp) + damp), 1e-5) << damp;
        EXPECT_NEAR(hit.h, 0.3, 1e-5);
        const glm::dvec3 point = surface_point(view.relief, hit.u, hit.v, hit.h);
        EXPECT_NEAR(hit.t, glm::dot(point - ray.origin, ray.direction), 1e-5) << damp;
    }
}

/// The ray crosses 4·H·tanθ texels of the map, which are larger than pixels.
TEST_F(SilhouetteParameters, FadeTheReliefWhereFewTexelsAreCrossed) {
    const View view = grazing_view();
    const double texels = 4 * height_scale * slope_;
    const auto faded = [&](double begin, double end) {
        return probe(
            view,
            {{"lod_fade", std::string("texels")}, {"lod_fade_begin_texels", begin}, {"lod_fade_end_texels", end}});
    };
    EXPECT_NEAR(faded(texels - 0.01, 0.1).hits.at(16, 16).h, 0.3, 1e-5);
    EXPECT_NEAR(faded(texels + 0.5, texels - 0.5).hits.at(16, 16).h, 0.65, 1e-4);
    const Probe gone = faded(9, texels + 0.01);
    EXPECT_EQ(gone.hits.at(16, 16).h, 1);
    EXPECT_EQ(gone.work.at(16, 16).steps, 0U);
    View far = view;
    far.relief.tiling = 64;  // 4·64/32: eight texels a pixel, so that of 281 texels 35 are left
    EXPECT_NEAR(probe(far, {{"lod_fade", std::string("texels")},
                            {"lod_fade_begin_texels", 8 * texels + 1},
                            {"lod_fade_end_texels", 8 * texels - 1}})
                    .hits.at(16, 16)
                    .h,
                0.65, 1e-3);
}

TEST_F(SilhouetteParameters, FadeTheReliefWhereRaysGraze) {
    const View view = grazing_view();
    const double cosine = std::cos(view_angle * std::numbers::pi / 180);
    const auto faded = [&](double begin, double end) {
        return probe(view, {{"grazing", std::string("fade")}, {"grazing_begin", begin}, {"grazing_end", end}});
    };
    EXPECT_NEAR(faded(cosine - 0.01, 0.1).hits.at(16, 16).h, 0.3, 1e-5);
    EXPECT_NEAR(faded(cosine + 0.1, cosine - 0.1).hits.at(16, 16).h, 0.65, 1e-4);
    const Probe gone = faded(0.9, cosine + 0.01);
    EXPECT_EQ(gone.hits.at(16, 16).h, 1);
    EXPECT_EQ(gone.work.at(16, 16).steps, 0U);
}

TEST_F(SilhouetteParameters, ClipByTheTexturesBoundsWhateverTheBoundary) {
    const View view = grazing_view();
    const Probe open = probe(view, {});
    const Probe clipped = probe(view, {{"texture_bounds", std::string("clip")}});
    int beyond = 0;
    for (std::size_t i = 0; i < open.hits.texels.size(); ++i) {
        ASSERT_TRUE(open.hits.texels[i].is_hit());
        const bool inside = open.hits.texels[i].v <= 1;
        if (!inside) ++beyond;
        EXPECT_EQ(clipped.hits.texels[i].is_hit(), inside);
    }
    EXPECT_GT(beyond, 50);
}

TEST_F(SilhouetteParameters, BendRaysByACurvatureGivenByHand) {
    const double full = height_scale * slope_;
    for (const double azimuth : {-90.0, 180.0}) {
        const View view = grazing_view(azimuth);
        const auto way = [&](const ParameterValues& parameters) {
            const Hit hit = probe(view, parameters).hits.at(16, 16);
            return hit.is_hit() ? glm::length(glm::dvec2(hit.u, hit.v) - entry(view)) : -1;
        };
        const auto expected = [&](double curvature) {
            const double bend = curvature * full * full / (2 * height_scale);
            return full * 2 * 0.7 / (1 + std::sqrt(1 - 4 * bend * 0.7));
        };
        const std::string constant = "constant";
        const std::string per_axis = "per_axis";
        EXPECT_NEAR(way({}), 0.7 * full, 1e-5);
        EXPECT_NEAR(way({{"hand_curvature", constant}, {"curvature_along_u", 0.5}}), expected(0.5), 1e-5);
        EXPECT_NEAR(way({{"hand_curvature", constant}, {"curvature_along_u", -2.0}}), expected(-2), 1e-5);
        EXPECT_NEAR(way({{"hand_curvature", per_axis}, {"curvature_along_u", 0.5}, {"curvature_along_v", -1.0}}),
                    expected(azimuth == -90 ? -1 : 0.5), 1e-5);
        // Past the outline of what is curved so.
        EXPECT_EQ(way({{"hand_curvature", constant}, {"curvature_along_u", 1.0}}), -1);
    }
}

TEST_F(SilhouetteParameters, GivenByHandAreTheBasesOwnCurvature) {
    View view = make_view(50, Projection::perspective);
    view.camera.azimuth = -70;
    view.relief.boundary = Boundary::repeat;
    view.relief.base = load_base({.kind = BaseSource::Kind::cylinder, .curvature = 1.5, .segments = 64});
    const Probe own = probe(view, {{"ray_model", std::string("quadric_uv")}});
    const Probe by_hand = probe(view, {{"ray_model", std::string("quadric_uv")},
                                       {"hand_curvature", std::string("per_axis")},
                                       {"curvature_along_u", 0.0},
                                       {"curvature_along_v", 1.5}});
    int compared = 0;
    for (std::size_t i = 0; i < own.hits.texels.size(); ++i) {
        const Hit& one = own.hits.texels[i];
        const Hit& other = by_hand.hits.texels[i];
        if (!one.is_hit() || !other.is_hit()) continue;
        ++compared;
        EXPECT_NEAR(one.u, other.u, 2e-5);
        EXPECT_NEAR(one.v, other.v, 2e-5);
    }
    EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace reliefbench
