#pragma once

#include "picture/picture.hpp"
#include "picture/text.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// Pictures in rows and columns with labels, on white.
struct Sheet {
    struct Column {
        std::string title;
        /// Below the column's last picture; of no size for none.
        Picture legend;
    };
    struct Row {
        /// What the row is, larger than the lines below it.
        std::string title;
        std::vector<std::string> lines;
        /// One per column, or none where there is nothing to show.
        std::vector<Picture> pictures;
    };

    /// Over the whole; empty for none.
    std::string title;
    std::vector<Column> columns;
    std::vector<Row> rows;
};

/// Row labels, if there are any, stand at the left. Columns are as wide as what is in them; titles too long for their
/// place are shortened.
Picture draw_sheet(const Sheet& sheet, const Font& font);

}  // namespace reliefbench
