#pragma once

#include "compare/ratio_estimate.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace reliefbench {

enum class Verdict { same, faster, slower, undecided };

std::string_view to_string(Verdict verdict);

/// Verdicts on cells that were compared together. `slower` and `faster`: the p-value of exceeding the threshold passes
/// Benjamini & Hochberg (1995) over all cells at `false_discovery_rate`, and the 95 % interval lies beyond the
/// threshold. `same`: the interval lies inside ±threshold. Else `undecided`.
std::vector<Verdict> decide(std::span<const RatioEstimate> estimates, double threshold, double false_discovery_rate);

}  // namespace reliefbench
