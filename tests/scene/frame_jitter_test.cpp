#include "scene/frame_jitter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace reliefbench {
namespace {

TEST(FrameJitter, IsHaltonsSequenceAboutThePixelsCentre) {
    const std::array<glm::dvec2, 6> points{{{1.0 / 2, 1.0 / 3},
                                            {1.0 / 4, 2.0 / 3},
                                            {3.0 / 4, 1.0 / 9},
                                            {1.0 / 8, 4.0 / 9},
                                            {5.0 / 8, 7.0 / 9},
                                            {3.0 / 8, 2.0 / 9}}};
    for (int frame = 0; frame < static_cast<int>(points.size()); ++frame) {
        EXPECT_NEAR(frame_jitter(frame).x, points.at(static_cast<std::size_t>(frame)).x - 0.5, 1e-15);
        EXPECT_NEAR(frame_jitter(frame).y, points.at(static_cast<std::size_t>(frame)).y - 0.5, 1e-15);
    }
}

TEST(FrameJitter, OfSixteenFramesCoversThePixelEvenly) {
    glm::dvec2 sum(0);
    std::array<int, 4> quarters{};
    for (int frame = 0; frame < 16; ++frame) {
        const glm::dvec2 jitter = frame_jitter(frame);
        EXPECT_GE(std::min(jitter.x, jitter.y), -0.5);
        EXPECT_LT(std::max(jitter.x, jitter.y), 0.5);
        sum += jitter;
        ++quarters.at((jitter.x < 0 ? 0U : 1U) + (jitter.y < 0 ? 0U : 2U));
    }
    EXPECT_LT(std::abs(sum.x) / 16, 0.04);
    EXPECT_LT(std::abs(sum.y) / 16, 0.04);
    for (const int frames : quarters) {
        EXPECT_GE(frames, 3);
        EXPECT_LE(frames, 5);
    }
}

}  // namespace
}  // namespace reliefbench
