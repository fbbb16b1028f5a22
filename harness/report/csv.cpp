#include "report/csv.hpp"

#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "report/flat_fields.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace reliefbench {

namespace {

/// With everything that a cell may have, so that columns do not depend on which cells failed.
CellResult complete_cell(const std::shared_ptr<const FigureList>& figures) {
    CellResult cell(figures);
    cell.time[draw_pass] = {};
    for (std::size_t index = 0; index < figures->all().size(); ++index)
        cell.figures.set(index, std::numeric_limits<double>::quiet_NaN());
    return cell;
}

std::string group_of(const std::string& column) {
    return column.substr(0, column.find('.'));
}

/// The names of all columns: by group, in the order in which they are first met.
class Columns {
public:
    void add(const std::string& column) {
        if (!known_.insert(column).second) return;
        const std::string group = group_of(column);
        auto found =
            std::find_if(groups_.begin(), groups_.end(), [&](const auto& each) { return each.first == group; });
        if (found == groups_.end()) found = groups_.insert(groups_.end(), {group, {}});
        found->second.push_back(column);
    }

    void add(const CellResult& cell) {
        for (const auto& [column, value] : flat_fields(cell))
            add(column);
    }

    void add(const Columns& others) {
        for (const auto& [group, names] : others.groups_) {
            for (const std::string& name : names)
                add(name);
        }
    }

    /// Less those that stand for a whole object which is null somewhere ("error").
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& [group, names] : groups_) {
            std::copy_if(names.begin(), names.end(), std::back_inserter(all), [&names = names](const auto& name) {
                return std::none_of(names.begin(), names.end(),
                                    [&](const auto& other) { return other.starts_with(name + "."); });
            });
        }
        return all;
    }

private:
    std::unordered_set<std::string> known_;
    std::vector<std::pair<std::string, std::vector<std::string>>> groups_;
};

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char character : text) {
        result += character == '"' ? std::string("\"\"") : std::string(1, character);
    }
    return result + '"';
}

/// What a spreadsheet would run as a formula begins with a quote, by which spreadsheets know text; numbers stay as they
/// are.
std::string without_formula(const std::string& text) {
    const bool is_formula = !text.empty() &&
                            std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos &&
                            !whole_text_as<double>(text);
    return is_formula ? "'" + text : text;
}

std::string value_text(const Json& value) {
    if (value.is_null()) return "";
    if (value.is_string()) return quoted(without_formula(value.get<std::string>()));
    return value.dump();
}

std::string csv_line(const std::vector<std::string>& texts) {
    std::string line;
    for (std::size_t column = 0; column < texts.size(); ++column) {
        line += (column == 0 ? "" : ",") + texts[column];
    }
    return line + '\n';
}

/// The cell's value of every column.
std::string cell_line(const CellResult& cell, const std::vector<std::string>& columns) {
    std::unordered_map<std::string, std::string> texts;
    for (const auto& [column, value] : flat_fields(cell)) {
        texts[column] = value_text(value);
    }
    std::vector<std::string> row;
    for (const std::string& column : columns) {
        row.push_back(texts[column]);
    }
    return csv_line(row);
}

}  // namespace

std::string format_csv(const Run& run) {
    constexpr std::size_t cells_at_a_time = 64;
    const std::size_t count = run.cells.size();
    std::vector<Columns> found((count + cells_at_a_time - 1) / cells_at_a_time);
    parallel_for(count, cells_at_a_time, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell)
            found[begin / cells_at_a_time].add(run.cells[cell]);
    });
    Columns columns;
    columns.add(complete_cell(run.figures));
    for (const Columns& part : found)
        columns.add(part);
    const std::vector<std::string> names = columns.names();
    std::vector<std::string> titles;
    for (const std::string& name : names) {
        titles.push_back(quoted(without_formula(name)));
    }
    std::vector<std::string> lines(count);
    parallel_for(count, cells_at_a_time, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell)
            lines[cell] = cell_line(run.cells[cell], names);
    });
    std::string csv = csv_line(titles);
    for (const std::string& line : lines) {
        csv += line;
    }
    return csv;
}

}  // namespace reliefbench
