#include "report/page_cells.hpp"

#include "report/flat_fields.hpp"
#include "report/quality_cost.hpp"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

namespace reliefbench {

namespace {

constexpr int no_value = -1;

/// Fields of words that every cell may have, by their path.
const std::vector<std::string> word_fields = {"technique", "status", "reason", "time.stop"};

/// Distinct values and which of them each cell has.
class ValueColumn {
public:
    void set(std::size_t cell, const Json& value) {
        if (value.is_null()) return;
        index_.resize(std::max(index_.size(), cell + 1), no_value);
        const auto [known, is_new] = known_.try_emplace(value.dump(), static_cast<int>(values_.size()));
        if (is_new) values_.push_back(value);
        index_[cell] = known->second;
    }

    Json to_json(std::size_t cells) {
        index_.resize(cells, no_value);
        return {{"values", values_}, {"index", index_}};
    }

private:
    Json values_ = Json::array();
    std::vector<int> index_;
    std::map<std::string, int> known_;
};

/// Columns in the order in which they are first met.
template <typename Column>
class NamedColumns {
public:
    Column& operator[](const std::string& name) {
        const auto [at, is_new] = position_.try_emplace(name, columns_.size());
        if (is_new) columns_.emplace_back(name, Column());
        return columns_[at->second].second;
    }
    std::vector<std::pair<std::string, Column>>& all() { return columns_; }

private:
    std::map<std::string, std::size_t> position_;
    std::vector<std::pair<std::string, Column>> columns_;
};

using NumberColumn = std::vector<std::optional<double>>;

Json to_json(NamedColumns<ValueColumn>& columns, std::size_t cells) {
    Json json = Json::object();
    for (auto& [name, column] : columns.all()) {
        json[name] = column.to_json(cells);
    }
    return json;
}

Json to_json(NamedColumns<NumberColumn>& columns, std::size_t cells) {
    Json json = Json::object();
    for (auto& [name, column] : columns.all()) {
        column.resize(cells);
        Json values = Json::array();
        for (const std::optional<double>& value : column) {
            values.push_back(value ? rounded_number(*value) : Json(nullptr));
        }
        json[name] = std::move(values);
    }
    return json;
}

void add_members(const Json& members, std::size_t cell, NamedColumns<ValueColumn>& columns) {
    if (!members.is_object()) return;
    for (const auto& [name, value] : members.items()) {
        columns[name].set(cell, value);
    }
}

/// What cells that were not measured are listed under: reasons that differ by figures alone are one.
void add_reason_groups(const std::vector<CellResult>& cells, NamedColumns<ValueColumn>& words) {
    std::map<const CellResult*, std::string> group_of;
    for (const CellStatus status : {CellStatus::failed, CellStatus::skipped}) {
        for (const ReasonGroup& group : group_by_reason(cells, status)) {
            for (const CellResult* cell : group.cells)
                group_of.emplace(cell, group.reason);
        }
    }
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        if (const auto found = group_of.find(&cells[cell]); found != group_of.end())
            words["reason_group"].set(cell, found->second);
    }
}

}  // namespace

Json rounded_number(double value) {
    if (!std::isfinite(value)) return nullptr;
    constexpr double largest_exact_integer = 9007199254740992.0;
    if (value == std::floor(value) && std::abs(value) < largest_exact_integer) {
        return static_cast<std::int64_t>(value);
    }
    return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

Json cells_to_columns(const std::vector<CellResult>& cells) {
    std::vector<std::string> ids;
    NamedColumns<ValueColumn> words, axes, parameters;
    NamedColumns<NumberColumn> numbers;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        ids.push_back(cells[cell].cell);
        add_members(cells[cell].axes, cell, axes);
        add_members(cells[cell].parameters, cell, parameters);
        for (const auto& [path, value] : flat_fields(cells[cell])) {
            if (path.starts_with("axes.") || path.starts_with("parameters.")) continue;
            if (std::find(word_fields.begin(), word_fields.end(), path) != word_fields.end()) {
                words[path].set(cell, value);
            } else if (value.is_number()) {
                NumberColumn& column = numbers[path];
                column.resize(cell + 1);
                column[cell] = value.get<double>();
            }
        }
    }
    add_reason_groups(cells, words);
    Json json;
    json["count"] = cells.size();
    json["id"] = ids;
    json["words"] = to_json(words, cells.size());
    json["axes"] = to_json(axes, cells.size());
    json["parameters"] = to_json(parameters, cells.size());
    json["numbers"] = to_json(numbers, cells.size());
    return json;
}

}  // namespace reliefbench
