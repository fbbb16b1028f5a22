#include "core/parallel.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
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

TEST(ParallelFor, TheLowestFailureIsTheOneThrown) {
    for (int repeat = 0; repeat < 50; ++repeat) {
        try {
            parallel_for(64, 1, [](std::size_t begin, std::size_t) {
                if (begin >= 3) fail("range {}", begin);
            });
            FAIL() << "nothing was thrown";
        } catch (const Error& error) {
            EXPECT_STREQ(error.what(), "range 3");
        }
    }
}

TEST(ParallelFor, CallsMayNest) {
    std::atomic<int> visits = 0;
    parallel_for(4, 1,
                 [&](std::size_t, std::size_t) { parallel_for(8, 1, [&](std::size_t, std::size_t) { ++visits; }); });
    EXPECT_EQ(visits.load(), 32);
}

}  // namespace
