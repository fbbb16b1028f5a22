#pragma once

#include "gpu/shader_compiler.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace reliefbench::gpu {

/// An instruction of a SPIR-V module: its opcode and its words, of which the first holds that and their number.
struct Instruction {
    std::uint32_t op = 0;
    std::span<const std::uint32_t> words;
};

/// A literal string: four bytes a word, the first in the lowest, ended by a 0.
inline std::string text_of(std::span<const std::uint32_t> words) {
    std::string text;
    for (const std::uint32_t word : words) {
        for (std::uint32_t shift = 0; shift < 32; shift += 8) {
            const char letter = static_cast<char>((word >> shift) & 0xffu);
            if (letter == 0) return text;
            text += letter;
        }
    }
    return text;
}

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
