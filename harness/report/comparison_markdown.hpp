#pragma once

#include "compare/comparison.hpp"

#include <string>

namespace reliefbench {

/// Fit for a comment on a pull request: what changed in one table, the rest folded. Long lists are cut, so that the
/// text stays below what GitHub takes for a comment (65,536 characters).
std::string format_comparison_markdown(const Comparison& comparison);

}  // namespace reliefbench
