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

/// Takes slices until the estimate is sound and `slices` are done.
template <typename Milliseconds>
void take(SlicePlan& plan, int slices, const Milliseconds& ms_of) {
    for (int slice = 0; slice < slices || !plan.is_estimate_sound(); ++slice) {
        const Slice next = plan.next();
        plan.took(ms_of(slice, static_cast<double>(next.end - next.begin)));
    }
}

// Every fourth slice stands still for a second, and those after it are short again.
TEST(SlicePlan, LoadDoesNotEnterTheEstimate) {
    for (int slices = 5; slices < 60; ++slices) {
        SlicePlan plan(1000000, 1 << 16, 1);
        take(plan, slices, [](int slice, double length) { return 0.5 * length + (slice % 4 == 3 ? 1000 : 0); });
        const double rest_ms = 0.5 * 1000000 * (1 - plan.fraction());
        EXPECT_NEAR(plan.estimated_ms() - plan.elapsed_ms(), rest_ms, 0.05 * rest_ms) << slices << " slices";
    }
}

// A dispatch costs 5 ms whatever it does: the first, short ones tell little else.
TEST(SlicePlan, WhatADispatchCostsDoesNotEnterTheEstimate) {
    SlicePlan plan(1000000, 1 << 22, 1);
    take(plan, 0, [](int, double length) { return 5 + 0.25 * length; });
    EXPECT_NEAR(plan.estimated_ms(), 1000000 * (0.25 + 5.0 / 380), 0.02 * plan.estimated_ms());
}

TEST(SlicePlan, FewSlicesAreNoSoundEstimate) {
    SlicePlan plan(1000000, 1 << 16, 1);
    for (int slice = 0; slice < 4; ++slice) {
        plan.next();
        plan.took(10000);
        EXPECT_FALSE(plan.is_estimate_sound()) << slice;
    }
}

}  // namespace
}  // namespace reliefbench
