#pragma once

#include "scene/height_map.hpp"

#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// One number a texel, as the file stores them.
struct StoredHeights {
    /// Row 0 is v = 0, the bottom row of the picture.
    Image<float> values;
    /// The value that stands for 1.
    double full_scale = 1;
    bool zero_is_white = false;
    /// Of the file; the source may know better. `unread_nodata`: RasterFile's.
    std::optional<double> nodata;
    std::string unread_nodata;
    /// How they were found in the file, for the record: "channel R", "orientation 6", ...
    std::vector<std::string> notes;
};

/// Of the part, channel or packed channels that the source chooses. Throws Error, with what there is to choose from,
/// for one that the file has not, and for a file of several pictures of which none is chosen. Warns where a colour
/// picture is taken for heights.
StoredHeights read_stored_heights(const HeightMapSource& source);

/// The size of the same, with the same Errors, from the file's header.
Resolution stored_heights_size(const HeightMapSource& source);

}  // namespace reliefbench
