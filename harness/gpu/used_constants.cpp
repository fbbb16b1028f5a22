#include "gpu/used_constants.hpp"

#include "gpu/instructions.hpp"

#include <spirv/unified1/spirv.hpp>

#include <map>

namespace reliefbench::gpu {

namespace {

/// The word of an instruction that is a number, not an id, however large; 0 where there is none. (Other numbers within
/// functions are smaller than any constant's id.)
std::size_t literal_word(std::uint32_t op) {
    if (op == spv::OpSpecConstantOp) return 3;
    if (op == spv::OpExtInst) return 4;
    return 0;
}

}  // namespace

std::set<std::uint32_t> used_constants(const SpirV& module) {
    std::map<std::uint32_t, std::uint32_t> constant_ids;  // by the id of their result
    std::set<std::uint32_t> used;
    bool in_functions = false;
    for_each_instruction(module, [&](const Instruction& instruction) {
        const auto& [op, words] = instruction;
        in_functions = in_functions || op == spv::OpFunction;
        if (op == spv::OpDecorate && words[2] == spv::DecorationSpecId) constant_ids[words[1]] = words[3];
        const bool refers =
            in_functions || op == spv::OpTypeArray || op == spv::OpSpecConstantComposite || op == spv::OpSpecConstantOp;
        if (!refers) return;
        for (std::size_t word = 1; word < words.size(); ++word) {
            const auto constant = constant_ids.find(words[word]);
            if (word != literal_word(op) && constant != constant_ids.end()) used.insert(constant->second);
        }
    });
    return used;
}

}  // namespace reliefbench::gpu
