#pragma once

#include "store/run_folder.hpp"
#include "support/cell_figures.hpp"

namespace reliefbench {

/// One measured cell with every field, one skipped, one failed.
inline Run sample_run() {
    Run run;
    run.run = Json::parse(R"({
        "configuration": {"name": "quick"},
        "environment": {"tool_version": "0.1.0", "git_revision": "abc", "git_dirty": null, "cpu": "CPU", "cores": 2,
                        "os": "Linux", "time": "2026-11-22T08:56:36Z"},
        "device": {"name": "llvmpipe", "type": "CPU", "driver": "llvmpipe", "driver_version": "Mesa 22.3.6"}
    })");
    CellResult cell;
    cell.cell = "pom max_steps=16 | heightmap=bricks";
    cell.technique = "pom";
    cell.axes = {{"heightmap", "bricks, \"red\""}, {"fov", nullptr}};
    cell.parameters = {{"max_steps", 16}, {"bias", 0.1}, {"refine", true}};
    cell.time["draw"] = {0.5, 0.0125, {0.25, 0.75}, 6, 4};
    cell.time["quadtree"] = {2, 0, {2, 2}, 3, 1};
    cell.ns_per_pixel = 12.5;
    cell.prepare_ms = 2;
    cell.prepare_bytes = 87381;
    set_figures(cell, {{"work.taps_mean", 17.5},
                       {"work.taps_p95", 18},
                       {"work.texels_mean", 70},
                       {"work.steps_mean", 16},
                       {"work.steps_p95", 16},
                       {"work.unconverged", 0.25},
                       {"work.covered_pixels", 65536}});
    cell.pipeline["fragment_shader_invocations"] = 65536;
    set_summary(cell, "error.uv_texels", {0.1, 0.2, 0.05, 0.5, 0.75, 3});
    set_summary(cell, "error.depth", {-0.001, 0.002, 0.0005, 0.005, 0.01, 0.03});
    set_figures(cell, {{"error.compared", 65000},
                       {"error.missed", 0.001},
                       {"error.false_hits", 0.002},
                       {"error.outside_quad.pixels", 0},
                       {"error.coverage_iou", 0.9}});
    set_figures(cell, {{"image.psnr", 30},
                       {"image.rmse", 0.03},
                       {"image.footprint.flip", 0.0625},
                       {"image.footprint.psnr", 36},
                       {"image.footprint.rmse", 0.015}});
    set_figures(cell, {{"motion.texels.mean", 0.25},
                       {"motion.texels.p95", 0.5},
                       {"motion.texels.max", 4},
                       {"motion.compared", 500000},
                       {"motion.hit_once", 12},
                       {"motion.unseen", 700}});
    run.cells.push_back(cell);
    CellResult skipped;
    skipped.cell = "tessellation | heightmap=bricks";
    skipped.technique = "tessellation";
    skipped.status = CellStatus::skipped;
    skipped.reason = "the device has no tessellation";
    run.cells.push_back(skipped);
    CellResult failed;
    failed.cell = "mine | heightmap=bricks";
    failed.technique = "mine";
    failed.status = CellStatus::failed;
    failed.reason = "trace.glsl:3: 'a' : undeclared,\nsee above";
    run.cells.push_back(failed);
    return run;
}

}  // namespace reliefbench
