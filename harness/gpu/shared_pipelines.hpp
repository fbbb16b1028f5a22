#pragma once

#include "gpu/handles.hpp"
#include "gpu/shader_compiler.hpp"
#include "gpu/shader_interface.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace reliefbench::gpu {

/// What pipelines of the same shaders, constants and formats share, whatever they are bound to.
struct SharedPipeline {
    /// Of all stages together.
    ShaderInterface interface;
    vk::raii::DescriptorSetLayout set_layout{nullptr};
    vk::raii::PipelineLayout layout{nullptr};
    vk::raii::Pipeline pipeline{nullptr};
    vk::PipelineBindPoint bind_point = vk::PipelineBindPoint::eGraphics;
    /// Wall time of the driver's making it; graphics only.
    double made_in_ms = 0;
    /// Kept so that the addresses of shaders, which are part of keys, are not given away again.
    std::vector<std::shared_ptr<const SpirV>> shaders;
};

/// Pipelines by key: the views of a sweep share them, so that the driver compiles a technique with its parameters once.
/// (lavapipe also leaves about a megabyte behind for each pipeline that was drawn with, even when it is destroyed.)
class SharedPipelines {
public:
    std::shared_ptr<const SharedPipeline> get(const std::string& key, const std::function<SharedPipeline()>& make);

    std::size_t size() const { return pipelines_.size(); }

    /// From here on, those that nobody uses are forgotten before another is made.
    static constexpr std::size_t most_unused = 256;

private:
    std::unordered_map<std::string, std::shared_ptr<const SharedPipeline>> pipelines_;
};

}  // namespace reliefbench::gpu
