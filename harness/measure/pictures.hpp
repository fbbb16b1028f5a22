#pragma once

#include "metrics/compared_hits.hpp"
#include "metrics/truth_noise.hpp"
#include "picture/picture.hpp"
#include "picture/pixel_map.hpp"
#include "reference/truth.hpp"
#include "scene/height_map.hpp"
#include "scene/image_file.hpp"
#include "scene/relief.hpp"
#include "technique/renderer.hpp"

#include <optional>

namespace reliefbench {

/// What a cell drew, and what it is compared with; all that it refers to must outlive it.
struct DrawnCell {
    const Probe& probe;
    const Truth& truth;
    const HeightMap& map;
    Relief relief;
    /// Of the technique's shape (ShapeKind::draws_base).
    bool draws_base = false;
    /// Of a truth of several samples.
    std::optional<TruthNoise> truth_noise = {};
};

/// Valid as long as what the cell refers to.
ComparedHits compared_hits(const DrawnCell& cell);

/// A value per pixel; not a number where it is undefined: errors of hits where not both hit, taps where no fragment of
/// the technique ran (those of vertex and tessellation stages are spread over covered pixels), FLIP and SSIM outside
/// the footprint.
Image<float> pixel_map(PixelMap map, const DrawnCell& cell);

/// In the colours of the map's scale, without a legend.
Picture map_picture(PixelMap map, const DrawnCell& cell);

/// The float channels hit.{u,v,h,t}, truth.{u,v,h,t}, color.{R,G,B} and truth_color.{R,G,B} (patch coordinates, linear
/// colours, t = −1 and zeros for a miss), and one of each pixel map by its name.
RasterFile layers(const DrawnCell& cell);

}  // namespace reliefbench
