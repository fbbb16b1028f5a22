#include "gpu/pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <string>
#include <utility>

namespace reliefbench::gpu {

namespace {

vk::ShaderStageFlagBits vulkan_stage(ShaderStage stage) {
    switch (stage) {
        case ShaderStage::vertex:
            return vk::ShaderStageFlagBits::eVertex;
        case ShaderStage::tessellation_control:
            return vk::ShaderStageFlagBits::eTessellationControl;
        case ShaderStage::tessellation_evaluation:
            return vk::ShaderStageFlagBits::eTessellationEvaluation;
        case ShaderStage::fragment:
            return vk::ShaderStageFlagBits::eFragment;
        case ShaderStage::compute:
            return vk::ShaderStageFlagBits::eCompute;
    }
    fail("unknown shader stage {}", static_cast<int>(stage));
}

/// Vulkan's description of SpecializationValues, with the numbers that the shaders give them; refers into itself.
struct Specialization {
    std::vector<vk::SpecializationMapEntry> entries;
    std::vector<std::uint32_t> data;
    vk::SpecializationInfo info;

    Specialization(const SpecializationValues& values, const ShaderInterface& interface) {
        for (const auto& [name, value] : values) {
            const auto declared = interface.constants.find(name);
            if (declared == interface.constants.end()) fail("the shaders declare no constant '{}'", name);
            entries.push_back({.constantID = declared->second,
                               .offset = static_cast<std::uint32_t>(data.size() * sizeof(std::uint32_t)),
                               .size = sizeof(std::uint32_t)});
            data.push_back(value);
        }
        info = vk::SpecializationInfo{.mapEntryCount = static_cast<std::uint32_t>(entries.size()),
                                      .pMapEntries = entries.data(),
                                      .dataSize = data.size() * sizeof(std::uint32_t),
                                      .pData = data.data()};
    }
    Specialization(const Specialization&) = delete;
    Specialization& operator=(const Specialization&) = delete;
};

/// Numbers of the set's bindings in their order. An Error where it binds what the shaders do not declare, or otherwise,
/// or leaves something out that they use.
std::vector<std::uint32_t> find_bindings(const ShaderInterface& interface, const std::vector<Binding>& set) {
    std::vector<std::uint32_t> numbers;
    for (const Binding& binding : set) {
        const auto declared = interface.resources.find(binding.name);
        if (declared == interface.resources.end()) fail("the shaders declare no '{}' to be bound", binding.name);
        if (declared->second.type != binding.type)
            fail("the shaders declare '{}' as {}, and {} is bound to it", binding.name,
                 vk::to_string(declared->second.type), vk::to_string(binding.type));
        const auto same = std::ranges::find(numbers, declared->second.binding);
        if (same != numbers.end())
            fail("the shaders declare both '{}' and '{}' at binding {}", set[same - numbers.begin()].name, binding.name,
                 *same);
        numbers.push_back(declared->second.binding);
    }
    for (const auto& [name, resource] : interface.resources) {
        if (resource.is_used && std::ranges::find(set, name, &Binding::name) == set.end())
            fail("the shaders use the {} '{}', to which nothing is bound", vk::to_string(resource.type), name);
    }
    return numbers;
}

void make_descriptor_sets(const DeviceHandles& handles, Pipeline& pipeline,
                          const std::vector<std::vector<Binding>>& sets) {
    const auto set_count = static_cast<std::uint32_t>(sets.size());
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const auto& [name, resource] : pipeline.interface().resources)
        sizes.push_back({.type = resource.type, .descriptorCount = set_count});
    pipeline.descriptor_pool = vk::raii::DescriptorPool(
        handles.device, vk::DescriptorPoolCreateInfo{.flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                                     .maxSets = set_count,
                                                     .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
                                                     .pPoolSizes = sizes.data()});
    const std::vector<vk::DescriptorSetLayout> layouts(sets.size(), *pipeline.shared->set_layout);
    vk::raii::DescriptorSets allocated(handles.device,
                                       vk::DescriptorSetAllocateInfo{.descriptorPool = *pipeline.descriptor_pool,
                                                                     .descriptorSetCount = set_count,
                                                                     .pSetLayouts = layouts.data()});
    for (vk::raii::DescriptorSet& set : allocated)
        pipeline.descriptor_sets.push_back(std::move(set));

