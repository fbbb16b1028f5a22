#include "gpu/shader_interface.hpp"

#include "core/error.hpp"
#include "gpu/instructions.hpp"

#include <fmt/format.h>
#include <spirv/unified1/spirv.hpp>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace reliefbench::gpu {

namespace {

/// Of the operand `Sampled` of OpTypeImage: 2 is a storage image.
constexpr std::uint32_t image_is_sampled = 1;

/// The words of a function's instruction among which ids of variables can be. Left out are numbers, which may be any,
/// and instructions that take no pointers but have such numbers (OpImageTexelPointer is none of those of images).
std::span<const std::uint32_t> words_with_ids(const Instruction& instruction) {
    const auto& [op, words] = instruction;
    const auto first = [&all = words](std::size_t count) { return all.first(std::min(count, all.size())); };
    if (op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageWrite) return {};
    if (op >= spv::OpImageSparseSampleImplicitLod && op <= spv::OpImageSparseRead) return {};
    switch (op) {
        case spv::OpLine:
        case spv::OpFunction:
        case spv::OpVariable:
        case spv::OpLoopMerge:
        case spv::OpSelectionMerge:
        case spv::OpBranchConditional:
        case spv::OpSwitch:
            return {};
        case spv::OpStore:
        case spv::OpCopyMemory:
            return first(3).subspan(1);
        case spv::OpLoad:
        case spv::OpArrayLength:
        case spv::OpCompositeExtract:
            return first(4).subspan(1);
        case spv::OpCompositeInsert:
        case spv::OpVectorShuffle:
            return first(5).subspan(1);
        case spv::OpExtInst:
            return words.subspan(5);
        default:
            return words.subspan(1);
    }
}

/// The declarations of a module by the id of their result. A technique's shaders may declare anything: what is not kept
/// here has the opcode 0 and no words.
class Declarations {
public:
    explicit Declarations(const SpirV& module) {
        for_each_instruction(module, [&](const Instruction& instruction) {
            in_functions_ = in_functions_ || instruction.op == spv::OpFunction;
            if (in_functions_)
                find_uses(instruction);
            else
                add(instruction);
        });
    }

    /// Those outside functions, and whether a function refers to them: Vulkan's static use, for the compiler leaves out
    /// functions that nobody calls.
    const std::map<std::uint32_t, bool>& variables() const { return variables_; }
    const std::map<std::uint32_t, std::uint32_t>& constant_ids() const { return decorated(spv::DecorationSpecId); }

    std::uint32_t storage_class(std::uint32_t variable) const { return word(variable, 3); }
    /// What the variable's pointer points to.
    std::uint32_t type_of(std::uint32_t variable) const { return word(word(variable, 1), 3); }
    std::uint32_t op(std::uint32_t id) const { return find(id).op; }
    /// 0 where there are fewer.
    std::uint32_t word(std::uint32_t id, std::size_t index) const {
        const auto& words = find(id).words;
        return index < words.size() ? words[index] : 0;
    }

    std::string name_of(std::uint32_t id) const {
        const auto found = names_.find(id);
        return found == names_.end() ? std::string() : found->second;
    }
    /// 0 where it is not decorated so.
    std::uint32_t decoration(std::uint32_t id, std::uint32_t kind) const {
        const auto& all = decorated(kind);
        const auto found = all.find(id);
        return found == all.end() ? 0 : found->second;
    }
    bool is_decorated(std::uint32_t id, std::uint32_t kind) const { return decorated(kind).contains(id); }

    /// SPIR-V 1.6 gives it by the ids of constants.
    std::array<std::uint32_t, 3> local_size() const {
        std::array<std::uint32_t, 3> size = local_size_;
        if (!local_size_by_id_) return size;
        for (std::uint32_t& side : size) {
            if (op(side) != spv::OpConstant) fail("the size of the shader's work groups is no constant");
            side = word(side, 3);
        }
        return size;
    }

    /// Bytes of a block's type up to its last member's end. Errors name `block`.
    std::uint32_t size_of_block(std::uint32_t type, const std::string& block) const {
        const auto& words = find(type).words;
        std::uint32_t end = 0;
        for (std::uint32_t member = 0; member + 2 < words.size(); ++member)
            end = std::max(end, member_decoration({type, member}, spv::DecorationOffset) +
                                    size_of(words[member + 2], {type, member}, block));
        return end;
    }

private:
    /// Of a structure's type.
    using Member = std::pair<std::uint32_t, std::uint32_t>;

