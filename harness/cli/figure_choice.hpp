#pragma once

#include "compare/stored_run.hpp"
#include "store/figures.hpp"

#include <span>
#include <string>

namespace reliefbench {

/// The figure that an option names, of this version or of a later one that made one of the runs; one that there is not
/// is an Error that names `option`, with those that a short name ("flip", "uv p99") may mean, else a "did you mean" by
/// its spelling.
const FigureDeclaration& chosen_figure(const std::string& path, const std::string& option,
                                       std::span<const StoredRun> runs = {});

}  // namespace reliefbench
