#include "report/csv.hpp"

#include "report/flat_fields.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace reliefbench {

namespace {

/// With everything that is always there, so that columns do not depend on which cells failed.
CellResult complete_cell() {
    CellResult cell;
    cell.time["draw"] = {};
    cell.work = CellResult::Work{};
    CellResult::Errors errors;
    errors.uv_texels = errors.depth = errors.normal_deg = Summary{};
    errors.shadow = CellResult::ShadowErrors{};
    cell.error = errors;
    cell.image = CellResult::ImageFields{};
    CellResult::Motion motion;
    motion.texels = motion.flip = CellResult::MotionFigure{};
    cell.motion = motion;
    return cell;
}

std::string group_of(const std::string& column) {
    return column.substr(0, column.find('.'));
}

/// The names of all columns: by group, in the order in which they are first met.
class Columns {
public:
    void add(const std::string& column) {
        const std::string group = group_of(column);
        auto found =
            std::find_if(groups_.begin(), groups_.end(), [&](const auto& each) { return each.first == group; });
        if (found == groups_.end()) found = groups_.insert(groups_.end(), {group, {}});
        std::vector<std::string>& names = found->second;
        if (std::find(names.begin(), names.end(), column) == names.end()) names.push_back(column);
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

std::string value_text(const Json& value) {
    if (value.is_null()) return "";
    if (value.is_string()) return quoted(value.get<std::string>());
    return value.dump();
}

std::string row_line(const std::vector<std::string>& texts) {
    std::string line;
    for (std::size_t column = 0; column < texts.size(); ++column) {
        line += (column == 0 ? "" : ",") + texts[column];
    }
    return line + '\n';
}

}  // namespace

std::string format_csv(const Run& run) {
    Columns columns;
    for (const auto& [column, value] : flat_fields(complete_cell())) {
        columns.add(column);
    }
    for (const CellResult& cell : run.cells) {
        for (const auto& [column, value] : flat_fields(cell)) {
            columns.add(column);
        }
    }
    const std::vector<std::string> names = columns.names();
    std::vector<std::string> titles;
    for (const std::string& name : names) {
        titles.push_back(quoted(name));
    }
    std::string csv = row_line(titles);
    for (const CellResult& cell : run.cells) {
        std::map<std::string, std::string> texts;
        for (const auto& [column, value] : flat_fields(cell)) {
            texts[column] = value_text(value);
        }
        std::vector<std::string> row;
        for (const std::string& name : names) {
            row.push_back(texts[name]);
        }
        csv += row_line(row);
    }
    return csv;
}

}  // namespace reliefbench
