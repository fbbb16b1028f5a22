#include "sweep/view_axes.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

TEST(ViewAxes, WhatMovesNoHitIsShadowsAndTheDepthThatIsWritten) {
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

}  // namespace
}  // namespace reliefbench
