#include "technique/material_mips.hpp"

#include "gpu/anisotropic_gradients.hpp"
#include "gpu/commands.hpp"
#include "gpu/shader_cache.hpp"
#include "gpu/timers.hpp"
#include "manifest/shared_shaders.hpp"
#include "technique/technique.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace reliefbench {

namespace {

constexpr auto chain_usage =
    vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eTransferDst;
constexpr auto ready = vk::ImageLayout::eShaderReadOnlyOptimal;

/// Those of scenes whose albedo comes from files: what unsupported_material asks for.
constexpr std::array material_formats{vk::Format::eR16G16B16A16Unorm, vk::Format::eR32G32Sfloat};

const char* texel_format(vk::Format format) {
    switch (format) {
        case vk::Format::eR16G16B16A16Unorm:
            return "rgba16";
        case vk::Format::eR32G32Sfloat:
            return "rg32f";
        case vk::Format::eR32G32B32A32Sfloat:
            return "rgba32f";
        default:
            fail("no mips are made of textures of format {}", vk::to_string(format));
    }
}

gpu::CompiledStage compile_mips(const gpu::Device& device, vk::Format format) {
    const char* const file = "material_mips.comp";
    const std::string preamble = fmt::format("#define RELIEFBENCH_TEXEL_FORMAT {}\n", texel_format(format));
    return {gpu::ShaderStage::compute,
            device.shader_cache().get(fmt::format("{}\n{}\n{}", shader_root().string(), file, preamble), [&] {
                return gpu::compile_shader({.stage = gpu::ShaderStage::compute,
                                            .file = file,
                                            .roots = shared_shader_folders(shader_root()),
                                            .generated = {},
                                            .preamble = preamble});
            })};
}

std::uint32_t groups_over(std::uint32_t texels, std::uint32_t texels_each) {
    return (texels + texels_each - 1) / texels_each;
}

}  // namespace

MaterialMips::MaterialMips(const gpu::Device& device, const gpu::Texture& albedo, const gpu::Texture& derivatives)
    : device_(&device), sampler_(gpu::make_sampler(device, {.filter = vk::Filter::eNearest})) {
    const auto add = [&](const char* name, const gpu::Texture& base) {
        Chain& chain = chains_.emplace_back(
            Chain{name, gpu::Texture(device, base.extent, base.format, gpu::full_mip_chain(base.extent), chain_usage)});
        const gpu::Texture& texture = chain.texture;
        bytes_ += texture.bytes - std::min(texture.bytes, base.bytes);
        copy_base(base, texture);
        if (texture.levels == 1) return;
        std::vector<std::vector<gpu::Binding>> sets;
        for (std::uint32_t level = 1; level < texture.levels; ++level)
            sets.push_back(
                {gpu::sampled_image("finer_level", texture.level_views[level - 1], sampler_, vk::ImageLayout::eGeneral),
                 gpu::storage_image("coarser_level", texture.level_views[level])});
        chain.pipeline =
            gpu::make_compute_pipeline(device, {.shader = compile_mips(device, base.format), .constants = {}}, sets);
    };
    add("albedo_mips", albedo);
    add("derivative_mips", derivatives);
}

void MaterialMips::copy_base(const gpu::Texture& from, const gpu::Texture& to) const {
    constexpr vk::ImageSubresourceLayers base{
        .aspectMask = vk::ImageAspectFlagBits::eColor, .mipLevel = 0, .baseArrayLayer = 0, .layerCount = 1};
    gpu::submit_and_wait(*device_, "copy a texture", [&](const vk::raii::CommandBuffer& commands) {
        gpu::change_layout(commands, *from.image, from.all(), ready, vk::ImageLayout::eTransferSrcOptimal);
        gpu::change_layout(commands, *to.image, to.all(), vk::ImageLayout::eUndefined,
                           vk::ImageLayout::eTransferDstOptimal);
        commands.copyImage(
            *from.image, vk::ImageLayout::eTransferSrcOptimal, *to.image, vk::ImageLayout::eTransferDstOptimal,
            vk::ImageCopy{
                .srcSubresource = base, .dstSubresource = base, .extent = {from.extent.width, from.extent.height, 1}});
        gpu::change_layout(commands, *from.image, from.all(), vk::ImageLayout::eTransferSrcOptimal, ready);
        gpu::change_layout(commands, *to.image, to.all(), vk::ImageLayout::eTransferDstOptimal, ready);
    });
}

