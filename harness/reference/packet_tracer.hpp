#pragma once

#include "reference/window_maxima.hpp"
#include "scene/ray.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace reliefbench {

/// A relief on the plane, as packets of rays see it.
struct PacketScene {
    const float* texels = nullptr;
    int width = 0;
    int height = 0;
    double height_scale = 0;
    /// Texels of the map on a side of the patch.
    double columns = 0;
    double rows = 0;
    bool clip = false;
    const WindowMaxima* windows = nullptr;
};

constexpr std::size_t max_packet_rays = 256;

/// Where each ray of a packet first crosses the sheet: its parameter s in [0, 1] (at the height 1 − s), or one of
/// these.
using PacketCrossings = std::array<double, max_packet_rays>;
constexpr double crosses_nowhere = -1;
/// Left to the walk of a single ray (exact_tracer.cpp).
constexpr double not_decided = -2;

/// At most max_packet_rays rays, whose crossings come first in `crossings`. What is decided is what the walk of a
/// single ray finds, bit for bit, with any instruction set; the widest that the machine has is taken.
///
/// Conservative steps in single precision lead each ray past where the surface certainly stays below it. There the walk
/// from cell to cell begins, in double, by the same formulas in the same order. It comes to the same crossing as any
/// other walk in which no cell with a crossing is left out: a ray that has been above the sheet stays above up to its
/// hit, so that what a cell answers depends on the cell and on where the ray enters it alone, which is where it crosses
/// the cell's wall. Only where a ray passes a corner of cells within rounding may walks differ in what they enter;
/// such rays are left undecided, as are those that start beneath the sheet, run along an axis, or reach too far for the
/// margins below.
///
/// Margins, in cells, of a map of N texels on its longer side, over which a ray moves by D cells (N + D ≤ 2^16): a
/// position origin + s·step in single precision, in which both, the product and the sum are rounded (2⁻²⁴ each) and
/// nothing exceeds N + D, is off by less than 5·2⁻²⁴·(N + D); windows are entered with 2⁻¹⁹·(N + D) on either side,
/// which is 6 times that. What is left pays for s itself where it was rounded from double, and for where a walk is
/// resumed: up to 2⁻²¹ in s, 2⁻²¹·D in cells. In height, bounds lie 1e-5 above the surface; 1 − s is rounded by 2⁻²⁴
/// and off by 2⁻²¹ where s is, together 6e-7. What the formulas in double are off by is below 1e-9 of either.
void find_crossings(const PacketScene& scene, std::span<const Ray> rays, PacketCrossings& crossings);

}  // namespace reliefbench
