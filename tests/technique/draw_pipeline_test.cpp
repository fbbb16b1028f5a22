#include "technique/pipeline/draw_pipeline.hpp"

#include "test_scene.hpp"

#include <gmock/gmock.h>

#include <set>

namespace reliefbench {
namespace {

using namespace test;
using testing::HasSubstr;

class DrawPipelines : public DeviceTest {
protected:
    /// Of a map of 100×60 texels, twice on a side of the patch.
    DrawGeometry geometry(const ParameterValues& parameters, const View& view) const {
        return pipeline_of(patches_).geometry(device(), {patches_, parameters, view, {100, 60}});
    }
    std::uint32_t per_call(std::uint32_t on_cpu, std::uint32_t all) const {
        return device().info().type == gpu::DeviceType::cpu ? on_cpu : all;
    }

    static Manifest grid_manifest() {
        Manifest manifest;
        manifest.shape = {.kind = "patches",
                          .patches_parameter = "patches",
                          .texels_per_patch = 64,
                          .triangles_with = {{"triangles", true}}};
        return manifest;
    }
    static ParameterValues values(std::int64_t patches, bool triangles) {
        return {{"patches", patches}, {"triangles", triangles}};
    }
    static View tiled_view() {
        View view = make_view(60, Projection::parallel, {32, 32});
        view.camera.azimuth = 0;
        view.relief.height_scale = 0.2;
        view.relief.tiling = 2;
        return view;
    }

    const Manifest patches_ = grid_manifest();
};

TEST_F(DrawPipelines, EveryShapeOfAManifestHasOne) {
    std::multiset<std::string> words;
    for (const ShapeKind& kind : shape_kinds())
        words.insert(kind.word);
    std::multiset<std::string> drawn;
    for (const DrawPipeline& pipeline : draw_pipelines())
        drawn.insert(pipeline.shape);
    EXPECT_EQ(words, drawn);
    Manifest manifest;
    for (const ShapeKind& kind : shape_kinds()) {
        manifest.shape.kind = kind.word;
        EXPECT_EQ(pipeline_of(manifest).shape, kind.word);
    }
}

TEST_F(DrawPipelines, TheQuadIsAStripOfFourThatNothingIsCulledOf) {
    const Manifest manifest;
    const View view;
    const DrawGeometry quad = pipeline_of(manifest).geometry(device(), {manifest, {}, view, {8, 8}});
    EXPECT_EQ(quad.vertices, 4U);
    EXPECT_EQ(quad.topology, vk::PrimitiveTopology::eTriangleStrip);
    EXPECT_EQ(quad.cull, vk::CullModeFlags(vk::CullModeFlagBits::eNone));
    EXPECT_EQ(quad.patch_vertices, 0U);
    EXPECT_EQ(quad.grid.count, glm::ivec2(1, 1));
}

TEST_F(DrawPipelines, PatchesAreAsManyAsAskedForOrAsTexelsNeed) {
    const View view = tiled_view();
    // 200 × 120 texels on the patch, 64 for each.
    const DrawGeometry quads = geometry(values(0, false), view);
    EXPECT_EQ(quads.grid.per_side, glm::ivec2(4, 2));
    EXPECT_EQ(quads.grid.first, glm::ivec2(0, 0));
    EXPECT_EQ(quads.grid.count, glm::ivec2(4, 2));
    EXPECT_EQ(quads.patch_vertices, 4U);
    EXPECT_EQ(quads.vertices, 4U * 8);
    EXPECT_EQ(quads.vertices_per_call, per_call(4 * 4, 4 * 8));
    EXPECT_EQ(quads.topology, vk::PrimitiveTopology::ePatchList);
    EXPECT_EQ(quads.cull, vk::CullModeFlags(vk::CullModeFlagBits::eBack));
    const DrawGeometry triangles = geometry(values(5, true), view);
    EXPECT_EQ(triangles.grid.count, glm::ivec2(5, 5));
    EXPECT_EQ(triangles.patch_vertices, 3U);
    EXPECT_EQ(triangles.vertices, 3U * 2 * 25);
    EXPECT_EQ(triangles.vertices_per_call, per_call(3 * 4, 3 * 2 * 25));
}

TEST_F(DrawPipelines, PatchesReachAsFarAsARepeatingReliefIsSeen) {
    View view = tiled_view();
    view.relief.boundary = Boundary::repeat;
    // Seen from +x, rays go on to −x by H·tan 60° = 0.346 of the patch, 1.73 patches of five.
    const DrawGeometry repeating = geometry(values(5, false), view);
    EXPECT_EQ(repeating.grid.first, glm::ivec2(-2, 0));
    EXPECT_EQ(repeating.grid.count, glm::ivec2(7, 5));
}

TEST_F(DrawPipelines, SayWhatTheyCannotDraw) {
    View view = tiled_view();
    const auto reason = [&](std::int64_t patches) {
        return pipeline_of(patches_).unsupported(device(), {patches_, values(patches, false), view, {100, 60}});
    };
    if (device().info().max_tessellation_factor < 64) GTEST_SKIP() << "the device cannot tessellate";
    EXPECT_EQ(reason(0), "");
    EXPECT_EQ(reason(2048), "");
    EXPECT_THAT(reason(2049), HasSubstr("the view would take 4.2e+06 patches, more than 4194304"));
    view.depth_write = DepthWrite::conservative;
    EXPECT_THAT(reason(0), HasSubstr("its own depth"));
    view.self_shadow.mode = SelfShadow::Mode::hard;
    EXPECT_THAT(reason(0), HasSubstr("self-shadowing"));
}

}  // namespace
}  // namespace reliefbench
