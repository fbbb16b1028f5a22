#pragma once

#include "compare/stored_run.hpp"
#include "report/advice.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

/// Only forward: CLI11 costs seconds per file.
namespace CLI {
class App;
}  // namespace CLI

namespace reliefbench {

/// What advice is asked for: --budget, --flip, --uv, --shadow, --limit and --rank-by.
struct AdviseRequestOptions {
    std::string budget;
    std::optional<double> flip;
    std::optional<double> uv;
    std::optional<double> shadow;
    std::vector<std::string> limits;
    std::string rank_by;

    void add_to(CLI::App& command);
    /// Nothing is asked for, no figure to rank by either.
    bool is_empty() const;
    /// `ranking`: the figure of --flip, and of the rank unless --rank-by names another. Figures may be those that
    /// `runs` declare. No limit at all is an Error, and so are figures without a direction.
    AdviceRequest request(const FigureDeclaration& ranking, std::span<const StoredRun> runs) const;
};

}  // namespace reliefbench
