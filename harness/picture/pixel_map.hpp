#pragma once

#include <string>
#include <vector>

namespace reliefbench {

/// What is shown of each pixel of a cell beside its picture.
enum class PixelMap {
    uv_error,
    depth_error,
    normal_error,
    flip,
    ssim,
    taps,
    /// Missed and false hits alone; its values are those of Coverage.
    coverage,
};

/// How values become colours of magma: its dark end stands for `dark`, its light end for `light`.
struct PixelMapScale {
    /// What pixels show whose value is not a number.
    enum class Undefined {
        /// That nothing was drawn.
        nothing,
        /// That they lie outside the footprint.
        outside,
        /// What became of the pixel: missed, false hit, ....
        coverage,
    };

    PixelMap map = PixelMap::uv_error;
    /// In options and file names: "uv_error".
    std::string name;
    std::string title;
    /// Empty for pure numbers.
    std::string unit;
    double dark = 0;
    double light = 1;
    /// Of magnitudes.
    bool logarithmic = false;
    /// Marks on the colour bar, from dark to light; empty where coverage is all that is shown.
    std::vector<double> marks;
    Undefined undefined = Undefined::nothing;

    /// 0 at the dark end, 1 at the light one; clamped.
    double position(double value) const;
};

/// All there are, the ones most asked for first.
const std::vector<PixelMapScale>& pixel_map_scales();
const PixelMapScale& scale_of(PixelMap map);

/// An Error names those there are.
PixelMap parse_pixel_map(const std::string& name);

}  // namespace reliefbench
