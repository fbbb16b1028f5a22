#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace reliefbench {

/// A cubic of s: c[0] + c[1]·s + c[2]·s² + c[3]·s³.
struct Cubic {
    std::array<double, 4> c{};

    double at(double s) const { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); }
    double slope(double s) const { return c[1] + s * (2 * c[2] + s * 3 * c[3]); }

    /// With values and slopes given at 0 and 1.
    static Cubic hermite(double at_0, double slope_0, double at_1, double slope_1) {
        const double rise = at_1 - at_0;
        return {{at_0, slope_0, 3 * rise - 2 * slope_0 - slope_1, slope_0 + slope_1 - 2 * rise}};
    }

    struct Range {
        double low;
        double high;
    };
    /// That contains all values over [from, to] (the control points' of its Bézier form).
    Range range(double from, double to) const {
        const double first = at(from);
        const double last = at(to);
        const double third = (to - from) / 3;
        const double second = first + slope(from) * third;
        const double before_last = last - slope(to) * third;
        return {std::min(std::min(first, second), std::min(before_last, last)),
                std::max(std::max(first, second), std::max(before_last, last))};
    }
};

/// At most three places in ascending order.
struct CubicRoots {
    std::array<double, 3> places{};
    std::size_t count = 0;
};

/// The root in [from, to] of what has different signs at both ends: f(s) and its slope are asked for.
template <typename Value, typename Slope>
double bracketed_root(double from, double to, double at_from, double tolerance, const Value& value,
                      const Slope& slope) {
    constexpr int max_steps = 100;
    double low = from;
    double high = to;
    double s = (from + to) / 2;
    for (int step = 0; step < max_steps && high - low > tolerance; ++step) {
        const double f = value(s);
        ((f >= 0) == (at_from >= 0) ? low : high) = s;
        const double next = s - f / slope(s);
        const bool stays = next > low && next < high;
        if (stays && std::abs(next - s) <= tolerance) return next;
        s = stays ? next : (low + high) / 2;
    }
    return s;
}

/// Where the cubic is `level` within (from, to), in `s` to about 1e-14; places at which it only touches that may be
/// left out.
CubicRoots crossings(const Cubic& cubic, double level, double from, double to);

}  // namespace reliefbench
