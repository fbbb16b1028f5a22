#pragma once

#include "gpu/shader_compiler.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace reliefbench::gpu {

/// An instruction of a SPIR-V module: its opcode and its words, of which the first holds that and their number.
struct Instruction {
    std::uint32_t op = 0;
    std::span<const std::uint32_t> words;
};

/// In the module's order (SPIR-V 1.6, section 2.3).
inline void for_each_instruction(const SpirV& module, const std::function<void(const Instruction&)>& visit) {
    constexpr std::size_t header_words = 5;
    for (std::size_t at = header_words; at < module.size();) {
        const std::size_t words = module[at] >> 16u;
        visit({module[at] & 0xffffu, std::span(&module[at], words)});
        at += words;
    }
}

}  // namespace reliefbench::gpu
