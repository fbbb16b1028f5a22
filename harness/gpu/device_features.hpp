#pragma once

#include "gpu/vulkan.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbench::gpu {

bool has_extension(const vk::raii::PhysicalDevice& device, std::string_view name);

/// Of a device with Vulkan 1.3: whether it has those of its features without which nothing here runs.
bool has_needed_features(const vk::raii::PhysicalDevice& device);

/// Of feature_names() (gpu/device.hpp), those that the device has: with all of their extensions.
std::vector<std::string> find_features(const vk::raii::PhysicalDevice& device);

/// A device with one queue of the family, and with these features of find_features enabled.
vk::raii::Device make_device_with(const vk::raii::PhysicalDevice& physical_device, std::uint32_t queue_family,
                                  const std::vector<std::string>& features);

}  // namespace reliefbench::gpu
