#pragma once

#include "compare/history.hpp"
#include "report/comparison_table.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace reliefbench {

/// How a history is written.
enum class HistoryFormat { table, markdown, json };

/// In the order of the enumerators, as the command line writes them.
const std::vector<std::string>& history_format_names();
/// An unknown name is an Error.
HistoryFormat parse_history_format(const std::string& name);

/// The series of each cell with its change points marked, the cells that moved together, and what changed in the runs'
/// records at the same time. `columns` is for the table only.
std::string format_history(const History& history, HistoryFormat format, std::size_t columns = widest_table);

}  // namespace reliefbench
