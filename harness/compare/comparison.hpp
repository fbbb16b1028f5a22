#pragma once

#include "compare/quality.hpp"
#include "compare/ratio_estimate.hpp"
#include "compare/verdict.hpp"
#include "core/json.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// A cell that both sides measured.
struct CellComparison {
    std::string cell;
    RatioEstimate time;
    Verdict verdict = Verdict::undecided;
    QualityComparison quality;
    /// In words: why the verdict, what could have been seen, what would decide.
    std::string reason;
};

/// A cell that cannot be compared, and why: in one side only, skipped or failed, its height map or parameters changed.
struct UncomparedCell {
    std::string cell;
    std::string reason;
    /// The base measured it and the new side failed: more than a hole in the table.
    bool failed_now = false;
};

/// Base against new: of stored runs, or of two variants measured live.
struct Comparison {
    std::vector<CellComparison> cells;
    std::vector<UncomparedCell> uncompared;
    /// What differs between the sides beside the measurements (driver, technique sources, sampling), in words.
    std::vector<std::string> notices;
    double threshold = 0.02;
    /// What the evidence counts: "runs" or "rounds".
    std::string unit = "runs";
    /// Of quality alone: the times, verdicts and reasons of `cells` mean nothing.
    bool quality_only = false;
    /// A quality that is mixed is none that is worse.
    bool accept_mixed = false;
    /// By what quality was decided.
    std::vector<DecidingFigure> deciding_figures = default_deciding_figures();
    /// Device, driver, CPU and tool version of both sides, the noise that was assumed and where it is from.
    Json environment;
};

}  // namespace reliefbench
