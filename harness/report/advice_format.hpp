#pragma once

#include "report/advice.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace reliefbench {

/// How advice is written.
enum class AdviceFormat { table, json };

/// In the order of the enumerators, as the command line writes them.
const std::vector<std::string>& advice_format_names();
/// An unknown name is an Error.
AdviceFormat parse_advice_format(const std::string& name);

/// `columns`: the widest line of a table, unless a single word is wider.
std::string format_advice(const Advice& advice, AdviceFormat format, std::size_t columns);

}  // namespace reliefbench
