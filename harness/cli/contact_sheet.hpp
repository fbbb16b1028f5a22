#pragma once

#include "cli/render_options.hpp"
#include "measure/laboratory.hpp"
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

struct ContactSheet {
    Sheet sheet;
    /// Cells that failed. Skipped ones are none.
    std::size_t failures = 0;
};

/// One row per cell, labelled with its technique, its sample count, parameters that are not at their defaults, the axes
/// in which cells differ, errors and taps, and where it is skipped or failed with that and why, which is told, too. A
/// failed cell that was drawn has its pictures all the same, to see where it fails.
ContactSheet make_contact_sheet(const std::vector<Cell>& cells, const std::vector<Shown>& shown, Laboratory& laboratory,
                                const LaboratoryCallbacks& callbacks, const Font& font);

/// Says that the cell is skipped or failed, and why; nothing of one that is not.
void tell_ending(const CellResult& result);

}  // namespace reliefbench
