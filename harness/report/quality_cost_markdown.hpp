#pragma once

#include "store/run_folder.hpp"

#include <string>

namespace reliefbench {

/// Quality against cost, one table per view, as the table on the terminal has it; failed and skipped cells follow.
std::string format_quality_cost_markdown(const Run& run);

}  // namespace reliefbench
