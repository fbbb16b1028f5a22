#pragma once

#include "scene/image.hpp"

#include <vector>

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

}  // namespace reliefbench
