#pragma once

#include "reference/truth.hpp"
#include "scene/albedo.hpp"
#include "scene/height_map.hpp"
#include "sweep/configuration.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace reliefbench {

/// What the truths of an execution took.
struct TruthWork {
    /// Wall time of tracing, or of reading what was cached.
    double seconds = 0;
    std::size_t traced = 0;
    std::size_t cached = 0;
};

/// All that a truth is made of: how it is cached, by content (a height map's path is none of it), and under the code
/// that traces.
struct TruthContent {
    const HeightMap& map;
    /// content_of(albedo)
    const std::string& albedo;
    /// With its base; of what moves no hits the shadows' mode alone.
    const View& view;
    const Lighting& lighting;
    const TruthSettings& settings;
    const std::optional<SceneObject>& object;
};

std::string content_of(const Albedo& albedo);

/// Fit for a file's name.
std::string cache_key(const TruthContent& content);

/// In a cache folder (core/cache_folder.hpp), empty: nowhere. The truth's time is that of reading it.
std::optional<Truth> read_cached_truth(const std::filesystem::path& folder, const std::string& key);
void cache_truth(const std::filesystem::path& folder, const std::string& key, const Truth& truth);

}  // namespace reliefbench
