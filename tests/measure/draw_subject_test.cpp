#include "measure/draw_subject.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <functional>
#include <string>
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

/// The calls of warming up after those that find the repeats.
std::vector<std::pair<int, int>> batches(const FakeDraw& draw, std::size_t calls_before) {
    return {draw.calls.begin() + static_cast<std::ptrdiff_t>(calls_before), draw.calls.end()};
}

TEST(DrawSubject, AConstantDrawIsWarmAfterThreeBatches) {
    FakeDraw draw{{12.0}, {}};
    DrawSubject subject(std::ref(draw), settings(3, 0.5));
    subject.warm_up();
    EXPECT_EQ(subject.repeats(), 1);
    EXPECT_THAT(draw.calls,
                ElementsAre(std::pair(3, 1), std::pair(1, 1), std::pair(1, 1), std::pair(1, 1), std::pair(1, 1)));
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

TEST(DrawSubject, ABatchLastsTenMilliseconds) {
    FakeDraw draw{{0.5}, {}};
    DrawSubject subject(std::ref(draw), settings(2, 1.0));
    subject.warm_up();
    // Two draws, a guess of one, a pass of two; then batches of ten passes of 1 ms.
    EXPECT_THAT(draw.calls, ElementsAre(std::pair(2, 1), std::pair(1, 1), std::pair(1, 2), std::pair(10, 2),
                                        std::pair(10, 2), std::pair(10, 2)));
}

TEST(DrawSubject, AFirstDrawThatCompilesIsLeftBehind) {
    FakeDraw draw{{300.0, 2.0}, {}};
    DrawSubject subject(std::ref(draw), settings(1, 1.0));
    subject.warm_up();
    EXPECT_EQ(subject.repeats(), 1);
    EXPECT_THAT(batches(draw, 2), ElementsAre(std::pair(5, 1), std::pair(5, 1), std::pair(5, 1)));
}

TEST(DrawSubject, WarmsUpUntilARisingClockIsUp) {
    // 3 % faster from batch to batch: too little to show between neighbours. Up after 30 calls.
    FakeDraw draw;
    double draw_ms = 10;
    for (int call = 0; call < 30; ++call) {
        draw.draw_ms.push_back(draw_ms);
        draw_ms *= 0.97;
    }
    DrawSubject subject(std::ref(draw), settings(1, 1.0));
    subject.warm_up();
    EXPECT_GE(draw.calls.size(), 30U);
    EXPECT_LE(draw.calls.size(), 32U);
}

TEST(DrawSubject, ATimingThatRisesIsNotWaitedFor) {
    FakeDraw draw{{12, 12, 12, 13, 14, 15, 16}, {}};
    DrawSubject subject(std::ref(draw), settings(1, 1.0));
    subject.warm_up();
    EXPECT_EQ(draw.calls.size(), 2U + 3U);
}

TEST(DrawSubject, TimingsThatNeverSettleEndWarmingUpAllTheSame) {
    FakeDraw draw;
    for (double draw_ms = 64; draw_ms > 1e-200; draw_ms /= 2) {
        draw.draw_ms.push_back(draw_ms);
    }
    DrawSubject subject(std::ref(draw), settings(1, 1.0));
    subject.warm_up();
    EXPECT_EQ(draw.calls.size(), 2U + 100U);
}

TEST(DrawSubject, AVeryLongDrawIsNotDrawnMoreThanItMust) {
    FakeDraw draw{{1500}, {}};
    DrawSubject subject(std::ref(draw), settings(1, 1.0));
    subject.warm_up();
    EXPECT_THAT(draw.calls, ElementsAre(std::pair(1, 1), std::pair(1, 1)));
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

TEST(DrawSubject, SubmitsAndCollectsWithItsTimer) {
    std::vector<std::string> log;
    DrawSubject subject(
        DrawTimer{[&log](int samples, int repeats) { log.push_back(fmt::format("submit {} {}", samples, repeats)); },
                  [&log] {
                      log.emplace_back("collect");
                      return std::vector<double>{0.25};
                  }},
        settings(0, 0.0));
    subject.submit(4);
    log.emplace_back("between");
    EXPECT_THAT(subject.collect(), ElementsAre(std::pair(std::string("draw"), std::vector<double>{0.25})));
    EXPECT_THAT(log, ElementsAre("submit 4 1", "between", "collect"));
}

}  // namespace
}  // namespace reliefbench
