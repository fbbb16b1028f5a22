#include "reference/packet_tracer.hpp"

#include "reference/packet_lanes.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "reference/packet_tracer.cpp"
#include <hwy/foreach_target.h>
// After it.
#include "reference/packet_cells-inl.hpp"
#include "reference/packet_march-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace reliefbench::HWY_NAMESPACE {

/// All rays into lanes; how many lanes, of whole beams, there are.
HWY_INLINE std::size_t set_up_all(const PacketScene& scene, std::span<const Ray> rays, PacketLanes& lanes) {
    const std::size_t step = hn::Lanes(Doubles());
    std::size_t at = 0;
    for (; at + step <= rays.size(); at += step)
        set_up(scene, &rays[at], lanes, at);
    const std::size_t count = (rays.size() + beam_rays - 1) / beam_rays * beam_rays;
    for (; at < count; at += step) {
        std::array<Ray, beam_rays> last;
        last.fill({{0, 0, 0}, {0, 0, 1}});  // does not descend: rests
        for (std::size_t lane = 0; lane < step && at + lane < rays.size(); ++lane)
            last[lane] = rays[at + lane];
        set_up(scene, last.data(), lanes, at);
    }
    return count;
}

/// What a beam passes, all of its rays have passed.
HWY_INLINE void march_beams(const WindowMaxima& windows, PacketLanes& lanes, std::size_t count) {
    const Floats d;
    const Ints ints;
    MarchLanes<max_beams> beams{};
    const std::size_t used = count / beam_rays;
    for (std::size_t beam = 0; beam < used; ++beam)
        lay_beam(windows, lanes.march, beams, beam);
    for (std::size_t at = 0; at < used; at += hn::Lanes(d))
        march_on(windows, beams, at);
    for (std::size_t at = 0; at < count; at += hn::Lanes(d)) {
        const std::size_t beam = at / beam_rays;
        hn::Store(hn::Max(hn::Load(d, lanes.march.s + at), hn::Set(d, beams.s[beam])), d, lanes.march.s + at);
        hn::Store(hn::Set(ints, beams.min_level[beam]), ints, lanes.march.level + at);
        hn::Store(hn::Zero(ints), ints, lanes.march.min_level + at);
    }
}

void find_all_crossings(const PacketScene& scene, std::span<const Ray> rays, PacketCrossings& crossings) {
    PacketLanes lanes;
    const std::size_t count = set_up_all(scene, rays, lanes);
    march_beams(*scene.windows, lanes, count);
    const Ints ints;
    for (std::size_t at = 0; at < count; at += hn::Lanes(ints)) {
        while (!hn::AllFalse(ints, hn::Gt(hn::Load(ints, lanes.march.state + at), hn::Zero(ints)))) {
            march_on(*scene.windows, lanes.march, at);
            for (std::size_t few = at; few < at + hn::Lanes(ints); few += hn::Lanes(Doubles())) {
                CellLanes cells(scene, lanes, few);
                if (cells.any()) cells.run();
            }
        }
    }
    std::copy_n(lanes.crossing, rays.size(), crossings.begin());
}

}  // namespace reliefbench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reliefbench {

HWY_EXPORT(find_all_crossings);

void find_crossings(const PacketScene& scene, std::span<const Ray> rays, PacketCrossings& crossings) {
    assert(rays.size() <= max_packet_rays);
    HWY_DYNAMIC_DISPATCH(find_all_crossings)(scene, rays, crossings);
}

}  // namespace reliefbench
#endif
