#include "gpu/fetches.hpp"

#include "gpu/instructions.hpp"

#include <spirv/unified1/spirv.hpp>

#include <map>
#include <optional>

namespace reliefbench::gpu {

namespace {

std::optional<Fetch::Kind> fetch_kind(std::uint32_t op) {
    if (op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageSampleProjDrefExplicitLod) return Fetch::Kind::sampled;
    if (op >= spv::OpImageSparseSampleImplicitLod && op <= spv::OpImageSparseSampleProjDrefExplicitLod)
        return Fetch::Kind::sampled;
    switch (op) {
        case spv::OpImageFetch:
        case spv::OpImageSparseFetch:
            return Fetch::Kind::texel;
        case spv::OpImageGather:
        case spv::OpImageDrefGather:
        case spv::OpImageSparseGather:
        case spv::OpImageSparseDrefGather:
            return Fetch::Kind::gather;
        case spv::OpImageTexelPointer:
        case spv::OpImageRead:
        case spv::OpImageSparseRead:
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
        if (instruction.op == spv::OpString) files[words[1]] = text_of(words.subspan(2));
        if (instruction.op == spv::OpLine) {
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
