#pragma once

#include "gpu/handles.hpp"

#include <functional>

namespace reliefbench::gpu {

/// Records into a fresh command buffer, submits it and waits for its end. `what` completes "cannot ..." in an Error.
void submit_and_wait(const Device& device, std::string_view what,
                     const std::function<void(const vk::raii::CommandBuffer&)>& record);

/// Everything before it is finished and visible to everything after it.
void full_barrier(const vk::raii::CommandBuffer& commands);

/// A full barrier that also changes an image's layout. From eUndefined the contents are lost.
void change_layout(const vk::raii::CommandBuffer& commands, vk::Image image, const vk::ImageSubresourceRange& range,
                   vk::ImageLayout from, vk::ImageLayout to);

}  // namespace reliefbench::gpu
