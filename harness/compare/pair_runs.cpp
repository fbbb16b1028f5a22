#include "compare/pair_runs.hpp"

#include "compare/run_differences.hpp"
#include "core/counted.hpp"
#include "core/json_lookup.hpp"
#include "core/suggest.hpp"
#include "store/chosen_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace reliefbench {

namespace {

/// Why the cell cannot be compared; empty when it can.
std::optional<UncomparedCell> uncompared(const std::string& id, const SideCell* base, const SideCell* changed) {
    if (changed == nullptr) return UncomparedCell{id, "only in the base"};
    if (base == nullptr) return UncomparedCell{id, "only in the new runs"};
    if (base->measured.empty() && changed->measured.empty()) {
        return UncomparedCell{id, fmt::format("not measured on either side (base: {}; new: {})", unmeasured_text(*base),
                                              unmeasured_text(*changed))};
    }
    if (base->measured.empty()) {
        return UncomparedCell{id, fmt::format("measured now, but in the base {}", unmeasured_text(*base))};
    }
    if (changed->measured.empty()) {
        const bool failed_now = changed->unmeasured->status == CellStatus::failed;
        return UncomparedCell{id, fmt::format("measured in the base, but now {}", unmeasured_text(*changed)),
                              failed_now};
    }
    const std::string difference =
        subject_difference(*base->runs[0], *base->measured[0], *changed->runs[0], *changed->measured[0]);
    if (!difference.empty()) return UncomparedCell{id, difference};
    return std::nullopt;
}

QualityComparison compare_quality_of(const SideCell& base, const SideCell& changed,
                                     std::span<const DecidingFigure> deciding) {
    CellResult before = *base.measured[0];
    CellResult after = *changed.measured[0];
    const bool truth = same_truth(*base.runs[0], *changed.runs[0]);
    const bool seen = same_lighting(*base.runs[0], *changed.runs[0]);
    const bool moved = same_motion(*base.runs[0], *changed.runs[0]);
    const bool resolved = same_history(*base.runs[0], *changed.runs[0]);
    const auto means_the_same = [&](const FigureDeclaration& figure) {
        const auto needs = [&](std::string_view need) { return figure.has_need(need); };
        return (truth || !needs(figure_needs::truth)) && (moved || !needs(figure_needs::motion)) &&
               (resolved || !needs(figure_needs::history)) &&
               (seen || !(needs(figure_needs::lighting) || needs(figure_needs::object)));
    };
    if (!truth || !seen || !moved || !resolved) {
        before.figures.keep_only(means_the_same);
        after.figures.keep_only(means_the_same);
    }
    return compare_quality(before, after, deciding);
}

void pair_cells(const RunSide& base, const RunSide& changed, Comparison& comparison) {
    const auto find = [](const RunSide& side, const std::string& id) {
        const auto found = side.cells.find(id);
        return found == side.cells.end() ? nullptr : &found->second;
    };
    std::vector<std::string> order = base.order;
    for (const std::string& id : changed.order) {
        if (!base.cells.contains(id)) order.push_back(id);
    }
    for (const std::string& id : order) {
        const SideCell* before = find(base, id);
        const SideCell* after = find(changed, id);
        if (auto reason = uncompared(id, before, after)) {
            comparison.uncompared.push_back(std::move(*reason));
            continue;
        }
        CellComparison cell;
        cell.cell = id;
        cell.quality = compare_quality_of(*before, *after, comparison.deciding_figures);
        comparison.cells.push_back(std::move(cell));
    }
}

std::vector<std::string> notices_on_runs(std::span<const StoredRun> base, std::span<const StoredRun> changed) {
    std::vector<std::string> notices = run_differences(base.front(), changed.front());
    for (const auto& [runs, side] : {std::pair(base, "base"), std::pair(changed, "new")}) {
        if (from_changed_tree(runs.front())) {
            notices.push_back(
                fmt::format("{} was made from a work tree with changes not committed", runs.front().name));
        }
        for (const StoredRun& run : runs.subspan(1)) {
            const std::vector<std::string> differences = run_differences(runs.front(), run);
            if (differences.empty()) continue;
            notices.push_back(fmt::format("the {} runs differ among themselves: between {} and {}, {}", side,
                                          runs.front().name, run.name, differences.front()));
        }
    }
    return notices;
}

/// Figures that runs of an older version lack.
std::vector<std::string> notices_on_stand_ins(const Comparison& comparison) {
    std::map<std::pair<std::string, std::string>, std::size_t> cells;
    for (const CellComparison& cell : comparison.cells) {
        for (const StandIn& each : cell.quality.stand_ins)
            ++cells[{each.figure, each.decided}];
    }
    std::vector<std::string> notices;
    for (const auto& [names, count] : cells) {
        notices.push_back(fmt::format("of {} of {} one side has no {}, so {} decides in its place", count,
                                      counted(comparison.cells.size(), "cell"), names.first, names.second));
    }
    return notices;
}

/// Where the truth found ties on one side and runs of the other knew none, errors are of different pixels.
std::optional<std::string> notice_on_ties(const RunSide& base, const RunSide& changed, const Comparison& comparison) {
    const auto ties = [](const SideCell& cell) { return value_of(chosen_figures::ties, *cell.measured[0]); };
    std::size_t cells = 0;
    for (const CellComparison& cell : comparison.cells) {
        const auto before = ties(base.cells.at(cell.cell));
        const auto after = ties(changed.cells.at(cell.cell));
        cells += before.has_value() != after.has_value() && before.value_or(0) + after.value_or(0) > 0 ? 1 : 0;
    }
    if (cells == 0) return std::nullopt;
    return fmt::format(
        "of {} of {} the errors of one side count ties ({}), which runs of an older version did not "
        "know: what is better or worse in them may be that and nothing else",
        cells, counted(comparison.cells.size(), "cell"), chosen_figures::ties);
}

/// Technique, axes and parameters of a side's cells: each with its values as text, in their order.
std::map<std::string, std::vector<std::string>> values_of_side(const RunSide& side) {
    std::map<std::string, std::vector<std::string>> values;
    const auto add = [&values](const std::string& name, const std::string& value) {
        std::vector<std::string>& known = values[name];
        if (std::find(known.begin(), known.end(), value) == known.end()) known.push_back(value);
    };
    for (const std::string& id : side.order) {
        const SideCell& cell = side.cells.at(id);
        const CellResult& result = cell.measured.empty() ? *cell.unmeasured : *cell.measured.front();
        add("technique", result.technique);
        for (const Json* members : {&result.axes, &result.parameters}) {
            if (!members->is_object()) continue;
            for (const auto& [name, value] : members->items())
                add(name, text_of(value));
        }
    }
    return values;
}

std::string first_values(const std::vector<std::string>& values) {
    constexpr std::size_t max_listed = 5;
    if (values.size() <= max_listed) return join(values);
    return join({values.begin(), values.begin() + max_listed}) + ", ...";
}

/// Where no cell is in both sides: what has no value in common, else what has not the same values.
std::optional<std::string> notice_on_disjoint_sides(const RunSide& base, const RunSide& changed) {
    const bool shares_a_cell = std::any_of(base.order.begin(), base.order.end(),
                                           [&](const std::string& id) { return changed.cells.contains(id); });
    if (shares_a_cell || base.order.empty() || changed.order.empty()) return std::nullopt;
    const auto before = values_of_side(base);
    const auto after = values_of_side(changed);
    std::vector<std::string> disjoint;
    std::vector<std::string> different;
    for (const auto& [name, values] : before) {
        const auto other = after.find(name);
        if (other == after.end() || other->second == values) continue;
        const std::string text = fmt::format("{} is {} in the base and {} in the new runs", name, first_values(values),
                                             first_values(other->second));
        const bool has_common = std::any_of(values.begin(), values.end(), [&](const std::string& value) {
            return std::find(other->second.begin(), other->second.end(), value) != other->second.end();
        });
        (has_common ? different : disjoint).push_back(text);
    }
    const std::vector<std::string>& told = disjoint.empty() ? different : disjoint;
    return "no cell is in both sides" +
           (told.empty() ? ", which have the same values in other combinations" : ": " + join(told, "; "));
}

Json side_record(std::span<const StoredRun> runs) {
    const Json& run = runs.front().run.run;
    Json json;
    json["runs"] = Json::array();
    for (const StoredRun& stored : runs) {
        json["runs"].push_back(stored.name);
    }
    for (const char* part : {"device", "environment"}) {
        json[part] = run.contains(part) ? run.at(part) : Json(nullptr);
    }
    return json;
}

}  // namespace

