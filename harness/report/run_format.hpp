#pragma once

#include "report/table.hpp"
#include "store/run_folder.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// What a finished run prints: the table for eyes, or a format for scripts. json is an array of the cells as
/// cells.jsonl has them.
enum class RunFormat { table, markdown, csv, json };

/// In the order of the enumerators, as the command line writes them.
const std::vector<std::string>& run_format_names();
/// An unknown name is an Error.
RunFormat parse_run_format(const std::string& name);

/// `style` is of the table.
std::string format_run(const Run& run, RunFormat format, const TableStyle& style);

}  // namespace reliefbench
