#pragma once

#include "scene/height_map.hpp"
#include "scene/image.hpp"

#include <array>

namespace reliefbench {

/// Linear RGB, row 0 is v = 0, bilinear between texel centres, repeating.
struct Albedo {
    enum class Format {
        /// 16 bits a channel, linear: filters at full precision on every device seen, CPU devices included.
        unorm16,
        /// 32-bit float, for tests that encode coordinates as colour.
        float32,
    };
    Image<std::array<float, 4>> texels;
    Format format = Format::unorm16;

    /// Bilinear, repeating.
    std::array<double, 3> sample(double u, double v) const;
};

/// The source's albedo image, sRGB decoded to linear and quantised to unorm16; without one the default albedo: a ramp
/// from a dark to a light stone colour by height, so that a wrong hit shows in the picture (docs/measurement.md).
Albedo load_albedo(const HeightMapSource& source, const HeightMap& map);

/// Without loading it; that of the height map where the source names no file.
Resolution albedo_size(const HeightMapSource& source, Resolution height_map);

}  // namespace reliefbench
