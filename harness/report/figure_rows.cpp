#include "report/figure_rows.hpp"

#include "report/text_layout.hpp"

#include <algorithm>
#include <cassert>

namespace reliefbench {

namespace {

/// The least that a cell's id gets: a terminal narrower than the figures and this is written over its edge.
constexpr std::size_t narrowest_id = 24;

std::string padded(const std::string& text, Alignment alignment, std::size_t width) {
    return alignment == Alignment::right ? pad_left(text, width) : pad_right(text, width);
}

}  // namespace

std::string format_figure_rows(const std::vector<FigureColumn>& figure_columns,
                               const std::vector<std::vector<std::string>>& figures,
                               const std::vector<std::string>& ids, std::size_t columns, const std::string& id_title) {
    assert(figures.size() == ids.size());
    std::vector<std::string> titles;
    std::vector<std::size_t> widths;
    std::size_t taken = space_between;
    for (std::size_t column = 0; column < figure_columns.size(); ++column) {
        titles.push_back(figure_columns[column].title);
        std::size_t width = text_width(titles.back());
        for (const std::vector<std::string>& row : figures) {
            width = std::max(width, text_width(row[column]));
        }
        widths.push_back(width);
        taken += space_between + width;
    }
    const std::size_t id_width = std::max(narrowest_id, columns - std::min(columns, taken));
    const auto line = [&](const std::vector<std::string>& row, const std::string& id) {
        std::string text;
        for (std::size_t column = 0; column < row.size(); ++column) {
            text +=
                std::string(space_between, ' ') + padded(row[column], figure_columns[column].alignment, widths[column]);
        }
        return text + std::string(space_between, ' ') + id + '\n';
    };
    std::string text = line(titles, id_title);
    for (std::size_t row = 0; row < figures.size(); ++row) {
        const std::vector<std::string> id = wrap(ids[row], id_width);
        text += line(figures[row], id.front());
        for (std::size_t rest = 1; rest < id.size(); ++rest) {
            text += std::string(taken, ' ') + id[rest] + '\n';
        }
    }
    return text;
}

}  // namespace reliefbench
