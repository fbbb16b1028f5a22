#pragma once

#include "core/json.hpp"
#include "scene/height_map.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// Of a height map or an image, in texels or pixels.
inline constexpr int largest_side = 16384;

/// A value of the axis `heightmap`: the name of a procedural map, the path of an image file, or an object that says
/// how to read it.
struct HeightMapValue {
    HeightMapSource source;
    /// The object gives a size of its own to a procedural map, which the axis heightmap_size leaves alone.
    bool has_own_size = false;
};

/// The keys of the object form.
const std::vector<std::string>& height_map_keys();

bool is_procedural(const std::string& name);

/// Does not look for files.
HeightMapValue read_height_map_value(const JsonView& view);

/// The same value with absolute paths of files that exist: in the first of `folders` that has them. A file that none
/// has is an Error.
Json resolve_height_map_paths(const JsonView& view, const std::vector<std::filesystem::path>& folders);

/// The value of the axis `albedo` likewise: "none", or the path of an image.
Json resolve_albedo_path(const JsonView& view, const std::vector<std::filesystem::path>& folders);

/// What ids and results call it, files by base name: "rock", "rock+seed=2", "gray_rocks.png+channel=1+invert".
std::string height_map_label(const HeightMapSource& source);

/// "256", "256x128" or 256, each side from 1 to `largest_side`.
Resolution read_resolution(const JsonView& view);

/// "256x128".
std::string to_string(Resolution resolution);

}  // namespace reliefbench
