#pragma once

#include "compare/deciding_figures.hpp"
#include "compare/stored_run.hpp"

#include <span>
#include <string>
#include <vector>

/// Only forward: CLI11 costs seconds per file.
namespace CLI {
class App;
}

namespace reliefbench {

/// By which figures quality is decided, as the command line says it.
struct QualityChoice {
    /// "image.ssim,error.missed+error.false_hits:0.002,error.uv_texels.p95:0.1:10%": names as `list figures` has them;
    /// an absolute or a relative tolerance or both in place of tolerance_of's. Empty for the default.
    std::string figures;

    void add_to(CLI::App& command);
    /// What is unknown, named twice, a time (which has a verdict of its own) or without a direction, a sum of unlike
    /// figures, and what is no tolerance is an Error.
    /// Of the figures of this version and of those that made the runs, which must outlive the answer.
    std::vector<DecidingFigure> deciding_figures(std::span<const StoredRun> runs = {}) const;
};

}  // namespace reliefbench
