#pragma once

#include "scene/raster_file.hpp"

#include <filesystem>
#include <string>

namespace reliefbench {

/// The only place that knows OpenImageIO, so that a build can leave it out: the portable one has
/// portable/image_file.cpp in place of image_file.cpp, which reads and writes less (plain_image_file.hpp).

/// For help texts: "a PNG, JPEG, ... image".
std::string readable_images();

/// Formats are told by a file's first bytes, so that no decoder but those of readable_images() sees it. An Error names
/// the file and what is wrong with it: missing, unreadable, of no size, larger than memory, of numbers or colours that
/// would not come out as they are stored, of several parts with none chosen. Channels chosen must exist.
RasterFile read_raster_file(const std::filesystem::path& path, const ImageChoice& choice = {});

/// What the file's header says, without `values`. The same Errors, as far as a header tells.
RasterFile read_raster_header(const std::filesystem::path& path, const std::string& part = {});

/// By extension: `.png` (8 bits, values clamped to [0, 1]) or `.exr` (32-bit float; the file keeps channels by name,
/// not in order; not in the portable build). Any channel names; a full scale of 1. `bits` is ignored. Nothing is left
/// behind on failure.
void write_raster_file(const std::filesystem::path& path, const RasterFile& raster);

}  // namespace reliefbench
