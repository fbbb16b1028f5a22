#include "broken_shaders.hpp"
#include "verify_test.hpp"

#include "metrics/wrong_surface.hpp"

namespace reliefbench::test {

namespace {

class ShippedDepth : public VerifyTest {
protected:
    /// The fraction of the footprint in which the wrong one of bricks and a sphere that stands in them is in front.
    static double wrong(const Technique& technique, DepthWrite depth_write) {
        const HeightMap map = procedural("bricks", {64, 64});
        const Albedo albedo = load_albedo(HeightMapSource{}, map);
        const SceneOnDevice scene(device(), map, albedo);
        View view = perspective_view(60);
        view.camera.distance = 1.1;
        view.relief.height_scale = 0.15;
        view.depth_write = depth_write;
        SceneObject sphere;
        sphere.centre = {0, 0, -0.15};
        sphere.radius = 0.3;
        const Lighting lighting;
        Renderer renderer(device(), technique, technique.manifest.defaults(), scene, view, lighting, sphere);
        renderer.prepare();
        const Probe probe = renderer.probe();
        Truth truth = trace_exact_truth(map, albedo, view, lighting);
        show_object(truth, sphere, view, lighting);
        return wrong_surface(*probe.front, *truth.front, truth.footprint);
    }
};

}  // namespace

// The lesson of PV227: with the depth of the displaced point other objects intersect the relief where they should.
TEST_F(ShippedDepth, OfThePointLetsObjectsIntersectTheRelief) {
    const double exact = wrong(shipped("max_mip"), DepthWrite::on);
    EXPECT_LE(exact, 0.001);
    EXPECT_EQ(wrong(shipped("max_mip"), DepthWrite::conservative), exact);
    EXPECT_GT(wrong(shipped("max_mip"), DepthWrite::off), 0.03);
    for (const char* id : {"steep", "pom"}) {
        const double on = wrong(shipped(id), DepthWrite::on);
        EXPECT_LE(on, 0.02) << id;
        EXPECT_GT(wrong(shipped(id), DepthWrite::off), on + 0.02) << id;
    }
}

TEST_F(ShippedDepth, OfThePolygonInItsPlaceIsFound) {
    const BrokenShaders broken("quad.frag", "vec4(surface_point(hit.xy, hit.z), 1.0)",
                               "vec4(surface_point(hit.xy, 1.0), 1.0)");
    EXPECT_GT(wrong(broken.compile("max_mip"), DepthWrite::on), 0.02);
}

}  // namespace reliefbench::test
