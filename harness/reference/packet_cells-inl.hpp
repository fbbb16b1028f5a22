// Part of packet_tracer.cpp, compiled once for each instruction set: the walk from cell to cell in double, by the
// formulas of that of a single ray (exact_tracer.cpp).
#if defined(RELIEFBENCH_PACKET_CELLS) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEFBENCH_PACKET_CELLS
#undef RELIEFBENCH_PACKET_CELLS
#else
#define RELIEFBENCH_PACKET_CELLS
#endif

#include "reference/packet_setup-inl.hpp"
#include "scene/relief.hpp"

HWY_BEFORE_NAMESPACE();
namespace reliefbench::HWY_NAMESPACE {

/// How many cells are tested before the lanes that are left march on.
constexpr int cells_in_a_row = 4;

/// Closer to a corner of cells than this, in cells, rounding may decide which way a walk takes.
constexpr double corner_distance = 0x1p-30;

/// Lanes as many as Doubles has, on their way from cell to cell above the sheet.
class CellLanes {
public:
    HWY_INLINE CellLanes(const PacketScene& scene, PacketLanes& lanes, std::size_t at)
        : scene_(scene), lanes_(lanes), at_(at), slab_(load_slab(lanes, at)) {
        active_ = hn::Gt(hn::PromoteTo(d_, hn::Load(FewInts(), lanes.march.state + at)), zero_);
    }

    HWY_INLINE bool any() const { return !hn::AllFalse(d_, active_); }

    /// Tests cells from where the lanes have marched to, and says what becomes of each.
    HWY_INLINE void run() {
        crossing_ = hn::IfThenElse(active_, number(not_decided), hn::Load(d_, lanes_.crossing + at_));
        right_ = hn::IfThenElseZero(hn::Ge(slab_.step_x, zero_), one_);
        up_ = hn::IfThenElseZero(hn::Ge(slab_.step_y, zero_), one_);
        DoubleMask at_start = enter();
        for (int cell = 0; cell < cells_in_a_row && any(); ++cell) {
            test_cell(at_start);
            at_start = hn::MaskFromVec(zero_);
            step();
        }
        const Double tested = hn::Load(d_, lanes_.tested + at_);
        hn::Store(hn::IfThenElse(active_, in_, tested), d_, lanes_.tested + at_);
        hn::Store(hn::IfThenElse(active_, number(crosses_nowhere), crossing_), d_, lanes_.crossing + at_);
        if (!any()) {
            hn::Store(hn::Zero(FewInts()), FewInts(), lanes_.march.state + at_);
            return;
        }
        store_slab(slab_, lanes_, at_);
        // Rounded upwards; the margins of the march reach back.
        start_march(scene_, slab_, active_, hn::Mul(in_, number(1 + 0x1p-22)), lanes_.march, at_);
    }

private:
    /// Into the cells where the lanes are; those that are at the start of their way.
    HWY_INLINE DoubleMask enter() {
        const Double tested = hn::Load(d_, lanes_.tested + at_);
        const Double reached = hn::PromoteTo(d_, hn::Load(FewFloats(), lanes_.march.s + at_));
        const DoubleMask at_start =
            hn::And(hn::And(active_, hn::Lt(tested, zero_)), hn::Le(reached, hn::Add(slab_.first, number(1e-7))));
        const Double s = hn::IfThenElse(at_start, slab_.first, reached);
        column_ = within(hn::Floor(slab_.x_at(s)), scene_.width);
        row_ = within(hn::Floor(slab_.y_at(s)), scene_.height);
        in_x_ = wall_x(hn::Sub(one_, right_));
        in_y_ = wall_y(hn::Sub(one_, up_));
        out_x_ = wall_x(right_);
        out_y_ = wall_y(up_);
        const Double wall = hn::Max(in_x_, in_y_);
        in_ = hn::IfThenElse(at_start, slab_.first, hn::Max(slab_.first, wall));
        // Any walk is in this cell at s; but one that s lies on the wall of, one that follows a cell too short to have
        // been seen, and the first one behind the map's border, whose wall has had another parameter, are not taken.
        const DoubleMask inside = hn::And(hn::Lt(wall, s), hn::Gt(hn::Min(out_x_, out_y_), s));
        const Double since = hn::Sub(in_, tested);
        const DoubleMask follows_gap = hn::And(hn::Gt(since, zero_), hn::Lt(since, number(1e-6)));
        const DoubleMask at_border =
            hn::Lt(hn::Mul(hn::Min(hn::Abs(hn::Sub(in_x_, slab_.first)), hn::Abs(hn::Sub(in_y_, slab_.first))),
                           least_extent()),
                   number(corner_distance));
        const DoubleMask resumed = hn::Ge(tested, zero_);
        const DoubleMask clear = hn::AndNot(hn::Or(follows_gap, hn::And(resumed, at_border)), inside);
        active_ = hn::And(active_, hn::Or(at_start, clear));
        return at_start;
    }

