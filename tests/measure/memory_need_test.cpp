#include "measure/memory_need.hpp"

#include "scene/surface/chart_grid.hpp"
#include "scene/surface/charts.hpp"
#include "support/closed_cylinder.hpp"
#include "technique/test_scene.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace reliefbench {
namespace {

constexpr InputSizes sizes{{1024, 512}, {1024, 512}};

BaseSurface surface_of(BaseMesh mesh) {
    return {MeshBase{std::make_shared<const BaseMesh>(std::move(mesh))}};
}

/// Of a cell of pom, 16×16 pixels, over the base.
MemoryNeed need_over(const BaseSurface& base, const std::string& settings = "{}") {
    static const TechniqueLibrary library = find_techniques({default_technique_root()});
    Json json = Json::parse(R"({"techniques": ["pom"], "axes": {"heightmap": "rock", "resolution": 16}})");
    json.update(Json::parse(settings));
    const Configuration configuration = parse_configuration(json, "test", {}, library.manifests());
    const Cell cell = expand(configuration, library.manifests()).front();
    return cell_need(library.get("pom"), cell, base, sizes, configuration);
}

TEST(MemoryNeed, OfAFilesTrianglesIsThatOfTheSameGenerated) {
    const BaseSurface generated = load_base({.kind = BaseSource::Kind::cylinder, .curvature = 1, .segments = 40});
    BaseMesh read = curved_base(generated);
    read.is_unit_square = false;
    read.name = "read.glb";
    for (const char* settings : {"{}", R"({"truth": {"kind": "mesh", "subdivision": 2}})", R"({"motion": {}})"}) {
        const MemoryNeed expected = need_over(generated, settings);
        const MemoryNeed need = need_over(surface_of(read), settings);
        EXPECT_EQ(need.host, expected.host) << settings;
        EXPECT_EQ(need.device, expected.device) << settings;
    }
}

TEST(MemoryNeed, GrowsWithTheTrianglesOfABaseAndWithTheTexelsThatTheyBear) {
    const auto cylinder = [](int around, double periods) {
        BaseMesh mesh = closed_cylinder(around, 100, periods);
        find_charts(mesh);
        return need_over(surface_of(std::move(mesh)));
    };
    const MemoryNeed flat = need_over({});
    const MemoryNeed few = cylinder(100, 1);
    const MemoryNeed many = cylinder(1000, 1);
    // What the tracer has of each triangle, and the device.
    EXPECT_GT(many.host - few.host, 180'000U * 500);
    EXPECT_GT(many.device - few.device, 90'000U * 32 + 180'000U * 12);
    EXPECT_GT(few.host - flat.host, 1024U * 512 * 100);
    EXPECT_GT(cylinder(100, 3).host - few.host, 2 * 1024U * 512 * 100);
}

TEST(MemoryNeed, OfABaseOnTheDeviceIsNotExceededByItsChartsGrid) {
    for (const double slant : {0.0, 0.7}) {
        BaseMesh mesh = closed_cylinder(200, 3, 5, slant);
        find_charts(mesh);
        const ChartGrid grid = make_chart_grid(mesh);
        const std::size_t bytes = mesh.vertices.size() * 32 + mesh.triangles.size() * 16 + grid.charts.size() * 40 +
                                  grid.cell_starts.size() * 4 + grid.cell_triangles.size() * 4;
        EXPECT_GE(base_bytes(mesh), bytes);
        EXPECT_LT(base_bytes(mesh), 2 * bytes);
    }
}

}  // namespace
}  // namespace reliefbench
