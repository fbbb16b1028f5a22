#include "report/github_action.hpp"

#include "core/counted.hpp"
#include "report/figure_text.hpp"
#include "report/text_layout.hpp"
#include "store/chosen_figures.hpp"

#include <fmt/format.h>

namespace reliefbench {

namespace {

std::string extra_of(const CellResult& cell, const PassTiming& draw) {
    std::string extra = fmt::format("95 % interval of the median: {} to {} ms\n{}", significant(draw.ci95_ms.low, 4),
                                    significant(draw.ci95_ms.high, 4), counted(draw.n, "sample"));
    for (const std::string_view path : {chosen_figures::taps, chosen_figures::quality}) {
        const FigureDeclaration& figure = known_figure(path);
        if (const std::optional<double> value = value_of(figure, cell))
            extra += fmt::format("\n{}: {}{}", figure.label, figure_value_text(*value, figure.unit),
                                 figure_unit_text(figure.unit));
    }
    return extra;
}

}  // namespace

std::string format_github_action(const Run& run) {
    Json entries = Json::array();
    for (const CellResult& cell : run.cells) {
        const auto draw = cell.time.find(draw_pass);
        if (cell.status != CellStatus::ok || draw == cell.time.end()) continue;
        Json entry;
        entry["name"] = cell.cell;
        entry["unit"] = "ms";
        entry["value"] = draw->second.median_ms;
        entry["range"] = "± " + significant(draw->second.mad_ms);
        entry["extra"] = extra_of(cell, draw->second);
        entries.push_back(std::move(entry));
    }
    constexpr int indent = 2;
    return entries.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace reliefbench