Comparison pair_runs(const RunSide& base, const RunSide& changed, const std::vector<DecidingFigure>& deciding) {
    Comparison comparison;
    comparison.deciding_figures = deciding;
    const std::string device = device_difference(base.runs.front(), changed.runs.front());
    if (!device.empty()) comparison.notices.push_back("the devices differ: " + device);
    pair_cells(base, changed, comparison);
    for (std::vector<std::string> notices :
         {notices_on_runs(base.runs, changed.runs), notices_on_stand_ins(comparison)})
        std::move(notices.begin(), notices.end(), std::back_inserter(comparison.notices));
    if (auto notice = notice_on_disjoint_sides(base, changed)) comparison.notices.push_back(std::move(*notice));
    if (auto notice = notice_on_ties(base, changed, comparison)) comparison.notices.push_back(std::move(*notice));
    comparison.environment["base"] = side_record(base.runs);
    comparison.environment["new"] = side_record(changed.runs);
    return comparison;
}

Comparison compare_quality_of_runs(std::span<const StoredRun> base, std::span<const StoredRun> changed,
                                   const std::vector<DecidingFigure>& deciding) {
    Comparison comparison = pair_runs(gather_side(base, has_figures), gather_side(changed, has_figures), deciding);
    comparison.quality_only = true;
    return comparison;
}

}  // namespace reliefbench
