#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>
#include <string_view>
#include <vector>

namespace reliefbench {

/// What a directory of a TIFF file (TIFF 6.0, BigTIFF) says of how its numbers are meant. A decoder's library passes
/// some of it over in silence, and some it does not tell.
struct TiffPage {
    /// Of samples; one entry for each, or one for all.
    std::vector<std::uint64_t> bits{1};
    /// 1 unsigned, 2 signed, 3 floating point, 4 undefined.
    std::vector<std::uint64_t> formats{1};
    /// 0: 0 is white.
    std::optional<std::uint64_t> photometric;
    /// Where in the file the low byte of `photometric` stands.
    std::uint64_t photometric_place = 0;
    std::uint64_t orientation = 1;
    /// A thumbnail, a smaller copy or a mask of another page.
    bool is_auxiliary = false;
    /// GDAL_NODATA, where it is a number: NaN is no data anyway.
    std::optional<double> nodata;
    /// GDAL_NODATA's text where it is no number.
    std::string unread_nodata;
};

/// All directories of the chain. Throws Error, with `path` for the message, for a file that is damaged.
std::vector<TiffPage> read_tiff_pages(std::istream& file, const std::filesystem::path& path);

/// Throws Error for numbers that OpenImageIO 2.4 does not read as they are (24 bits of either kind in the wrong byte
/// order, 6 bits by rounding, 64 bits of tiles not at all), for palettes, whose 16 bits it cuts to 8, and for inks and
/// colour spaces whose conversion to RGB is a matter of taste.
void check_tiff_page(const TiffPage& page, const std::filesystem::path& path);

/// The orientation (1 to 8) of a block of EXIF, which is a TIFF file; 1 where it says none or is damaged.
int exif_orientation(std::string_view block);

}  // namespace reliefbench
