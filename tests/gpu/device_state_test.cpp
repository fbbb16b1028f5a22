#include "gpu/device_state.hpp"

#include "core/file.hpp"
#include "gpu/device.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <dlfcn.h>

namespace reliefbench::gpu {
namespace {

namespace fs = std::filesystem;

constexpr const char* fake_nvml = RELIEFBENCH_FAKE_NVML;
constexpr const char* fake_device = "0000:65:00.0";

/// A variable of the fake library, which stays loaded.
template <typename Value>
Value& fake(const char* name) {
    static void* const library = dlopen(fake_nvml, RTLD_NOW);
    return *static_cast<Value*>(dlsym(library, name));
}

class Nvml : public testing::Test {
protected:
    void SetUp() override {
        fake<bool>("fake_knows_clocks") = true;
        fake<unsigned long long>("fake_throttle_reasons") = 0;
    }
};

TEST_F(Nvml, TellsClocksTemperatureAndThrottling) {
    const auto source = open_nvml_state(fake_nvml, fake_device);
    ASSERT_TRUE(source);
    const DeviceState state = source->read();
    EXPECT_EQ(state.clock_mhz, 1980);
    EXPECT_EQ(state.memory_clock_mhz, 2619);
    EXPECT_EQ(state.temperature_c, 41);
    EXPECT_EQ(state.throttled, false);
}

TEST_F(Nvml, HeatAndPowerThrottleButIdlingAndSetClocksDoNot) {
    const auto source = open_nvml_state(fake_nvml, fake_device);
    ASSERT_TRUE(source);
    // nvml.h: nvmlClocksThrottleReason*.
    const std::pair<unsigned long long, bool> reasons[] = {
        {0x1, false} /* idle */,       {0x2, false} /* application clocks */, {0x4, true} /* power cap */,
        {0x8, true} /* hw slowdown */, {0x10, false} /* sync boost */,        {0x20, true} /* sw thermal */,
        {0x40, true} /* hw thermal */, {0x80, true} /* power brake */,        {0x100, false} /* display clocks */,
        {0x1 | 0x20, true} /* both */,
    };
    for (const auto& [reason, throttled] : reasons) {
        fake<unsigned long long>("fake_throttle_reasons") = reason;
        EXPECT_EQ(source->read().throttled, throttled) << reason;
    }
}

TEST_F(Nvml, WhatItDoesNotKnowIsEmpty) {
    const auto source = open_nvml_state(fake_nvml, fake_device);
    ASSERT_TRUE(source);
    fake<bool>("fake_knows_clocks") = false;
    EXPECT_FALSE(source->read().clock_mhz);
    EXPECT_EQ(source->read().temperature_c, 41);
}

TEST_F(Nvml, IsShutDownWhenDoneAndWhenTheDeviceIsUnknown) {
    {
        const auto source = open_nvml_state(fake_nvml, fake_device);
        EXPECT_EQ(fake<int>("fake_users"), 1);
    }
    EXPECT_EQ(fake<int>("fake_users"), 0);
    EXPECT_FALSE(open_nvml_state(fake_nvml, "0000:66:00.0"));
    EXPECT_EQ(fake<int>("fake_users"), 0);
}

TEST_F(Nvml, WithoutALibraryThereIsNone) {
    EXPECT_FALSE(open_nvml_state("libno-such-library.so.1", fake_device));
    EXPECT_FALSE(open_nvml_state("libm.so.6", fake_device)) << "a library without NVML's functions";
}

class Sysfs : public testing::Test {
protected:
    void write(const fs::path& file, const std::string& text) const {
        fs::create_directories((root / file).parent_path());
        write_text_file(root / file, text);
    }
    const TemporaryFolder temporary;
    const fs::path root = temporary.path();
};

TEST_F(Sysfs, TellsOfAmdgpu) {
    write("0000:03:00.0/hwmon/hwmon4/name", "amdgpu\n");
    write("0000:03:00.0/hwmon/hwmon4/freq1_input", "2540000000\n");
    write("0000:03:00.0/hwmon/hwmon4/freq2_input", "1249000000\n");
    write("0000:03:00.0/hwmon/hwmon4/temp1_input", "56500\n");
    const auto source = open_amdgpu_state(root, "0000:03:00.0");
    ASSERT_TRUE(source);
    const DeviceState state = source->read();
    EXPECT_DOUBLE_EQ(state.clock_mhz.value(), 2540);
    EXPECT_DOUBLE_EQ(state.memory_clock_mhz.value(), 1249);
    EXPECT_DOUBLE_EQ(state.temperature_c.value(), 56.5);
    EXPECT_FALSE(state.throttled);
}

TEST_F(Sysfs, AnIntegratedGpuWithoutAMemoryClockTellsTheRest) {
    write("0000:03:00.0/hwmon/hwmon4/name", "amdgpu\n");
    write("0000:03:00.0/hwmon/hwmon4/freq1_input", "800000000\n");
    const auto source = open_amdgpu_state(root, "0000:03:00.0");
    ASSERT_TRUE(source);
    EXPECT_DOUBLE_EQ(source->read().clock_mhz.value(), 800);
    EXPECT_FALSE(source->read().memory_clock_mhz);
}

TEST_F(Sysfs, OtherDevicesAreNotAmdgpu) {
    write("0000:03:00.0/hwmon/hwmon4/name", "i915\n");
    EXPECT_FALSE(open_amdgpu_state(root, "0000:03:00.0"));
    EXPECT_FALSE(open_amdgpu_state(root, "0000:04:00.0"));
}

TEST_F(Sysfs, ACpusClockIsTheMeanOfItsProcessors) {
    write("cpu0/cpufreq/scaling_cur_freq", "3000000\n");
    write("cpu1/cpufreq/scaling_cur_freq", "2000000\n");
    write("cpufreq/policy0/scaling_cur_freq", "1000\n");
    write("cpuidle/current_driver", "none\n");
    const auto source = open_cpu_state(root);
    ASSERT_TRUE(source);
    EXPECT_DOUBLE_EQ(source->read().clock_mhz.value(), 2500);
    fs::remove_all(root / "cpu1");
    EXPECT_DOUBLE_EQ(source->read().clock_mhz.value(), 3000);
}

TEST_F(Sysfs, WithoutCpufreqThereIsNone) {
    write("cpu0/topology/core_id", "0\n");
    EXPECT_FALSE(open_cpu_state(root));
    EXPECT_FALSE(open_cpu_state(root / "missing"));
}

TEST(DeviceState, OfAnyDeviceCanBeAskedFor) {
    const Device device;
    const auto source = open_device_state(device);
    ASSERT_TRUE(source);
    source->read();
}

}  // namespace
}  // namespace reliefbench::gpu
