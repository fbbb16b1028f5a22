#pragma once

#include "verify/check_list.hpp"

namespace reliefbench {

/// Each holds the technique to one promise, under the parameter values that the promise names, and adds its checks to
/// the list. δ is the filter's deviation (measure_filter_deviation), a stride the texels that a ray travels from h = 1
/// to h = 0, so that δ·stride is the filter's floor. All heights are r16.

/// On every procedural map, at 0, 45, 75 and 85°, both projections, tiled and repeated too: the 99th percentile of the
/// UV error is below 0.1 texel + the floor, missed + false hits are at most 0.5 % of the footprint, all searches
/// converge.
void check_first_hit(CheckList& list, const PromiseDeclaration& declaration);

/// On every procedural map: in at most 0.5 % of the footprint, as with `first_hit`, is the reported point more than
/// half a texel + the floor beyond the first hit, misses included. (Silhouettes are decided by the last bits of a
/// float.)
void check_conservative(CheckList& list, const PromiseDeclaration& declaration);

/// On the smooth map, seen so that each ray crosses it once: the median UV error halves (0.4 to 0.6) with each doubling
/// of the sample count and with each of the `halvings`, until the floor; and no error exceeds
/// `within` of its pixel's stride/(samples·2^halvings) + floor.
void check_order_1(CheckList& list, const PromiseDeclaration& declaration);

/// On the smooth map: the median UV error falls by about four (to 0.17 to 0.33) with each doubling of the sample count,
/// until the floor.
void check_order_2(CheckList& list, const PromiseDeclaration& declaration);

/// Footprint pixels whose reported point lies more than half a texel and the floor beyond the first hit, misses
/// included.
std::size_t pixels_beyond(const TruthComparison& comparison, const HeightMap& map, const View& view, double deviation);

void check_promise(CheckList& list, const PromiseDeclaration& declaration);

}  // namespace reliefbench
