#pragma once

#include "scene/image.hpp"

#include <cstdint>

namespace reliefbench {

/// Where a ray passes from above the sheet to below it. u, v in patch coordinates (never wrapped), h the height in
/// [0, 1], t the distance along the unit ray from the eye (for parallel rays from z = 0). A miss is t = −1 and zeros.
struct Hit {
    float u = 0;
    float v = 0;
    float h = 0;
    float t = -1;

    bool is_hit() const { return t >= 0; }
    bool operator==(const Hit&) const = default;
};

using HitImage = Image<Hit>;

/// By pixel, whether it lies in the footprint F (docs/architecture.md): 0 outside; `in_footprint`; or
/// `tie_in_footprint` where the smallest shift of the ray gives another hit, so that no answer there is right or wrong.
using FootprintImage = Image<std::uint8_t>;
constexpr std::uint8_t in_footprint = 1;
constexpr std::uint8_t tie_in_footprint = 2;

}  // namespace reliefbench
