#pragma once

#include <sys/types.h>

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

/// Waits for a child's end, whatever signals come meanwhile; its status as waitpid gives it.
int wait_for_end(pid_t child);

/// For exec and spawn: pointers to the words, and a null. The words must stay.
std::vector<char*> pointers_to(std::vector<std::string>& words);

}  // namespace reliefbench
