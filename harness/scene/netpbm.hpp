#pragma once

#include "scene/raster_file.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace reliefbench {

inline constexpr std::size_t netpbm_magic_length = 3;
/// The format sets no limit; longer ones are read, but not looked at alone.
inline constexpr std::size_t longest_netpbm_header = 4096;

/// Whether the bytes begin as a binary PGM, PPM or PFM file does: P5, P6, Pf or PF and white space.
bool is_netpbm(std::string_view bytes);

/// PGM and PPM (binary, 8 or 16 bits) and PFM (both byte orders; of its scale only the sign counts, which tells the
/// byte order). `path` is for messages. Throws Error for what is damaged, of fewer or more bytes than its header says,
/// or larger than can be read.
RasterFile parse_netpbm(std::string_view bytes, const std::filesystem::path& path);

/// Of the first bytes of a file.
RasterFile parse_netpbm_header(std::string_view bytes, const std::filesystem::path& path);

/// The bytes of a portable float map, which holds one channel or three. Throws Error for any other count.
std::string format_pfm(const RasterFile& raster, const std::filesystem::path& path);

}  // namespace reliefbench
