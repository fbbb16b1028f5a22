#pragma once

#include <cstddef>
#include <span>

namespace reliefbench {

/// Values whose modified z-score exceeds 3.5 (Iglewicz & Hoaglin 1993): |x − median| > 3.5 · 1.4826 · MAD. Where more
/// than half of the values are equal the MAD is 0, and the mean absolute deviation takes its place, with the factor
/// 1.2533. They are told, never dropped.
std::size_t count_outliers(std::span<const double> values);

}  // namespace reliefbench
