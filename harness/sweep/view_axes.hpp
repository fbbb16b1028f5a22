#pragma once

#include "core/json.hpp"
#include "sweep/cell.hpp"

#include <functional>
#include <string>
#include <vector>

namespace reliefbench {

/// Sets one value of an axis in a view.
using ViewSetting = std::function<void(ViewKey&)>;

/// What people are told of an axis.
struct AxisDescription {
    /// "degrees"; empty where it has none.
    std::string unit = {};
    /// "from 0 to below 90", "clip|repeat".
    std::string values = {};
    /// One line: meaning, and where it has a use.
    std::string help;
    /// What other programs call it, or a word for it that is no name here.
    std::vector<std::string> also_called = {};
};

/// An axis of the view: one row of the table that reading, ids and results share.
struct ViewAxis {
    std::string name;
    AxisDescription description;
    /// Checks the value: a wrong type or a value out of range is an Error that names file and JSON path.
    std::function<ViewSetting(const JsonView&)> read;
    /// The view's value as results write it, a scalar; null where the view has no use for the axis (a file's
    /// heightmap_size, the distance of parallel rays).
    std::function<Json(const ViewKey&)> value;
    /// What ids leave out: the value that a view has where nothing sets the axis. Null: ids always tell it.
    Json default_value = {};
    /// Whether what the truth hits depends on it. Not so: how a hit is lit, and what is left in the depth buffer.
    bool moves_hits = true;
    /// Ids and results have it in their word for the height map ("rock+albedo=a.png") and not by itself.
    bool part_of_height_map = false;
    /// `value` of a view that is taken to have a use for the axis; empty where all have.
    std::function<Json(const ViewKey&)> value_in_use = {};
};

/// In the order of ids and results; heightmap first.
const std::vector<ViewAxis>& view_axes();

/// `list axes` as JSON: an array of {"axis", "unit", "default", "values", "description"}, `sample_count` among them.
Json axis_list_json();

/// Names of axes (`sample_count`, too) that `word` is another word for; empty when it is for none.
std::vector<std::string> axes_also_called(const std::string& word);

/// Null when there is no such axis.
const ViewAxis* find_view_axis(const std::string& name);

/// The view with every axis that moves no hits at its default: where these are equal, so are the truth's hits.
ViewKey hits_view(ViewKey view);

/// One value chosen for an axis.
struct ViewChoice {
    const ViewAxis* axis = nullptr;
    const ViewSetting* setting = nullptr;
};

/// The choices in any order. What the view has no use for is left at its default, so that equal views are equal.
ViewKey make_view(const std::vector<ViewChoice>& choices);

/// The view's part of a cell's id: "heightmap=bricks view_angle=60".
std::string view_id(const ViewKey& view);

}  // namespace reliefbench
