#include "technique/draw.hpp"

#include "core/error.hpp"
#include "gpu/commands.hpp"
#include "scene/colour.hpp"

#include <cassert>

namespace reliefbench {

namespace {

constexpr vk::Format depth_format = vk::Format::eD32Sfloat;
constexpr std::uint32_t object_vertices = 3;
/// Constants of scene.glsl that the object is drawn with, too.
constexpr const char* srgb_target = "srgb_target";
constexpr const char* lighting_enabled = "lighting_enabled";

bool has_samples(const View& view) {
    return view.samples_per_pixel > 1;
}

vk::SampleCountFlagBits sample_bit(const View& view) {
    return static_cast<vk::SampleCountFlagBits>(view.samples_per_pixel);
}

/// Whether the target holds linear light that the device encodes, so that samples are averaged in linear light: without
/// samples the shader encodes.
bool is_encoded_by_device(Draw::Kind kind, const View& view) {
    return kind == Draw::Kind::timed_display && has_samples(view);
}

std::vector<vk::Format> target_formats(Draw::Kind kind, const BaseSurface& base, const View& view) {
    switch (kind) {
        case Draw::Kind::probed:
            // Colours, hits, shadows; normals, which over a flat base follow from the hits.
            return std::vector<vk::Format>(is_flat(base) ? 3 : 4, vk::Format::eR32G32B32A32Sfloat);
        case Draw::Kind::timed_display:
            return {is_encoded_by_device(kind, view) ? vk::Format::eR8G8B8A8Srgb : vk::Format::eR8G8B8A8Unorm};
        case Draw::Kind::timed_float:
            return {vk::Format::eR32G32B32A32Sfloat};
    }
    return {};
}

vk::ClearColorValue background_of(bool is_encoded, const std::array<float, 3>& linear) {
    std::array<float, 4> colour{linear[0], linear[1], linear[2], 0};
    if (is_encoded) {
        for (std::size_t i = 0; i < linear.size(); ++i)
            colour[i] = static_cast<float>(srgb_encode(static_cast<double>(linear[i])));
    }
    return {.float32 = colour};
}

vk::Extent2D target_extent(const View& view) {
    return {static_cast<std::uint32_t>(view.resolution.width), static_cast<std::uint32_t>(view.resolution.height)};
}

gpu::GraphicsPipelineOptions pipeline_options(const gpu::Device& device, const Technique& technique, Draw::Kind kind,
                                              const DrawSetup& setup) {
    gpu::GraphicsPipelineOptions options{
        .stages = compile_draw(device, technique, setup.parameters,
                               kind == Draw::Kind::probed ? Variant::probed : Variant::timed, setup.view),
        .constants = setup.constants,
        .colour_formats = target_formats(kind, drawn_base(technique.manifest, setup.view.relief.base), setup.view),
        .depth_format = depth_format,
        .extent = target_extent(setup.view),
        .topology = setup.geometry.topology,
        .cull = setup.geometry.cull,
        .patch_vertices = setup.geometry.patch_vertices,
        .samples = sample_bit(setup.view)};
    options.constants[srgb_target] =
        kind == Draw::Kind::timed_display && !is_encoded_by_device(kind, setup.view) ? 1 : 0;
    // What of the object stands before the near plane has a depth of 0, as the polygon has under parallel rays.
    if (setup.object && kind != Draw::Kind::probed) options.depth_compare = vk::CompareOp::eLess;
    return options;
}

std::vector<gpu::Binding> bindings_of(const DrawSetup& setup, const std::vector<gpu::CompiledStage>& stages) {
    std::vector<gpu::Binding> bindings = setup.bindings;
    for (const auto& [name, make] : setup.on_demand) {
        if (gpu::use_resource(stages, name)) bindings.push_back(make());
    }
    return bindings;
}

}  // namespace

Draw::Draw(const gpu::Device& device, const Technique& technique, Kind kind, const DrawSetup& setup)
    : device_(&device),
      extent_(target_extent(setup.view)),
      draws_by_(&pipeline_of(technique.manifest)),
      geometry_(setup.geometry),
      depth_(device, extent_, depth_format, 1,
             vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eTransferSrc, 0,
             sample_bit(setup.view)) {
    assert(kind != Kind::probed || !has_samples(setup.view));
    const gpu::GraphicsPipelineOptions options = pipeline_options(device, technique, kind, setup);
    for (const vk::Format format : options.colour_formats) {
        colours_.emplace_back(device, extent_, format, 1,
                              vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc);
        if (has_samples(setup.view))
            sampled_colours_.emplace_back(device, extent_, format, 1, vk::ImageUsageFlagBits::eColorAttachment, 0,
                                          options.samples);
    }
    clears_.push_back(background_of(options.constants.at(srgb_target) != 0, setup.background));

    std::vector<gpu::Binding> bindings = bindings_of(setup, options.stages);
    if (kind == Kind::probed) {
        clears_.push_back({.float32 = std::array<float, 4>{0, 0, 0, -1}});
        clears_.push_back({.float32 = std::array<float, 4>{1, 1, 1, 0}});
        clears_.push_back({.float32 = std::array<float, 4>{0, 0, 0, 0}});
        const std::size_t pixels = std::size_t{extent_.width} * extent_.height;
        work_.emplace(device, pixels);
        bindings.push_back(gpu::storage_buffer(WorkCounters::name, work_->buffer()));
    }
    pipeline_ = gpu::make_graphics_pipeline(device, options, bindings);
    if (pipeline_.interface().push_constant_bytes > 0)
        fail("the shaders use push constants, and a draw pushes none; take parameters instead");
    if (!setup.object || kind == Kind::probed) return;
    object_pipeline_ = setup.object->make_pipeline(
        options.colour_formats, depth_format, extent_, options.samples,
        {{srgb_target, options.constants.at(srgb_target)}, {lighting_enabled, options.constants.at(lighting_enabled)}});
}

void Draw::begin(const vk::raii::CommandBuffer& commands) const {
    for (const std::vector<gpu::Texture>* targets : {&colours_, &sampled_colours_}) {
        for (const gpu::Texture& colour : *targets)
            gpu::change_layout(commands, *colour.image, colour.all(), vk::ImageLayout::eUndefined,
                               vk::ImageLayout::eColorAttachmentOptimal);
    }
    gpu::change_layout(commands, *depth_.image, depth_.all(), vk::ImageLayout::eUndefined,
                       vk::ImageLayout::eDepthAttachmentOptimal);
    if (work_) work_->clear(commands);
}

void Draw::record(const vk::raii::CommandBuffer& commands) const {
    std::vector<vk::RenderingAttachmentInfo> attachments;
    for (std::size_t i = 0; i < colours_.size(); ++i) {
        vk::RenderingAttachmentInfo attachment{.imageView = *colours_[i].view,
                                               .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
                                               .loadOp = vk::AttachmentLoadOp::eClear,
                                               .storeOp = vk::AttachmentStoreOp::eStore,
                                               .clearValue = vk::ClearValue{.color = clears_[i]}};
        if (!sampled_colours_.empty()) {
            attachment.resolveMode = vk::ResolveModeFlagBits::eAverage;
            attachment.resolveImageView = attachment.imageView;
            attachment.resolveImageLayout = attachment.imageLayout;
            attachment.imageView = *sampled_colours_[i].view;
            attachment.storeOp = vk::AttachmentStoreOp::eDontCare;
        }
        attachments.push_back(attachment);
    }
    const vk::RenderingAttachmentInfo depth{.imageView = *depth_.view,
                                            .imageLayout = vk::ImageLayout::eDepthAttachmentOptimal,
                                            .loadOp = vk::AttachmentLoadOp::eClear,
                                            .storeOp = vk::AttachmentStoreOp::eStore,
                                            .clearValue = vk::ClearValue{.depthStencil = {.depth = 1}}};
    commands.beginRendering(vk::RenderingInfo{.renderArea = {.extent = extent_},
                                              .layerCount = 1,
                                              .colorAttachmentCount = static_cast<std::uint32_t>(attachments.size()),
                                              .pColorAttachments = attachments.data(),
                                              .pDepthAttachment = &depth});
    if (object_pipeline_) {
        object_pipeline_->bind(commands);
        commands.draw(object_vertices, 1, 0, 0);
    }
    pipeline_.bind(commands);
    draws_by_->record(commands, geometry_);
    commands.endRendering();
}

std::vector<std::byte> Draw::read_target(std::size_t colour_target) const {
    return gpu::read_texture(*device_, colours_[colour_target], 0, vk::ImageLayout::eColorAttachmentOptimal);
}

std::vector<std::byte> Draw::read_depth() const {
    return gpu::read_texture(*device_, depth_, 0, vk::ImageLayout::eDepthAttachmentOptimal);
}

gpu::ExecutableStatistics read_executable_statistics(const gpu::Device& device, const Technique& technique,
                                                     const DrawSetup& setup) {
    const gpu::GraphicsPipelineOptions options = pipeline_options(device, technique, Draw::Kind::timed_display, setup);
    return gpu::read_executable_statistics(device, options, bindings_of(setup, options.stages));
}

}  // namespace reliefbench
