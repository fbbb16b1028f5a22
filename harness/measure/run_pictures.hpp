#pragma once

#include "measure/pictures.hpp"
#include "store/run_folder.hpp"

#include <string>

namespace reliefbench {

/// images/ of a run: <cell>.png, <cell>.truth.png and, by the names of their scales, <cell>.<map>.png of UV error,
/// FLIP, taps and depth error. All have the cell's resolution, pixel for pixel.
void write_cell_pictures(RunWriter& writer, const std::string& cell, const DrawnCell& drawn);

/// legend.<map>.png: what the colours of the maps mean.
void write_legends(RunWriter& writer);

}  // namespace reliefbench
