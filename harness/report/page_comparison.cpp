#include "report/page_comparison.hpp"

#include "report/comparison_json.hpp"
#include "report/comparison_words.hpp"
#include "report/page_cells.hpp"

#include <string_view>
#include <unordered_map>

namespace reliefbench {

namespace {

/// The most important of a cell.
constexpr std::size_t max_changes = 12;

Json changes_to_json(const QualityComparison& quality) {
    Json changes = Json::array();
    for (const QualityChange& change : quality.changes) {
        if (changes.size() == max_changes) break;
        const bool on_one_side_only = !(change.base && change.changed);
        if (on_one_side_only ? !change.is_deciding : !(change.worse || change.better)) continue;
        changes.push_back({{"decides", change.decides}, {"text", quality_change_text(change)}});
    }
    return changes;
}

Json cells_to_columns(const std::vector<CellComparison>& cells, const std::vector<std::string>& ids) {
    std::unordered_map<std::string_view, std::size_t> place_of_id;
    for (std::size_t place = 0; place < ids.size(); ++place)
        place_of_id.emplace(ids[place], place);
    Json cell, verdict, ratio, low, high, visible, reason, quality, changes;
    for (Json* column : {&cell, &verdict, &ratio, &low, &high, &visible, &reason, &quality, &changes})
        *column = Json::array();
    for (std::size_t place = 0; place < cells.size(); ++place) {
        const CellComparison& compared = cells[place];
        cell.push_back(place_of_id.at(compared.cell));
        verdict.push_back(to_string(compared.verdict));
        ratio.push_back(rounded_number(compared.time.ratio));
        low.push_back(rounded_number(compared.time.ci95.low));
        high.push_back(rounded_number(compared.time.ci95.high));
        visible.push_back(rounded_number(compared.time.visible));
        reason.push_back(compared.reason);
        quality.push_back(to_string(compared.quality.verdict));
        if (Json important = changes_to_json(compared.quality); !important.empty())
            changes.push_back({place, std::move(important)});
    }
    return {{"cell", std::move(cell)},     {"verdict", std::move(verdict)}, {"ratio", std::move(ratio)},
            {"low", std::move(low)},       {"high", std::move(high)},       {"visible", std::move(visible)},
            {"reason", std::move(reason)}, {"quality", std::move(quality)}, {"changes", std::move(changes)}};
}

}  // namespace

Json comparison_to_columns(const Comparison& comparison, const std::vector<std::string>& ids) {
    Json json;
    json["cells"] = cells_to_columns(comparison.cells, ids);
    json.update(comparison_without_cells(comparison));
    return json;
}

}  // namespace reliefbench
