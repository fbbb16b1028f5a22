#pragma once

#include "gpu/handles.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace reliefbench::gpu {

/// A buffer with memory of its own. Visible to the host, coherent and mapped for its lifetime when asked for.
struct Buffer {
    Buffer(const Device& device, vk::DeviceSize size, vk::BufferUsageFlags usage, bool host_visible);

    vk::DeviceSize size;
    vk::raii::DeviceMemory memory{nullptr};
    vk::raii::Buffer buffer{nullptr};
    /// Null unless visible to the host.
    std::byte* mapped = nullptr;
};

/// Host-visible buffer that holds `bytes`.
Buffer make_filled_buffer(const Device& device, vk::BufferUsageFlags usage, std::span<const std::byte> bytes);

/// The same in the device's own memory, as shaders that read it often want it.
Buffer make_device_buffer(const Device& device, vk::BufferUsageFlags usage, std::span<const std::byte> bytes);

/// An image with memory of its own, a view of all its levels, and one of each.
struct Texture {
    /// `slices`: of a three-dimensional image, which has one level; 0 makes one of two dimensions. `samples`: of each
    /// texel of a target with one level.
    Texture(const Device& device, vk::Extent2D extent, vk::Format format, std::uint32_t levels,
            vk::ImageUsageFlags usage, std::uint32_t slices = 0,
            vk::SampleCountFlagBits samples = vk::SampleCountFlagBits::e1);

    vk::Extent2D extent;
    std::uint32_t slices;
    vk::Format format;
    std::uint32_t levels;
    /// What the driver asked for.
    vk::DeviceSize bytes = 0;
    vk::raii::DeviceMemory memory{nullptr};
    vk::raii::Image image{nullptr};
    vk::raii::ImageView view{nullptr};
    std::vector<vk::raii::ImageView> level_views;

    vk::Extent2D level_extent(std::uint32_t level) const;
    vk::ImageSubresourceRange all() const;
};

/// Levels of a chain down to 1×1.
std::uint32_t full_mip_chain(vk::Extent2D extent);

/// Bytes of one texel of the formats that reliefbench uses.
std::uint32_t texel_bytes(vk::Format format);

/// Fills level 0, row 0 first, and leaves the image ready for sampling (eShaderReadOnlyOptimal).
void upload_texture(const Device& device, const Texture& texture, std::span<const std::byte> texels);

/// All levels, each as read_texture gives it, and leaves the image as upload_texture does. False, and nothing done,
/// where their number or their sizes are not the texture's.
bool upload_levels(const Device& device, const Texture& texture, std::span<const std::vector<std::byte>> levels);

/// One level, tightly packed, slice after slice. `layout` is the layout that the image is in, and stays in.
std::vector<std::byte> read_texture(const Device& device, const Texture& texture, std::uint32_t level,
                                    vk::ImageLayout layout);

struct SamplerOptions {
    vk::Filter filter = vk::Filter::eLinear;
    vk::SamplerAddressMode address = vk::SamplerAddressMode::eRepeat;
    /// Across the slices of a three-dimensional image.
    vk::SamplerAddressMode address_across_slices = vk::SamplerAddressMode::eClampToEdge;
    /// Added to the level, up to DeviceInfo::max_lod_bias to either side.
    float mip_bias = 0;
    /// Up to DeviceInfo::max_anisotropy; without a value none, which devices without samplerAnisotropy have, too.
    std::optional<float> anisotropy = {};
};

vk::raii::Sampler make_sampler(const Device& device, const SamplerOptions& options);

}  // namespace reliefbench::gpu
