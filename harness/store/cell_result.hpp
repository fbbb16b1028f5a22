#pragma once

#include "core/json.hpp"
#include "core/statistics.hpp"
#include "sweep/cell.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

enum class CellStatus { ok, skipped, failed };

struct PassTiming {
    double median_ms = 0;
    double mad_ms = 0;
    Interval ci95_ms;
    std::size_t n = 0;
    /// Draws inside one timestamp pair.
    int repeats = 1;
};

/// One line of cells.jsonl as plain data; docs/architecture.md lists the fields. What is undefined is empty here and
/// null in the file; non-finite numbers are never written.
struct CellResult {
    std::string cell;
    std::string technique;
    Json axes;
    Json parameters;
    CellStatus status = CellStatus::ok;
    std::string reason;

    std::map<std::string, PassTiming> time;
    std::optional<double> ns_per_pixel;
    std::optional<double> prepare_ms;
    std::optional<std::uint64_t> prepare_bytes;

    struct Work {
        double taps_mean = 0, taps_p95 = 0, texels_mean = 0, steps_mean = 0, steps_p95 = 0;
        /// Fraction of covered pixels.
        double unconverged = 0;
        std::uint64_t covered_pixels = 0;
    };
    std::optional<Work> work;
    std::map<std::string, std::uint64_t> pipeline;

    struct Errors {
        std::optional<Summary> uv_texels, depth, normal_deg;
        std::uint64_t compared = 0;
        double missed = 0, false_hits = 0;
        std::uint64_t outside_quad_pixels = 0;
        std::optional<double> outside_quad_covered;
        double coverage_iou = 0;
    };
    std::optional<Errors> error;

    struct ImageFields {
        std::optional<double> flip, psnr, ssim, rmse;
    };
    std::optional<ImageFields> image;
};

Json to_json(const CellResult& result);
/// Strict; errors name `file` and the JSON path.
CellResult parse_cell_result(const Json& json, const std::string& file);

}  // namespace reliefbench
