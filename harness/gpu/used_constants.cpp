#include "gpu/used_constants.hpp"

#include "gpu/instructions.hpp"

#include <map>

namespace reliefbench::gpu {

namespace {

/// SPIR-V 1.6, section 3.
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
    for_each_instruction(module, [&](const Instruction& instruction) {
        const auto& [op, words] = instruction;
        in_functions = in_functions || op == op_function;
        if (op == op_decorate && words[2] == decoration_spec_id) constant_ids[words[1]] = words[3];
        const bool refers =
            in_functions || op == op_type_array || op == op_spec_constant_composite || op == op_spec_constant_op;
        if (!refers) return;
        for (std::size_t word = 1; word < words.size(); ++word) {
            const auto constant = constant_ids.find(words[word]);
            if (word != literal_word(op) && constant != constant_ids.end()) used.insert(constant->second);
        }
    });
    return used;
}

}  // namespace reliefbench::gpu
