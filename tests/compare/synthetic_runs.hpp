#pragma once

#include "compare/stored_run.hpp"
#include "core/random.hpp"
#include "support/cell_figures.hpp"
#include "support/normal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

namespace reliefbench {

/// The record of a run as far as comparing reads it.
inline Json run_record() {
    return Json::parse(R"({
        "configuration": {
            "sampling": {"rule": "fixed", "rounds": 5},
            "truth": {"kind": "exact"},
            "lighting": {"ambient": 0.2}
        },
        "environment": {"tool_version": "1.0", "git_revision": "abc", "git_dirty": false, "cpu": "a CPU", "cores": 2,
                        "os": "an OS"},
        "device": {"name": "a device", "type": "CPU", "driver": "a driver", "driver_version": "1.2"},
        "techniques": {"first": "hash1", "second": "hash2"},
        "source_hashes": "included files",
        "height_maps": [{"name": "rock", "format": "r16", "size": [256, 256], "hash": "h", "albedo_hash": "a"}]
    })");
}

inline CellResult cell_result(const std::string& cell, double median_ms, const std::string& technique = "first") {
    CellResult result;
    result.cell = cell;
    result.technique = technique;
    result.axes = {{"heightmap", "rock"}, {"heightmap_size", "256x256"}, {"height_format", "r16"}};
    result.parameters = {{"max_steps", 32}};
    result.time["draw"].median_ms = median_ms;
    result.time["draw"].ci95_ms = {median_ms, median_ms};
    result.time["draw"].n = 15;
    set_figures(result, {{"work.taps_mean", 16}, {"error.compared", 0}, {"error.missed", 0}, {"error.false_hits", 0}});
    return result;
}

/// Runs of cells "c0", "c1", ..., about 1 ms each, which differ by chance only.
struct RunsModel {
    std::size_t cells = 75;
    /// Standard deviations of the logarithm: of each cell by itself, drawn evenly between these, and of all together.
    double smallest_sd = 0.05;
    double largest_sd = 0.07;
    double common_sd = 0.01;
};

inline std::vector<StoredRun> synthetic_runs(const RunsModel& model, std::size_t count, Random& random) {
    std::vector<double> deviations;
    for (std::size_t cell = 0; cell < model.cells; ++cell) {
        deviations.push_back(random.uniform(model.smallest_sd, model.largest_sd));
    }
    std::vector<StoredRun> runs;
    for (std::size_t index = 0; index < count; ++index) {
        StoredRun run;
        run.name = fmt::format("run{}", index + 1);
        run.run.run = run_record();
        const double common = model.common_sd * standard_normal(random);
        for (std::size_t cell = 0; cell < model.cells; ++cell) {
            const double log_ms = common + deviations[cell] * standard_normal(random);
            run.run.cells.push_back(cell_result(fmt::format("c{}", cell), std::exp(log_ms)));
        }
        runs.push_back(std::move(run));
    }
    return runs;
}

inline StoredRun one_run(const std::string& name, std::vector<CellResult> cells) {
    StoredRun run;
    run.name = name;
    run.run.run = run_record();
    run.run.cells = std::move(cells);
    return run;
}

}  // namespace reliefbench
