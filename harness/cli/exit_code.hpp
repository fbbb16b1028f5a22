#pragma once

namespace reliefbench {

/// What the process tells its caller; docs/architecture.md, "Exit codes".
enum class ExitCode {
    done = 0,
    regression = 1,
    bad_input = 2,
    undecided = 3,
    cells_failed = 4,
    internal_error = 5,
};

/// The one to report where both apply: 5, 2, 4, 1, 3, 0.
ExitCode worse_of(ExitCode first, ExitCode second);

}  // namespace reliefbench
