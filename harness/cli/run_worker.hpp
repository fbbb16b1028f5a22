#pragma once

#include "cli/device_lock.hpp"
#include "cli/exit_code.hpp"
#include "cli/export_target.hpp"
#include "cli/run_sources.hpp"
#include "core/worker_status.hpp"
#include "gpu/device.hpp"
#include "measure/chosen_run.hpp"
#include "store/run_folder.hpp"
#include "sweep/shard.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// A run of cells that something chooses while it measures, for an answer in place of the table.
struct ChosenCells {
    std::shared_ptr<CellChooser> chooser;
    /// What measuring may take in all, the workers before this one included.
    double time_s = 0;
    /// Kept in run.json: a run for another question is not gone on with.
    Json question;
    /// What is printed in the end, of the cells that are recorded.
    std::function<std::string(const Run& run, bool is_time_over)> answer;
};

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
    /// Empty: all cells are measured.
    std::optional<ChosenCells> chosen = {};
};

/// The part of a run that needs the device, in a worker process: measures what is not finished, then prints the table.
/// Tells its supervisor what it is on.
ExitCode work_on_run(const RunJob& job, WorkerStatus& status);

}  // namespace reliefbench
