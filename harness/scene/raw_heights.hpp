#pragma once

#include "scene/height_map.hpp"
#include "scene/raster_file.hpp"

#include <filesystem>

namespace reliefbench {

/// A file of numbers without a header (.r16, .raw, .hgt). Throws Error unless it has as many bytes as the layout says.
RasterFile read_raw_heights(const std::filesystem::path& path, const RawLayout& layout);

/// The same without `values`: nothing but the file's length is looked at.
RasterFile read_raw_header(const std::filesystem::path& path, const RawLayout& layout);

}  // namespace reliefbench
