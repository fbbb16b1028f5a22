#include "reference/ray_cubic.hpp"

namespace reliefbench {

namespace {

/// Between them the cubic rises or falls.
struct TurningPoints {
    std::array<double, 2> places{};
    std::size_t count = 0;
};

TurningPoints turning_points(const Cubic& cubic, double from, double to) {
    const double a = 3 * cubic.c[3];
    const double half_b = cubic.c[2];
    const double c = cubic.c[1];
    const double discriminant = half_b * half_b - a * c;
    TurningPoints found;
    if (discriminant <= 0) return found;
    const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
    // Quotients that are infinite lie outside.
    for (const double place : {q / a, c / q}) {
        if (place > from && place < to) found.places[found.count++] = place;
    }
    if (found.count == 2 && found.places[0] > found.places[1]) std::swap(found.places[0], found.places[1]);
    return found;
}

}  // namespace

CubicRoots crossings(const Cubic& cubic, double level, double from, double to) {
    CubicRoots roots;
    const Cubic::Range range = cubic.range(from, to);
    if (range.low > level || range.high < level) return roots;
    const TurningPoints turns = turning_points(cubic, from, to);
    double start = from;
    for (std::size_t part = 0; part <= turns.count; ++part) {
        const double end = part < turns.count ? turns.places[part] : to;
        const double at_start = cubic.at(start) - level;
        const double at_end = cubic.at(end) - level;
        if ((at_start >= 0) != (at_end >= 0)) {
            roots.places[roots.count++] = bracketed_root(
                start, end, at_start, 1e-14, [&](double s) { return cubic.at(s) - level; },
                [&](double s) { return cubic.slope(s); });
        }
        start = end;
    }
    return roots;
}

}  // namespace reliefbench
