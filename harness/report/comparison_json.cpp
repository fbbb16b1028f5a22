#include "report/comparison_json.hpp"

#include "report/comparison_words.hpp"

#include <cmath>
#include <optional>

namespace reliefbench {

namespace {

Json quality_to_json(const QualityComparison& quality) {
    Json json;
    json["verdict"] = to_string(quality.verdict);
    json["changes"] = Json::array();
    for (const QualityChange& change : quality.changes) {
        json["changes"].push_back(quality_change_to_json(change));
    }
    return json;
}

Json cell_to_json(const CellComparison& cell, bool quality_only) {
    Json json;
    json["cell"] = cell.cell;
    if (quality_only) {
        json["quality"] = quality_to_json(cell.quality);
        return json;
    }
    json["verdict"] = to_string(cell.verdict);
    json["ratio"] = finite_or_null(cell.time.ratio);
    json["ci95"] = {finite_or_null(cell.time.ci95.low), finite_or_null(cell.time.ci95.high)};
    json["visible"] = finite_or_null(cell.time.visible);
    json["reason"] = cell.reason;
    json["p_slower"] = finite_or_null(cell.time.p_slower);
    json["p_faster"] = finite_or_null(cell.time.p_faster);
    json["p_unchanged"] = finite_or_null(cell.time.p_unchanged);
    json["units"] = cell.time.units;
    json["more"] = cell.time.more ? Json(*cell.time.more) : Json(nullptr);
    json["quality"] = quality_to_json(cell.quality);
    return json;
}

Json counts_to_json(const Comparison& comparison) {
    const ComparisonCounts counts = count(comparison);
    Json json;
    if (!comparison.quality_only) {
        json["slower"] = counts.slower;
        json["undecided"] = counts.undecided;
        json["faster"] = counts.faster;
        json["same"] = counts.same;
    }
    json["worse"] = counts.worse;
    json["mixed"] = counts.mixed;
    json["better"] = counts.better;
    json["same_quality"] = counts.same_quality;
    json["not_comparable"] = counts.not_comparable;
    json["uncompared"] = counts.uncompared;
    json["failed_now"] = counts.failed_now;
    return json;
}

Json deciding_figures_to_json(const std::vector<DecidingFigure>& figures) {
    Json json = Json::array();
    for (const DecidingFigure& figure : figures) {
        json.push_back({{"figure", figure.name()},
                        {"absolute", figure.tolerance.absolute},
                        {"relative", figure.tolerance.relative},
                        {"tolerance", tolerance_text(figure)}});
    }
    return json;
}

}  // namespace

Json quality_change_to_json(const QualityChange& change) {
    Json json;
    json["field"] = change.field;
    json["base"] = finite_or_null(change.base);
    json["new"] = finite_or_null(change.changed);
    json["worse"] = change.worse;
    json["better"] = change.better;
    json["decides"] = change.decides;
    json["tolerances"] = finite_or_null(change.size());
    json["text"] = quality_change_text(change);
    return json;
}

Json comparison_without_cells(const Comparison& comparison) {
    Json json;
    json["uncompared"] = Json::array();
    for (const UncomparedCell& cell : comparison.uncompared) {
        json["uncompared"].push_back({{"cell", cell.cell}, {"reason", cell.reason}, {"failed_now", cell.failed_now}});
    }
    json["notices"] = comparison.notices;
    json["summary"] = counts_to_json(comparison);
    json["deciding_figures"] = deciding_figures_to_json(comparison.deciding_figures);
    if (!comparison.quality_only) {
        json["threshold"] = finite_or_null(comparison.threshold);
        json["unit"] = comparison.unit;
    }
    json["environment"] = comparison.environment;
    return json;
}

Json comparison_to_json(const Comparison& comparison) {
    Json json;
    json["cells"] = Json::array();
    for (const CellComparison& cell : comparison.cells) {
        json["cells"].push_back(cell_to_json(cell, comparison.quality_only));
    }
    json.update(comparison_without_cells(comparison));
    return json;
}

std::string format_comparison_json(const Comparison& comparison) {
    constexpr int indent = 2;
    return comparison_to_json(comparison).dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace reliefbench
