#pragma once

#include "cli/exit_code.hpp"
#include "compare/comparison.hpp"
#include "report/comparison_format.hpp"

#include <string>

/// Only forward: CLI11 costs seconds per file.
namespace CLI {
class App;
}

namespace reliefbench {

/// How a command that compares writes its result.
struct ComparisonOutput {
    std::string format = "table";
    bool all = false;
    bool accept_mixed = false;

    void add_to(CLI::App& command);
    /// Refuses an unknown format before anything is measured or read.
    void check() const;
    /// To standard output; the exit code is what the comparison means.
    ExitCode print(Comparison comparison) const;
};

/// A slower cell or a worse quality is a regression, a mixed one too unless it is accepted; a cell that failed now
/// weighs more, an undecided one less. Where nothing could be compared, nothing is decided; of quality alone neither is
/// a cell of which no deciding figure could be compared.
ExitCode exit_code_of(const Comparison& comparison);

}  // namespace reliefbench
