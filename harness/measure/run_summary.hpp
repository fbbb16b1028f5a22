#pragma once

#include "core/json.hpp"
#include "measure/run.hpp"

#include <string>

namespace reliefbench {

/// The content of summary.json: how many cells ended how, why sampling stopped, and where the wall time went.
/// `empty_pass` is the record's (run.json).
Json make_run_summary(const RunOutcome& outcome, const Json& empty_pass);

/// The same as lines for the end of a run.
std::string format_run_summary(const RunOutcome& outcome, const Json& empty_pass);

}  // namespace reliefbench