    void add(const Instruction& instruction) {
        const auto& [op, words] = instruction;
        switch (op) {
            case spv::OpName:
                names_[words[1]] = text_of(words.subspan(2));
                break;
            case spv::OpExecutionMode:
            case spv::OpExecutionModeId:
                if (words[2] != spv::ExecutionModeLocalSize && words[2] != spv::ExecutionModeLocalSizeId) break;
                local_size_ = {words[3], words[4], words[5]};
                local_size_by_id_ = op == spv::OpExecutionModeId;
                break;
            case spv::OpDecorate:
                if (words.size() > 3) decorations_[words[2]][words[1]] = words[3];
                break;
            case spv::OpMemberDecorate:
                member_decorations_[words[3]][{words[1], words[2]}] = words.size() > 4 ? words[4] : 0;
                break;
            case spv::OpVariable:
                variables_.emplace(words[2], false);
                instructions_[words[2]] = instruction;
                break;
            case spv::OpConstant:
                instructions_[words[2]] = instruction;
                break;
            case spv::OpTypeInt:
            case spv::OpTypeFloat:
            case spv::OpTypeVector:
            case spv::OpTypeMatrix:
            case spv::OpTypeImage:
            case spv::OpTypeSampler:
            case spv::OpTypeSampledImage:
            case spv::OpTypeArray:
            case spv::OpTypeRuntimeArray:
            case spv::OpTypeStruct:
            case spv::OpTypePointer:
            case spv::OpTypeAccelerationStructureKHR:
                instructions_[words[1]] = instruction;
                break;
            default:
                break;
        }
    }

    void find_uses(const Instruction& instruction) {
        for (const std::uint32_t id : words_with_ids(instruction)) {
            const auto variable = variables_.find(id);
            if (variable != variables_.end()) variable->second = true;
        }
    }

    const Instruction& find(std::uint32_t id) const {
        static const Instruction none;
        const auto found = instructions_.find(id);
        return found == instructions_.end() ? none : found->second;
    }

    const std::map<std::uint32_t, std::uint32_t>& decorated(std::uint32_t kind) const {
        static const std::map<std::uint32_t, std::uint32_t> none;
        const auto found = decorations_.find(kind);
        return found == decorations_.end() ? none : found->second;
    }

    /// 0 where it is not decorated so.
    std::uint32_t member_decoration(const Member& member, std::uint32_t kind) const {
        const auto all = member_decorations_.find(kind);
        if (all == member_decorations_.end()) return 0;
        const auto found = all->second.find(member);
        return found == all->second.end() ? 0 : found->second;
    }
    bool is_row_major(const Member& member) const {
        const auto all = member_decorations_.find(spv::DecorationRowMajor);
        return all != member_decorations_.end() && all->second.contains(member);
    }

    /// Bytes of what `member` is or, of an array, holds: the layout of matrices is the member's.
    std::uint32_t size_of(std::uint32_t type, const Member& member, const std::string& block) const {
        constexpr std::uint32_t bits_per_byte = 8;
        switch (op(type)) {
            case spv::OpTypeInt:
            case spv::OpTypeFloat:
                return word(type, 2) / bits_per_byte;
            case spv::OpTypeVector:
                return word(type, 3) * size_of(word(type, 2), member, block);
            case spv::OpTypeMatrix: {
                const std::uint32_t columns = word(type, 3);
                const std::uint32_t rows = word(word(type, 2), 3);
                return (is_row_major(member) ? rows : columns) * member_decoration(member, spv::DecorationMatrixStride);
            }
            case spv::OpTypeArray: {
                const std::uint32_t length = word(type, 3);
                if (op(length) != spv::OpConstant)
                    fail("the shader's push constants '{}' have an array whose length is no plain constant", block);
                return word(length, 3) * decoration(type, spv::DecorationArrayStride);
            }
            case spv::OpTypeStruct:
                return size_of_block(type, block);
            default:
                fail(
                    "the shader's push constants '{}' have what is neither a number, a vector, a matrix, an array nor "
                    "a structure of these",
                    block);
        }
    }

