#pragma once

#include "compare/comparison.hpp"

#include <string>

namespace reliefbench {

/// `{"cells": [{"cell", "verdict", "ratio", "ci95": [low, high], "visible", "reason", ..., "quality": {"verdict",
/// "changes": [...]}}, ...], "uncompared": [...], "notices": [...], "summary": {...}, "deciding_figures": [{"figure",
/// "absolute", "relative", "tolerance"}, ...], "threshold", "unit", "environment": {...}}`. Ratios are new / base,
/// `visible` and `threshold` fractions. Finite numbers only; what is undefined is null. Of quality alone there is
/// nothing on times: no verdict, ratio ..., threshold and unit.
Json comparison_to_json(const Comparison& comparison);
/// The same less `cells`.
Json comparison_without_cells(const Comparison& comparison);
/// `{"field", "base", "new", "worse", "better", "decides", "tolerances", "text"}`: whether it is part of the verdict,
/// by how many tolerances it changed (null for endlessly many), and all of it in words.
Json quality_change_to_json(const QualityChange& change);

/// One document, indented.
std::string format_comparison_json(const Comparison& comparison);

}  // namespace reliefbench
