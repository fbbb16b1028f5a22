#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "scene/relief.hpp"
#include "scene/scene_object.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// The scene's object on the device.
class ObjectOnDevice {
public:
    /// `view`: in which it stands; `shaders`: the folder of the shared GLSL; `scene`: the binding of the scene's
    /// uniforms, which must outlive it.
    ObjectOnDevice(const gpu::Device& device, const SceneObject& object, const View& view,
                   std::filesystem::path shaders, const gpu::Binding& scene);

    /// Draws it with three vertices into targets of these formats and samples: its colour with an alpha of
    /// `object_alpha`, and its depth.
    gpu::Pipeline make_pipeline(const std::vector<vk::Format>& colour_formats, vk::Format depth_format,
                                vk::Extent2D extent, vk::SampleCountFlagBits samples,
                                const gpu::SpecializationValues& constants) const;

private:
    const gpu::Device* device_;
    SceneObject::Shape shape_;
    /// In front of its shaders.
    std::string preamble_;
    std::filesystem::path shaders_;
    gpu::Binding scene_;
    gpu::Buffer uniforms_;
};

/// Of what a picture's alpha is where the object is in front; the relief's is 1 and the background's 0.
inline constexpr float object_alpha = 0.5F;

}  // namespace reliefbench
