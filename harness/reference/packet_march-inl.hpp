// Part of packet_tracer.cpp, compiled once for each instruction set: steps in single precision past where the surface
// certainly stays below.
#if defined(RELIEFBENCH_PACKET_MARCH) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEFBENCH_PACKET_MARCH
#undef RELIEFBENCH_PACKET_MARCH
#else
#define RELIEFBENCH_PACKET_MARCH
#endif

#include "reference/packet_setup-inl.hpp"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace reliefbench::HWY_NAMESPACE {

using Float = hn::Vec<Floats>;
using Int = hn::Vec<Ints>;

HWY_INLINE hn::Mask<Floats> float_mask(hn::Mask<Ints> mask) {
    return hn::MaskFromVec(hn::BitCast(Floats(), hn::VecFromMask(Ints(), mask)));
}
HWY_INLINE hn::Mask<Ints> int_mask(hn::Mask<Floats> mask) {
    return hn::MaskFromVec(hn::BitCast(Ints(), hn::VecFromMask(Floats(), mask)));
}

/// The bound of the window of this level that begins at or before (x, y), as a height.
HWY_INLINE Float window_bound(const WindowMaxima& windows, Int level, Float x, Float y) {
    const Ints d;
    const Int column = hn::Shr(hn::ConvertTo(d, x), level);
    const Int row = hn::Shr(hn::ConvertTo(d, y), level);
    const Int first = hn::Shr(hn::Set(d, static_cast<std::int32_t>(windows.first())), level);
    const Int of_row = hn::Shr(hn::Add(first, hn::ShiftLeftSame(row, windows.row_shift())), level);
    const Int index = hn::Add(of_row, column);
    const auto* pairs = reinterpret_cast<const std::int32_t*>(windows.bounds());
    const Int bound = hn::And(hn::GatherOffset(d, pairs, hn::Add(index, index)), hn::Set(d, 0xffff));
    return hn::Mul(hn::ConvertTo(Floats(), bound), hn::Set(Floats(), static_cast<float>(WindowMaxima::step)));
}

/// Lanes that march do so until they reach their end or cannot pass a window of their finest level. Those that reach
/// the end of the relief rest then.
template <std::size_t count>
HWY_INLINE void march_on(const WindowMaxima& windows, MarchLanes<count>& march, std::size_t at) {
    const Floats d;
    const Ints ints;
    const Int top = hn::Set(ints, windows.top_level());
    const Float x = hn::Load(d, march.x + at), y = hn::Load(d, march.y + at);
    const Float step_x = hn::Load(d, march.step_x + at), step_y = hn::Load(d, march.step_y + at);
    const Float end = hn::Load(d, march.end + at);
    const Float s_per_cell = hn::Load(d, march.s_per_cell + at), s_of_margin = hn::Load(d, march.s_of_margin + at);
    const Float zero = hn::Zero(d), one = hn::Set(d, 1);
    // A window lies ahead: it begins where the step ends when coordinates fall.
    const Float back_x = hn::IfThenElseZero(hn::Lt(step_x, zero), hn::Set(d, -1));
    const Float back_y = hn::IfThenElseZero(hn::Lt(step_y, zero), hn::Set(d, -1));
    const Int min_level = hn::Load(ints, march.min_level + at);
    const Int state = hn::Load(ints, march.state + at);
    Float s = hn::Load(d, march.s + at);
    Int level = hn::Load(ints, march.level + at);
    auto active = float_mask(hn::Gt(state, hn::Zero(ints)));
    auto ended = hn::MaskFromVec(zero);
    while (!hn::AllFalse(d, active)) {
        const Float stride = hn::BitCast(d, hn::ShiftLeft<23>(hn::Add(level, hn::Set(ints, 127))));  // 2^level
        const Float next = hn::Min(hn::Add(s, hn::MulSub(stride, s_per_cell, s_of_margin)), end);
        const Float window_x = hn::Max(hn::MulAdd(s, step_x, hn::MulAdd(back_x, stride, x)), zero);
        const Float window_y = hn::Max(hn::MulAdd(s, step_y, hn::MulAdd(back_y, stride, y)), zero);
        const Float free = hn::Sub(one, window_bound(windows, level, window_x, window_y));
        const auto passes = hn::Le(next, free);
        // What does not pass the window still gets down to its bound.
        s = hn::IfThenElse(active, hn::Max(s, hn::Min(next, free)), s);
        const auto at_end = hn::And(passes, hn::Ge(next, end));
        const auto can_refine = float_mask(hn::Gt(level, min_level));
        ended = hn::Or(ended, hn::And(active, at_end));
        active = hn::And(active, hn::Or(hn::AndNot(at_end, passes), hn::AndNot(passes, can_refine)));
        const Int change = hn::IfThenElse(int_mask(passes), hn::Set(ints, 1), hn::Set(ints, -1));
        level = hn::Min(top, hn::Max(min_level, hn::Add(level, change)));
    }
    hn::Store(s, d, march.s + at);
    hn::Store(level, ints, march.level + at);
    const auto leaves = hn::And(int_mask(ended), hn::Eq(state, hn::Set(ints, lane_marches)));
    hn::Store(hn::IfThenZeroElse(leaves, state), ints, march.state + at);
}