    std::map<std::uint32_t, Instruction> instructions_;
    std::map<std::uint32_t, std::string> names_;
    /// By kind, then by what is decorated.
    std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> decorations_;
    std::map<std::uint32_t, std::map<Member, std::uint32_t>> member_decorations_;
    std::map<std::uint32_t, bool> variables_;
    std::array<std::uint32_t, 3> local_size_{};
    bool local_size_by_id_ = false;
    bool in_functions_ = false;
};

/// A block without an instance name goes by the block's.
std::string variable_name(const Declarations& module, std::uint32_t variable) {
    const std::string name = module.name_of(variable);
    return name.empty() ? module.name_of(module.type_of(variable)) : name;
}

std::optional<vk::DescriptorType> descriptor_type(const Declarations& module, std::uint32_t variable) {
    if (module.storage_class(variable) == spv::StorageClassStorageBuffer) return vk::DescriptorType::eStorageBuffer;
    if (module.storage_class(variable) == spv::StorageClassUniform) return vk::DescriptorType::eUniformBuffer;
    const std::uint32_t type = module.type_of(variable);
    const bool is_combined = module.op(type) == spv::OpTypeSampledImage;
    const std::uint32_t image = is_combined ? module.word(type, 2) : type;
    const bool is_buffer = module.word(image, 3) == spv::DimBuffer;
    switch (module.op(type)) {
        case spv::OpTypeSampledImage:
            // samplerBuffer has the shape of a combined sampler, and no sampler.
            return is_buffer ? vk::DescriptorType::eUniformTexelBuffer : vk::DescriptorType::eCombinedImageSampler;
        case spv::OpTypeImage:
            if (module.word(image, 3) == spv::DimSubpassData) return vk::DescriptorType::eInputAttachment;
            if (module.word(image, 7) == image_is_sampled)
                return is_buffer ? vk::DescriptorType::eUniformTexelBuffer : vk::DescriptorType::eSampledImage;
            return is_buffer ? vk::DescriptorType::eStorageTexelBuffer : vk::DescriptorType::eStorageImage;
        case spv::OpTypeSampler:
            return vk::DescriptorType::eSampler;
        case spv::OpTypeAccelerationStructureKHR:
            return vk::DescriptorType::eAccelerationStructureKHR;
        default:
            return std::nullopt;
    }
}

void add_resource(ShaderInterface& interface, const Declarations& module, std::uint32_t variable, bool is_used,
                  vk::ShaderStageFlagBits stage) {
    const std::string name = variable_name(module, variable);
    const auto leave_out = [&](const std::string& because) {
        if (is_used) fail("the shader's '{}' is {}", name, because);
    };
    const std::uint32_t set = module.decoration(variable, spv::DecorationDescriptorSet);
    const std::uint32_t type = module.op(module.type_of(variable));
    if (set != 0) return leave_out(fmt::format("in descriptor set {}; there is set 0 only", set));
    if (type == spv::OpTypeArray || type == spv::OpTypeRuntimeArray)
        return leave_out("an array of resources; each needs a name of its own");
    const std::optional<vk::DescriptorType> bound_as = descriptor_type(module, variable);
    if (!bound_as) return leave_out("of a kind that is never bound");
    interface.resources.emplace(name, ShaderInterface::Resource{module.decoration(variable, spv::DecorationBinding),
                                                                *bound_as, stage, is_used});
}

/// A multiple of four, as Vulkan wants it.
std::uint32_t push_constant_bytes(const Declarations& module, std::uint32_t variable) {
    const std::uint32_t bytes = module.size_of_block(module.type_of(variable), variable_name(module, variable));
    constexpr std::uint32_t granularity = 4;
    return (bytes + granularity - 1) / granularity * granularity;
}

}  // namespace

ShaderInterface read_interface(const SpirV& module, vk::ShaderStageFlagBits stage) {
    const Declarations declarations(module);
    ShaderInterface interface;
    for (const auto& [variable, is_used] : declarations.variables()) {
        if (declarations.storage_class(variable) == spv::StorageClassPushConstant && is_used)
            interface.push_constant_bytes = push_constant_bytes(declarations, variable);
        if (declarations.is_decorated(variable, spv::DecorationBinding))
            add_resource(interface, declarations, variable, is_used, stage);
    }
    for (const auto& [constant, id] : declarations.constant_ids())
        interface.constants.emplace(declarations.name_of(constant), id);
    interface.local_size = declarations.local_size();
    return interface;
}

void add_interface(ShaderInterface& pipeline, const ShaderInterface& stage) {
    for (const auto& [name, resource] : stage.resources) {
        for (const auto& [other_name, other] : pipeline.resources) {
            const bool both_used = other.is_used && resource.is_used;
            if (both_used && other.binding == resource.binding && other_name != name)
                fail("the shaders use both '{}' and '{}' at binding {}", other_name, name, resource.binding);
        }
        const auto [known, is_new] = pipeline.resources.emplace(name, resource);
        if (is_new) continue;
        if (known->second.binding == resource.binding && known->second.type == resource.type) {
            known->second.stages |= resource.stages;
            known->second.is_used = known->second.is_used || resource.is_used;
            continue;
        }
        if (known->second.is_used && resource.is_used) fail("the shaders' stages declare '{}' in different ways", name);
        if (resource.is_used) known->second = resource;
    }
    for (const auto& [name, id] : stage.constants) {
        for (const auto& [other_name, other] : pipeline.constants) {
            if ((other == id) != (other_name == name))
                fail("the shaders declare both '{}' and '{}' as constants, with the constant_id {} and {}", other_name,
                     name, other, id);
        }
        pipeline.constants.emplace(name, id);
    }
    pipeline.push_constant_bytes = std::max(pipeline.push_constant_bytes, stage.push_constant_bytes);
    if (stage.local_size[0] > 0) pipeline.local_size = stage.local_size;
}

}  // namespace reliefbench::gpu
