#pragma once

#include "core/json.hpp"
#include "core/statistics.hpp"
#include "sweep/cell.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

enum class CellStatus { ok, skipped, failed };

/// Why a cell got no more rounds.
enum class StopReason {
    /// The interval of the median is as narrow as asked for.
    precise,
    /// More rounds do not narrow it.
    stalled,
    /// It is not as narrow as asked for, but the cell's time is spent.
    budget,
    /// The rounds asked for are done.
    rounds,
    /// The time asked for is spent.
    time,
};

std::string_view to_string(StopReason reason);

/// Name of the draw among a cell's passes.
inline constexpr const char* draw_pass = "draw";

struct PassTiming {
    /// Of the rounds' medians.
    double median_ms = 0;
    /// Of all samples.
    double mad_ms = 0;
    /// Of the median, over the rounds' medians.
    Interval ci95_ms;
    std::size_t n = 0;
    /// Draws inside one timestamp pair.
    int repeats = 1;
    std::size_t rounds = 0;
    /// Samples far from the median: counted here, dropped nowhere.
    std::size_t outliers = 0;
    /// Of all samples: what runs are compared by, for what disturbs a draw only ever makes it longer. Empty in runs
    /// made before it was kept.
    std::optional<double> lower_quartile_ms = {};
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
    std::optional<StopReason> stop;
    /// Rounds in which the device was throttled and that count all the same, because repeating them did not help.
    std::size_t throttled_rounds = 0;
    std::optional<double> prepare_ms;
    std::optional<std::uint64_t> prepare_bytes;

    struct Work {
        double taps_mean = 0, taps_p95 = 0, texels_mean = 0, steps_mean = 0, steps_p95 = 0;
        /// Fraction of covered pixels.
        double unconverged = 0;
        std::uint64_t covered_pixels = 0;
        /// Of self-shadowing, which the others leave out. Empty without it.
        std::optional<double> shadow_taps_mean = {}, shadow_taps_p95 = {};
    };
    std::optional<Work> work;
    std::map<std::string, std::uint64_t> pipeline;
    /// What the driver says of the compiled stages, by stage and statistic: registers, spills, bytes of code. Empty
    /// where it says nothing.
    std::map<std::string, std::map<std::string, double>> executable;

    /// Of visibilities, over the pixels and lights compared.
    struct ShadowErrors {
        double mean = 0, false_shadow = 0, missed_shadow = 0;
        std::uint64_t compared = 0;
        /// Of the truth's soft shadows, averaged over their penumbrae.
        std::optional<double> truth_standard_error;
    };

    struct Errors {
        std::optional<Summary> uv_texels, depth, normal_deg;
        std::uint64_t compared = 0;
        double missed = 0, false_hits = 0;
        /// Fraction of F, which no other of these errors counts. Empty in runs made before ties were told apart.
        std::optional<double> ties = {};
        std::uint64_t outside_quad_pixels = 0;
        std::optional<double> outside_quad_covered;
        double coverage_iou = 0;
        /// Empty without self-shadowing.
        std::optional<ShadowErrors> shadow = {};
        /// Fraction of F in which the wrong one of relief and object is in front. Empty without an object.
        std::optional<double> wrong_surface = {};
    };
    std::optional<Errors> error;

    /// Over F (metrics/image_errors.hpp).
    struct FootprintFields {
        std::optional<double> flip, psnr, ssim, rmse;
    };
    /// Over the union of both coverages, so that relief beyond the quad counts.
    struct ImageFields {
        std::optional<double> flip, psnr, ssim, rmse;
        /// Empty in runs of version 0.1.0.
        std::optional<FootprintFields> footprint = {};
    };
    std::optional<ImageFields> image;

    /// Of one pair of neighbouring frames, over all pairs (metrics/motion_errors.hpp).
    struct MotionFigure {
        double mean = 0, p95 = 0, max = 0;
    };
    struct Motion {
        std::optional<MotionFigure> texels, flip;
        /// Pixels of all pairs: compared; seen in both frames and hit in one only; of F and not seen in the next frame.
        std::uint64_t compared = 0, hit_once = 0, unseen = 0;
    };
    /// Empty where the configuration does not ask for it.
    std::optional<Motion> motion;

    /// Finished by a run that was gone on with though its environment had changed (`--resume=force`).
    bool forced_resume = false;
};

Json to_json(const CellResult& result);
/// Strict; errors name `file` and the JSON path.
CellResult parse_cell_result(const Json& json, const std::string& file);

}  // namespace reliefbench
