#include "gpu/used_constants.hpp"

#include <map>
#include <span>

namespace reliefbench::gpu {

namespace {

/// SPIR-V 1.6, section 3.
constexpr std::size_t header_words = 5;
constexpr std::uint32_t op_ext_inst = 12;
constexpr std::uint32_t op_type_array = 28;
constexpr std::uint32_t op_spec_constant_composite = 51;
constexpr std::uint32_t op_spec_constant_op = 52;
constexpr std::uint32_t op_function = 54;
constexpr std::uint32_t op_decorate = 71;
constexpr std::uint32_t decoration_spec_id = 1;

/// The word of an instruction that is a number, not an id, however large; 0 where there is none. (Other numbers within
/// functions are smaller than any constant's id.)
std::size_t literal_word(std::uint32_t op) {
    if (op == op_spec_constant_op) return 3;
    if (op == op_ext_inst) return 4;
    return 0;
}

}  // namespace

std::set<std::uint32_t> used_constants(const SpirV& module) {
    std::map<std::uint32_t, std::uint32_t> constant_ids;  // by the id of their result
    std::set<std::uint32_t> used;
    bool in_functions = false;
    for (std::size_t at = header_words; at < module.size();) {
        const std::uint32_t op = module[at] & 0xffffu;
        const std::size_t words = module[at] >> 16u;
        const std::span<const std::uint32_t> instruction(&module[at], words);
        at += words;
        in_functions = in_functions || op == op_function;
        if (op == op_decorate && instruction[2] == decoration_spec_id) constant_ids[instruction[1]] = instruction[3];
        const bool refers =
            in_functions || op == op_type_array || op == op_spec_constant_composite || op == op_spec_constant_op;
        if (!refers) continue;
        for (std::size_t word = 1; word < words; ++word) {
            const auto constant = constant_ids.find(instruction[word]);
            if (word != literal_word(op) && constant != constant_ids.end()) used.insert(constant->second);
        }
    }
    return used;
}

}  // namespace reliefbench::gpu
