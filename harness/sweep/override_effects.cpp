#include "sweep/override_effects.hpp"

#include "core/log.hpp"
#include "core/suggest.hpp"
#include "sweep/condition.hpp"
#include "sweep/view_axes.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace reliefbench {

namespace {

/// Values of the axes that stayed tied, in their order.
using TiedValues = std::vector<Json>;

/// All that the cells of one technique have, of the technique that has most: what one does not take says nothing of the
/// zip.
std::set<TiedValues> most_tied_values(const std::vector<std::string>& names, const std::vector<Cell>& cells,
                                      const ManifestIndex& manifests) {
    std::map<std::string, std::set<TiedValues>> by_technique;
    for (const Cell& cell : cells) {
        TiedValues values;
        for (const std::string& name : names)
            values.push_back(cell_quantity(cell, name, manifests));
        by_technique[cell.technique].insert(std::move(values));
    }
    std::set<TiedValues> most;
    for (auto& [technique, values] : by_technique) {
        if (values.size() > most.size()) most = std::move(values);
    }
    return most;
}

std::set<Json> values_of(std::size_t name, const std::set<TiedValues>& all) {
    std::set<Json> values;
    for (const TiedValues& tied : all)
        values.insert(tied[name]);
    return values;
}

/// "projection=perspective": of all filters by one value of one axis the one that leaves fewest combinations.
std::string narrowest_filter(const std::vector<std::string>& names, const std::set<TiedValues>& all) {
    std::string narrowest;
    std::size_t fewest = all.size() + 1;
    for (std::size_t name = 0; name < names.size(); ++name) {
        for (const Json& value : values_of(name, all)) {
            const auto left = static_cast<std::size_t>(
                std::ranges::count_if(all, [&](const TiedValues& tied) { return tied[name] == value; }));
            if (left >= fewest) continue;
            fewest = left;
            narrowest = names[name] + "=" + value_as_argument(value);
        }
    }
    return narrowest;
}

void warn_of_loosened_zip(const LoosenedZip& zip, const std::vector<Cell>& cells, const ManifestIndex& manifests) {
    const std::set<TiedValues> all = most_tied_values(zip.kept, cells, manifests);
    if (all.size() < 2) return;
    std::vector<std::string> to_give;
    for (std::size_t name = 0; name < zip.kept.size(); ++name) {
        if (values_of(name, all).size() > 1) to_give.push_back(fmt::format("-a {}=...", zip.kept[name]));
    }
    const bool one = zip.taken.size() == 1;
    log_warning(
        "{}: the configuration ties {} to {} (\"zip\"); with values of {} own {} tied no more, and combined with each "
        "of "
        "{}; give {} too, or --filter {}",
        join(zip.arguments, " "), join(zip.taken, " and "), join(zip.kept, " and "), one ? "its" : "their",
        one ? "it is" : "they are",
        zip.kept.size() == 1 ? fmt::format("the {} values of {}", all.size(), zip.kept.front())
                             : fmt::format("the {} combinations of {}", all.size(), join(zip.kept, " and ")),
        join(to_give, " "), narrowest_filter(zip.kept, all));
}

/// The axis of the parameter that `sample_count` means for the technique, which goes before it.
const Axis* axis_before_sample_count(const Configuration& configuration, const std::vector<Cell>& cells,
                                     const ManifestIndex& manifests) {
    for (const Axis& axis : configuration.axes) {
        const bool goes_before = std::ranges::any_of(cells, [&](const Cell& cell) {
            const auto manifest = manifests.find(cell.technique);
            return manifest != manifests.end() && manifest->second->sample_count == axis.name;
        });
        if (goes_before) return &axis;
    }
    return nullptr;
}

/// Why no cell has a value that was given.
std::string why_without_effect(const Axis& axis, const Configuration& configuration, const std::vector<Cell>& cells,
                               const ManifestIndex& manifests) {
    const std::vector<Json> values = distinct_quantities(cells, axis.name, manifests);
    if (values.empty()) {
        if (axis.name == "sample_count") return "no technique that is left has a sample count";
        if (find_view_axis(axis.name)) return fmt::format("no view that is left has a use for '{}'", axis.name);
        return fmt::format("no technique that is left has a parameter '{}'", axis.name);
    }
    std::string why = fmt::format("{} is {} there", axis.name, alternatives(values));
    if (axis.name != "sample_count") return why;
    if (const Axis* before = axis_before_sample_count(configuration, cells, manifests))
        why += fmt::format(", as the axis '{}' goes before it", before->name);
    return why;
}

void warn_without_effect(const Axis& axis, const Configuration& configuration, const std::vector<Cell>& cells,
                         const ManifestIndex& manifests) {
    // Whose sizes of files have a warning of their own.
    if (axis.name == "heightmap_size") return;
    std::vector<Json> given;
    for (const Json& value : axis.values)
        given.push_back(read_quantity_value(JsonView(value, axis.origin.file, axis.origin.path), axis.name, manifests));
    const bool has_effect = std::ranges::any_of(cells, [&](const Cell& cell) {
        const Json quantity = cell_quantity(cell, axis.name, manifests);
        return std::ranges::any_of(given,
                                   [&](const Json& value) { return quantity_equals(axis.name, quantity, value); });
    });
    if (has_effect) return;
    log_warning("{}: no cell that is left has a value given here: {}", axis.origin.file,
                why_without_effect(axis, configuration, cells, manifests));
}

}  // namespace

void warn_of_overrides(const Configuration& configuration, const std::vector<Cell>& cells,
                       const std::vector<Manifest>& techniques) {
    const ManifestIndex manifests = index_manifests(techniques);
    for (const LoosenedZip& zip : configuration.loosened_zips)
        warn_of_loosened_zip(zip, cells, manifests);
    for (const std::string& name : configuration.overridden) {
        const auto axis = std::ranges::find(configuration.axes, name, &Axis::name);
        if (axis != configuration.axes.end()) warn_without_effect(*axis, configuration, cells, manifests);
    }
}

}  // namespace reliefbench
