#pragma once

#include "scene/height_map.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace reliefbench::test {

/// Cone ratios as harness/shaders/library/cone_preparation.glsl defines them, made on the CPU in double and in the
/// plainest way: radius in texture coordinates over height in units of the height scale, at most 1. One for each texel.
using Ratios = Image<double>;

/// The widest cones that no texel reaches into.
Ratios conservative_ratios(const HeightMap& map);

/// Relaxed ones as GPU Gems 3 makes them (chapter 18), for these texels only: without any short cut.
std::vector<double> published_relaxed_ratios(const HeightMap& map, int search_steps,
                                             const std::vector<Resolution>& texels);

/// The same for all texels, with the short cut that a ray is given up where it can narrow its cone no more.
Ratios published_relaxed_ratios(const HeightMap& map, int search_steps);

/// The widest cones that hold no vertex from which an edge falls away from the axis.
Ratios falling_edge_ratios(const HeightMap& map);

/// The narrowest of each 3×3 texels.
Ratios narrowest_around(const Ratios& ratios);

/// Rounded down to 16 bits.
Ratios stored(const Ratios& ratios);

/// What a map of cones holds and interpolates between texels: ratios, or their square roots.
enum class ConeEncoding { linear, square_root };

Ratios square_roots(const Ratios& ratios);

/// A dense test of interpolated cones, at so many places all over the map, between texels too, against the bilinear
/// surface.
struct ConeProof {
    std::size_t places = 0;
    /// Places whose cone does what it must not.
    std::size_t failures = 0;
    /// How deep the surface reaches into a cone, horizontally, in texels.
    double deepest_texels = 0;

    double failed_fraction() const { return static_cast<double>(failures) / static_cast<double>(places); }
};

/// No point of the surface lies in a cone, by more than a hundredth of a texel.
ConeProof prove_conservative(const HeightMap& map, const Ratios& encoded, std::size_t places,
                             ConeEncoding encoding = ConeEncoding::linear);

/// No ray from the axis above the apex to the cone's mantle comes out of the surface again: many directions, heights
/// and slopes for each place.
ConeProof prove_relaxed(const HeightMap& map, const Ratios& ratios, std::size_t places);

}  // namespace reliefbench::test
