#include "core/error.hpp"
#include "core/suggest.hpp"
#include "sweep/condition.hpp"
#include "sweep/configuration.hpp"
#include "sweep/override.hpp"

#include <algorithm>
#include <span>

namespace reliefbench {

namespace {

struct Filter {
    enum class Comparison { equal, not_equal, less, less_or_equal, greater, greater_or_equal };
    std::string name;
    Comparison comparison = Comparison::equal;
    std::vector<Json> values;
    /// As written: "--filter view_angle>=60".
    std::string argument;
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
    filter.argument = argument;
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

/// What there is where a filter lets nothing pass, and how to get what it asks for.
std::string what_there_is(const Filter& filter, const std::vector<Cell>& cells, const ManifestIndex& manifests) {
    const std::vector<Json> there = distinct_quantities(cells, filter.name, manifests);
    const bool asks_for_one = filter.comparison == Filter::Comparison::equal && filter.values.size() == 1;
    std::string text = there.empty() ? fmt::format("no cell there has a '{}'", filter.name)
                                     : fmt::format("{} is {} there", filter.name, alternatives(there));
    if (!asks_for_one || there.empty()) return text;
    const Json& asked = filter.values.front();
    std::vector<std::string> words;
    for (const Json& value : there) {
        if (value.is_string()) words.push_back(value.get<std::string>());
    }
    // A technique that is asked for is one that there is.
    const std::string suggestion =
        asked.is_string() && filter.name != "technique" ? did_you_mean(asked.get<std::string>(), words) : "";
    if (!suggestion.empty()) return text + suggestion;
    return text + fmt::format("; to measure it, use -a {}={}", filter.name, value_as_argument(asked));
}

std::string as_arguments(std::span<const Filter> filters) {
    std::vector<std::string> arguments;
    for (const Filter& filter : filters)
        arguments.push_back(filter.argument);
    return join(arguments, " ");
}

/// Of filters that let no cell pass together: the first that does so alone, else the first that does so after those
/// before it.
[[noreturn]] void fail_without_cells(const std::vector<Filter>& filters, std::vector<Cell> cells,
                                     const ManifestIndex& manifests) {
    const auto keeps_none = [&](const Filter& filter) {
        return std::ranges::none_of(
            cells, [&](const Cell& cell) { return passes(filter, cell_quantity(cell, filter.name, manifests)); });
    };
    const auto alone = std::ranges::find_if(filters, keeps_none);
    if (alone != filters.end()) {
        fail("{}: no cell of the configuration passes: {}", alone->argument, what_there_is(*alone, cells, manifests));
    }
    auto last = filters.begin();
    for (; !keeps_none(*last); ++last) {
        std::erase_if(cells,
                      [&](const Cell& cell) { return !passes(*last, cell_quantity(cell, last->name, manifests)); });
    }
    fail("{}: no cell of those that pass {} passes: {}", last->argument, as_arguments({filters.begin(), last}),
         what_there_is(*last, cells, manifests));
}

}  // namespace

std::vector<Cell> filter_cells(std::vector<Cell> cells, const std::vector<std::string>& filters,
                               const std::vector<Manifest>& techniques) {
    const ManifestIndex manifests = index_manifests(techniques);
    std::vector<Filter> parsed;
    for (const std::string& text : filters)
        parsed.push_back(parse_filter(text, manifests));
    const auto passes_all = [&](const Cell& cell) {
        return std::ranges::all_of(
            parsed, [&](const Filter& filter) { return passes(filter, cell_quantity(cell, filter.name, manifests)); });
    };
    if (!parsed.empty() && std::ranges::none_of(cells, passes_all)) {
        fail_without_cells(parsed, std::move(cells), manifests);
    }
    std::erase_if(cells, [&](const Cell& cell) { return !passes_all(cell); });
    return cells;
}

}  // namespace reliefbench
