#pragma once

#include "metrics/filter_bank.hpp"

#include <array>
#include <cstddef>

namespace reliefbench::flip {

/// Filters of FLIP (Andersson et al. 2020): the eye's contrast sensitivity, and the detector of edges and points. All
/// are sums of products of kernels along y and along x.
struct Filters {
    /// Along y on Y: the achromatic sensitivity; the detector's Gaussian, its second derivative and its first.
    FilterBank<3, 1> luminance;
    /// Along y on Cz: both Gaussians of its sensitivity.
    FilterBank<2, 0> blue_yellow;
    /// Along x on what the above made, each with its Gaussian's share of the whole filter.
    std::array<FilterBank<1, 0>, 2> blue_yellow_shares;
    FilterBank<1, 0> achromatic;
    /// Along y and along x.
    FilterBank<1, 0> red_green;
    FilterBank<1, 0> smooth;
    /// The detector's second and first derivative.
    FilterBank<1, 1> point_and_edge;
    /// How far a pixel's filters reach.
    std::size_t radius = 0;
};

/// For a viewer who sees so many pixels in a degree.
Filters make_filters(double pixels_per_degree);

}  // namespace reliefbench::flip
