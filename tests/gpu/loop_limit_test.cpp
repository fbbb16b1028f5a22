#include "gpu/loop_limit.hpp"

#include "gpu/commands.hpp"
#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cstring>

namespace reliefbench::gpu {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// How far two loops after each other come that are to count to `asked` each.
std::array<std::uint32_t, 2> count_twice(const Device& device, std::uint32_t asked) {
    const char* const text = R"(
        layout(local_size_x = 1) in;
        layout(set = 0, binding = 0, std430) buffer Loops { uint asked; uint turns[2]; } loops;
        void main() {
            uint first = 0u;
            while (first < loops.asked) first += 1u;
            uint second = 0u;
            while (second < loops.asked) second += 1u;
            loops.turns[0] = first;
            loops.turns[1] = second;
        })";
    const auto code = std::make_shared<const SpirV>(compile_shader({.stage = ShaderStage::compute,
                                                                    .file = "twice.comp",
                                                                    .roots = {},
                                                                    .generated = {{"twice.comp", text}},
                                                                    .preamble = {}}));
    const std::array<std::uint32_t, 3> values{asked, 0, 0};
    const Buffer buffer =
        make_filled_buffer(device, vk::BufferUsageFlagBits::eStorageBuffer, std::as_bytes(std::span(values)));
    const Pipeline pipeline = make_compute_pipeline(device, {.shader = {ShaderStage::compute, code}, .constants = {}},
                                                    {{storage_buffer("loops", buffer.buffer)}});
    submit_and_wait(device, "count", [&](const vk::raii::CommandBuffer& commands) {
        pipeline.bind(commands);
        commands.dispatch(1, 1, 1);
    });
    std::array<std::uint32_t, 2> turns{};
    std::memcpy(turns.data(), buffer.mapped + sizeof asked, sizeof turns);
    return turns;
}

TEST(LoopLimit, IsWhereTheDeviceEndsLoopsAllTogether) {
    const Device device({.choice = "", .validation = true});
    const std::optional<std::uint32_t> limit = loop_limit(device);
    EXPECT_EQ(loop_limit(device), limit) << "asked again";
    if (device.info().name.starts_with("llvmpipe")) {
        EXPECT_EQ(limit, 65535U);
    }
    const std::uint32_t most = limit.value_or(200000);
    // A little is what the ends of loops cost.
    constexpr std::uint32_t ends = 4;
    const auto half = count_twice(device, most / 2 - ends);
    EXPECT_EQ(half[0] + half[1], 2 * (most / 2 - ends)) << "within the limit nothing is cut";
    const auto whole = count_twice(device, most - ends);
    EXPECT_EQ(whole[0], most - ends);
    EXPECT_EQ(whole[1], limit ? ends - 1 : most - ends) << "the second loop has what the first has left";
    EXPECT_THAT(describe_loop_limit(device), HasSubstr(device.info().name + " ends the loops of an invocation"));
    EXPECT_THAT(device.validation_messages(), IsEmpty());
}

}  // namespace
}  // namespace reliefbench::gpu
