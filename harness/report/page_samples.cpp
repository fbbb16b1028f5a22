#include "report/page_samples.hpp"

#include "report/page_cells.hpp"

#include <algorithm>

namespace reliefbench {

namespace {

/// Of all passes and cells together: 60,000 groups are 3 MB of text.
constexpr std::size_t wanted_groups = 60'000;
constexpr std::size_t min_groups = 2;
constexpr std::size_t max_groups = 64;

std::size_t groups_per_cell(const RunSamples& samples) {
    std::size_t series = 0;
    for (const auto& [pass, cells] : samples) {
        series += cells.size();
    }
    return std::clamp(wanted_groups / std::max<std::size_t>(series, 1), min_groups, max_groups);
}

}  // namespace

Json samples_to_columns(const RunSamples& samples, const std::vector<CellResult>& cells) {
    const std::size_t most = groups_per_cell(samples);
    Json passes = Json::array();
    for (const auto& [pass, series] : samples) {
        Json json = {{"pass", pass},
                     {"cell", Json::array()},
                     {"groups", Json::array()},
                     {"first_round", Json::array()},
                     {"samples", Json::array()},
                     {"ms", Json::array()}};
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            const auto rounds = series.find(cells[cell].cell);
            if (rounds == series.end()) continue;
            const std::vector<SampleGroup> groups = group_samples(rounds->second, most);
            json["cell"].push_back(cell);
            json["groups"].push_back(groups.size());
            for (const SampleGroup& group : groups) {
                json["first_round"].push_back(group.first_round);
                json["samples"].push_back(group.samples);
                for (const double ms : group.quantiles) {
                    json["ms"].push_back(rounded_number(ms));
                }
            }
        }
        passes.push_back(std::move(json));
    }
    return passes;
}

}  // namespace reliefbench
