#pragma once

#include "cli/cell_drawing.hpp"
#include "cli/render_options.hpp"
#include "picture/sheet.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// Columns of what is shown, with legends of the maps.
std::vector<Sheet::Column> columns_of(const std::vector<Shown>& shown, const Font& font);

/// The same order.
std::vector<Picture> pictures_of(const std::vector<Shown>& shown, const DrawnCell& drawn);

/// The smallest rectangle with all pixels of the footprint and of the truth's relief, and a few more around it; the
/// whole picture where there is none.
Rectangle relief_rectangle(const Truth& truth);

/// One row per cell, labelled with its technique, its sample count, parameters that are not at their defaults, the axes
/// in which cells differ, errors and taps. A cell that cannot be drawn has its reason in place of pictures, and is
/// counted in `failures` unless it was skipped.
Sheet make_contact_sheet(const std::vector<Cell>& cells, const std::vector<Shown>& shown, CellDrawing& drawing,
                         const Font& font, std::size_t& failures);

}  // namespace reliefbench
