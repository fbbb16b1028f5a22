#pragma once

#include "core/statistics.hpp"
#include "store/cell_result.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reliefbench {

inline void set_figure(CellResult& cell, std::string_view path, double value) {
    cell.figures.set(path, value);
}

inline void set_figures(CellResult& cell, const std::vector<std::pair<std::string, double>>& values) {
    for (const auto& [path, value] : values)
        set_figure(cell, path, value);
}

inline void set_summary(CellResult& cell, const std::string& path, const Summary& summary) {
    set_figures(cell, {{path + ".mean", summary.mean},
                       {path + ".rms", summary.rms},
                       {path + ".p50", summary.p50},
                       {path + ".p95", summary.p95},
                       {path + ".p99", summary.p99},
                       {path + ".max", summary.max}});
}

/// Whether the path is that of the group, or leads through it.
inline bool is_in_group(std::string_view path, std::string_view group) {
    return path.starts_with(group) && (path.size() == group.size() || path[group.size()] == '.');
}

/// Every figure of a group ("error.shadow"), with the same value.
inline void set_group(CellResult& cell, std::string_view group, double value) {
    for (const FigureDeclaration& figure : cell.figures.list().all()) {
        if (is_in_group(figure.path, group)) set_figure(cell, figure.path, value);
    }
}

/// A figure, or all of a group.
inline void remove_figures(CellResult& cell, std::string_view group) {
    cell.figures.keep_only([&](const FigureDeclaration& figure) { return !is_in_group(figure.path, group); });
}

}  // namespace reliefbench
