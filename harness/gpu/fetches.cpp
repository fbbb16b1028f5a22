#include "gpu/fetches.hpp"

#include "gpu/instructions.hpp"

#include <map>
#include <optional>

namespace reliefbench::gpu {

namespace {

/// SPIR-V 1.6, section 3.
constexpr std::uint32_t op_string = 7;
constexpr std::uint32_t op_line = 8;
constexpr std::uint32_t op_image_texel_pointer = 60;
constexpr std::uint32_t op_image_sample_first = 87;
constexpr std::uint32_t op_image_sample_last = 94;
constexpr std::uint32_t op_image_fetch = 95;
constexpr std::uint32_t op_image_gather = 96;
constexpr std::uint32_t op_image_dref_gather = 97;
constexpr std::uint32_t op_image_read = 98;
constexpr std::uint32_t op_image_sparse_sample_first = 305;
constexpr std::uint32_t op_image_sparse_sample_last = 312;
constexpr std::uint32_t op_image_sparse_fetch = 313;
constexpr std::uint32_t op_image_sparse_gather = 314;
constexpr std::uint32_t op_image_sparse_dref_gather = 315;
constexpr std::uint32_t op_image_sparse_read = 320;

std::optional<Fetch::Kind> fetch_kind(std::uint32_t op) {
    if (op >= op_image_sample_first && op <= op_image_sample_last) return Fetch::Kind::sampled;
    if (op >= op_image_sparse_sample_first && op <= op_image_sparse_sample_last) return Fetch::Kind::sampled;
    switch (op) {
        case op_image_fetch:
        case op_image_sparse_fetch:
            return Fetch::Kind::texel;
        case op_image_gather:
        case op_image_dref_gather:
        case op_image_sparse_gather:
        case op_image_sparse_dref_gather:
            return Fetch::Kind::gather;
        case op_image_texel_pointer:
        case op_image_read:
        case op_image_sparse_read:
            return Fetch::Kind::stored;
        default:
            return std::nullopt;
    }
}

}  // namespace

std::vector<Fetch> find_fetches(const SpirV& module) {
    std::map<std::uint32_t, std::string> files;
    std::vector<Fetch> fetches;
    Fetch here;
    for_each_instruction(module, [&](const Instruction& instruction) {
        const auto& words = instruction.words;
        if (instruction.op == op_string) files[words[1]] = text_of(words.subspan(2));
        if (instruction.op == op_line) {
            here.file = files[words[1]];
            here.line = words[2];
        }
        if (const std::optional<Fetch::Kind> kind = fetch_kind(instruction.op)) {
            here.kind = *kind;
            fetches.push_back(here);
        }
    });
    return fetches;
}

}  // namespace reliefbench::gpu
