#include "gpu/device.hpp"

#include "gpu/commands.hpp"
#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <set>
#include <span>

namespace reliefbench::gpu {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::SizeIs;

/// Sets an environment variable, or unsets it, until the end of the scope.
class ScopedVariable {
public:
    ScopedVariable(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        set(value);
    }
    ~ScopedVariable() { set(old_ ? old_->c_str() : nullptr); }
    ScopedVariable(const ScopedVariable&) = delete;
    ScopedVariable& operator=(const ScopedVariable&) = delete;

private:
    void set(const char* value) const {
        if (value) {
            setenv(name_, value, 1);
        } else {
            unsetenv(name_);
        }
    }

    const char* name_;
    std::optional<std::string> old_;
};

DeviceInfo device(int index, const char* name, DeviceType type, const char* unusable_reason = "") {
    DeviceInfo info;
    info.index = index;
    info.name = name;
    info.type = type;
    info.unusable_reason = unusable_reason;
    return info;
}

const std::vector<DeviceInfo> machine{
    device(0, "llvmpipe (LLVM 15)", DeviceType::cpu),
    device(1, "Intel UHD 630", DeviceType::integrated),
    device(2, "GeForce RTX 4070", DeviceType::discrete),
    device(3, "GeForce GT 730", DeviceType::discrete, "it has Vulkan 1.2.175; 1.3 is needed"),
};

TEST(DeviceChoice, BestIsDiscreteThenIntegratedThenVirtualThenCpu) {
    EXPECT_EQ(choose_device(machine, ""), 2u);
    EXPECT_EQ(choose_device({machine[0], machine[1]}, ""), 1u);
    EXPECT_EQ(choose_device({machine[0], device(1, "virtio", DeviceType::virtual_gpu)}, ""), 1u);
    EXPECT_EQ(choose_device({machine[0]}, ""), 0u);
}

TEST(DeviceChoice, TakesIndexOrPartOfNameInAnyCase) {
    EXPECT_EQ(choose_device(machine, "1"), 1u);
    EXPECT_EQ(choose_device(machine, "LLVMpipe"), 0u);
    // Two are called so; one of them cannot be used.
    EXPECT_EQ(choose_device(machine, "geforce"), 2u);
}

TEST(DeviceChoice, WrongChoiceListsWhatThereIs) {
    EXPECT_THAT(error_message([] { choose_device(machine, "radeon"); }), HasSubstr("1: Intel UHD 630 (integrated)"));
    EXPECT_THAT(error_message([] { choose_device(machine, "4"); }), HasSubstr("no Vulkan device 4"));
    EXPECT_THAT(error_message([] { choose_device(machine, "3"); }), HasSubstr("Vulkan 1.2.175"));
    EXPECT_THAT(error_message([] { choose_device({machine[3]}, ""); }), HasSubstr("mesa-vulkan-drivers"));
}

TEST(DeviceList, DescribesDevices) {
    const std::vector<DeviceInfo> devices = list_devices();
    ASSERT_FALSE(devices.empty());
    const DeviceInfo& info = devices[choose_device(devices, "")];
    EXPECT_NE(info.name, "");
    EXPECT_NE(info.driver, "");
    EXPECT_THAT(info.api_version, testing::StartsWith("1."));
    EXPECT_GT(info.timestamp_period_ns, 0);
    EXPECT_GT(info.timestamp_valid_bits, 0);
    EXPECT_GE(info.max_image_side, 4096);
}

TEST(DeviceList, NoDriverNamesThePackage) {
    // Both names: older loaders know only the first.
    const ScopedVariable old_name("VK_ICD_FILENAMES", "/nowhere.json");
    const ScopedVariable new_name("VK_DRIVER_FILES", "/nowhere.json");
    EXPECT_THAT(error_message([] { list_devices(); }), HasSubstr("apt-get install mesa-vulkan-drivers"));
    EXPECT_THAT(error_message([] { Device device; }), HasSubstr("apt-get install mesa-vulkan-drivers"));
}

TEST(DeviceOpening, EnvironmentChoosesUnlessTold) {
    const ScopedVariable variable("RELIEFBENCH_DEVICE", "no such device");
    EXPECT_THAT(error_message([] { Device device; }), HasSubstr("'no such device'"));
    EXPECT_EQ(Device({.choice = "0", .validation = false}).info().index, 0);
}

TEST(DeviceOpening, ValidationMessagesAreCaptured) {
    const Device device({.choice = "", .validation = true});
    const Buffer buffer(device, 16, vk::BufferUsageFlagBits::eTransferSrc, true);
    EXPECT_THAT(device.validation_messages(), IsEmpty());
    submit_and_wait(device, "fill a buffer", [&](const vk::raii::CommandBuffer& commands) {
        commands.fillBuffer(*buffer.buffer, 0, VK_WHOLE_SIZE, 0);
    });
    // The buffer is no destination of transfers.
    ASSERT_THAT(device.validation_messages(), SizeIs(1));
    EXPECT_THAT(device.validation_messages().front(), HasSubstr("VUID-vkCmdFillBuffer"));
}

TEST(DeviceOpening, SynchronisationIsValidated) {
    const Device device({.choice = "", .validation = true});
    const auto usage = vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst;
    const Buffer buffer(device, 16, usage, true);
    submit_and_wait(device, "fill a buffer", [&](const vk::raii::CommandBuffer& commands) {
        commands.fillBuffer(*buffer.buffer, 0, VK_WHOLE_SIZE, 0);
        commands.fillBuffer(*buffer.buffer, 0, VK_WHOLE_SIZE, 1);
    });
    ASSERT_THAT(device.validation_messages(), SizeIs(1));
    EXPECT_THAT(device.validation_messages().front(), HasSubstr("SYNC-HAZARD-WRITE-AFTER-WRITE"));
}

TEST(DeviceFeatures, HaveNamesOfTheirOwnAndADeviceHasSomeOfThem) {
    const std::vector<std::string> names = feature_names();
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    EXPECT_THAT(names, IsSupersetOf({"tessellationShader", "VK_EXT_mesh_shader", "VK_KHR_ray_query",
                                     pipeline_executable_feature}));
    const Device device({.choice = "", .validation = true});
    EXPECT_THAT(names, IsSupersetOf(device.info().features));
    EXPECT_TRUE(device.info().has_feature("fragmentStoresAndAtomics"));
    EXPECT_THAT(device.validation_messages(), IsEmpty()) << "all of them enabled together";
}

TEST(DeviceFeatures, AreEnabledWhereTheDeviceHasThem) {
    const Device device({.choice = "", .validation = true});
    if (!device.info().has_feature("shaderFloat64")) GTEST_SKIP() << "the device has no doubles";
    const char* const text = R"(
        layout(local_size_x = 1) in;
        layout(set = 0, binding = 0, std430) buffer Numbers { double numbers[2]; };
        void main() { numbers[1] = numbers[0] * 3.0LF; })";
    const auto code = std::make_shared<const SpirV>(compile_shader({.stage = ShaderStage::compute,
                                                                    .file = "doubles.comp",
                                                                    .roots = {},
                                                                    .generated = {{"doubles.comp", text}},
                                                                    .preamble = {}}));
    const std::array<double, 2> numbers{1 + 0x1p-50, 0};
    const Buffer buffer =
        make_filled_buffer(device, vk::BufferUsageFlagBits::eStorageBuffer, std::as_bytes(std::span(numbers)));
    const Pipeline pipeline = make_compute_pipeline(device, {.shader = {ShaderStage::compute, code}, .constants = {}},
                                                    {{storage_buffer("Numbers", buffer.buffer)}});
    submit_and_wait(device, "multiply doubles", [&](const vk::raii::CommandBuffer& commands) {
        pipeline.bind(commands);
        commands.dispatch(1, 1, 1);
    });
    double product = 0;
    std::memcpy(&product, buffer.mapped + sizeof product, sizeof product);
    EXPECT_EQ(product, 3 * numbers[0]);
    EXPECT_THAT(device.validation_messages(), IsEmpty());
}

TEST(DeviceOpening, TooLargeABufferIsAnError) {
    const Device device;
    constexpr vk::DeviceSize absurd = vk::DeviceSize{1} << 46;
    EXPECT_THAT(error_message([&] { Buffer(device, absurd, vk::BufferUsageFlagBits::eTransferSrc, false); }),
                HasSubstr("make a buffer of 70368744177664 bytes"));
}

}  // namespace
}  // namespace reliefbench::gpu
