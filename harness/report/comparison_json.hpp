#pragma once

#include "compare/comparison.hpp"

#include <string>

namespace reliefbench {

/// `{"cells": [{"cell", "verdict", "ratio", "ci95": [low, high], "visible", "reason", ...}, ...], "uncompared": [...],
/// "notices": [...], "summary": {...}, "threshold", "unit", "environment": {...}}`. Ratios are new / base, `visible`
/// and `threshold` fractions. Finite numbers only; what is undefined is null.
Json comparison_to_json(const Comparison& comparison);

/// One document, indented.
std::string format_comparison_json(const Comparison& comparison);

}  // namespace reliefbench
