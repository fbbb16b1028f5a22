// Part of packet_tracer.cpp, compiled once for each instruction set: rays into lanes.
#if defined(RELIEFBENCH_PACKET_SETUP) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEFBENCH_PACKET_SETUP
#undef RELIEFBENCH_PACKET_SETUP
#else
#define RELIEFBENCH_PACKET_SETUP
#endif

#include "reference/packet_lanes.hpp"

#include <algorithm>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace reliefbench::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
/// As many as Doubles.
using FewFloats = hn::Rebind<float, Doubles>;
using FewInts = hn::Rebind<std::int32_t, Doubles>;
using Double = hn::Vec<Doubles>;
using DoubleMask = hn::Mask<Doubles>;

/// std::min and std::max, to the sign of zeros.
HWY_INLINE Double least_of(Double a, Double b) {
    return hn::IfThenElse(hn::Lt(b, a), b, a);
}
HWY_INLINE Double greatest_of(Double a, Double b) {
    return hn::IfThenElse(hn::Lt(a, b), b, a);
}

HWY_INLINE Double number(double value) {
    return hn::Set(Doubles(), value);
}

/// The rays in the walk's own terms.
struct SlabLanes {
    Double x, y, step_x, step_y, inverse_x, inverse_y, first, last;

    HWY_INLINE Double x_at(Double s) const { return hn::Add(x, hn::Mul(s, step_x)); }
    HWY_INLINE Double y_at(Double s) const { return hn::Add(y, hn::Mul(s, step_y)); }

    HWY_INLINE void clip(Double origin, Double inverse, double high) {
        const Double a = hn::Mul(hn::Sub(number(-0.5), origin), inverse);
        const Double b = hn::Mul(hn::Sub(number(high), origin), inverse);
        first = greatest_of(first, least_of(a, b));
        last = least_of(last, greatest_of(a, b));
    }

    /// Where they leave the copy of the map that the origin is of.
    HWY_INLINE Double copy_end(const PacketScene& scene) const {
        const auto wall = [](Double step, int size) {
            return hn::IfThenElseZero(hn::Ge(step, number(0)), number(size));
        };
        return hn::Min(hn::Mul(hn::Sub(wall(step_x, scene.width), x), inverse_x),
                       hn::Mul(hn::Sub(wall(step_y, scene.height), y), inverse_y));
    }
};

/// An axis is moved by whole maps so that the ray starts in the first one.
HWY_INLINE Double in_first_copy(Double origin, Double step, Double first, int size) {
    const Double sizes = number(size);
    const Double start = hn::Add(origin, hn::Mul(first, step));
    const auto outside = hn::Or(hn::Lt(start, number(0)), hn::Ge(start, sizes));
    if (hn::AllFalse(Doubles(), outside)) return origin;
    const Double moved = hn::Sub(origin, hn::Mul(hn::Floor(hn::Div(start, sizes)), sizes));
    const auto still_outside = hn::Ge(hn::Add(moved, hn::Mul(first, step)), sizes);
    return hn::IfThenElse(outside, hn::IfThenElse(still_outside, hn::Sub(moved, sizes), moved), origin);
}

/// Where `marches`: in single precision, with margins, up to the end of the relief or of the map's copy.
HWY_INLINE void start_march(const PacketScene& scene, const SlabLanes& slab, DoubleMask marches, Double from,
                            MarchLanes<max_packet_rays>& march, std::size_t at) {
    const FewFloats few;
    const double size = std::max(scene.width, scene.height);
    const Double extent = hn::Max(hn::Abs(slab.step_x), hn::Abs(slab.step_y));
    const Double margin = hn::Mul(hn::Add(extent, number(size)), number(0x1p-19));
    const Double per_cell = hn::Min(hn::Abs(slab.inverse_x), hn::Abs(slab.inverse_y));
    const Double copy_end = slab.copy_end(scene);
    const auto to_border = hn::Lt(copy_end, slab.last);
    const Double end =
        hn::IfThenElse(to_border, hn::Mul(copy_end, number(1 - 0x1p-21)), hn::Mul(slab.last, number(1 + 0x1p-21)));
    const auto store = [&](Double value, float* to) {
        hn::Store(hn::DemoteTo(few, hn::IfThenElseZero(marches, value)), few, to + at);
    };
    store(hn::Sub(slab.x, hn::CopySign(margin, slab.step_x)), march.x);
    store(hn::Sub(slab.y, hn::CopySign(margin, slab.step_y)), march.y);
    store(slab.step_x, march.step_x);
    store(slab.step_y, march.step_y);
    store(from, march.s);
    store(end, march.end);
    store(per_cell, march.s_per_cell);
    store(hn::Mul(hn::Add(margin, margin), per_cell), march.s_of_margin);
    const Double state = hn::IfThenElse(to_border, number(lane_marches_to_border), number(lane_marches));
    hn::Store(hn::DemoteTo(FewInts(), hn::IfThenElseZero(marches, state)), FewInts(), march.state + at);
    static_assert(lane_rests == 0);
}

