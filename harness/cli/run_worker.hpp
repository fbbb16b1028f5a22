#pragma once

#include "cli/device_lock.hpp"
#include "cli/exit_code.hpp"
#include "cli/export_target.hpp"
#include "cli/run_sources.hpp"
#include "core/worker_status.hpp"
#include "gpu/device.hpp"
#include "sweep/shard.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// A run as its command line asks for it, before anything is measured.
struct RunJob {
    RunSources sources;
    std::optional<Shard> shard = {};
    std::filesystem::path folder = {};
    /// Empty, "plain" or "force".
    std::string resume;
    std::string format;
    bool colour = false;
    std::vector<ExportTarget> exports;
    gpu::DeviceOptions device;
    DeviceSharing sharing;
    std::vector<std::string> command_line;
    /// It goes on for a worker that died.
    bool takes_over = false;
};

/// The part of a run that needs the device, in a worker process: measures what is not finished, then prints the table.
/// Tells its supervisor what it is on.
ExitCode work_on_run(const RunJob& job, WorkerStatus& status);

}  // namespace reliefbench
