#include "measure/recent_state.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

class FakeClock : public Clock {
public:
    double seconds() const override { return now_s; }
    double now_s = 1000;
};

/// Heats up by a degree with every reading and is throttled from 42 on.
class FakeSource : public gpu::DeviceStateSource {
public:
    gpu::DeviceState read() override {
        ++degrees;
        gpu::DeviceState state;
        state.temperature_c = degrees;
        state.throttled = degrees >= 42;
        return state;
    }
    double degrees = 40;
};

TEST(RecentState, IsReadAgainOnlyWhenItIsOld) {
    FakeSource source;
    FakeClock clock;
    RecentState state(source, clock);
    EXPECT_EQ(state.read().temperature_c, 41);
    clock.now_s += 0.04;
    EXPECT_EQ(state.read().temperature_c, 41);
    EXPECT_FALSE(state.is_throttled());
    clock.now_s += 0.02;
    EXPECT_TRUE(state.is_throttled());
    EXPECT_EQ(state.read().temperature_c, 42);
}

TEST(RecentState, WhatIsNotToldIsNotThrottled) {
    class Silent : public gpu::DeviceStateSource {
    public:
        gpu::DeviceState read() override { return {}; }
    };
    Silent source;
    FakeClock clock;
    EXPECT_FALSE(RecentState(source, clock).is_throttled());
}

}  // namespace
}  // namespace reliefbench
