#pragma once

#include "compare/ratio_estimate.hpp"
#include "compare/verdict.hpp"

#include <string>
#include <string_view>

namespace reliefbench {

/// A fraction as a change in per cent: 0.072 is "7.2 %". `signed_percent` writes "+7.2 %" or "−7.2 %".
std::string percent(double fraction);
std::string signed_percent(double fraction);

/// Why the verdict, what could have been seen, what would decide, in words; `unit` is "runs" or "rounds":
/// "slower by 7.2 % (95 %: 5.1 to 9.4 %), 5 runs a side".
std::string describe(const RatioEstimate& estimate, Verdict verdict, std::string_view unit);

}  // namespace reliefbench
