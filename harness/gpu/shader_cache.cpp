#include "gpu/shader_cache.hpp"

namespace reliefbench::gpu {

std::shared_ptr<const SpirV> ShaderCache::get(const std::string& key, const std::function<SpirV()>& compile) {
    const auto found = shaders_.find(key);
    if (found != shaders_.end()) return found->second;
    auto shader = std::make_shared<const SpirV>(compile());
    ++compilations_;
    shaders_.emplace(key, shader);
    return shader;
}

}  // namespace reliefbench::gpu