    HWY_INLINE Double within(Double cell, int size) const { return hn::Max(hn::Min(cell, number(size - 1)), zero_); }
    /// The parameter of a cell's wall: 0 or 1, the lower or the upper one.
    HWY_INLINE Double wall_x(Double which) const {
        return hn::Mul(hn::Sub(hn::Add(column_, which), slab_.x), slab_.inverse_x);
    }
    HWY_INLINE Double wall_y(Double which) const {
        return hn::Mul(hn::Sub(hn::Add(row_, which), slab_.y), slab_.inverse_y);
    }
    HWY_INLINE Double least_extent() const { return hn::Min(hn::Abs(slab_.step_x), hn::Abs(slab_.step_y)); }

    /// Ends the way of lanes that cross the sheet in their cell.
    HWY_INLINE void test_cell(DoubleMask at_start) {
        exit_ = greatest_of(least_of(out_x_, out_y_), in_);
        const Double next_column = hn::Add(column_, one_), next_row = hn::Add(row_, one_);
        const Double width = number(scene_.width);
        const Double right = hn::IfThenElseZero(hn::Ne(next_column, width), next_column);
        const Double lower = hn::Mul(row_, width);
        const Double upper = hn::IfThenElseZero(hn::Ne(next_row, number(scene_.height)), hn::Mul(next_row, width));
        const auto texel = [&](Double row, Double column) {
            return hn::GatherIndex(FewFloats(), scene_.texels, hn::DemoteTo(FewInts(), hn::Add(row, column)));
        };
        const auto h00 = texel(lower, column_), h10 = texel(lower, right);
        const auto h01 = texel(upper, column_), h11 = texel(upper, right);
        const Double maximum = hn::PromoteTo(d_, hn::Max(hn::Max(h00, h10), hn::Max(h01, h11)));
        const Double end = least_of(exit_, slab_.last);
        const DoubleMask near = hn::And(active_, hn::Lt(hn::Sub(one_, end), maximum));
        if (hn::AllFalse(d_, hn::Or(near, at_start))) return;
        Quadratic f =
            quadratic(hn::PromoteTo(d_, h00), hn::PromoteTo(d_, h10), hn::PromoteTo(d_, h01), hn::PromoteTo(d_, h11));
        if (!hn::AllFalse(d_, at_start)) start_on_sheet(f, at_start);
        const Double length = hn::Sub(end, in_);
        const DoubleMask hit = hn::And(hn::And(active_, near), f.falls_within(length));
        crossing_ = hn::IfThenElse(hit, hn::Add(in_, f.falling_root(length)), crossing_);
        // A walk that has come by larger nodes may have passed the corner on its other side.
        const Double gap = hn::Min(hn::Abs(hn::Sub(in_x_, in_y_)), hn::Sub(exit_, in_));
        const DoubleMask at_corner = hn::And(hn::Lt(hn::Mul(gap, least_extent()), number(corner_distance)),
                                             hn::And(hn::And(active_, near), hn::Gt(in_, zero_)));
        crossing_ = hn::IfThenElse(at_corner, number(not_decided), crossing_);
        active_ = hn::AndNot(hn::Or(hit, at_corner), active_);
    }

    /// CellQuadratic, where the ray is above the sheet.
    struct Quadratic {
        Double a, b, c;

        HWY_INLINE Double discriminant_part() const { return hn::Mul(hn::Mul(number(4), a), c); }

        HWY_INLINE DoubleMask falls_within(Double length) const {
            const Double zero = number(0);
            const Double at_end = hn::Add(hn::Mul(hn::Add(hn::Mul(a, length), b), length), c);
            const DoubleMask below = hn::Lt(at_end, zero);
            const DoubleMask could_turn = hn::And(hn::And(hn::Gt(a, zero), hn::Lt(b, zero)),
                                                  hn::AndNot(below, hn::Gt(hn::Mul(b, b), discriminant_part())));
            if (hn::AllFalse(Doubles(), could_turn)) return below;  // nearly always, and divisions are slow
            const Double extremum = hn::Div(hn::Neg(b), hn::Mul(number(2), a));
            const DoubleMask within = hn::And(hn::Gt(extremum, zero), hn::Lt(extremum, length));
            return hn::Or(below, hn::And(could_turn, within));
        }

        /// Clamped to [0, length].
        HWY_INLINE Double falling_root(Double length) const {
            const Double zero = number(0);
            const Double root = hn::Sqrt(greatest_of(hn::Sub(hn::Mul(b, b), discriminant_part()), zero));
            const Double q = hn::Sub(root, b);
            const DoubleMask rising = hn::Gt(b, zero);
            const Double numerator = hn::IfThenElse(rising, hn::Sub(hn::Neg(b), root), hn::Mul(number(2), c));
            const Double quotient = hn::Div(numerator, hn::IfThenElse(rising, hn::Mul(number(2), a), q));
            const Double s = hn::IfThenElseZero(hn::Or(rising, hn::Gt(q, zero)), quotient);
            return hn::IfThenElse(hn::Lt(s, zero), zero, hn::IfThenElse(hn::Lt(length, s), length, s));
        }
    };

