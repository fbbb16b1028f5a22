#include "core/error.hpp"
#include "core/suggest.hpp"
#include "sweep/condition.hpp"
#include "sweep/configuration.hpp"
#include "sweep/override.hpp"

#include <algorithm>
#include <functional>

namespace reliefbench {

namespace {

struct Filter {
    enum class Comparison { equal, not_equal, less, less_or_equal, greater, greater_or_equal };
    std::string name;
    Comparison comparison = Comparison::equal;
    std::vector<Json> values;
};

struct Operator {
    std::string_view text;
    Filter::Comparison comparison;
};

/// Longer ones first, as "<" is the beginning of "<=".
constexpr Operator operators[] = {{"!=", Filter::Comparison::not_equal},
                                  {"<=", Filter::Comparison::less_or_equal},
                                  {">=", Filter::Comparison::greater_or_equal},
                                  {"=", Filter::Comparison::equal},
                                  {"<", Filter::Comparison::less},
                                  {">", Filter::Comparison::greater}};

bool is_order(Filter::Comparison comparison) {
    return comparison != Filter::Comparison::equal && comparison != Filter::Comparison::not_equal;
}

Filter parse_filter(const std::string& text, const ManifestIndex& manifests) {
    const std::string argument = "--filter " + text;
    const std::size_t begin = text.find_first_of("!<>=");
    const auto found = begin == std::string::npos || begin == 0
                           ? std::end(operators)
                           : std::ranges::find_if(operators, [&](const Operator& candidate) {
                                 return text.compare(begin, candidate.text.size(), candidate.text) == 0;
                             });
    if (found == std::end(operators) || begin + found->text.size() == text.size()) {
        fail("{}: expected name=value,value or one of != < <= > >= instead of =", argument);
    }
    Filter filter;
    filter.name = text.substr(0, begin);
    filter.comparison = found->comparison;
    const Json nothing;
    check_quantity_name(JsonView(nothing, argument, filter.name), filter.name, manifests);
    for (const Json& value : parse_values(filter.name, text.substr(begin + found->text.size()), argument)) {
        const JsonView view(value, argument, filter.name);
        if (!is_order(filter.comparison)) {
            filter.values.push_back(read_quantity_value(view, filter.name, manifests));
        } else {
            filter.values.emplace_back(view.number());
        }
    }
    if (is_order(filter.comparison) && filter.values.size() != 1) fail("{}: expected one number", argument);
    return filter;
}

bool passes(const Filter& filter, const Json& quantity) {
    const auto equals = [&](const Json& value) { return quantity_equals(filter.name, quantity, value); };
    if (filter.comparison == Filter::Comparison::equal) return std::ranges::any_of(filter.values, equals);
    if (filter.comparison == Filter::Comparison::not_equal) return std::ranges::none_of(filter.values, equals);
    if (!quantity.is_number()) return false;
    const double number = quantity.get<double>();
    const double bound = filter.values.front().get<double>();
    switch (filter.comparison) {
        case Filter::Comparison::less:
            return number < bound;
        case Filter::Comparison::less_or_equal:
            return number <= bound;
        case Filter::Comparison::greater:
            return number > bound;
        default:
            return number >= bound;
    }
}

}  // namespace

std::vector<Cell> filter_cells(std::vector<Cell> cells, const std::vector<std::string>& filters,
                               const std::vector<Manifest>& techniques) {
    const ManifestIndex manifests = index_manifests(techniques);
    std::vector<Filter> parsed;
    for (const std::string& text : filters)
        parsed.push_back(parse_filter(text, manifests));
    std::erase_if(cells, [&](const Cell& cell) {
        return !std::ranges::all_of(
            parsed, [&](const Filter& filter) { return passes(filter, cell_quantity(cell, filter.name, manifests)); });
    });
    if (cells.empty() && !filters.empty()) {
        fail("--filter {}: no cell of the configuration passes; --dry-run without it lists what there is",
             join(filters, " --filter "));
    }
    return cells;
}

}  // namespace reliefbench
