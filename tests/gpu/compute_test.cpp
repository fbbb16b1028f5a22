#include "gpu/commands.hpp"
#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/shader_cache.hpp"
#include "gpu/timers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

namespace reliefbench::gpu {
namespace {

using testing::IsEmpty;

CompiledStage compile_compute(const std::string& text) {
    return {ShaderStage::compute, std::make_shared<const SpirV>(compile_shader({.stage = ShaderStage::compute,
                                                                                .file = "test.comp",
                                                                                .roots = {},
                                                                                .generated = {{"test.comp", text}},
                                                                                .preamble = {}}))};
}

const char* const counting_shader = R"(
layout(local_size_x = 64) in;
layout(constant_id = 3) const int factor = 1;
layout(set = 0, binding = 0, std430) buffer Values { uint values[]; };
void main() { values[gl_GlobalInvocationID.x] = gl_GlobalInvocationID.x * uint(factor); }
)";

TEST(Compute, RunsWithSpecializationConstants) {
    const Device device({.choice = "", .validation = true});
    constexpr std::uint32_t count = 256;
    const Buffer buffer(device, count * sizeof(std::uint32_t), vk::BufferUsageFlagBits::eStorageBuffer, true);
    const Pipeline pipeline =
        make_compute_pipeline(device, {.shader = compile_compute(counting_shader), .constants = {{"factor", 5}}},
                              {{storage_buffer("Values", buffer.buffer)}});
    const Timestamps timestamps(device, 2);
    submit_and_wait(device, "count", [&](const vk::raii::CommandBuffer& commands) {
        timestamps.reset(commands);
        for (std::uint32_t interval = 0; interval < 2; ++interval) {
            timestamps.start(commands, interval);
            pipeline.bind(commands);
            commands.dispatch(count / 64, 1, 1);
            timestamps.end(commands, interval);
        }
    });
    std::vector<std::uint32_t> values(count);
    std::memcpy(values.data(), buffer.mapped, buffer.size);
    for (std::uint32_t i = 0; i < count; ++i)
        EXPECT_EQ(values[i], 5 * i);
    for (const double milliseconds : timestamps.milliseconds())
        EXPECT_GT(milliseconds, 0);
    EXPECT_THAT(device.validation_messages(), IsEmpty());
}

TEST(Compute, PipelinesOfTheSameMakingAreShared) {
    const Device device({.choice = "", .validation = true});
    const Buffer first(device, 256, vk::BufferUsageFlagBits::eStorageBuffer, true);
    const Buffer second(device, 256, vk::BufferUsageFlagBits::eStorageBuffer, true);
    const CompiledStage shader = compile_compute(counting_shader);
    const auto make = [&](const Buffer& buffer, std::uint32_t factor) {
        return make_compute_pipeline(device, {.shader = shader, .constants = {{"factor", factor}}},
                                     {{storage_buffer("Values", buffer.buffer)}});
    };
    const Pipeline one = make(first, 5);
    EXPECT_EQ(one.shared, make(second, 5).shared) << "what is bound is no part of the making";
    EXPECT_NE(one.shared, make(first, 6).shared);
    EXPECT_EQ(device.shared_pipelines().size(), 2U);
    EXPECT_THAT(device.validation_messages(), IsEmpty());
}

TEST(Textures, ComeBackAsUploaded) {
    const Device device({.choice = "", .validation = true});
    const Texture texture(
        device, {7, 3}, vk::Format::eR8Unorm, 1,
        vk::ImageUsageFlagBits::eTransferDst | vk::ImageUsageFlagBits::eTransferSrc | vk::ImageUsageFlagBits::eSampled);
    std::vector<std::byte> texels(21);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = std::byte(11 * i);
    upload_texture(device, texture, texels);
    EXPECT_EQ(read_texture(device, texture, 0, vk::ImageLayout::eShaderReadOnlyOptimal), texels);
    EXPECT_THAT(device.validation_messages(), IsEmpty());
}

TEST(Textures, MipChainEndsAtOneTexel) {
    EXPECT_EQ(full_mip_chain({1, 1}), 1u);
    EXPECT_EQ(full_mip_chain({8, 4}), 4u);
    EXPECT_EQ(full_mip_chain({3, 9}), 4u);
}

TEST(Timers, DifferenceSurvivesTheCountersWrap) {
    EXPECT_DOUBLE_EQ(elapsed_milliseconds(1000, 3000, 64, 1.0), 2e-3);
    EXPECT_DOUBLE_EQ(elapsed_milliseconds(1000, 3000, 64, 2.5), 5e-3);
    // A 36-bit counter that wraps, with what the undefined bits may hold.
    const std::uint64_t wrap = std::uint64_t{1} << 36;
    EXPECT_DOUBLE_EQ(elapsed_milliseconds(wrap - 500, 500, 36, 1.0), 1e-3);
    EXPECT_DOUBLE_EQ(
        elapsed_milliseconds((std::uint64_t{0xabc} << 36) + 7, (std::uint64_t{0x123} << 36) + 1007, 36, 1.0), 1e-3);
    EXPECT_DOUBLE_EQ(elapsed_milliseconds(~std::uint64_t{0} - 9, 10, 64, 1.0), 20e-6);
}

TEST(ShaderCache, CompilesEachKeyOnce) {
    ShaderCache cache;
    const auto compile = [] { return SpirV{1, 2, 3}; };
    const auto first = cache.get("a", compile);
    EXPECT_EQ(cache.get("a", compile), first);
    cache.get("b", compile);
    EXPECT_EQ(cache.compilations(), 2);
    EXPECT_THROW(cache.get("c", []() -> SpirV { throw std::runtime_error("no"); }), std::runtime_error);
    EXPECT_EQ(*cache.get("c", compile), (SpirV{1, 2, 3}));
}

}  // namespace
}  // namespace reliefbench::gpu
