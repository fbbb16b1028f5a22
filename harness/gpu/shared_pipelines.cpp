#include "gpu/shared_pipelines.hpp"

namespace reliefbench::gpu {

std::shared_ptr<const SharedPipeline> SharedPipelines::get(const std::string& key,
                                                           const std::function<SharedPipeline()>& make) {
    const auto found = pipelines_.find(key);
    if (found != pipelines_.end()) return found->second;
    if (pipelines_.size() >= most_unused)
        std::erase_if(pipelines_, [](const auto& entry) { return entry.second.use_count() == 1; });
    auto pipeline = std::make_shared<const SharedPipeline>(make());
    pipelines_.emplace(key, pipeline);
    return pipeline;
}

}  // namespace reliefbench::gpu