void MaterialMips::change_layouts(const vk::raii::CommandBuffer& commands, vk::ImageLayout from,
                                  vk::ImageLayout to) const {
    for (const Chain& chain : chains_)
        gpu::change_layout(commands, *chain.texture.image, chain.texture.all(), from, to);
}

/// Level by level, both chains' side by side.
void MaterialMips::record(const vk::raii::CommandBuffer& commands) const {
    std::uint32_t levels = 0;
    for (const Chain& chain : chains_)
        levels = std::max(levels, chain.texture.levels);
    for (std::uint32_t level = 1; level < levels; ++level) {
        for (const Chain& chain : chains_) {
            if (level >= chain.texture.levels) continue;
            const auto& [columns, rows, slices] = chain.pipeline.interface().local_size;
            const vk::Extent2D size = chain.texture.level_extent(level);
            chain.pipeline.bind(commands, level - 1);
            commands.dispatch(groups_over(size.width, columns), groups_over(size.height, rows), slices);
        }
        gpu::full_barrier(commands);
    }
}

std::vector<double> MaterialMips::make(int samples) const {
    std::vector<double> milliseconds;
    for (int sample = 0; sample < samples; ++sample) {
        const gpu::Timestamps timestamps(*device_, 1);
        gpu::submit_and_wait(*device_, "make the material's mips", [&](const vk::raii::CommandBuffer& commands) {
            timestamps.reset(commands);
            change_layouts(commands, ready, vk::ImageLayout::eGeneral);
            timestamps.start(commands, 0);
            record(commands);
            timestamps.end(commands, 0);
            change_layouts(commands, vk::ImageLayout::eGeneral, ready);
        });
        milliseconds.push_back(timestamps.milliseconds().front());
    }
    return milliseconds;
}

std::vector<gpu::Binding> MaterialMips::bindings(const vk::raii::Sampler& sampler) const {
    std::vector<gpu::Binding> bindings;
    for (const Chain& chain : chains_)
        bindings.push_back(gpu::sampled_image(chain.name, chain.texture.view, sampler, ready));
    return bindings;
}

vk::raii::Sampler make_material_sampler(const gpu::Device& device, const MaterialFilter& filter) {
    gpu::SamplerOptions options{.mip_bias = static_cast<float>(filter.mip_bias)};
    if (filter.kind == MaterialFilter::Kind::anisotropic) options.anisotropy = static_cast<float>(filter.anisotropy);
    return gpu::make_sampler(device, options);
}

std::string unsupported_material(const gpu::Device& device, const MaterialFilter& filter) {
    if (!filter.has_mips()) return {};
    const gpu::DeviceInfo& info = device.info();
    if (filter.kind == MaterialFilter::Kind::anisotropic) {
        if (!info.has_feature("samplerAnisotropy"))
            return fmt::format("{} lacks the feature samplerAnisotropy", info.name);
        if (filter.anisotropy > info.max_anisotropy)
            return fmt::format("the anisotropy would be {}; {} has up to {:g}", filter.anisotropy, info.name,
                               info.max_anisotropy);
        if (!gpu::anisotropy_takes_gradients(device))
            return fmt::format(
                "anisotropic samplers of {} go by differences of the coordinates between neighbours, whatever "
                "gradients and "
                "maximum they are given",
                info.name);
    }
    if (std::abs(filter.mip_bias) > info.max_lod_bias)
        return fmt::format("the mip bias would be {:g}; {} has up to {:g} to either side", filter.mip_bias, info.name,
                           info.max_lod_bias);
    for (const vk::Format format : material_formats) {
        const auto properties = device.handles().physical_device.getFormatProperties(format);
        const bool writable = info.has_feature("shaderStorageImageExtendedFormats") &&
                              (properties.optimalTilingFeatures & vk::FormatFeatureFlagBits::eStorageImage);
        if (!writable) return fmt::format("{} cannot write mips of format {}", info.name, vk::to_string(format));
    }
    return {};
}

}  // namespace reliefbench
