#pragma once

#include "store/figures.hpp"

#include <string>

namespace reliefbench {

/// The figure that an option names; one that there is not is an Error that names `option`, with those
/// that a short name ("flip", "uv p99") may mean, else a "did you mean" by its spelling.
const FigureDeclaration& chosen_figure(const std::string& path, const std::string& option);

}  // namespace reliefbench
