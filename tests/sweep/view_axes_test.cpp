#include "sweep/view_axes.hpp"

#include <gmock/gmock.h>

#include <set>

namespace reliefbench {
namespace {

TEST(ViewAxes, WhatMovesNoHitIsShadowsTheDepthThatIsWrittenAndWhatMakesThePicture) {
    ViewKey view;
    view.view.camera.view_angle = 60;
    ViewKey lit = view;
    lit.view.self_shadow.mode = SelfShadow::Mode::soft;
    lit.view.self_shadow.soft = SelfShadow::Soft::tatarchuk;
    lit.view.self_shadow.softening = 2;
    lit.view.self_shadow.hard_bias = 0.5;
    lit.view.self_shadow.dykhta_bias = 0.5;
    lit.view.self_shadow.min_steps = 3;
    lit.view.self_shadow.max_steps = 4;
    lit.view.depth_write = DepthWrite::conservative;
    lit.view.material = {.kind = MaterialFilter::Kind::anisotropic,
                         .anisotropy = 4,
                         .mip_bias = -1,
                         .gradients = MaterialFilter::Gradients::analytic};
    lit.view.samples_per_pixel = 4;
    lit.view.frames = 16;
    EXPECT_NE(lit, view);
    EXPECT_EQ(hits_view(lit), view);
}

TEST(ViewAxes, WhatMovesHitsIsLeftAsItIs) {
    ViewKey view;
    view.height_map.name = "rock";
    view.height_map.size = {32, 16};
    view.height_format = HeightFormat::r8;
    view.view.camera = {.projection = Projection::parallel, .view_angle = 33, .azimuth = 5};
    view.view.relief = {.height_scale = 0.2, .tiling = 3, .boundary = Boundary::repeat};
    view.view.resolution = {10, 20};
    EXPECT_EQ(hits_view(view), view);
}

TEST(ViewAxes, AreListedWithAllThatIsToBeKnown) {
    std::set<std::string> names;
    for (const Json& axis : axis_list_json()) {
        names.insert(axis.at("axis").get<std::string>());
        EXPECT_FALSE(axis.at("values").get<std::string>().empty()) << axis;
        EXPECT_FALSE(axis.at("description").get<std::string>().empty()) << axis;
        EXPECT_EQ(axis.at("description").get<std::string>().find('\n'), std::string::npos) << axis;
    }
    EXPECT_EQ(names.size(), view_axes().size() + 1);
    EXPECT_TRUE(names.contains("sample_count"));
}

/// The bounds that are listed are those that are read.
TEST(ViewAxes, TakeWhatTheyAreListedToTake) {
    const ViewAxis& angle = *find_view_axis("view_angle");
    EXPECT_EQ(angle.description.values, "from 0 to below 90");
    EXPECT_EQ(angle.description.unit, "degrees");
    EXPECT_EQ(find_view_axis("height_scale")->description.values, "above 0, up to 10");
    EXPECT_EQ(find_view_axis("boundary")->description.values, "clip|repeat");
    EXPECT_EQ(find_view_axis("fov")->description.values, "from 1 to 170");
    const auto takes = [](const char* axis, const Json& value) {
        try {
            find_view_axis(axis)->read(JsonView(value, "test"));
            return true;
        } catch (const std::exception&) {
            return false;
        }
    };
    EXPECT_TRUE(takes("view_angle", 0) && takes("view_angle", 89.9));
    EXPECT_FALSE(takes("view_angle", 90) || takes("view_angle", -0.1) || takes("view_angle", "30"));
    EXPECT_TRUE(takes("height_scale", 10) && takes("height_scale", 1e-6));
    EXPECT_FALSE(takes("height_scale", 0) || takes("height_scale", 10.1));
    EXPECT_EQ(find_view_axis("samples_per_pixel")->description.values, "1, 2, 4 or 8");
    EXPECT_TRUE(takes("samples_per_pixel", 1) && takes("samples_per_pixel", 2) && takes("samples_per_pixel", 8));
    EXPECT_FALSE(takes("samples_per_pixel", 0) || takes("samples_per_pixel", 3) || takes("samples_per_pixel", 16));
    EXPECT_TRUE(takes("frames", 1) && takes("frames", 16));
    EXPECT_FALSE(takes("frames", 0) || takes("frames", 17) || takes("frames", 1.5));
}

/// Else a word would be answered with another name than the one that it is.
TEST(ViewAxes, OtherWordsForThemAreNoNames) {
    for (const ViewAxis& axis : view_axes()) {
        for (const std::string& word : axis.description.also_called)
            EXPECT_EQ(find_view_axis(word), nullptr) << axis.name << ": " << word;
    }
    EXPECT_THAT(axes_also_called("num-samples"), testing::ElementsAre("sample_count"));
    EXPECT_THAT(axes_also_called("nonsense"), testing::IsEmpty());
}

}  // namespace
}  // namespace reliefbench
