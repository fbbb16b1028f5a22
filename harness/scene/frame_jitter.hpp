#pragma once

#include <glm/vec2.hpp>

#include <cassert>

namespace reliefbench {

/// The digits of `index` in the base, mirrored at the point: in [0, 1).
constexpr double radical_inverse(int index, int base) {
    double sum = 0;
    double place = 1;
    for (; index > 0; index /= base) {
        place /= base;
        sum += place * (index % base);
    }
    return sum;
}

/// How far beside the pixels' centres the rays of frame 0, 1, ... of a sequence run, to the right and downwards, in
/// pixels: the points 1, 2, ... of Halton's sequence in the bases 2 and 3 about the centre, as engines jitter the
/// camera under temporal antialiasing. In [-½, ½); divided by the picture's size it is Camera::shift.
inline glm::dvec2 frame_jitter(int frame) {
    assert(frame >= 0);
    return glm::dvec2(radical_inverse(frame + 1, 2), radical_inverse(frame + 1, 3)) - 0.5;
}

}  // namespace reliefbench
