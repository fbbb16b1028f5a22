#pragma once

#include "cli/configuration_text.hpp"
#include "cli/exit_code.hpp"
#include "core/worker_status.hpp"

#include <memory>
#include <string>
#include <vector>

namespace reliefbench {

struct Supervision {
    /// Of this process; the worker has the same.
    std::vector<std::string> command_line;
    double pass_timeout_s = 10;
    /// As messages write it.
    std::string pass_timeout;
    /// Inherited by each worker, which finds its variable in its environment.
    const HandedConfiguration& configuration;
};

/// The status that this process shares with its supervisor; null in a process that is no worker. To be asked once.
std::unique_ptr<WorkerStatus> take_worker_status();

/// Runs this program again as a worker process, in which take_worker_status gives what it tells this one by. What the
/// worker prints goes where this process's output goes. Starts another when it dies, hangs in a pass or has lost its
/// device, and writes down (crashes.jsonl in the folder that the worker has set) which cell it was on; returns the
/// exit code of the one that ends by itself. Two that die in turn outside any cell are the end: an internal error.
/// The first SIGINT or SIGTERM is told to the worker as an interruption; when it has ended early for that, Interrupted
/// is thrown. A worker does not outlive this process.
ExitCode supervise(const Supervision& supervision);

}  // namespace reliefbench
