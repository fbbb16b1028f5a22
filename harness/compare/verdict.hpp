#pragma once

#include "compare/ratio_estimate.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace reliefbench {

enum class Verdict { same, faster, slower, undecided };

std::string_view to_string(Verdict verdict);

/// Verdicts on cells that were compared together. `slower` and `faster`: twice the p-value of exceeding the threshold
/// (either could have happened) passes Benjamini & Hochberg (1995) over all cells at `false_discovery_rate`, the
/// p-value of unchanged code is at most highest_p_unchanged, and the 95 % interval lies beyond the threshold. `same`:
/// the interval lies inside ±threshold. Else `undecided`.
std::vector<Verdict> decide(std::span<const RatioEstimate> estimates, double threshold, double false_discovery_rate);

/// The two-sided p-value that one more cell would have had to pass beside those decided: the level for which `visible`
/// of these estimates is honest.
double level_of_verdicts(std::span<const Verdict> verdicts, double false_discovery_rate);

/// Whether more evidence is not needed for the estimate alone: `same`, or beyond the threshold at the two-sided
/// `level`. With level = false_discovery_rate / number of cells, decide() then decides whatever the other cells do:
/// what a sampler stops at.
bool is_settled(const RatioEstimate& estimate, double threshold, double level);

}  // namespace reliefbench
