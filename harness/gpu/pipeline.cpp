#include "gpu/pipeline.hpp"

#include <cassert>

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

/// Vulkan's description of SpecializationValues; refers into itself.
struct Specialization {
    std::vector<vk::SpecializationMapEntry> entries;
    std::vector<std::uint32_t> data;
    vk::SpecializationInfo info;

    explicit Specialization(const SpecializationValues& values) {
        for (const auto& [id, value] : values) {
            entries.push_back({.constantID = id,
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

void make_descriptor_sets(const DeviceHandles& handles, Pipeline& pipeline,
                          const std::vector<std::vector<Binding>>& sets) {
    const auto set_count = static_cast<std::uint32_t>(sets.size());
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const Binding& binding : sets.front())
        sizes.push_back({.type = binding.type, .descriptorCount = set_count});
    pipeline.descriptor_pool = vk::raii::DescriptorPool(
        handles.device, vk::DescriptorPoolCreateInfo{.flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                                     .maxSets = set_count,
                                                     .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
                                                     .pPoolSizes = sizes.data()});
    const std::vector<vk::DescriptorSetLayout> layouts(sets.size(), *pipeline.set_layout);
    vk::raii::DescriptorSets allocated(handles.device,
                                       vk::DescriptorSetAllocateInfo{.descriptorPool = *pipeline.descriptor_pool,
                                                                     .descriptorSetCount = set_count,
                                                                     .pSetLayouts = layouts.data()});
    for (vk::raii::DescriptorSet& set : allocated)
        pipeline.descriptor_sets.push_back(std::move(set));

    std::vector<vk::WriteDescriptorSet> writes;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        for (const Binding& binding : sets[i])
            writes.push_back({.dstSet = *pipeline.descriptor_sets[i],
                              .dstBinding = binding.index,
                              .descriptorCount = 1,
                              .descriptorType = binding.type,
                              .pImageInfo = &binding.image,
                              .pBufferInfo = &binding.buffer});
    }
    handles.device.updateDescriptorSets(writes, {});
}

/// Everything but the pipeline itself.
Pipeline make_layout(const DeviceHandles& handles, const std::vector<std::vector<Binding>>& sets,
                     vk::ShaderStageFlags stages, std::uint32_t push_constant_bytes) {
    assert(!sets.empty());
    Pipeline result;
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (const Binding& binding : sets.front())
        bindings.push_back(
            {.binding = binding.index, .descriptorType = binding.type, .descriptorCount = 1, .stageFlags = stages});
    result.set_layout = vk::raii::DescriptorSetLayout(
        handles.device, vk::DescriptorSetLayoutCreateInfo{.bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                                          .pBindings = bindings.data()});
    make_descriptor_sets(handles, result, sets);
    const vk::PushConstantRange push_constants{.stageFlags = stages, .size = push_constant_bytes};
    result.layout = vk::raii::PipelineLayout(
        handles.device, vk::PipelineLayoutCreateInfo{.setLayoutCount = 1,
                                                     .pSetLayouts = &*result.set_layout,
                                                     .pushConstantRangeCount = push_constant_bytes > 0 ? 1u : 0u,
                                                     .pPushConstantRanges = &push_constants});
    return result;
}

vk::raii::ShaderModule make_module(const DeviceHandles& handles, const SpirV& code) {
    return vk::raii::ShaderModule(
        handles.device,
        vk::ShaderModuleCreateInfo{.codeSize = code.size() * sizeof(std::uint32_t), .pCode = code.data()});
}

}  // namespace

Binding uniform_buffer(std::uint32_t index, const vk::raii::Buffer& buffer) {
    return {.index = index,
            .type = vk::DescriptorType::eUniformBuffer,
            .buffer = {.buffer = *buffer, .offset = 0, .range = VK_WHOLE_SIZE}};
}

Binding storage_buffer(std::uint32_t index, const vk::raii::Buffer& buffer) {
    return {.index = index,
            .type = vk::DescriptorType::eStorageBuffer,
            .buffer = {.buffer = *buffer, .offset = 0, .range = VK_WHOLE_SIZE}};
}

Binding sampled_image(std::uint32_t index, const vk::raii::ImageView& view, const vk::raii::Sampler& sampler,
                      vk::ImageLayout layout) {
    return {.index = index,
            .type = vk::DescriptorType::eCombinedImageSampler,
            .image = {.sampler = *sampler, .imageView = *view, .imageLayout = layout}};
}

Binding storage_image(std::uint32_t index, const vk::raii::ImageView& view) {
    return {.index = index,
            .type = vk::DescriptorType::eStorageImage,
            .image = {.imageView = *view, .imageLayout = vk::ImageLayout::eGeneral}};
}

void Pipeline::bind(const vk::raii::CommandBuffer& commands, std::size_t descriptor_set) const {
    commands.bindPipeline(bind_point, *pipeline);
    commands.bindDescriptorSets(bind_point, *layout, 0, *descriptor_sets[descriptor_set], {});
}

Pipeline make_compute_pipeline(const Device& device, const ComputePipelineOptions& options,
                               const std::vector<std::vector<Binding>>& sets) {
    const DeviceHandles& handles = device.handles();
    return translate_errors("make a compute pipeline", handles.info.name, [&] {
        Pipeline result = make_layout(handles, sets, vk::ShaderStageFlagBits::eCompute, options.push_constant_bytes);
        const Specialization specialization(options.constants);
        const vk::raii::ShaderModule module = make_module(handles, *options.shader.code);
        result.bind_point = vk::PipelineBindPoint::eCompute;
        result.pipeline =
            vk::raii::Pipeline(handles.device, handles.pipeline_cache,
                               vk::ComputePipelineCreateInfo{.stage = {.stage = vk::ShaderStageFlagBits::eCompute,
                                                                       .module = *module,
                                                                       .pName = "main",
                                                                       .pSpecializationInfo = &specialization.info},
                                                             .layout = *result.layout});
        return result;
    });
}

namespace {

vk::raii::Pipeline make_graphics(const DeviceHandles& handles, const GraphicsPipelineOptions& options,
                                 const std::vector<vk::PipelineShaderStageCreateInfo>& stages,
                                 vk::PipelineLayout layout) {
    const bool patches = options.patch_vertices > 0;
    const vk::PipelineVertexInputStateCreateInfo vertex_input{};
    const vk::PipelineInputAssemblyStateCreateInfo assembly{
        .topology = patches ? vk::PrimitiveTopology::ePatchList : vk::PrimitiveTopology::eTriangleStrip};
    // The tessellator's v runs up as the patch's does, so that `ccw` in GLSL is counter-clockwise seen from above.
    const vk::PipelineTessellationDomainOriginStateCreateInfo origin{.domainOrigin =
                                                                         vk::TessellationDomainOrigin::eLowerLeft};
    const vk::PipelineTessellationStateCreateInfo tessellation{.pNext = &origin,
                                                               .patchControlPoints = options.patch_vertices};
    const vk::Viewport viewport{.width = static_cast<float>(options.extent.width),
                                .height = static_cast<float>(options.extent.height),
                                .minDepth = 0,
                                .maxDepth = 1};
    const vk::Rect2D scissor{.extent = options.extent};
    const vk::PipelineViewportStateCreateInfo viewports{
        .viewportCount = 1, .pViewports = &viewport, .scissorCount = 1, .pScissors = &scissor};
    const vk::PipelineRasterizationStateCreateInfo rasterization{
        .polygonMode = vk::PolygonMode::eFill,
        .cullMode = patches ? vk::CullModeFlagBits::eBack : vk::CullModeFlagBits::eNone,
        .frontFace = vk::FrontFace::eCounterClockwise,
        .lineWidth = 1};
    const vk::PipelineMultisampleStateCreateInfo multisampling{.rasterizationSamples = vk::SampleCountFlagBits::e1};
    const vk::PipelineDepthStencilStateCreateInfo depth{
        .depthTestEnable = true, .depthWriteEnable = true, .depthCompareOp = vk::CompareOp::eLessOrEqual};
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
    return vk::raii::Pipeline(handles.device, handles.pipeline_cache,
                              vk::GraphicsPipelineCreateInfo{.pNext = &rendering,
                                                             .stageCount = static_cast<std::uint32_t>(stages.size()),
                                                             .pStages = stages.data(),
                                                             .pVertexInputState = &vertex_input,
                                                             .pInputAssemblyState = &assembly,
                                                             .pTessellationState = patches ? &tessellation : nullptr,
                                                             .pViewportState = &viewports,
                                                             .pRasterizationState = &rasterization,
                                                             .pMultisampleState = &multisampling,
                                                             .pDepthStencilState = &depth,
                                                             .pColorBlendState = &blending,
                                                             .layout = layout});
}

}  // namespace

Pipeline make_graphics_pipeline(const Device& device, const GraphicsPipelineOptions& options,
                                const std::vector<Binding>& bindings) {
    const DeviceHandles& handles = device.handles();
    return translate_errors("make a graphics pipeline", handles.info.name, [&] {
        vk::ShaderStageFlags used;
        for (const CompiledStage& stage : options.stages)
            used |= vulkan_stage(stage.stage);
        Pipeline result = make_layout(handles, {bindings}, used, 0);
        const Specialization specialization(options.constants);
        std::vector<vk::raii::ShaderModule> modules;
        std::vector<vk::PipelineShaderStageCreateInfo> stages;
        for (const CompiledStage& stage : options.stages) {
            modules.push_back(make_module(handles, *stage.code));
            stages.push_back({.stage = vulkan_stage(stage.stage),
                              .module = *modules.back(),
                              .pName = "main",
                              .pSpecializationInfo = &specialization.info});
        }
        result.pipeline = make_graphics(handles, options, stages, *result.layout);
        return result;
    });
}

}  // namespace reliefbench::gpu
