#include "report/github_action.hpp"

#include "core/counted.hpp"
#include "report/text_layout.hpp"
#include "store/chosen_figures.hpp"

#include <fmt/format.h>

namespace reliefbench {

namespace {

std::string extra_of(const CellResult& cell, const PassTiming& draw) {
    std::string extra = fmt::format("95 % interval of the median: {} to {} ms\n{}", significant(draw.ci95_ms.low, 4),
                                    significant(draw.ci95_ms.high, 4), counted(draw.n, "sample"));
    if (const auto taps = value_of(chosen_figures::taps, cell))
        extra += fmt::format("\n{} taps per pixel", significant(*taps));
    if (const auto uv = value_of(chosen_figures::quality, cell))
        extra += fmt::format("\nUV error p99: {} texels", significant(*uv));
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
