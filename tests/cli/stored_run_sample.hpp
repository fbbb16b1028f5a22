#pragma once

#include "core/json.hpp"
#include "store/run_folder.hpp"
#include "support/cell_figures.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// What a stored run measured of one cell.
struct StoredCell {
    std::string cell;
    double ms = 1;
    double uv_p99 = 0.5;
    CellStatus status = CellStatus::ok;
    double missed = 0;
};

/// Writes a run that no device drew, so that what it says is known: rounds of 1 ‰ more and less than the median.
inline void store_run(const std::filesystem::path& folder, const std::vector<StoredCell>& cells,
                      const std::string& device = "test device") {
    Json record = Json::parse(R"({
        "configuration": {"name": "stored", "truth": {"kind": "exact"}},
        "environment": {"tool_version": "0.1.0", "git_revision": null, "git_dirty": null, "cpu": "test CPU", "cores": 2,
                        "os": "test", "time": "2026-11-22T08:00:00Z"},
        "device": {"name": "", "type": "discrete GPU", "driver": "test", "driver_version": "1"},
        "techniques": {}, "height_maps": []
    })");
    record["device"]["name"] = device;
    RunWriter writer(folder, record);
    for (const StoredCell& stored : cells) {
        CellResult cell;
        cell.cell = stored.cell;
        cell.technique = stored.cell.substr(0, stored.cell.find(' '));
        cell.status = stored.status;
        if (stored.status == CellStatus::ok) {
            cell.time["draw"] = {stored.ms, 0.001 * stored.ms, {0.999 * stored.ms, 1.001 * stored.ms}, 9, 1};
            set_figures(cell, {{"work.taps_mean", 17.5},
                               {"work.taps_p95", 18},
                               {"work.texels_mean", 17.5},
                               {"work.steps_mean", 16},
                               {"work.steps_p95", 16},
                               {"work.unconverged", 0},
                               {"work.covered_pixels", 65536}});
            set_summary(cell, "error.uv_texels", {0.1, 0.2, 0.1, 0.4, stored.uv_p99, 3});
            set_figures(cell, {{"error.compared", 65536},
                               {"error.missed", stored.missed},
                               {"error.false_hits", 0},
                               {"error.coverage_iou", 1}});
            for (int round = 0; round < 9; ++round) {
                writer.append_samples({stored.cell, "draw", round, 0, 1, {stored.ms * (1 + 0.001 * (round % 3 - 1))}});
            }
        } else {
            cell.reason = "trace.glsl:3: error";
        }
        writer.append_cell(cell);
    }
}

}  // namespace reliefbench
