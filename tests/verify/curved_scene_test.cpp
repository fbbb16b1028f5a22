// What stands over, behind and beside bases that are not flat, drawn and compared with the truth.

#include "verify_test.hpp"

#include "metrics/raster_mismatch.hpp"
#include "metrics/wrong_surface.hpp"
#include "scene/surface/charts.hpp"
#include "support/closed_cylinder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace reliefbench::test {
namespace {

using Kind = BaseSource::Kind;
using testing::Each;

const ParameterValues bent{{"ray_model", std::string("quadric_uv")}};

class CurvedScene : public VerifyTest {
protected:
    static const CoordinateScene& rock() {
        static const CoordinateScene scene(device(), procedural("rock", {64, 64}));
        return scene;
    }

    static BaseSurface generated(Kind kind, double curvature) {
        return load_base({.kind = kind, .curvature = curvature, .segments = 64});
    }

    static BaseSurface surface_of(BaseMesh mesh) {
        return {MeshBase{std::make_shared<const BaseMesh>(std::move(mesh))}};
    }

    /// Turned about x by 180°, and scaled.
    static BaseSurface turned_over(const BaseSurface& base, float scale = 1) {
        BaseMesh mesh = curved_base(base);
        for (MeshVertex& vertex : mesh.vertices) {
            vertex.position = scale * vertex.position * glm::vec3(1, -1, -1);
            vertex.normal *= glm::vec3(1, -1, -1);
        }
        return surface_of(std::move(mesh));
    }

