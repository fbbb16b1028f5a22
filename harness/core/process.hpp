#pragma once

#include <string>
#include <vector>

namespace reliefbench {

/// What a finished child process left behind.
struct FinishedProcess {
    /// As a shell has it: 128 + the signal's number for one that was killed.
    int exit_code = 0;
    std::string output;
    std::string errors;
};

/// Runs a program, found along PATH, to its end: no shell, nothing on its standard input. `unset` names environment
/// variables that it does not inherit. A program that cannot be started is an Error.
FinishedProcess run_process(const std::vector<std::string>& arguments, const std::vector<std::string>& unset = {});

}  // namespace reliefbench
