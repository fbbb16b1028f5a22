#pragma once

#include "sweep/configuration.hpp"

#include <vector>

namespace reliefbench {

/// Warns where "-a" arguments do something else than they seem to ask for, judged by the cells that filters left of the
/// configuration: where axes of a zip that lost others to them are now combined with each of their values, and where a
/// value that was given is that of no cell.
void warn_of_overrides(const Configuration& configuration, const std::vector<Cell>& cells,
                       const std::vector<Manifest>& techniques);

}  // namespace reliefbench
