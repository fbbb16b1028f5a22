#pragma once

namespace reliefbench {

/// IEC 61966-2-1, for one channel in [0, 1] (values outside are clamped).
double srgb_encode(double linear);
double srgb_decode(double encoded);

}  // namespace reliefbench
