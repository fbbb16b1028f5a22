#include "picture/pixel_map.hpp"

#include "core/error.hpp"
#include "core/suggest.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace reliefbench {

double PixelMapScale::position(double value) const {
    const auto along = [this](double x) { return logarithmic ? std::log10(std::max(std::abs(x), dark)) : x; };
    return std::clamp((along(value) - along(dark)) / (along(light) - along(dark)), 0.0, 1.0);
}

const std::vector<PixelMapScale>& pixel_map_scales() {
    using Undefined = PixelMapScale::Undefined;
    constexpr bool logarithmic = true;
    constexpr bool linear = false;
    // Fixed ranges, so that pictures can be compared across runs.
    static const std::vector<PixelMapScale> scales{
        {PixelMap::uv_error,
         "uv_error",
         "UV error",
         "texels",
         0.01,
         10,
         logarithmic,
         {0.01, 0.1, 1, 10},
         Undefined::coverage},
        {PixelMap::flip, "flip", "FLIP", "", 0, 1, linear, {0, 0.5, 1}, Undefined::outside},
        {PixelMap::taps, "taps", "Taps per pixel", "", 1, 1000, logarithmic, {1, 10, 100, 1000}, Undefined::nothing},
        {PixelMap::depth_error,
         "depth_error",
         "Depth error",
         "patch widths",
         1e-5,
         0.1,
         logarithmic,
         {1e-5, 1e-3, 0.1},
         Undefined::coverage},
        {PixelMap::normal_error,
         "normal_error",
         "Normal error",
         "degrees",
         0.1,
         100,
         logarithmic,
         {0.1, 1, 10, 100},
         Undefined::coverage},
        {PixelMap::ssim, "ssim", "SSIM", "", 1, 0, linear, {1, 0.5, 0}, Undefined::outside},
        {PixelMap::coverage, "coverage", "Missed and false hits", "", 0, 1, linear, {}, Undefined::coverage},
    };
    return scales;
}

const PixelMapScale& scale_of(PixelMap map) {
    const std::vector<PixelMapScale>& scales = pixel_map_scales();
    const auto found =
        std::find_if(scales.begin(), scales.end(), [&](const PixelMapScale& scale) { return scale.map == map; });
    assert(found != scales.end());
    return *found;
}

PixelMap parse_pixel_map(const std::string& name) {
    std::vector<std::string> names;
    for (const PixelMapScale& scale : pixel_map_scales()) {
        if (scale.name == name) return scale.map;
        names.push_back(scale.name);
    }
    fail("there is no map '{}'{}; the maps are {}", name, did_you_mean(name, names), join(names));
}

}  // namespace reliefbench
