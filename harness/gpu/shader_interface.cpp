#include "gpu/shader_interface.hpp"

#include "core/error.hpp"
#include "gpu/instructions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace reliefbench::gpu {

namespace {

/// SPIR-V 1.6, section 3.
namespace spv {
constexpr std::uint32_t op_name = 5;
constexpr std::uint32_t op_execution_mode = 16;
constexpr std::uint32_t op_type_int = 21;
constexpr std::uint32_t op_type_float = 22;
constexpr std::uint32_t op_type_vector = 23;
constexpr std::uint32_t op_type_image = 25;
constexpr std::uint32_t op_type_sampled_image = 27;
constexpr std::uint32_t op_type_array = 28;
constexpr std::uint32_t op_type_runtime_array = 29;
constexpr std::uint32_t op_type_struct = 30;
constexpr std::uint32_t op_type_pointer = 32;
constexpr std::uint32_t op_constant = 43;
constexpr std::uint32_t op_variable = 59;
constexpr std::uint32_t op_decorate = 71;
constexpr std::uint32_t op_member_decorate = 72;
constexpr std::uint32_t op_type_acceleration_structure = 5341;
constexpr std::uint32_t op_execution_mode_id = 331;
constexpr std::uint32_t mode_local_size = 17;
constexpr std::uint32_t mode_local_size_id = 38;
constexpr std::uint32_t storage_uniform = 2;
constexpr std::uint32_t storage_push_constant = 9;
constexpr std::uint32_t storage_buffer = 12;
constexpr std::uint32_t spec_id = 1;
constexpr std::uint32_t array_stride = 6;
constexpr std::uint32_t binding = 33;
constexpr std::uint32_t descriptor_set = 34;
constexpr std::uint32_t offset = 35;
}  // namespace spv

/// The declarations of a module by the id of their result.
class Declarations {
public:
    explicit Declarations(const SpirV& module) {
        for_each_instruction(module, [&](const Instruction& instruction) { add(instruction); });
    }

    const std::vector<std::uint32_t>& variables() const { return variables_; }
    const std::map<std::uint32_t, std::uint32_t>& constant_ids() const { return decorated(spv::spec_id); }

    std::uint32_t storage_class(std::uint32_t variable) const { return words(variable)[3]; }
    /// What the variable's pointer points to.
    std::uint32_t type_of(std::uint32_t variable) const { return words(words(variable)[1])[3]; }
    std::uint32_t op(std::uint32_t id) const { return instructions_.at(id).op; }

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
            if (!instructions_.contains(side)) fail("the size of the shader's work groups is no constant");
            side = words(side)[3];
        }
        return size;
    }

    /// Bytes of a type as blocks lay it out.
    std::uint32_t size_of(std::uint32_t type) const {
        constexpr std::uint32_t bits_per_byte = 8;
        const auto& word = words(type);
        switch (op(type)) {
            case spv::op_type_int:
            case spv::op_type_float:
                return word[2] / bits_per_byte;
            case spv::op_type_vector:
                return word[3] * size_of(word[2]);
            case spv::op_type_array:
                return words(word[3])[3] * decoration(type, spv::array_stride);
            case spv::op_type_struct: {
                std::uint32_t end = 0;
                for (std::uint32_t member = 0; member + 2 < word.size(); ++member)
                    end = std::max(end, member_offsets_.at({type, member}) + size_of(word[member + 2]));
                return end;
            }
            default:
                fail("a push constant is neither a number, a vector, an array nor a structure of these");
        }
    }

