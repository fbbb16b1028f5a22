#include "report/cautions.hpp"

#include "core/counted.hpp"
#include "core/json_lookup.hpp"
#include "core/suggest.hpp"
#include "report/quality_cost.hpp"
#include "report/ranking.hpp"
#include "report/text_layout.hpp"
#include "store/chosen_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace reliefbench {

namespace {

/// Of the footprint.
constexpr double many_ties = 0.01;

/// Nothing where the axis is none of the cell's.
Json axis(const CellResult& cell, const char* name) {
    const auto found = cell.axes.find(name);
    return found == cell.axes.end() ? Json(nullptr) : *found;
}

bool is_head_on(const CellResult& cell) {
    return axis(cell, "view_angle") == 0.0;
}

/// Of a perspective view no more than a line of pixels is.
bool has_rays_along_texels(const CellResult& cell) {
    const Json azimuth = axis(cell, "azimuth");
    return axis(cell, "projection") == "parallel" && azimuth.is_number() && std::fmod(azimuth.get<double>(), 90.0) == 0;
}

std::string caution_of_ties(const std::vector<CellResult>& cells) {
    std::set<std::string> views;
    std::pair<double, std::string> most;
    for (const CellResult& cell : cells) {
        const double ties = value_of(chosen_figures::ties, cell).value_or(0);
        if (ties <= many_ties) continue;
        const std::string view = split_cell_id(cell.cell).second;
        views.insert(view);
        most = std::max(most, {ties, view});
    }
    if (views.empty()) return "";
    return fmt::format(
        "in {} more than 1 % of the footprint are ties (up to {}: {:.2g} %): rays that only touch the surface, on "
        "edges of "
        "texels; errors of hits leave them out and those of images count them; change the resolution or the azimuth a "
        "little",
        counted(views.size(), "view"), most.second.empty() ? "the default view" : most.second, 100 * most.first);
}

std::string caution_of_axes(const std::vector<CellResult>& cells) {
    bool any = false;
    for (const CellResult& cell : cells) {
        if (!wrong_hits(cell) || is_head_on(cell)) continue;
        if (!has_rays_along_texels(cell)) return "";
        any = true;
    }
    if (!any) return "";
    return "all rays run along rows or columns of texels, where the surface is straight within each texel: errors of "
           "refinements come out too small; add views off the axes (-a azimuth=-67,-45)";
}

/// Of `group`, which is "axes" of the view or "parameters" of the technique, the value of a cell that is not at its
/// default; null else, and where the cell has none.
Json set_value(const CellResult& cell, const std::string& group, const std::string& name, const Json& record) {
    const bool is_axis = group == "axes";
    const Json& values = is_axis ? cell.axes : cell.parameters;
    const auto found = values.find(name);
    if (found == values.end()) return nullptr;
    const Json default_value = is_axis
                                   ? value_at(record, {"defaults", "axes", name.c_str()})
                                   : value_at(record, {"defaults", "parameters", cell.technique.c_str(), name.c_str()});
    return *found == default_value ? Json(nullptr) : *found;
}

}  // namespace

std::vector<std::string> cautions(const std::vector<CellResult>& cells, const Json& record) {
    std::vector<std::string> all;
    for (std::string text : {caution_of_ties(cells), caution_of_axes(cells), caution_of_truth(cells, record)}) {
        if (!text.empty()) all.push_back(std::move(text));
    }
    return all;
}

std::string caution_of_truth(const std::vector<CellResult>& cells, const Json& record) {
    if (truth_samples(record) > 1) return "";
    static const std::vector<std::pair<std::string, std::string>> filters = {
        {"axes", "material_filter"}, {"axes", "samples_per_pixel"}, {"axes", "frames"}, {"parameters", "start_offset"}};
    std::vector<std::string> set;
    for (const auto& [group, name] : filters) {
        if (std::ranges::any_of(cells, [&](const CellResult& cell) {
                return value_of(chosen_figures::flip, cell) && !set_value(cell, group, name, record).is_null();
            }))
            set.push_back(name);
    }
    if (set.empty()) return "";
    return fmt::format(
        "pictures are compared with a truth of one sample a pixel, which counts as errors what {} {} for; "
        "\"truth\": {{\"samples\": 64}} in the configuration compares with what a player should see",
        join(set), set.size() == 1 ? "is" : "are");
}

}  // namespace reliefbench
