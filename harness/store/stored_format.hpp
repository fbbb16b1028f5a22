#pragma once

#include "core/json.hpp"

namespace reliefbench {

/// What a run's folder holds and means (docs/stored_runs.md). Version 0.1.0 wrote format 1 and no number.
inline constexpr int stored_run_format = 2;

/// The member `format` of a run.json; 1 where it has none. An Error where a later version wrote it.
int format_of(const JsonView& record);

struct Run;

/// What parameters and axes were where nothing set them, as the run knew them:
/// `{"parameters": {technique: {name: value}}, "axes": {name: value}}`, each in the order of ids. A run of format 1
/// does not record them: its parameters' are those of cells whose ids leave them out, and its axes are unknown.
Json defaults_of(const Run& run);

}  // namespace reliefbench
