#pragma once

#include "gpu/handles.hpp"
#include "gpu/shader_compiler.hpp"
#include "gpu/shared_pipelines.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench::gpu {

struct CompiledStage {
    ShaderStage stage = ShaderStage::compute;
    std::shared_ptr<const SpirV> code;
};

/// Whether a function of any of the stages refers to what has this name.
bool use_resource(const std::vector<CompiledStage>& stages, const std::string& name);

/// 32-bit values by the constants' names in GLSL.
using SpecializationValues = std::map<std::string, std::uint32_t>;

/// What stands behind a name of the shaders (ShaderInterface): a buffer, or a sampled or storage image.
struct Binding {
    std::string name;
    vk::DescriptorType type = vk::DescriptorType::eUniformBuffer;
    vk::DescriptorBufferInfo buffer{};
    vk::DescriptorImageInfo image{};
};

Binding uniform_buffer(std::string name, const vk::raii::Buffer& buffer);
Binding storage_buffer(std::string name, const vk::raii::Buffer& buffer);
Binding sampled_image(std::string name, const vk::raii::ImageView& view, const vk::raii::Sampler& sampler,
                      vk::ImageLayout layout);
Binding storage_image(std::string name, const vk::raii::ImageView& view);

/// A pipeline, which others of the same making share, with descriptor sets of its own. The bindings' resources must
/// outlive it.
struct Pipeline {
    std::shared_ptr<const SharedPipeline> shared;
    vk::raii::DescriptorPool descriptor_pool{nullptr};
    std::vector<vk::raii::DescriptorSet> descriptor_sets;
    /// Graphics only: viewport and scissor.
    vk::Extent2D extent;

    void bind(const vk::raii::CommandBuffer& commands, std::size_t descriptor_set = 0) const;
    vk::PipelineLayout layout() const { return *shared->layout; }
    const ShaderInterface& interface() const { return shared->interface; }
};

struct ComputePipelineOptions {
    CompiledStage shader;
    SpecializationValues constants;
};

/// One descriptor set for each element of `sets`. The layouts of descriptors and of push constants are what the shaders
/// declare: each set must bind all names that they use and none that they do not declare, the same in all sets, and
/// constants must be declared by some stage; else it is an Error with the name. So with graphics pipelines.
Pipeline make_compute_pipeline(const Device& device, const ComputePipelineOptions& options,
                               const std::vector<std::vector<Binding>>& sets);

struct GraphicsPipelineOptions {
    std::vector<CompiledStage> stages;
    SpecializationValues constants;
    std::vector<vk::Format> colour_formats;
    vk::Format depth_format = vk::Format::eUndefined;
    vk::Extent2D extent;
    vk::PrimitiveTopology topology = vk::PrimitiveTopology::eTriangleStrip;
    vk::CullModeFlags cull = vk::CullModeFlagBits::eNone;
    /// Of a patch list, which has tessellation stages.
    std::uint32_t patch_vertices = 0;
    vk::CompareOp depth_compare = vk::CompareOp::eLessOrEqual;
    /// Of the targets; with several, each sample is shaded by itself (the feature sampleRateShading).
    vk::SampleCountFlagBits samples = vk::SampleCountFlagBits::e1;
    vk::PipelineCreateFlags flags = {};
};

/// No vertex buffers; viewport and scissor cover `extent`; depth test with write.
Pipeline make_graphics_pipeline(const Device& device, const GraphicsPipelineOptions& options,
                                const std::vector<Binding>& bindings);

}  // namespace reliefbench::gpu
