#pragma once

#include "report/advice.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// What engines' presets pay and miss, and what is better for no more time: Advice without limits, whose presets
/// (ViewAdvice::presets) are in the order of their times. Empty where no cell with a preset was measured with its
/// errors. `record` is run.json's.
std::optional<Advice> answer_engines(const std::vector<CellResult>& cells, const Json& record);

/// As tables for the terminal, `columns` wide: of each kind of view the presets, under each what is better and what is
/// cheaper. Titles, and what no parameter expresses, are those of `record`'s presets.
std::string format_engines(const Advice& advice, const Json& record, std::size_t columns);

}  // namespace reliefbench