    static void expect_numbers(const TruthComparison& found) {
        for (const Hit& hit : found.probe.hits.texels) {
            if (!hit.is_hit()) continue;
            EXPECT_TRUE(std::isfinite(hit.u + hit.v + hit.h + hit.t));
        }
        for (const std::array<float, 3>& normal : found.probe.normals->texels)
            EXPECT_TRUE(std::isfinite(normal[0] + normal[1] + normal[2]));
    }
};

TEST_F(CurvedScene, FromBehindNothingIsHit) {
    for (const char* id : {"max_mip", "pom", "tessellation", "shell_march"}) {
        for (const double curvature : {-0.5, 0.5}) {
            for (View view : {perspective_view(10), parallel_view(20)}) {
                // Flat enough for no slope to face the viewer.
                view.relief.height_scale = 0.01;
                view.relief.base = turned_over(generated(Kind::sphere, curvature));
                const TruthComparison found = compare(id, {}, rock(), view);
                EXPECT_THAT(found.truth.footprint.texels, Each(0));
                EXPECT_EQ(std::ranges::count_if(found.truth.hits.texels, &Hit::is_hit), 0);
                EXPECT_EQ(std::ranges::count_if(found.probe.hits.texels, &Hit::is_hit), 0) << id;
                EXPECT_EQ(found.errors.missed + found.errors.false_hits, 0);
                EXPECT_EQ(found.errors.coverage_iou, 1);
                EXPECT_FALSE(found.errors.uv_texels);
            }
        }
    }
}

// Half of the pipe shows its back, through which its inside is seen.
TEST_F(CurvedScene, ThroughTheBackOfAConcaveBaseItsInsideIsHit) {
    for (const char* id : {"max_mip", "pom"}) {
        for (const View& from : {perspective_view(65), parallel_view(65)}) {
            View view = from;
            view.relief.height_scale = 0.03;
            view.relief.base = generated(Kind::cylinder, -3);
            const TruthComparison found = compare(id, bent, rock(), view);
            expect_numbers(found);
            // The near half lies before the origin's depth in v.
            const auto behind = std::ranges::count_if(found.truth.hits.texels,
                                                      [](const Hit& hit) { return hit.is_hit() && hit.v > 0.5F; });
            EXPECT_GT(behind, 300);
            EXPECT_GT(found.errors.compared, 500U);
            EXPECT_LT(found.errors.missed, 0.03) << id;
            EXPECT_LT(found.errors.false_hits, 0.03) << id;
            EXPECT_LT(found.errors.uv_texels->p50, 0.2) << id;
            EXPECT_LT(raster_mismatch(found.probe.covered, found.truth.footprint), 0.01);
        }
    }
}

TEST_F(CurvedScene, ABaseSmallerThanAPixelIsThatOfTheTruth) {
    for (const char* id : {"max_mip", "pom", "tessellation", "shell_march"}) {
        for (const int side : {33, 32}) {
            View view = perspective_view(30);
            view.resolution = {side, side};
            view.relief.height_scale = 2e-5;
            BaseMesh mesh = curved_base(load_base({.kind = Kind::sphere, .curvature = 1, .segments = 4}));
            // Not with a vertex in the middle of the picture.
            for (MeshVertex& vertex : mesh.vertices)
                vertex.position = 1e-3F * (vertex.position + glm::vec3(0.1F, 0.04F, 0));
            view.relief.base = surface_of(std::move(mesh));
            const TruthComparison found = compare(id, {}, rock(), view);
            expect_numbers(found);
            // The middle of an odd number of pixels looks at the origin.
            const std::ptrdiff_t expected = side % 2;
            EXPECT_EQ(std::ranges::count_if(found.truth.hits.texels, &Hit::is_hit), expected);
            EXPECT_EQ(std::ranges::count_if(found.probe.hits.texels, &Hit::is_hit), expected) << id << ' ' << side;
            EXPECT_EQ(found.errors.footprint, static_cast<std::size_t>(expected));
            EXPECT_EQ(found.errors.coverage_iou, 1) << id << ' ' << side;
            EXPECT_EQ(found.errors.depth.has_value(), expected == 1);
        }
    }
}

TEST_F(CurvedScene, AnObjectIsInFrontWhereTheTruthSaysSo) {
    const Lighting lighting;
    SceneObject sphere;
    sphere.centre = {0, 0, -0.1};
    sphere.radius = 0.25;
    const auto wrong = [&](const char* id, const ParameterValues& changed, DepthWrite depth_write) {
        View view = perspective_view(50);
        view.camera.distance = 1.3;
        view.relief.height_scale = 0.1;
        view.relief.base = generated(Kind::cylinder, 1);
        view.depth_write = depth_write;
        const Technique technique = shipped(id);
        Renderer renderer(device(), technique, with_values(technique.manifest, changed), rock().on_device, view,
                          lighting, sphere);
        renderer.prepare();
        const Probe probe = renderer.probe();
        Truth truth = trace_exact_truth(rock().map, rock().albedo, view, lighting);
        show_object(truth, sphere, view, lighting);
        EXPECT_GT(std::ranges::count(truth.front->texels, Front::object), 100);
        EXPECT_GT(std::ranges::count(truth.front->texels, Front::relief), 500);
        return wrong_surface(*probe.front, *truth.front, truth.footprint);
    };
    EXPECT_LE(wrong("max_mip", bent, DepthWrite::on), 0.002);
    EXPECT_LE(wrong("max_mip", bent, DepthWrite::conservative), 0.002);
    EXPECT_LE(wrong("tessellation", {{"factor", std::int64_t{4}}}, DepthWrite::on), 0.01);
    EXPECT_LE(wrong("shell_march", {}, DepthWrite::on), 0.01);
    EXPECT_GT(wrong("max_mip", bent, DepthWrite::off), 0.03);
}

// On a closed cylinder the triangle over a hit may lie past the seam, and beside the entered one for long.
TEST_F(CurvedScene, NormalsByTheFrameOfTheHitAreNearerToTheTruths) {
    BaseMesh closed = closed_cylinder(96, 4, 2);
    find_charts(closed);
    for (const auto& [base, angle] :
         {std::pair(generated(Kind::sphere, 2), 50.0), std::pair(generated(Kind::saddle, 1), 60.0),
          std::pair(surface_of(closed), 60.0)}) {
        for (const char* id : {"max_mip", "pom"}) {
            View view = perspective_view(angle, 20);
            view.camera.distance = 2;
            view.relief.height_scale = 0.1;
            view.relief.base = base;
            const auto errors = [&](const char* frame) {
                ParameterValues values = bent;
                values["normal_frame"] = std::string(frame);
                const TruthComparison found = compare(id, values, rock(), view);
                expect_numbers(found);
                EXPECT_GT(found.errors.compared, 300U);
                return found.errors;
            };
            const HitErrors entry = errors("entry");
            const HitErrors hit = errors("hit");
            EXPECT_EQ(hit.pixels.uv_texels, entry.pixels.uv_texels) << "the hits are the same";
            EXPECT_LT(hit.normal_deg->mean, 0.6 * entry.normal_deg->mean) << id << ' ' << angle;
            RecordProperty(std::string(id) + curved_base(base).name + "_entry", std::to_string(entry.normal_deg->mean));
            RecordProperty(std::string(id) + curved_base(base).name + "_hit", std::to_string(hit.normal_deg->mean));
        }
    }
}

}  // namespace
}  // namespace reliefbench::test
