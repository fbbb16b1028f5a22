#include "core/limited_child.hpp"

#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <vector>

namespace reliefbench {
namespace {

using Work = std::function<std::string(const ChildNote&)>;

std::string error_of(const Work& work, const ChildLimits& limits = {}) {
    return error_message([&] { run_in_child("the work failed", work, limits); });
}

TEST(LimitedChild, GivesBackWhatTheWorkReturns) {
    const std::string large(3 << 20, 'x');
    EXPECT_EQ(run_in_child("", [&](const ChildNote&) { return large; }, {}), large);
    EXPECT_EQ(run_in_child("", [](const ChildNote&) { return std::string(); }, {}), "");
}

TEST(LimitedChild, WhatTheWorkChangesStaysInTheChild) {
    int value = 1;
    run_in_child("", [&](const ChildNote&) { return std::to_string(value = 2); }, {});
    EXPECT_EQ(value, 1);
}

TEST(LimitedChild, ErrorsComeThrough) {
    EXPECT_EQ(error_of([](const ChildNote&) -> std::string { fail("no {}", "good"); }), "no good");
}

TEST(LimitedChild, ACrashIsAnErrorWithTheLastNote) {
    const Work crash = [](const ChildNote& note) -> std::string {
        note("first");
        note("second");
        std::signal(SIGSEGV, SIG_DFL);
        std::raise(SIGSEGV);
        return "";
    };
    EXPECT_EQ(error_of(crash), "the work failed: it was ended by a signal (Segmentation fault); at last second");
}

TEST(LimitedChild, WorkWithoutEndIsEnded) {
    const Work endless = [](const ChildNote&) -> std::string {
        for (volatile unsigned turn = 0;;)
            turn = turn + 1;
    };
    EXPECT_EQ(error_of(endless, {.cpu_s = 1}), "the work failed: it took more than 1 s of CPU time");
}

TEST(LimitedChild, WorkThatTakesAllMemoryIsEnded) {
    const Work greedy = [](const ChildNote&) -> std::string {
        std::vector<std::vector<char>> taken;
        for (;;)
            taken.emplace_back(16 << 20, 'x');
    };
    EXPECT_THAT(error_of(greedy, {.memory_bytes = 256 << 20}), testing::StartsWith("the work failed: it "));
}

TEST(LimitedChild, AResultWithoutEndIsRefused) {
    const Work large = [](const ChildNote&) { return std::string(20 << 20, 'x'); };
    EXPECT_EQ(error_of(large, {.result_bytes = 1 << 20}), "the work failed: what it made is larger than 2 MB");
}

}  // namespace
}  // namespace reliefbench