    std::vector<vk::WriteDescriptorSet> writes;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const std::vector<std::uint32_t> numbers = find_bindings(pipeline.interface(), sets[i]);
        for (std::size_t j = 0; j < numbers.size(); ++j)
            writes.push_back({.dstSet = *pipeline.descriptor_sets[i],
                              .dstBinding = numbers[j],
                              .descriptorCount = 1,
                              .descriptorType = sets[i][j].type,
                              .pImageInfo = &sets[i][j].image,
                              .pBufferInfo = &sets[i][j].buffer});
    }
    handles.device.updateDescriptorSets(writes, {});
}

/// What a pipeline's making depends on, apart from fixed state: shaders by their addresses, bindings by their names.
std::string shared_key(const std::vector<CompiledStage>& stages, const SpecializationValues& constants,
                       const std::vector<Binding>& set) {
    std::string key;
    for (const CompiledStage& stage : stages)
        key += fmt::format("stage {} {};", static_cast<int>(stage.stage), static_cast<const void*>(stage.code.get()));
    for (const auto& [name, value] : constants)
        key += fmt::format("constant {} {};", name, value);
    for (const Binding& binding : set)
        key += fmt::format("binding {};", binding.name);
    return key;
}

/// Everything but the pipeline itself. The layout holds what `set` binds, which is all that the shaders use.
SharedPipeline make_layout(const DeviceHandles& handles, const std::vector<CompiledStage>& compiled,
                           const std::vector<Binding>& set) {
    SharedPipeline result;
    vk::ShaderStageFlags stages;
    for (const CompiledStage& stage : compiled) {
        stages |= vulkan_stage(stage.stage);
        add_interface(result.interface, read_interface(*stage.code, vulkan_stage(stage.stage)));
        result.shaders.push_back(stage.code);
    }
    find_bindings(result.interface, set);
    std::erase_if(result.interface.resources, [&](const auto& resource) {
        return std::ranges::find(set, resource.first, &Binding::name) == set.end();
    });
    const std::uint32_t max_push_constants = handles.physical_device.getProperties().limits.maxPushConstantsSize;
    if (result.interface.push_constant_bytes > max_push_constants)
        fail("the shaders use {} bytes of push constants; {} has {}", result.interface.push_constant_bytes,
             handles.info.name, max_push_constants);
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (const auto& [name, resource] : result.interface.resources)
        bindings.push_back({.binding = resource.binding,
                            .descriptorType = resource.type,
                            .descriptorCount = 1,
                            .stageFlags = resource.stages});
    result.set_layout = vk::raii::DescriptorSetLayout(
        handles.device, vk::DescriptorSetLayoutCreateInfo{.bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                                          .pBindings = bindings.data()});
    const vk::PushConstantRange push_constants{.stageFlags = stages, .size = result.interface.push_constant_bytes};
    result.layout = vk::raii::PipelineLayout(
        handles.device, vk::PipelineLayoutCreateInfo{.setLayoutCount = 1,
                                                     .pSetLayouts = &*result.set_layout,
                                                     .pushConstantRangeCount = push_constants.size > 0 ? 1u : 0u,
                                                     .pPushConstantRanges = &push_constants});
    return result;
}

vk::raii::ShaderModule make_module(const DeviceHandles& handles, const SpirV& code) {
    return vk::raii::ShaderModule(
        handles.device,
        vk::ShaderModuleCreateInfo{.codeSize = code.size() * sizeof(std::uint32_t), .pCode = code.data()});
}

}  // namespace

bool use_resource(const std::vector<CompiledStage>& stages, const std::string& name) {
    return std::ranges::any_of(stages, [&](const CompiledStage& stage) {
        const ShaderInterface interface = read_interface(*stage.code, vulkan_stage(stage.stage));
        const auto declared = interface.resources.find(name);
        return declared != interface.resources.end() && declared->second.is_used;
    });
}

