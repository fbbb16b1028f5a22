#pragma once

#include "scene/image.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// What an image file stores, numbers as they stand in the file: integers are not divided, unassociated alpha is kept,
/// no colour is converted but YCbCr to RGB; palettes are resolved to RGB. Row 0 is the top row of the picture as
/// viewers show it: orientation tags and an OpenEXR file's display window are applied (docs/height_maps.md).
struct RasterFile {
    Resolution size;
    std::vector<std::string> channel_names;
    /// size.pixels() × channels, interleaved. 32-bit integers beyond 2²⁴ are rounded to the nearest float.
    std::vector<float> values;
    /// The stored number that stands for 1: the largest of an integer type, 1 of floats.
    double full_scale = 1;
    /// The first channel's numbers mean the opposite: 0 is white (TIFF's PhotometricInterpretation 0).
    bool zero_is_white = false;
    /// The stored number that stands for "nothing is known here" (GDAL_NODATA).
    std::optional<double> nodata;
    /// What the file has in its place, where that is no number.
    std::string unread_nodata;
    /// Bits of the stored number, rounded up to 8, 16 or 32.
    int bits = 0;
    /// What was done to the picture, for the record: "orientation 6", "display window", ...
    std::vector<std::string> notes;

    int channels() const { return static_cast<int>(channel_names.size()); }
    /// Of 1, of the value at `index`.
    double fraction(std::size_t index) const;
};

/// What of a file is read.
struct ImageChoice {
    /// An OpenEXR part or a TIFF page: its name, or its number from 0. Empty: the only one.
    std::string part;
    /// Numbers of channels, in the order wanted. Empty: all.
    std::vector<std::size_t> channels;
};

/// The raster with these of its channels only. They must exist.
RasterFile with_channels(const RasterFile& raster, const std::vector<std::size_t>& channels);

/// Rows and columns as EXIF's and TIFF's orientation (1 to 8) has them shown; others are taken as 1. Also of a header,
/// which has no values.
RasterFile oriented(RasterFile raster, int orientation);

/// Throws Error unless `part` is empty or the only part there is, number 0.
void check_single_part(const std::filesystem::path& path, const std::string& part);

/// The number of the part that is meant. `names` may be empty strings. Throws Error for none of that name or number,
/// and where there are several to choose from and none is chosen. `pictures` lists those that count as pictures.
std::size_t chosen_part(const std::filesystem::path& path, const std::string& part,
                        const std::vector<std::string>& names, const std::vector<std::size_t>& pictures);

}  // namespace reliefbench
