#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace reliefbench {

enum class Alignment { left, right };

struct FigureColumn {
    std::string title;
    Alignment alignment = Alignment::right;
};

/// A table for the terminal whose rows end in a cell's id, or a setting: the figures of each row stand before it,
/// because it may be long or several lines and is wrapped under itself to fit into `columns`.
std::string format_figure_rows(const std::vector<FigureColumn>& figure_columns,
                               const std::vector<std::vector<std::string>>& figures,
                               const std::vector<std::string>& ids, std::size_t columns,
                               const std::string& id_title = "cell");

}  // namespace reliefbench