Binding uniform_buffer(std::string name, const vk::raii::Buffer& buffer) {
    return {.name = std::move(name),
            .type = vk::DescriptorType::eUniformBuffer,
            .buffer = {.buffer = *buffer, .offset = 0, .range = VK_WHOLE_SIZE}};
}

Binding storage_buffer(std::string name, const vk::raii::Buffer& buffer) {
    return {.name = std::move(name),
            .type = vk::DescriptorType::eStorageBuffer,
            .buffer = {.buffer = *buffer, .offset = 0, .range = VK_WHOLE_SIZE}};
}

Binding sampled_image(std::string name, const vk::raii::ImageView& view, const vk::raii::Sampler& sampler,
                      vk::ImageLayout layout) {
    return {.name = std::move(name),
            .type = vk::DescriptorType::eCombinedImageSampler,
            .image = {.sampler = *sampler, .imageView = *view, .imageLayout = layout}};
}

Binding storage_image(std::string name, const vk::raii::ImageView& view) {
    return {.name = std::move(name),
            .type = vk::DescriptorType::eStorageImage,
            .image = {.imageView = *view, .imageLayout = vk::ImageLayout::eGeneral}};
}

void Pipeline::bind(const vk::raii::CommandBuffer& commands, std::size_t descriptor_set) const {
    commands.bindPipeline(shared->bind_point, *shared->pipeline);
    commands.bindDescriptorSets(shared->bind_point, layout(), 0, *descriptor_sets[descriptor_set], {});
    if (shared->bind_point != vk::PipelineBindPoint::eGraphics) return;
    commands.setViewport(0, vk::Viewport{.width = static_cast<float>(extent.width),
                                         .height = static_cast<float>(extent.height),
                                         .minDepth = 0,
                                         .maxDepth = 1});
    commands.setScissor(0, vk::Rect2D{.extent = extent});
}

Pipeline make_compute_pipeline(const Device& device, const ComputePipelineOptions& options,
                               const std::vector<std::vector<Binding>>& sets) {
    assert(!sets.empty());
    const DeviceHandles& handles = device.handles();
    return translate_errors("make a compute pipeline", handles.info.name, [&] {
        const std::vector<CompiledStage> stages{options.shader};
        const auto make = [&] {
            SharedPipeline made = make_layout(handles, stages, sets.front());
            const Specialization specialization(options.constants, made.interface);
            const vk::raii::ShaderModule module = make_module(handles, *options.shader.code);
            made.bind_point = vk::PipelineBindPoint::eCompute;
            made.pipeline =
                vk::raii::Pipeline(handles.device, handles.pipeline_cache,
                                   vk::ComputePipelineCreateInfo{.stage = {.stage = vk::ShaderStageFlagBits::eCompute,
                                                                           .module = *module,
                                                                           .pName = "main",
                                                                           .pSpecializationInfo = &specialization.info},
                                                                 .layout = *made.layout});
            return made;
        };
        Pipeline result;
        result.shared = device.shared_pipelines().get(shared_key(stages, options.constants, sets.front()), make);
        make_descriptor_sets(handles, result, sets);
        return result;
    });
}

