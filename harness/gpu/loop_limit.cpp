#include "gpu/loop_limit.hpp"

#include "gpu/commands.hpp"
#include "gpu/handles.hpp"
#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"

#include <cstring>
#include <memory>
#include <span>

namespace reliefbench::gpu {

namespace {

/// Some milliseconds on a device that counts to the end.
constexpr std::uint32_t turns_asked = std::uint32_t{1} << 20;

const char* const counting_loop = R"(
layout(local_size_x = 1) in;
layout(set = 0, binding = 0, std430) buffer Loop {
    uint turns_asked;
    uint turns;
}
loop;
void main() {
    uint turns = 0u;
    while (turns < loop.turns_asked) turns += 1u;
    loop.turns = turns;
}
)";

struct Loop {
    std::uint32_t turns_asked = 0;
    std::uint32_t turns = 0;
};

std::optional<std::uint32_t> find_loop_limit(const Device& device) {
    const char* const file = "counting_loop.comp";
    const auto code = std::make_shared<const SpirV>(compile_shader({.stage = ShaderStage::compute,
                                                                    .file = file,
                                                                    .roots = {},
                                                                    .generated = {{file, counting_loop}},
                                                                    .preamble = {}}));
    Loop loop{.turns_asked = turns_asked};
    const Buffer buffer =
        make_filled_buffer(device, vk::BufferUsageFlagBits::eStorageBuffer, std::as_bytes(std::span(&loop, 1)));
    const Pipeline pipeline = make_compute_pipeline(device, {.shader = {ShaderStage::compute, code}, .constants = {}},
                                                    {{storage_buffer("loop", buffer.buffer)}});
    submit_and_wait(device, "count a loop's iterations", [&](const vk::raii::CommandBuffer& commands) {
        pipeline.bind(commands);
        commands.dispatch(1, 1, 1);
    });
    std::memcpy(&loop, buffer.mapped, sizeof loop);
    if (loop.turns == turns_asked) return std::nullopt;
    return loop.turns;
}

}  // namespace

std::optional<std::uint32_t> loop_limit(const Device& device) {
    KnownLoopLimit& known = *device.handles().loop_limit;
    if (!known.is_known) {
        known.iterations = find_loop_limit(device);
        known.is_known = true;
    }
    return known.iterations;
}

std::string describe_loop_limit(const Device& device) {
    const std::optional<std::uint32_t> limit = loop_limit(device);
    const std::string when =
        limit ? fmt::format("after {} iterations of all of them together", *limit) : "at some length";
    return fmt::format("{} ends the loops of an invocation {}", device.info().name, when);
}

}  // namespace reliefbench::gpu
