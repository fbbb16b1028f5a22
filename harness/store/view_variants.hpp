#pragma once

#include "store/cell_result.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// A cell's view in two parts.
struct ViewVariant {
    /// "heightmap=bricks view_angle=60": cells in which it is equal see the same hits.
    std::string view;
    /// "self_shadow=hard": what of the view moves no hit (sweep/view_axes.hpp), at its default or not. Empty where the
    /// cells do not differ in it.
    std::string variant;
};

/// Of each cell, for cells that are shown together: those that differ only in axes that move no hits then stand in one
/// view. A cell of a run that did not know an axis has it at its default.
std::vector<ViewVariant> view_variants(const std::vector<CellResult>& cells);

/// A value of an axis as ids write it: "view_angle=60".
std::string axis_word(const std::string& axis, const Json& value);

}  // namespace reliefbench
