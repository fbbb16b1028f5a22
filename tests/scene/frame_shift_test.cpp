#include "scene/camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace reliefbench {
namespace {

constexpr Resolution resolution{64, 32};

/// In pixels.
glm::dvec2 shift_of(int frame, int frames) {
    return frame_shift(frame, frames, resolution) * glm::dvec2(resolution.width, resolution.height);
}

TEST(FrameShift, IsHaltonsSequenceAboutItsMean) {
    const std::array<glm::dvec2, 6> points{{{1.0 / 2, 1.0 / 3},
                                            {1.0 / 4, 2.0 / 3},
                                            {3.0 / 4, 1.0 / 9},
                                            {1.0 / 8, 4.0 / 9},
                                            {5.0 / 8, 7.0 / 9},
                                            {3.0 / 8, 2.0 / 9}}};
    glm::dvec2 mean(0);
    for (const glm::dvec2& point : points)
        mean += point / static_cast<double>(points.size());
    for (int frame = 0; frame < static_cast<int>(points.size()); ++frame) {
        const glm::dvec2 expected = points.at(static_cast<std::size_t>(frame)) - mean;
        EXPECT_NEAR(shift_of(frame, 6).x, expected.x, 1e-15);
        EXPECT_NEAR(shift_of(frame, 6).y, expected.y, 1e-15);
    }
}

TEST(FrameShift, LeavesEachOfSeveralSamplesInItsRowAndColumnOfThePixel) {
    for (int frame = 0; frame < 4; ++frame)
        EXPECT_EQ(frame_shift(frame, 4, resolution, 4), frame_shift(frame, 4, resolution) / 4.0);
}

TEST(FrameShift, OfOneFrameIsNone) {
    EXPECT_EQ(frame_shift(0, 1, resolution), glm::dvec2(0));
}

TEST(FrameShift, OfSixteenFramesCoversThePixelEvenlyAndMovesNoPicture) {
    glm::dvec2 sum(0);
    std::array<int, 4> quarters{};
    for (int frame = 0; frame < 16; ++frame) {
        const glm::dvec2 shift = shift_of(frame, 16);
        EXPECT_GE(std::min(shift.x, shift.y), -0.54);
        EXPECT_LT(std::max(shift.x, shift.y), 0.54);
        sum += shift;
        ++quarters.at((shift.x < 0 ? 0U : 1U) + (shift.y < 0 ? 0U : 2U));
    }
    EXPECT_NEAR(sum.x, 0, 1e-14);
    EXPECT_NEAR(sum.y, 0, 1e-14);
    for (const int frames : quarters) {
        EXPECT_GE(frames, 3);
        EXPECT_LE(frames, 5);
    }
}

}  // namespace
}  // namespace reliefbench