    HWY_INLINE Quadratic quadratic(Double h00, Double h10, Double h01, Double h11) const {
        const Double x = hn::Sub(slab_.x_at(in_), column_), y = hn::Sub(slab_.y_at(in_), row_);
        const Double along_x = hn::Sub(h10, h00), along_y = hn::Sub(h01, h00);
        const Double twist = hn::Sub(hn::Sub(h11, h01), along_x);
        const Double slope_x = hn::Add(along_x, hn::Mul(twist, y));
        const Double slope_y = hn::Add(along_y, hn::Mul(twist, x));
        Quadratic f;
        f.a = hn::Mul(hn::Mul(hn::Neg(twist), slab_.step_x), slab_.step_y);
        f.b = hn::Sub(number(-1), hn::Add(hn::Mul(slope_x, slab_.step_x), hn::Mul(slope_y, slab_.step_y)));
        f.c = hn::Sub(hn::Sub(one_, in_), hn::Add(hn::Add(h00, hn::Mul(along_x, x)), hn::Mul(slope_y, y)));
        return f;
    }

    /// Lanes that enter the relief on its top have hit it; those that come in beneath the sheet are not decided here.
    HWY_INLINE void start_on_sheet(const Quadratic& f, DoubleMask at_start) {
        const DoubleMask from_above = hn::Le(in_, zero_);
        const DoubleMask starts = hn::And(active_, at_start);
        const DoubleMask on_top = hn::And(hn::And(starts, from_above), hn::Le(f.c, number(entry_tolerance)));
        const DoubleMask beneath = hn::And(hn::AndNot(from_above, starts), hn::Lt(f.c, zero_));
        crossing_ = hn::IfThenElse(on_top, zero_, crossing_);
        active_ = hn::AndNot(hn::Or(on_top, beneath), active_);
    }

    /// Into the next cell; out of the relief, where that ends before.
    HWY_INLINE void step() {
        const DoubleMask leaves = hn::And(active_, hn::Ge(exit_, slab_.last));
        crossing_ = hn::IfThenElse(leaves, number(crosses_nowhere), crossing_);
        active_ = hn::AndNot(leaves, active_);
        const DoubleMask by_x = hn::Le(out_x_, out_y_);
        column_ = hn::IfThenElse(by_x, hn::Add(column_, hn::Sub(hn::Add(right_, right_), one_)), column_);
        row_ = hn::IfThenElse(by_x, row_, hn::Add(row_, hn::Sub(hn::Add(up_, up_), one_)));
        in_x_ = hn::IfThenElse(by_x, out_x_, in_x_);
        in_y_ = hn::IfThenElse(by_x, in_y_, out_y_);
        in_ = exit_;
        cross_border();
        out_x_ = wall_x(right_);
        out_y_ = wall_y(up_);
    }

    /// From the map's last cell to the first of the next copy, with the axis.
    HWY_INLINE void cross_border() {
        const Double width = number(scene_.width), height = number(scene_.height);
        const DoubleMask left_x = hn::Or(hn::Lt(column_, zero_), hn::Ge(column_, width));
        const DoubleMask left_y = hn::Or(hn::Lt(row_, zero_), hn::Ge(row_, height));
        const DoubleMask left = hn::Or(left_x, left_y);
        if (hn::AllFalse(d_, left)) return;
        const DoubleMask right = hn::Gt(right_, zero_), up = hn::Gt(up_, zero_);
        slab_.x =
            hn::IfThenElse(left_x, hn::IfThenElse(right, hn::Sub(slab_.x, width), hn::Add(slab_.x, width)), slab_.x);
        slab_.y =
            hn::IfThenElse(left_y, hn::IfThenElse(up, hn::Sub(slab_.y, height), hn::Add(slab_.y, height)), slab_.y);
        column_ = hn::IfThenElse(left_x, hn::IfThenElse(right, zero_, hn::Sub(width, one_)), column_);
        row_ = hn::IfThenElse(left_y, hn::IfThenElse(up, zero_, hn::Sub(height, one_)), row_);
        slab_.first = hn::IfThenElse(left, in_, slab_.first);
    }

    const Doubles d_;
    const Double zero_ = number(0);
    const Double one_ = number(1);
    const PacketScene& scene_;
    PacketLanes& lanes_;
    std::size_t at_;
    SlabLanes slab_;
    DoubleMask active_ = hn::MaskFromVec(number(0));
    Double crossing_ = number(0);
    /// 1 where the coordinate grows.
    Double right_ = number(0), up_ = number(0);
    Double column_ = number(0), row_ = number(0);
    /// Parameters of the cell's walls, and of where the ray enters and leaves it.
    Double in_x_ = number(0), in_y_ = number(0), out_x_ = number(0), out_y_ = number(0);
    Double in_ = number(0), exit_ = number(0);
};

}  // namespace reliefbench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