/// Least and greatest values of those lanes of a beam that march.
struct Extremes {
    Float least;
    Float greatest;

    HWY_INLINE Extremes() : least(hn::Set(Floats(), 1e30F)), greatest(hn::Set(Floats(), -1e30F)) {}

    HWY_INLINE void add(Float value, hn::Mask<Floats> which) {
        least = hn::Min(least, hn::IfThenElse(which, value, least));
        greatest = hn::Max(greatest, hn::IfThenElse(which, value, greatest));
    }
    HWY_INLINE float low() const { return hn::GetLane(hn::MinOfLanes(Floats(), least)); }
    HWY_INLINE float high() const { return hn::GetLane(hn::MaxOfLanes(Floats(), greatest)); }
};

/// One coordinate of a beam: of its rays at s = 0 and at s = 1, and their steps.
struct BeamSide {
    Extremes start;
    Extremes end;
    Extremes step;

    HWY_INLINE BeamSide() {}
    HWY_INLINE void add(Float origin, Float by, hn::Mask<Floats> which) {
        start.add(origin, which);
        end.add(hn::Add(origin, by), which);
        step.add(by, which);
    }
    HWY_INLINE bool all_go_one_way() const { return (step.low() < 0) == (step.high() < 0); }
    HWY_INLINE float breadth() const { return std::max(start.high() - start.low(), end.high() - end.low()); }
    /// The line behind all rays: least and greatest coordinates are concave and convex in s, so that between s = 0 and
    /// s = 1 the chord lies outside.
    HWY_INLINE void line_behind(float margin, float& origin, float& by) const {
        const bool back = step.high() < 0;
        origin = back ? start.high() + margin : start.low() - margin;
        by = back ? end.high() - start.high() : end.low() - start.low();
    }
};

/// A beam as broad as its rays together. It rests where they have no way in common.
HWY_INLINE void lay_beam(const WindowMaxima& windows, const MarchLanes<max_packet_rays>& rays,
                         MarchLanes<max_beams>& beams, std::size_t beam) {
    const Floats d;
    BeamSide x, y;
    Extremes start, end, s_per_cell, margins;
    auto any = hn::MaskFromVec(hn::Zero(d));
    for (std::size_t at = beam * beam_rays; at < (beam + 1) * beam_rays; at += hn::Lanes(d)) {
        const auto marches = float_mask(hn::Gt(hn::Load(Ints(), rays.state + at), hn::Zero(Ints())));
        any = hn::Or(any, marches);
        const Float per_cell = hn::Load(d, rays.s_per_cell + at);
        x.add(hn::Load(d, rays.x + at), hn::Load(d, rays.step_x + at), marches);
        y.add(hn::Load(d, rays.y + at), hn::Load(d, rays.step_y + at), marches);
        start.add(hn::Load(d, rays.s + at), marches);
        end.add(hn::Load(d, rays.end + at), marches);
        s_per_cell.add(per_cell, marches);
        margins.add(hn::Div(hn::Load(d, rays.s_of_margin + at), per_cell), marches);
    }
    if (hn::AllFalse(d, any) || !x.all_go_one_way() || !y.all_go_one_way()) return;
    // Of both sides; the rays' own once more, and as much for what is rounded here.
    const float margin = margins.high();
    const float breadth = std::max(x.breadth(), y.breadth()) + 2 * margin;
    const int level = std::max(std::ilogb(2 * breadth) + 1, 0);  // more than half of a window is way
    if (level > windows.top_level()) return;
    x.line_behind(margin / 2, beams.x[beam], beams.step_x[beam]);
    y.line_behind(margin / 2, beams.y[beam], beams.step_y[beam]);
    const float per_cell =
        std::min(s_per_cell.low(), 1 / std::max(std::abs(beams.step_x[beam]), std::abs(beams.step_y[beam])));
    beams.s[beam] = start.low();
    beams.end[beam] = end.low();
    beams.s_per_cell[beam] = per_cell;
    beams.s_of_margin[beam] = breadth * per_cell;
    beams.min_level[beam] = level;
    // A quarter of the way: larger windows hardly ever let it pass.
    beams.level[beam] = std::clamp(std::ilogb(0.25F / per_cell), level, windows.top_level());
    beams.state[beam] = lane_marches;
}

}  // namespace reliefbench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
