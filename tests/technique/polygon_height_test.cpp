// A polygon within the relief: part of it stands above, part is sunk in.

#include "test_scene.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace reliefbench {
namespace {

using namespace test;

constexpr double height_scale = 0.1;
constexpr double floor_height = 0.3;
constexpr double view_angle = 70;
const double slope = std::tan(view_angle * std::numbers::pi / 180);

class PolygonHeight : public DeviceTest {
protected:
    Probe probe(const std::string& technique, const View& view, const ParameterValues& parameters = {},
                const SceneOnDevice& scene = floor()) const {
        return make_renderer(device(), techniques_.get(technique), scene, view, lights_off(), parameters).probe();
    }

    /// Parallel rays over relief without a border.
    static View floor_view(double polygon_height, double azimuth = -90) {
        View view = make_view(view_angle, Projection::parallel, {32, 32});
        view.camera.azimuth = azimuth;
        view.relief.height_scale = height_scale;
        view.relief.boundary = Boundary::repeat;
        set_polygon_height(view, polygon_height);
        return view;
    }
    static const SceneOnDevice& floor() {
        static const SceneOnDevice scene(device(),
                                         make_map(
                                             {4, 4}, [](int, int) { return floor_height; }, HeightFormat::r32f),
                                         grey_albedo());
        return scene;
    }
    /// (u, v) where the polygon shows in the middle pixel, whatever its height.
    static constexpr glm::dvec2 in_picture{16.5 / 32, 1 - 16.5 / 32};

private:
    TechniqueLibrary techniques_ = find_techniques({default_technique_root()});
};

/// Away from the eye by what the floor lies beneath the polygon, towards it by what it lies above.
TEST_F(PolygonHeight, IsWhereNothingMoves) {
    for (const char* technique : {"pom", "secant", "max_mip", "qdm", "tessellation"}) {
        for (const double height : {1.0, 0.6, floor_height, 0.0}) {
            const Hit hit = probe(technique, floor_view(height)).hits.at(16, 16);
            EXPECT_NEAR(hit.u, in_picture.x, 2e-5) << technique << ' ' << height;
            EXPECT_NEAR(hit.v - in_picture.y, (height - floor_height) * height_scale * slope, 2e-5)
                << technique << ' ' << height;
            EXPECT_NEAR(hit.h, floor_height, 2e-5) << technique << ' ' << height;
        }
    }
}

TEST_F(PolygonHeight, MovesThePolygonAndNotWhatIsSeenOfTheRelief) {
    HeightMapSource source;
    source.name = "rock";
    source.size = {64, 64};
    const SceneOnDevice rock(device(), load_height_map(source, HeightFormat::r16), grey_albedo());
    View within = make_view(60, Projection::perspective, {64, 48});
    within.camera.azimuth = -67;
    within.relief.height_scale = height_scale;
    set_polygon_height(within, 0.4);
    // The same camera over a polygon at h = 1.
    View above = within;
    above.relief.polygon_height = 1;
    for (const char* technique : {"pom", "qdm"}) {
        const Probe one = probe(technique, within, {}, rock);
        const Probe other = probe(technique, above, {}, rock);
        int compared = 0;
        for (int j = 0; j < within.resolution.height; ++j) {
            for (int i = 0; i < within.resolution.width; ++i) {
                const Ray ray = pixel_ray(within, i, j);
                if (!is_in_footprint(ray, within.relief) || !is_in_footprint(ray, above.relief)) continue;
                ++compared;
                ASSERT_EQ(one.hits.at(i, j), other.hits.at(i, j)) << technique << ' ' << i << ' ' << j;
            }
        }
        EXPECT_GT(compared, 500);
    }
}

TEST_F(PolygonHeight, IsWhereReliefFadesTo) {
    const Probe gone = probe("pom", floor_view(0.6, -50),
                             {{"lod_fade", std::string("mip")}, {"lod_fade_end", -10.0}, {"lod_fade_width", 0.0}});
    const Hit hit = gone.hits.at(16, 16);
    EXPECT_NEAR(hit.u, in_picture.x, 2e-5);
    EXPECT_NEAR(hit.v, in_picture.y, 2e-5);
    EXPECT_NEAR(hit.h, 0.6, 2e-5);
    EXPECT_EQ(gone.work.at(16, 16).steps, 0U);
}

/// PlayCanvas enters the relief where the shortened way, extrapolated back from the polygon, does.
TEST_F(PolygonHeight, IsWhereShortenedWaysMeetTheRay) {
    const Hit hit =
        probe("pom", floor_view(0.6), {{"grazing", std::string("limit")}, {"grazing_max_slope", 1.5}}).hits.at(16, 16);
    EXPECT_NEAR(hit.v - in_picture.y, (0.6 - floor_height) * height_scale * 1.5, 2e-5);
    const View view = floor_view(0.6);
    const Ray ray = pixel_ray(view, 16, 16);
    EXPECT_NEAR(hit.t, glm::dot(surface_point(view.relief, hit.u, hit.v, hit.h) - ray.origin, ray.direction), 2e-5);
}

/// What comes in through the side, beneath the top, is seen by no search that begins there.
TEST_F(PolygonHeight, LeavesABandAtTheClippedBorderOutOfTheFootprint) {
    View view = floor_view(0.5);
    const auto rows_in_footprint = [&] {
        int rows = 0;
        for (int j = 0; j < view.resolution.height; ++j)
            rows += is_in_footprint(pixel_ray(view, 16, j), view.relief) ? 1 : 0;
        return rows;
    };
    view.resolution = {32, 400};
    EXPECT_EQ(rows_in_footprint(), 400);
    view.relief.boundary = Boundary::clip;
    EXPECT_NEAR(rows_in_footprint(), 400 * (1 - 0.5 * height_scale * slope), 1);
}

}  // namespace
}  // namespace reliefbench
