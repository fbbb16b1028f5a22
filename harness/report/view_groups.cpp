#include "report/view_groups.hpp"

#include "report/quality_cost.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace reliefbench {

namespace {

/// Axes by which the cells differ, but those that are pooled.
std::vector<std::string> dividing_axes(const std::vector<CellResult>& cells) {
    std::vector<std::string> order;
    std::map<std::string, std::set<std::string>> values;
    for (const CellResult& cell : cells) {
        if (!is_measured(cell) || !cell.axes.is_object()) continue;
        for (const auto& [axis, value] : cell.axes.items()) {
            if (value.is_null() || std::ranges::find(pooled_axes, axis) != std::end(pooled_axes)) continue;
            if (!values.contains(axis)) order.push_back(axis);
            values[axis].insert(value.dump());
        }
    }
    std::erase_if(order, [&](const std::string& axis) { return values.at(axis).size() < 2; });
    return order;
}

}  // namespace

bool is_measured(const CellResult& cell) {
    return cell.status == CellStatus::ok && draw_timing(cell) != nullptr;
}

ViewGroup group_of_all_views(const std::vector<CellResult>& cells) {
    ViewGroup group;
    for (const CellResult& cell : cells) {
        if (is_measured(cell)) group.cells.push_back(&cell);
    }
    return group;
}

std::vector<ViewGroup> groups_of_views(const std::vector<CellResult>& cells) {
    const std::vector<std::string> dividing = dividing_axes(cells);
    std::vector<ViewGroup> groups;
    for (const CellResult& cell : cells) {
        if (!is_measured(cell)) continue;
        std::vector<std::pair<std::string, Json>> axes;
        for (const std::string& axis : dividing) {
            const Json value = cell.axes.is_object() ? cell.axes.value(axis, Json()) : Json();
            if (!value.is_null()) axes.emplace_back(axis, value);
        }
        auto group = std::ranges::find(groups, axes, &ViewGroup::axes);
        if (group == groups.end()) group = groups.insert(groups.end(), ViewGroup{axes, {}});
        group->cells.push_back(&cell);
    }
    return groups;
}

}  // namespace reliefbench