HWY_INLINE void store_slab(const SlabLanes& slab, PacketLanes& lanes, std::size_t at) {
    const Doubles d;
    hn::Store(slab.x, d, lanes.x + at);
    hn::Store(slab.y, d, lanes.y + at);
    hn::Store(slab.step_x, d, lanes.step_x + at);
    hn::Store(slab.step_y, d, lanes.step_y + at);
    hn::Store(slab.inverse_x, d, lanes.inverse_x + at);
    hn::Store(slab.inverse_y, d, lanes.inverse_y + at);
    hn::Store(slab.first, d, lanes.first + at);
    hn::Store(slab.last, d, lanes.last + at);
}

HWY_INLINE SlabLanes load_slab(const PacketLanes& lanes, std::size_t at) {
    const Doubles d;
    return {hn::Load(d, lanes.x + at),      hn::Load(d, lanes.y + at),         hn::Load(d, lanes.step_x + at),
            hn::Load(d, lanes.step_y + at), hn::Load(d, lanes.inverse_x + at), hn::Load(d, lanes.inverse_y + at),
            hn::Load(d, lanes.first + at),  hn::Load(d, lanes.last + at)};
}

/// As many rays as Doubles has lanes, by the formulas of straight_path and of the walk of a single ray.
HWY_INLINE void set_up(const PacketScene& scene, const Ray* rays, PacketLanes& lanes, std::size_t at) {
    const Doubles d;
    const hn::RebindToSigned<Doubles> wide;
    static_assert(sizeof(Ray) == 6 * sizeof(double));
    alignas(64) std::int64_t numbers[hn::MaxLanes(wide)];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
        numbers[lane] = static_cast<std::int64_t>(6 * lane);
    const auto index = hn::Load(wide, numbers);
    const auto gather = [&](std::size_t member) { return hn::GatherIndex(d, &rays->origin.x + member, index); };
    const Double half = number(0.5);
    const Double zero = number(0);
    const Double along_x = gather(3), along_y = gather(4), along_z = gather(5);
    const Double t_per_z = hn::Div(number(1), along_z);
    const Double t_top = hn::Mul(hn::Neg(gather(2)), t_per_z);
    const Double t_per_s = hn::Mul(number(-scene.height_scale), t_per_z);
    const Double u = hn::Add(hn::Add(gather(0), hn::Mul(t_top, along_x)), half);
    const Double v = hn::Add(hn::Add(gather(1), hn::Mul(t_top, along_y)), half);
    SlabLanes slab;
    slab.x = hn::Sub(hn::Mul(u, number(scene.columns)), half);
    slab.y = hn::Sub(hn::Mul(v, number(scene.rows)), half);
    slab.step_x = hn::Mul(hn::Mul(t_per_s, along_x), number(scene.columns));
    slab.step_y = hn::Mul(hn::Mul(t_per_s, along_y), number(scene.rows));
    slab.inverse_x = hn::Div(number(1), slab.step_x);
    slab.inverse_y = hn::Div(number(1), slab.step_y);
    const auto starts_below = hn::Lt(t_top, zero);
    slab.first = zero;
    if (!hn::AllFalse(d, starts_below)) slab.first = hn::IfThenElseZero(starts_below, hn::Div(hn::Neg(t_top), t_per_s));
    slab.last = number(1.5);
    if (scene.clip) {
        slab.clip(slab.x, slab.inverse_x, scene.columns - 0.5);
        slab.clip(slab.y, slab.inverse_y, scene.rows - 0.5);
    }
    const double size = std::max(scene.width, scene.height);
    const Double extent_x = hn::Abs(slab.step_x), extent_y = hn::Abs(slab.step_y);
    const auto descends = hn::Lt(along_z, zero);
    const auto suits = hn::And(hn::And(hn::Ge(hn::Min(extent_x, extent_y), number(1e-6)),
                                       hn::Le(hn::Max(extent_x, extent_y), number(0x1p16 - size))),
                               hn::Le(hn::Max(hn::Abs(slab.x), hn::Abs(slab.y)), number(0x1p18)));
    const auto in_slab = hn::And(hn::Le(slab.first, slab.last), hn::Le(slab.first, number(1)));
    slab.x = in_first_copy(slab.x, slab.step_x, slab.first, scene.width);
    slab.y = in_first_copy(slab.y, slab.step_y, slab.first, scene.height);
    const auto enters = hn::And(hn::And(descends, suits), in_slab);
    const auto marches = hn::And(enters, hn::Gt(slab.copy_end(scene), slab.first));
    const auto misses = hn::Or(hn::Not(descends), hn::AndNot(in_slab, suits));
    store_slab(slab, lanes, at);
    start_march(scene, slab, marches, hn::Mul(slab.first, number(1 - 0x1p-21)), lanes.march, at);
    hn::Store(number(-1), d, lanes.tested + at);
    hn::Store(hn::IfThenElse(hn::Or(misses, marches), number(crosses_nowhere), number(not_decided)), d,
              lanes.crossing + at);
}

}  // namespace reliefbench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
