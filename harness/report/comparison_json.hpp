#pragma once

#include "compare/comparison.hpp"

#include <string>

namespace reliefbench {

/// `{"cells": [{"cell", "verdict", "ratio", "ci95": [low, high], "visible", "reason", ...}, ...], "uncompared": [...],
/// "notices": [...], "summary": {...}, "threshold", "unit", "environment": {...}}`. Ratios are new / base, `visible`
/// and `threshold` fractions. Finite numbers only; what is undefined is null.
Json comparison_to_json(const Comparison& comparison);
/// The same less `cells`.
Json comparison_without_cells(const Comparison& comparison);
/// `{"field", "base", "new", "worse", "better"}`.
Json quality_change_to_json(const QualityChange& change);

/// One document, indented.
std::string format_comparison_json(const Comparison& comparison);

}  // namespace reliefbench
