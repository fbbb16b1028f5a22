#include "picture/sheet.hpp"

#include "picture/style.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace reliefbench {

namespace {

constexpr int widest_label = 250;

struct Layout {
    int label_width = 0;
    int header_height = 0;
    std::vector<int> column_widths;
    std::vector<int> row_heights;
    int legend_height = 0;

    Resolution size() const {
        const int columns = static_cast<int>(column_widths.size());
        const int rows = static_cast<int>(row_heights.size());
        const int widths = std::accumulate(column_widths.begin(), column_widths.end(), label_width);
        const int heights = std::accumulate(row_heights.begin(), row_heights.end(), header_height + legend_height);
        return {widths + (columns - 1) * style::gap + 2 * style::margin,
                heights + rows * style::gap + 2 * style::margin};
    }
};

bool is_labelled(const Sheet::Row& row) {
    return !row.title.empty() || !row.lines.empty();
}

int label_height(const Sheet::Row& row, const Font& font) {
    return font.line_height(style::text) + static_cast<int>(row.lines.size()) * font.line_height(style::small_text);
}

int label_width(const Sheet::Row& row, const Font& font) {
    int width = font.width(row.title, style::text);
    for (const std::string& line : row.lines) {
        width = std::max(width, font.width(line, style::small_text));
    }
    return std::min(width, widest_label) + style::margin;
}

Layout lay_out(const Sheet& sheet, const Font& font) {
    Layout layout;
    layout.header_height = font.line_height(style::text);
    if (!sheet.title.empty()) layout.header_height += font.line_height(style::title_text) + style::gap;
    for (const Sheet::Column& column : sheet.columns) {
        layout.column_widths.push_back(column.legend.size.width);
        layout.legend_height = std::max(layout.legend_height, column.legend.size.height);
    }
    for (const Sheet::Row& row : sheet.rows) {
        assert(row.pictures.empty() || row.pictures.size() == sheet.columns.size());
        int height = 0;
        if (is_labelled(row)) {
            height = label_height(row, font);
            layout.label_width = std::max(layout.label_width, label_width(row, font));
        }
        for (std::size_t column = 0; column < row.pictures.size(); ++column) {
            const Resolution size = row.pictures[column].size;
            height = std::max(height, size.height);
            layout.column_widths[column] = std::max(layout.column_widths[column], size.width);
        }
        layout.row_heights.push_back(height);
    }
    return layout;
}

/// The largest of the sizes at which the title fits.
int title_size(const std::string& title, int width, const Font& font) {
    for (const int size : {style::title_text, style::text}) {
        if (font.width(title, size) <= width) return size;
    }
    return style::small_text;
}

void draw_label(Picture& picture, int left, int top, const Sheet::Row& row, const Font& font) {
    font.draw(picture, left, top, font.shortened(row.title, style::text, widest_label), style::text, style::ink);
    top += font.line_height(style::text);
    for (const std::string& line : row.lines) {
        font.draw(picture, left, top, font.shortened(line, style::small_text, widest_label), style::small_text,
                  style::pale_ink);
        top += font.line_height(style::small_text);
    }
}

}  // namespace

Picture draw_sheet(const Sheet& sheet, const Font& font) {
    const Layout layout = lay_out(sheet, font);
    Picture picture(layout.size(), style::paper);
    int top = style::margin;
    if (!sheet.title.empty()) {
        const int width = picture.size.width - 2 * style::margin;
        const int size = title_size(sheet.title, width, font);
        font.draw(picture, style::margin, top, font.shortened(sheet.title, size, width), size, style::ink);
    }
    top += layout.header_height;
    std::vector<int> lefts;
    int left = style::margin + layout.label_width;
    for (std::size_t column = 0; column < sheet.columns.size(); ++column) {
        const std::string title =
            font.shortened(sheet.columns[column].title, style::text, layout.column_widths[column]);
        font.draw(picture, left, top - font.line_height(style::text), title, style::text, style::ink);
        lefts.push_back(left);
        left += layout.column_widths[column] + style::gap;
    }
    for (std::size_t index = 0; index < sheet.rows.size(); ++index) {
        const Sheet::Row& row = sheet.rows[index];
        draw_label(picture, style::margin, top, row, font);
        for (std::size_t column = 0; column < row.pictures.size(); ++column) {
            paste(picture, lefts[column], top, row.pictures[column]);
        }
        top += layout.row_heights[index] + style::gap;
    }
    for (std::size_t column = 0; column < sheet.columns.size(); ++column) {
        paste(picture, lefts[column], top, sheet.columns[column].legend);
    }
    return picture;
}

}  // namespace reliefbench
