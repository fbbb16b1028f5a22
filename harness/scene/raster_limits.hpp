#pragma once

#include "scene/raster_file.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace reliefbench {

/// What every reader and writer of image files asks of them.

/// Texels along a side of a height map or an albedo.
inline constexpr int largest_side = 16384;

/// Throws Error for an image without pixels, and for one of more values than the largest height map with four channels.
void check_raster_size(const std::filesystem::path& path, int width, int height, int channels);

/// Throws Error where this machine has not the memory for the values that the header claims, and the decoder's copy, in
/// which `decoded` pixels stand.
void check_raster_memory(const std::filesystem::path& path, const RasterFile& header, Resolution decoded);

/// Throws Error for a count of channels that PNG does not take.
void check_png_channels(const std::filesystem::path& path, int channels);

/// Clamped to [0, 1], times 255, rounded; NaN becomes 0.
std::vector<std::uint8_t> to_bytes(const std::vector<float>& values);

}  // namespace reliefbench
