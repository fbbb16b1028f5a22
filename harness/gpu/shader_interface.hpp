#pragma once

#include "gpu/shader_compiler.hpp"
#include "gpu/vulkan.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace reliefbench::gpu {

/// What a compiled shader says of itself to those who run it: read out of its SPIR-V, by the names of its source, so
/// that numbers of bindings and constants stand in GLSL alone.
struct ShaderInterface {
    struct Resource {
        std::uint32_t binding = 0;
        vk::DescriptorType type = vk::DescriptorType::eUniformBuffer;
        vk::ShaderStageFlags stages = {};
        /// Whether a function refers to it. What none refers to may be bound or not.
        bool is_used = true;
    };
    /// Of descriptor set 0. A block without an instance name goes by the block's.
    std::map<std::string, Resource> resources;
    /// constant_id of each specialization constant that is declared.
    std::map<std::string, std::uint32_t> constants;
    /// 0 where no function refers to them.
    std::uint32_t push_constant_bytes = 0;
    /// Of a work group; zeros in stages that have none.
    std::array<std::uint32_t, 3> local_size{};
};

/// What can never be bound (another descriptor set, an array of resources) is an Error with its name where a function
/// refers to it, and else left out.
ShaderInterface read_interface(const SpirV& module, vk::ShaderStageFlagBits stage);

/// The interface of a pipeline with both stages. Names that stand for different things, or different names for one
/// binding or constant_id, are Errors, but for resources of which only one is used.
void add_interface(ShaderInterface& pipeline, const ShaderInterface& stage);

}  // namespace reliefbench::gpu
