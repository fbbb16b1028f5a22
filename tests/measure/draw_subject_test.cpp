#include "measure/draw_subject.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace reliefbench {
namespace {

using testing::ElementsAre;

/// Answers each call with the next duration, the last one for ever, and keeps (samples, repeats).
struct FakeDraw {
    std::vector<double> draw_ms;
    std::vector<std::pair<int, int>> calls;

    std::vector<double> operator()(int samples, int repeats) {
        const std::size_t call = std::min(calls.size(), draw_ms.size() - 1);
        calls.emplace_back(samples, repeats);
        return std::vector<double>(static_cast<std::size_t>(samples), draw_ms[call]);
    }
};

SamplingSettings settings(int warm_up, double minimum_pass_ms) {
    SamplingSettings sampling;
    sampling.warm_up = warm_up;
    sampling.minimum_pass_ms = minimum_pass_ms;
    return sampling;
}

TEST(DrawSubject, ALongDrawIsTimedOnce) {
    FakeDraw draw{{10.0}, {}};
    DrawSubject subject(std::ref(draw), settings(3, 0.5));
    subject.warm_up();
    EXPECT_EQ(subject.repeats(), 1);
    EXPECT_THAT(draw.calls, ElementsAre(std::pair(3, 1), std::pair(1, 1)));
}

TEST(DrawSubject, AShortDrawIsRepeatedUntilItLastsLongEnough) {
    FakeDraw draw{{0.125}, {}};
    DrawSubject subject(std::ref(draw), settings(2, 1.0));
    subject.warm_up();
    EXPECT_EQ(subject.repeats(), 8);
    draw.calls.clear();
    EXPECT_THAT(subject.visit(3), ElementsAre(std::pair(std::string("draw"), std::vector<double>(3, 0.125))));
    EXPECT_THAT(draw.calls, ElementsAre(std::pair(3, 8)));
}

TEST(DrawSubject, RepeatsGrowWhenTheDeviceSpeedsUp) {
    FakeDraw draw{{1.0, 0.5, 0.25}, {}};
    DrawSubject subject(std::ref(draw), settings(1, 1.0));
    subject.warm_up();
    EXPECT_EQ(subject.repeats(), 4);
}

TEST(DrawSubject, WarmsUpLongEnoughForTheClockToRise) {
    FakeDraw draw{{0.5}, {}};
    DrawSubject subject(std::ref(draw), settings(2, 1.0));
    subject.warm_up();
    // Two draws, a guess of one, a pass of two: 2.5 ms. The 17.5 ms that are missing take 18 passes of 1 ms.
    EXPECT_THAT(draw.calls, ElementsAre(std::pair(2, 1), std::pair(1, 1), std::pair(1, 2), std::pair(18, 2)));
}

TEST(DrawSubject, ConfiguredWithoutWarmUpFindsTheRepeatsOnly) {
    FakeDraw draw{{0.5}, {}};
    DrawSubject subject(std::ref(draw), settings(0, 0.0));
    subject.warm_up();
    EXPECT_THAT(draw.calls, ElementsAre(std::pair(1, 1)));
}

TEST(DrawSubject, ADrawTooShortForTheClockIsRepeatedABoundedNumberOfTimes) {
    FakeDraw draw{{0.0}, {}};
    DrawSubject subject(std::ref(draw), settings(1, 0.2));
    subject.warm_up();
    EXPECT_EQ(subject.repeats(), 1000);
}

}  // namespace
}  // namespace reliefbench
