#include "gpu/memory.hpp"

#include "gpu/commands.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

namespace reliefbench::gpu {

namespace {

vk::raii::DeviceMemory allocate(const DeviceHandles& handles, const vk::MemoryRequirements& requirements,
                                vk::MemoryPropertyFlags wanted) {
    for (std::uint32_t type = 0; type < handles.memory.memoryTypeCount; ++type) {
        const bool allowed = (requirements.memoryTypeBits >> type & 1u) != 0;
        if (allowed && (handles.memory.memoryTypes[type].propertyFlags & wanted) == wanted) {
            return vk::raii::DeviceMemory(
                handles.device, vk::MemoryAllocateInfo{.allocationSize = requirements.size, .memoryTypeIndex = type});
        }
    }
    fail("{} has no memory that is {}", handles.info.name, vk::to_string(wanted));
}

/// Memory that the host reads back from should be cached where there is such memory.
vk::raii::DeviceMemory allocate_host_visible(const DeviceHandles& handles, const vk::MemoryRequirements& requirements) {
    constexpr auto coherent = vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
    constexpr auto cached = coherent | vk::MemoryPropertyFlagBits::eHostCached;
    const auto types = std::span(handles.memory.memoryTypes).first(handles.memory.memoryTypeCount);
    const bool has_cached = std::any_of(types.begin(), types.end(), [&](const vk::MemoryType& type) {
        return (type.propertyFlags & cached) == cached &&
               (requirements.memoryTypeBits >> (&type - types.data()) & 1u) != 0;
    });
    return allocate(handles, requirements, has_cached ? cached : coherent);
}

vk::raii::ImageView make_view(const DeviceHandles& handles, const Texture& texture, std::uint32_t first_level,
                              std::uint32_t level_count) {
    const vk::ImageViewType view_type = texture.slices > 0 ? vk::ImageViewType::e3D : vk::ImageViewType::e2D;
    vk::ImageSubresourceRange range = texture.all();
    range.baseMipLevel = first_level;
    range.levelCount = level_count;
    return vk::raii::ImageView(
        handles.device,
        vk::ImageViewCreateInfo{
            .image = *texture.image, .viewType = view_type, .format = texture.format, .subresourceRange = range});
}

}  // namespace

Buffer::Buffer(const Device& device, vk::DeviceSize byte_count, vk::BufferUsageFlags usage, bool host_visible)
    : size(byte_count) {
    const DeviceHandles& handles = device.handles();
    translate_errors(fmt::format("make a buffer of {} bytes", byte_count), handles.info.name, [&] {
        buffer = vk::raii::Buffer(handles.device, vk::BufferCreateInfo{.size = byte_count, .usage = usage});
        const vk::MemoryRequirements requirements = buffer.getMemoryRequirements();
        memory = host_visible ? allocate_host_visible(handles, requirements)
                              : allocate(handles, requirements, vk::MemoryPropertyFlagBits::eDeviceLocal);
        buffer.bindMemory(*memory, 0);
        if (host_visible) mapped = static_cast<std::byte*>(memory.mapMemory(0, VK_WHOLE_SIZE));
    });
}

Buffer make_filled_buffer(const Device& device, vk::BufferUsageFlags usage, std::span<const std::byte> bytes) {
    Buffer buffer(device, bytes.size(), usage, true);
    std::memcpy(buffer.mapped, bytes.data(), bytes.size());
    return buffer;
}

Buffer make_device_buffer(const Device& device, vk::BufferUsageFlags usage, std::span<const std::byte> bytes) {
    Buffer buffer(device, bytes.size(), usage | vk::BufferUsageFlagBits::eTransferDst, false);
    const Buffer staging = make_filled_buffer(device, vk::BufferUsageFlagBits::eTransferSrc, bytes);
    submit_and_wait(device, "upload a buffer", [&](const vk::raii::CommandBuffer& commands) {
        commands.copyBuffer(*staging.buffer, *buffer.buffer, vk::BufferCopy{.size = bytes.size()});
        full_barrier(commands);
    });
    return buffer;
}

Texture::Texture(const Device& device, vk::Extent2D size, vk::Format texel_format, std::uint32_t level_count,
                 vk::ImageUsageFlags usage, std::uint32_t slice_count, vk::SampleCountFlagBits samples)
    : extent(size), slices(slice_count), format(texel_format), levels(level_count) {
    assert((slices == 0 && samples == vk::SampleCountFlagBits::e1) || levels == 1);
    const DeviceHandles& handles = device.handles();
    const std::uint32_t depth = std::max(slices, 1u);
    const std::string what =
        fmt::format("make a {}x{}x{} {} image", size.width, size.height, depth, vk::to_string(format));
    translate_errors(what, handles.info.name, [&] {
        image = vk::raii::Image(handles.device,
                                vk::ImageCreateInfo{.imageType = slices > 0 ? vk::ImageType::e3D : vk::ImageType::e2D,
                                                    .format = format,
                                                    .extent = {extent.width, extent.height, depth},
                                                    .mipLevels = levels,
                                                    .arrayLayers = 1,
                                                    .samples = samples,
                                                    .tiling = vk::ImageTiling::eOptimal,
                                                    .usage = usage,
                                                    .initialLayout = vk::ImageLayout::eUndefined});
        const vk::MemoryRequirements requirements = image.getMemoryRequirements();
        bytes = requirements.size;
        memory = allocate(handles, requirements, vk::MemoryPropertyFlagBits::eDeviceLocal);
        image.bindMemory(*memory, 0);
        view = make_view(handles, *this, 0, levels);
        for (std::uint32_t level = 0; level < levels; ++level)
            level_views.push_back(make_view(handles, *this, level, 1));
    });
}

vk::Extent2D Texture::level_extent(std::uint32_t level) const {
    return {std::max(extent.width >> level, 1u), std::max(extent.height >> level, 1u)};
}

vk::ImageSubresourceRange Texture::all() const {
    return {.aspectMask =
                format == vk::Format::eD32Sfloat ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor,
            .baseMipLevel = 0,
            .levelCount = levels,
            .baseArrayLayer = 0,
            .layerCount = 1};
}

std::uint32_t full_mip_chain(vk::Extent2D extent) {
    return static_cast<std::uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
}

std::uint32_t texel_bytes(vk::Format format) {
    switch (format) {
        case vk::Format::eR8Unorm:
            return 1;
        case vk::Format::eR16Unorm:
            return 2;
        case vk::Format::eR32Sfloat:
        case vk::Format::eD32Sfloat:
        case vk::Format::eR8G8B8A8Unorm:
        case vk::Format::eR8G8B8A8Srgb:
        case vk::Format::eR16G16Unorm:
            return 4;
        case vk::Format::eR32G32Sfloat:
        case vk::Format::eR16G16B16A16Unorm:
            return 8;
        case vk::Format::eR32G32B32A32Sfloat:
            return 16;
        default:
            fail("the size of a texel of format {} is not known here", vk::to_string(format));
    }
}

namespace {

vk::BufferImageCopy whole_level(const Texture& texture, std::uint32_t level) {
    const vk::Extent2D size = texture.level_extent(level);
    return {.imageSubresource = {.aspectMask = texture.all().aspectMask, .mipLevel = level, .layerCount = 1},
            .imageExtent = {size.width, size.height, std::max(texture.slices, 1u)}};
}

}  // namespace

void upload_texture(const Device& device, const Texture& texture, std::span<const std::byte> texels) {
    assert(texels.size() == std::size_t{texture.extent.width} * texture.extent.height * texel_bytes(texture.format));
    const Buffer staging = make_filled_buffer(device, vk::BufferUsageFlagBits::eTransferSrc, texels);
    submit_and_wait(device, "upload a texture", [&](const vk::raii::CommandBuffer& commands) {
        change_layout(commands, *texture.image, texture.all(), vk::ImageLayout::eUndefined,
                      vk::ImageLayout::eTransferDstOptimal);
        commands.copyBufferToImage(*staging.buffer, *texture.image, vk::ImageLayout::eTransferDstOptimal,
                                   whole_level(texture, 0));
        change_layout(commands, *texture.image, texture.all(), vk::ImageLayout::eTransferDstOptimal,
                      vk::ImageLayout::eShaderReadOnlyOptimal);
    });
}

bool upload_levels(const Device& device, const Texture& texture, std::span<const std::vector<std::byte>> levels) {
    if (levels.size() != texture.levels) return false;
    for (std::uint32_t level = 0; level < texture.levels; ++level) {
        const vk::Extent2D size = texture.level_extent(level);
        const std::size_t texels = std::size_t{size.width} * size.height * std::max(texture.slices, 1u);
        if (levels[level].size() != texels * texel_bytes(texture.format)) return false;
    }
    std::vector<Buffer> staging;
    for (const std::vector<std::byte>& level : levels)
        staging.push_back(make_filled_buffer(device, vk::BufferUsageFlagBits::eTransferSrc, level));
    submit_and_wait(device, "upload a texture", [&](const vk::raii::CommandBuffer& commands) {
        change_layout(commands, *texture.image, texture.all(), vk::ImageLayout::eUndefined,
                      vk::ImageLayout::eTransferDstOptimal);
        for (std::uint32_t level = 0; level < texture.levels; ++level)
            commands.copyBufferToImage(*staging[level].buffer, *texture.image, vk::ImageLayout::eTransferDstOptimal,
                                       whole_level(texture, level));
        change_layout(commands, *texture.image, texture.all(), vk::ImageLayout::eTransferDstOptimal,
                      vk::ImageLayout::eShaderReadOnlyOptimal);
    });
    return true;
}

std::vector<std::byte> read_texture(const Device& device, const Texture& texture, std::uint32_t level,
                                    vk::ImageLayout layout) {
    const vk::Extent2D size = texture.level_extent(level);
    const std::size_t byte_count =
        std::size_t{size.width} * size.height * std::max(texture.slices, 1u) * texel_bytes(texture.format);
    const Buffer staging(device, byte_count, vk::BufferUsageFlagBits::eTransferDst, true);
    submit_and_wait(device, "read an image back", [&](const vk::raii::CommandBuffer& commands) {
        change_layout(commands, *texture.image, texture.all(), layout, vk::ImageLayout::eTransferSrcOptimal);
        commands.copyImageToBuffer(*texture.image, vk::ImageLayout::eTransferSrcOptimal, *staging.buffer,
                                   whole_level(texture, level));
        change_layout(commands, *texture.image, texture.all(), vk::ImageLayout::eTransferSrcOptimal, layout);
    });
    return {staging.mapped, staging.mapped + byte_count};
}

vk::raii::Sampler make_sampler(const Device& device, const SamplerOptions& options) {
    const DeviceHandles& handles = device.handles();
    const auto mip_mode =
        options.filter == vk::Filter::eLinear ? vk::SamplerMipmapMode::eLinear : vk::SamplerMipmapMode::eNearest;
    return translate_errors("make a sampler", handles.info.name, [&] {
        return vk::raii::Sampler(handles.device,
                                 vk::SamplerCreateInfo{.magFilter = options.filter,
                                                       .minFilter = options.filter,
                                                       .mipmapMode = mip_mode,
                                                       .addressModeU = options.address,
                                                       .addressModeV = options.address,
                                                       .addressModeW = options.address_across_slices,
                                                       .mipLodBias = options.mip_bias,
                                                       .anisotropyEnable = options.anisotropy.has_value(),
                                                       .maxAnisotropy = options.anisotropy.value_or(1),
                                                       .maxLod = VK_LOD_CLAMP_NONE});
    });
}

}  // namespace reliefbench::gpu
