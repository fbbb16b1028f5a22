#pragma once

#include "store/cell_result.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reliefbench {

/// Axes that whoever asks for advice does not choose: which material is seen, and from which side. Views that differ in
/// these alone are of one kind, and a setting counts by the worst of them.
inline constexpr std::array<std::string_view, 2> pooled_axes{"heightmap", "azimuth"};

/// Whether the draw has a time.
bool is_measured(const CellResult& cell);

/// Measured cells of one kind of view.
struct ViewGroup {
    /// The axes by which this kind differs from the others of the run: "view_angle" and 60.
    std::vector<std::pair<std::string, Json>> axes;
    /// Of those given.
    std::vector<const CellResult*> cells;
};

/// By kind of view, in the order in which they are first met.
std::vector<ViewGroup> groups_of_views(const std::vector<CellResult>& cells);

/// All kinds together, without axes.
ViewGroup group_of_all_views(const std::vector<CellResult>& cells);

}  // namespace reliefbench
