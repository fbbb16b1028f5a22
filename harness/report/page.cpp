#include "report/page.hpp"

#include "compare/deciding_figures.hpp"
#include "core/error.hpp"
#include "report/advice_format.hpp"
#include "report/cautions.hpp"
#include "report/engine_answers.hpp"
#include "report/page_cells.hpp"
#include "report/page_comparison.hpp"
#include "report/page_pictures.hpp"
#include "report/page_samples.hpp"
#include "store/figures.hpp"

#include <algorithm>

namespace reliefbench {

namespace {

/// In the page, where the data go.
constexpr std::string_view data_place = "\"RELIEFBENCH_DATA\"";

Json legend_to_json(const MapLegend& legend) {
    Json json;
    json["title"] = legend.title;
    json["unit"] = legend.unit;
    json["dark"] = legend.dark;
    json["light"] = legend.light;
    json["logarithmic"] = legend.logarithmic;
    json["colours"] = base64(legend.colours);
    json["marks"] = legend.marks;
    json["others"] = Json::array();
    for (const LegendColour& other : legend.others) {
        json["others"].push_back({{"colour", other.colour}, {"text", other.text}});
    }
    return json;
}

Json pictures_to_json(const CellPictures& pictures) {
    Json json;
    json["technique"] = pictures.technique;
    json["truth"] = pictures.truth;
    json["maps"] = Json::object();
    for (const auto& [name, positions] : pictures.maps) {
        json["maps"][name] = positions;
    }
    json["legends"] = Json::object();
    for (const auto& [name, legend] : pictures.legends) {
        json["legends"][name] = legend_to_json(legend);
    }
    json["step"] = pictures.step;
    json["left_out"] = pictures.left_out;
    return json;
}

Json run_to_json(const PageRun& run) {
    Json json;
    json["name"] = run.stored.name;
    json["record"] = run.stored.run.run;
    json["record"].erase("figures");  // the page has one list for all runs
    json["summary"] = run.summary ? *run.summary : Json(nullptr);
    const std::optional<Advice> engines = answer_engines(run.stored.run.cells, run.stored.run.run);
    json["engines"] = engines ? to_json(*engines) : Json(nullptr);
    json["cautions"] = cautions(run.stored.run.cells, run.stored.run.run);
    json["cells"] = cells_to_columns(run.stored.run.cells);
    json["samples"] = samples_to_columns(run.samples, run.stored.run.cells);
    json["pictures"] = pictures_to_json(run.pictures);
    return json;
}

std::vector<std::string> ids_of(const std::vector<PageRun>& runs) {
    std::vector<std::string> ids;
    for (const PageRun& run : runs) {
        for (const CellResult& cell : run.stored.run.cells)
            ids.push_back(cell.cell);
    }
    return ids;
}

Json comparison_to_page(const PageComparison& comparison, const std::vector<PageRun>& runs) {
    Json json;
    json["base"] = comparison.base;
    json["new"] = comparison.changed;
    json["failure"] = comparison.failure.empty() ? Json(nullptr) : Json(comparison.failure);
    json["result"] =
        comparison.comparison ? comparison_to_columns(*comparison.comparison, ids_of(runs)) : Json(nullptr);
    return json;
}

/// Of this version, and what a later one declared in a run; each with the change that can be told, by which verdicts
/// decide.
Json figures_to_page(const std::vector<PageRun>& runs) {
    std::vector<FigureDeclaration> all(figures().begin(), figures().end());
    for (const PageRun& run : runs) {
        for (const FigureDeclaration& figure : run.stored.run.figures->all()) {
            const bool known = std::ranges::find(all, figure.path, &FigureDeclaration::path) != all.end();
            if (!known) all.push_back(figure);
        }
    }
    Json list = figures_to_json(all);
    for (std::size_t at = 0; at < all.size(); ++at) {
        const FigureTolerance tolerance = tolerance_of(all[at]);
        list[at]["tolerance"] = {{"absolute", tolerance.absolute}, {"relative", tolerance.relative}};
    }
    return list;
}

}  // namespace

Json page_data(const std::vector<PageRun>& runs, const Json& pictures, const std::optional<PageComparison>& comparison,
               std::string_view tool_version) {
    Json json;
    json["tool_version"] = tool_version;
    json["figures"] = figures_to_page(runs);
    json["runs"] = Json::array();
    for (const PageRun& run : runs) {
        json["runs"].push_back(run_to_json(run));
    }
    json["pictures"] = pictures;
    json["comparison"] = comparison ? comparison_to_page(*comparison, runs) : Json(nullptr);
    return json;
}

std::string fill_page(std::string_view page, const Json& data) {
    const std::size_t at = page.find(data_place);
    if (at == std::string_view::npos) {
        fail("the report's page has no place for data (\"RELIEFBENCH_DATA\"): build the target report_page again");
    }
    std::string filled(page.substr(0, at));
    const std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
    filled.reserve(page.size() + text.size());
    // Inside JSON, < stands in strings only.
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('<', begin), text.size());
        filled.append(text, begin, end - begin);
        if (end < text.size()) filled += "\\u003c";
        begin = end + 1;
    }
    filled += page.substr(at + data_place.size());
    return filled;
}

}  // namespace reliefbench