private:
    void add(const Instruction& instruction) {
        const auto& [op, words] = instruction;
        switch (op) {
            case spv::op_name:
                names_[words[1]] = text_of(words.subspan(2));
                break;
            case spv::op_execution_mode:
            case spv::op_execution_mode_id:
                if (words[2] != spv::mode_local_size && words[2] != spv::mode_local_size_id) break;
                local_size_ = {words[3], words[4], words[5]};
                local_size_by_id_ = op == spv::op_execution_mode_id;
                break;
            case spv::op_decorate:
                if (words.size() > 3) decorations_[words[2]][words[1]] = words[3];
                break;
            case spv::op_member_decorate:
                if (words[3] == spv::offset) member_offsets_[{words[1], words[2]}] = words[4];
                break;
            case spv::op_variable:
                variables_.push_back(words[2]);
                instructions_[words[2]] = instruction;
                break;
            case spv::op_constant:
                instructions_[words[2]] = instruction;
                break;
            case spv::op_type_int:
            case spv::op_type_float:
            case spv::op_type_vector:
            case spv::op_type_image:
            case spv::op_type_sampled_image:
            case spv::op_type_array:
            case spv::op_type_runtime_array:
            case spv::op_type_struct:
            case spv::op_type_pointer:
            case spv::op_type_acceleration_structure:
                instructions_[words[1]] = instruction;
                break;
            default:
                break;
        }
    }

    const std::span<const std::uint32_t>& words(std::uint32_t id) const { return instructions_.at(id).words; }

    const std::map<std::uint32_t, std::uint32_t>& decorated(std::uint32_t kind) const {
        static const std::map<std::uint32_t, std::uint32_t> none;
        const auto found = decorations_.find(kind);
        return found == decorations_.end() ? none : found->second;
    }

    std::map<std::uint32_t, Instruction> instructions_;
    std::map<std::uint32_t, std::string> names_;
    /// By kind, then by what is decorated.
    std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> decorations_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> member_offsets_;
    std::vector<std::uint32_t> variables_;
    std::array<std::uint32_t, 3> local_size_{};
    bool local_size_by_id_ = false;
};

vk::DescriptorType descriptor_type(const Declarations& module, std::uint32_t variable, const std::string& name) {
    const std::uint32_t type = module.op(module.type_of(variable));
    if (type == spv::op_type_array || type == spv::op_type_runtime_array)
        fail("the shader's '{}' is an array of resources; each needs a name of its own", name);
    if (module.storage_class(variable) == spv::storage_buffer) return vk::DescriptorType::eStorageBuffer;
    if (module.storage_class(variable) == spv::storage_uniform) return vk::DescriptorType::eUniformBuffer;
    switch (type) {
        case spv::op_type_sampled_image:
            return vk::DescriptorType::eCombinedImageSampler;
        case spv::op_type_image:
            return vk::DescriptorType::eStorageImage;
        case spv::op_type_acceleration_structure:
            return vk::DescriptorType::eAccelerationStructureKHR;
        default:
            fail("the shader's '{}' is of a kind that is never bound", name);
    }
}

void add_resource(ShaderInterface& interface, const Declarations& module, std::uint32_t variable,
                  vk::ShaderStageFlagBits stage) {
    std::string name = module.name_of(variable);
    if (name.empty()) name = module.name_of(module.type_of(variable));
    if (module.decoration(variable, spv::descriptor_set) != 0)
        fail("the shader's '{}' is in descriptor set {}; there is set 0 only", name,
             module.decoration(variable, spv::descriptor_set));
    const vk::DescriptorType type = descriptor_type(module, variable, name);
    interface.resources.emplace(name,
                                ShaderInterface::Resource{module.decoration(variable, spv::binding), type, stage});
}

}  // namespace

ShaderInterface read_interface(const SpirV& module, vk::ShaderStageFlagBits stage) {
    const Declarations declarations(module);
    ShaderInterface interface;
    for (const std::uint32_t variable : declarations.variables()) {
        if (declarations.storage_class(variable) == spv::storage_push_constant)
            interface.push_constant_bytes = declarations.size_of(declarations.type_of(variable));
        if (declarations.is_decorated(variable, spv::binding)) add_resource(interface, declarations, variable, stage);
    }
    for (const auto& [constant, id] : declarations.constant_ids())
        interface.constants.emplace(declarations.name_of(constant), id);
    interface.local_size = declarations.local_size();
    return interface;
}

void add_interface(ShaderInterface& pipeline, const ShaderInterface& stage) {
    for (const auto& [name, resource] : stage.resources) {
        for (auto& [other_name, other] : pipeline.resources) {
            if (other.binding == resource.binding && other_name != name)
                fail("the shaders declare both '{}' and '{}' at binding {}", other_name, name, resource.binding);
        }
        const auto [known, is_new] = pipeline.resources.emplace(name, resource);
        if (is_new) continue;
        if (known->second.binding != resource.binding || known->second.type != resource.type)
            fail("the shaders' stages declare '{}' in different ways", name);
        known->second.stages |= resource.stages;
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
