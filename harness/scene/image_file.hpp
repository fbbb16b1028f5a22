#pragma once

#include "scene/image.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// The only place that knows OpenImageIO, so that a build can leave it out: the portable one has
/// portable/image_file.cpp in place of image_file.cpp, which reads and writes less (plain_image_file.hpp).

/// Raw channel values: integers divided by their maximum, floats as they are; unassociated alpha kept, no colour
/// conversion. Row 0 is the top row of the file.
struct RasterFile {
    Resolution size;
    std::vector<std::string> channel_names;
    /// size.pixels() × channels, interleaved.
    std::vector<float> values;
    /// Bits of the stored number: 8, 16 or 32.
    int bits = 0;

    int channels() const { return static_cast<int>(channel_names.size()); }
};

/// For help texts: "a PNG, JPEG, ... image".
std::string readable_images();

/// Formats are told by a file's first bytes, so that no decoder but those of readable_images() sees it. An Error names
/// the file and what is wrong with it: missing, unreadable, of no size, larger than memory.
RasterFile read_raster_file(const std::filesystem::path& path);

/// What the file's header says, without `values`.
RasterFile read_raster_header(const std::filesystem::path& path);

/// By extension: `.png` (8 bits, values clamped to [0, 1]) or `.exr` (32-bit float; the file keeps channels by name,
/// not in order; not in the portable build). Any channel names. `bits` is ignored. Nothing is left behind on failure.
void write_raster_file(const std::filesystem::path& path, const RasterFile& raster);

}  // namespace reliefbench
