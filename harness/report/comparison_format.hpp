#pragma once

#include "report/comparison_table.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// How a comparison is written.
enum class ComparisonFormat { table, markdown, json, github };

/// In the order of the enumerators, as the command line writes them.
const std::vector<std::string>& comparison_format_names();
/// An unknown name is an Error.
ComparisonFormat parse_comparison_format(const std::string& name);

/// `table` is for the format of that name only.
std::string format_comparison(const Comparison& comparison, ComparisonFormat format,
                              const ComparisonTableOptions& table = {});

}  // namespace reliefbench
