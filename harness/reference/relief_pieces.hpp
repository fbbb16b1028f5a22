#pragma once

#include "reference/embree_scene.hpp"
#include "reference/maximum_mip_chain.hpp"
#include "reference/prism.hpp"

#include <cstdint>
#include <vector>

namespace reliefbench {

/// The relief over one triangle and one square block of bilinear cells (cell i spans the texel centres i to i + 1).
struct ReliefPiece {
    std::uint32_t triangle = 0;
    /// The block's first cell, not wrapped.
    std::int32_t column = 0;
    std::int32_t row = 0;
    /// Where the sheet lies: m of Prism, rounded outwards.
    float lowest = 0;
    float highest = 0;
};

/// How far past its triangle and block a piece goes, in texels, so that no ray slips between two of them.
constexpr double piece_overlap = 1e-8;

/// Every triangle split along the borders of blocks of 2^level × 2^level cells of the map (fewer at its last column and
/// row), each piece with a box around the sheet in it.
struct ReliefPieces {
    int level = 0;
    std::vector<ReliefPiece> pieces;
    std::vector<Box> boxes;
};

/// About how many pieces there are at most, where the map and the base do not need more.
constexpr double max_relief_pieces = 3e6;

/// Of the least level with no more than about `max_pieces`. `margin`: what boxes are widened by, in world units.
/// `minima` is of the map upside down, so that their negatives are the least heights.
ReliefPieces split_relief(const std::vector<Prism>& prisms, const TexelScale& scale, const HeightMap& map,
                          const MaximumMipChain& maxima, const MaximumMipChain& minima, double margin,
                          double max_pieces);

}  // namespace reliefbench
