#pragma once

#include "scene/height_map.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// How a map is seen, as far as what is wrong with it depends on that.
struct MapUse {
    /// In patch sides.
    double height_scale = 0.05;
    /// The texture repeats within what is seen.
    bool repeats = false;
    /// Degrees.
    double steepest_view_angle = 60;
    /// Of the picture along a patch side, seen head-on.
    double pixels_per_side = 512;
};

struct MapFault {
    enum class Kind {
        /// All heights are equal: there is nothing to measure.
        constant,
        /// The relief shifts nothing by as much as half a pixel.
        flat,
        /// It uses a small part of the range of heights.
        narrow_range,
        /// So few heights that its slopes are stairs.
        few_levels,
        /// Heights of 8 bits that rise by less than a step from texel to texel.
        terraces,
        /// Most of its slopes are from one texel to the next.
        noise,
        /// It does not go on at its border, where it repeats.
        seam,
    };
    Kind kind = Kind::constant;
    /// What it is, what it means for the measurement, and what to do.
    std::string text;
};

/// What makes the map useless (constant) or its figures misleading. docs/advice.md has the thresholds. Empty: nothing
/// was found.
std::vector<MapFault> map_faults(const HeightMap& map, const MapUse& use);

}  // namespace reliefbench
