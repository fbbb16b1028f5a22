#pragma once

#include "reference/packet_tracer.hpp"

#include <cstdint>

namespace reliefbench {

/// Neighbouring rays that share the beginning of their way.
constexpr std::size_t beam_rays = 16;
constexpr std::size_t max_beams = max_packet_rays / beam_rays;

/// What a lane does next.
enum LaneState : std::int32_t {
    lane_rests,
    /// Its end is that of the relief.
    lane_marches,
    /// Its end is that of the copy of the map which it is in.
    lane_marches_to_border,
};

/// Rays, or beams, on their way through windows in single precision: at the parameter s they are at origin + s·step, in
/// cells. `origin` lies behind the ray by the margin, so that windows there begin in time.
template <std::size_t count>
struct MarchLanes {
    alignas(64) float x[count];
    alignas(64) float y[count];
    alignas(64) float step_x[count];
    alignas(64) float step_y[count];
    alignas(64) float s[count];
    alignas(64) float end[count];
    /// A window of n cells is left behind within n·s_per_cell − s_of_margin.
    alignas(64) float s_per_cell[count];
    alignas(64) float s_of_margin[count];
    alignas(64) std::int32_t level[count];
    alignas(64) std::int32_t min_level[count];
    alignas(64) std::int32_t state[count];
};

/// Up to max_packet_rays rays; in double what the walk of a single ray has, in the copy of the map in which they are.
struct PacketLanes {
    MarchLanes<max_packet_rays> march;
    alignas(64) double x[max_packet_rays];
    alignas(64) double y[max_packet_rays];
    alignas(64) double step_x[max_packet_rays];
    alignas(64) double step_y[max_packet_rays];
    alignas(64) double inverse_x[max_packet_rays];
    alignas(64) double inverse_y[max_packet_rays];
    /// Where the ray enters the relief or this copy of the map, and where it leaves the relief.
    alignas(64) double first[max_packet_rays];
    alignas(64) double last[max_packet_rays];
    /// Every cell up to here is known to have no crossing; negative before the first.
    alignas(64) double tested[max_packet_rays];
    alignas(64) double crossing[max_packet_rays];
};

}  // namespace reliefbench