namespace {

vk::raii::Pipeline make_graphics(const DeviceHandles& handles, const GraphicsPipelineOptions& options,
                                 const std::vector<vk::PipelineShaderStageCreateInfo>& stages,
                                 vk::PipelineLayout layout) {
    const vk::PipelineVertexInputStateCreateInfo vertex_input{};
    const vk::PipelineInputAssemblyStateCreateInfo assembly{.topology = options.topology};
    // The tessellator's v runs up as the patch's does, so that `ccw` in GLSL is counter-clockwise seen from above.
    const vk::PipelineTessellationDomainOriginStateCreateInfo origin{.domainOrigin =
                                                                         vk::TessellationDomainOrigin::eLowerLeft};
    const vk::PipelineTessellationStateCreateInfo tessellation{.pNext = &origin,
                                                               .patchControlPoints = options.patch_vertices};
    const vk::PipelineViewportStateCreateInfo viewports{.viewportCount = 1, .scissorCount = 1};
    const std::array dynamic_states{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = dynamic_states.size(),
                                                     .pDynamicStates = dynamic_states.data()};
    const vk::PipelineRasterizationStateCreateInfo rasterization{.polygonMode = vk::PolygonMode::eFill,
                                                                 .cullMode = options.cull,
                                                                 .frontFace = vk::FrontFace::eCounterClockwise,
                                                                 .lineWidth = 1};
    const vk::PipelineMultisampleStateCreateInfo multisampling{
        .rasterizationSamples = options.samples,
        .sampleShadingEnable = options.samples != vk::SampleCountFlagBits::e1,
        .minSampleShading = 1};
    const vk::PipelineDepthStencilStateCreateInfo depth{
        .depthTestEnable = true, .depthWriteEnable = true, .depthCompareOp = options.depth_compare};
    using Component = vk::ColorComponentFlagBits;
    const std::vector<vk::PipelineColorBlendAttachmentState> attachments(
        options.colour_formats.size(),
        {.colorWriteMask = Component::eR | Component::eG | Component::eB | Component::eA});
    const vk::PipelineColorBlendStateCreateInfo blending{
        .attachmentCount = static_cast<std::uint32_t>(attachments.size()), .pAttachments = attachments.data()};
    const vk::PipelineRenderingCreateInfo rendering{
        .colorAttachmentCount = static_cast<std::uint32_t>(options.colour_formats.size()),
        .pColorAttachmentFormats = options.colour_formats.data(),
        .depthAttachmentFormat = options.depth_format};
    return vk::raii::Pipeline(
        handles.device, handles.pipeline_cache,
        vk::GraphicsPipelineCreateInfo{.pNext = &rendering,
                                       .flags = options.flags,
                                       .stageCount = static_cast<std::uint32_t>(stages.size()),
                                       .pStages = stages.data(),
                                       .pVertexInputState = &vertex_input,
                                       .pInputAssemblyState = &assembly,
                                       .pTessellationState = options.patch_vertices > 0 ? &tessellation : nullptr,
                                       .pViewportState = &viewports,
                                       .pRasterizationState = &rasterization,
                                       .pMultisampleState = &multisampling,
                                       .pDepthStencilState = &depth,
                                       .pColorBlendState = &blending,
                                       .pDynamicState = &dynamic,
                                       .layout = layout});
}

}  // namespace

Pipeline make_graphics_pipeline(const Device& device, const GraphicsPipelineOptions& options,
                                const std::vector<Binding>& bindings) {
    const DeviceHandles& handles = device.handles();
    return translate_errors("make a graphics pipeline", handles.info.name, [&] {
        const auto make = [&] {
            SharedPipeline made = make_layout(handles, options.stages, bindings);
            const Specialization specialization(options.constants, made.interface);
            std::vector<vk::raii::ShaderModule> modules;
            std::vector<vk::PipelineShaderStageCreateInfo> stages;
            for (const CompiledStage& stage : options.stages) {
                modules.push_back(make_module(handles, *stage.code));
                stages.push_back({.stage = vulkan_stage(stage.stage),
                                  .module = *modules.back(),
                                  .pName = "main",
                                  .pSpecializationInfo = &specialization.info});
            }
            const auto start = std::chrono::steady_clock::now();
            made.pipeline = make_graphics(handles, options, stages, *made.layout);
            made.made_in_ms =
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
            return made;
        };
        std::string key = shared_key(options.stages, options.constants, bindings);
        for (const vk::Format format : options.colour_formats)
            key += fmt::format("colour {};", vk::to_string(format));
        key += fmt::format("depth {} {};{} cull {} patch {};samples {};flags {};", vk::to_string(options.depth_format),
                           vk::to_string(options.depth_compare), vk::to_string(options.topology),
                           vk::to_string(options.cull), options.patch_vertices, vk::to_string(options.samples),
                           vk::to_string(options.flags));
        Pipeline result;
        result.shared = device.shared_pipelines().get(key, make);
        result.extent = options.extent;
        make_descriptor_sets(handles, result, {bindings});
        return result;
    });
}

}  // namespace reliefbench::gpu
