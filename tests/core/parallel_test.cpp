#include "core/parallel.hpp"

#include "support/error_message.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

using namespace reliefbench;

namespace {

TEST(ParallelFor, CoversEveryIndexOnceInFixedRanges) {
    std::vector<std::atomic<int>> visits(1003);
    std::mutex mutex;
    std::set<std::pair<std::size_t, std::size_t>> ranges;
    parallel_for(visits.size(), 100, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            ++visits[index];
        }
        const std::lock_guard lock(mutex);
        ranges.emplace(begin, end);
    });
    for (const std::atomic<int>& count : visits) {
        EXPECT_EQ(count.load(), 1);
    }
    std::set<std::pair<std::size_t, std::size_t>> expected;
    for (std::size_t begin = 0; begin < 1003; begin += 100) {
        expected.emplace(begin, std::min<std::size_t>(begin + 100, 1003));
    }
    EXPECT_EQ(ranges, expected);
}

TEST(ParallelFor, NothingToDoCallsNothing) {
    parallel_for(0, 16, [](std::size_t, std::size_t) { FAIL(); });
}

/// Two ranges fail at the same time, as far as there are two cores; `late` (0 or 1) does so after the other.
std::string failure_with_late_range(std::size_t late) {
    std::atomic<bool> second_started = false;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
    return error_message([&] {
        parallel_for(2, 1, [&](std::size_t range, std::size_t) {
            second_started = second_started || range == 1;
            while (!second_started && std::chrono::steady_clock::now() < deadline) {
                std::this_thread::yield();
            }
            if (range == late) std::this_thread::sleep_for(std::chrono::milliseconds(20));
            fail("range {}", range);
        });
    });
}

TEST(ParallelFor, TheLowestFailureIsTheOneThrown) {
    EXPECT_EQ(failure_with_late_range(0), "range 0");
    EXPECT_EQ(failure_with_late_range(1), "range 0");
}

TEST(ParallelFor, CallsMayNest) {
    std::atomic<int> visits = 0;
    parallel_for(4, 1,
                 [&](std::size_t, std::size_t) { parallel_for(8, 1, [&](std::size_t, std::size_t) { ++visits; }); });
    EXPECT_EQ(visits.load(), 32);
}

}  // namespace
