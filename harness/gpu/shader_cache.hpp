#pragma once

#include "gpu/shader_compiler.hpp"

#include <functional>
#include <memory>
#include <string>
#include <unordered_map>

namespace reliefbench::gpu {

/// Compiled shaders by key. A compilation that fails is not kept.
class ShaderCache {
public:
    std::shared_ptr<const SpirV> get(const std::string& key, const std::function<SpirV()>& compile);

    /// How often `compile` ran.
    int compilations() const { return compilations_; }

private:
    std::unordered_map<std::string, std::shared_ptr<const SpirV>> shaders_;
    int compilations_ = 0;
};

}  // namespace reliefbench::gpu
