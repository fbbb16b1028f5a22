#include "technique/slice_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace reliefbench {
namespace {

/// The slices of a search on a device that takes `ms_per_source(source)` for each.
template <typename Cost>
std::vector<Slice> slices_of(SlicePlan& plan, const Cost& ms_per_source) {
    std::vector<Slice> slices;
    while (!plan.is_done()) {
        slices.push_back(plan.next());
        double ms = 0;
        for (std::int64_t source = slices.back().begin; source < slices.back().end; ++source)
            ms += ms_per_source(source);
        plan.took(ms);
    }
    return slices;
}

TEST(SlicePlan, CoversEverySourceOnce) {
    SlicePlan plan(1000003, 64, 1);
    const std::vector<Slice> slices = slices_of(plan, [](std::int64_t source) { return source % 7 == 0 ? 0.01 : 0; });
    std::int64_t next = 0;
    for (const Slice& slice : slices) {
        EXPECT_EQ(slice.begin, next);
        EXPECT_GT(slice.end, slice.begin);
        next = slice.end;
    }
    EXPECT_EQ(next, 1000003);
    EXPECT_EQ(plan.fraction(), 1);
}

TEST(SlicePlan, NoInvocationLoopsMoreThanEveryDeviceAllows) {
    for (const int iterations : {1, 5, 129, 32768}) {
        SlicePlan plan(200000, 1, iterations);
        for (const Slice& slice : slices_of(plan, [](std::int64_t) { return 0.0; }))
            ASSERT_LT((slice.end - slice.begin) * iterations, 65535) << iterations;
    }
}

TEST(SlicePlan, SlicesTakeAboutATenthOfASecond) {
    constexpr double ms_per_source = 0.25;
    SlicePlan plan(20000, 1 << 20, 1);
    std::vector<Slice> slices = slices_of(plan, [](std::int64_t) { return ms_per_source; });
    slices.pop_back();
    for (const Slice& slice : slices)
        EXPECT_LE(static_cast<double>(slice.end - slice.begin) * ms_per_source, 110);
    EXPECT_GE(static_cast<double>(slices.back().end - slices.back().begin) * ms_per_source, 90);
}

TEST(SlicePlan, EstimatesTheWholeFromEvenSlices) {
    SlicePlan plan(100000, 1 << 16, 1);
    EXPECT_FALSE(plan.is_estimate_sound());
    while (!plan.is_estimate_sound()) {
        const Slice slice = plan.next();
        plan.took(0.5 * static_cast<double>(slice.end - slice.begin));
    }
    EXPECT_LT(plan.fraction(), 0.1);
    EXPECT_NEAR(plan.estimated_ms(), 50000, 1e-6);
}

}  // namespace
}  // namespace reliefbench
