#pragma once

#include "scene/raster_file.hpp"

#include <filesystem>
#include <string>

namespace reliefbench {

/// What a build without OpenImageIO reads and writes, under the contract of image_file.hpp. Every build has it, so that
/// every build tests it.

/// PNG (8 and 16 bits), binary PGM and PPM, and PFM: told by content, not by name.
RasterFile read_plain_image(const std::filesystem::path& path, const ImageChoice& choice = {});
RasterFile read_plain_header(const std::filesystem::path& path, const std::string& part = {});

/// `.png` or `.pfm`, by extension.
void write_plain_image(const std::filesystem::path& path, const RasterFile& raster);

}  // namespace reliefbench
