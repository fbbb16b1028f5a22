#pragma once

#include "core/json.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// How far the medians of identical runs lie apart.
struct RunNoise {
    /// Standard deviation of log(median ms) between runs of identical code: 0.10 is about 10 %. The default is what a
    /// shared two-core machine with a CPU device showed over 24 processes.
    double log_sd = 0.10;
    /// Of log_sd: how much it is known by.
    double degrees_of_freedom = 23;
    /// In words, for reports.
    std::string source = "default; `reliefbench selfcheck` measures this machine's";
};

/// What noise belongs to: another device, driver or CPU has another one.
struct MachineKey {
    std::string device;
    std::string driver;
    std::string driver_version;
    std::string cpu;

    bool operator==(const MachineKey&) const = default;
};

/// The result of `reliefbench selfcheck`, kept per machine.
struct NoiseRecord {
    MachineKey machine;
    /// ISO 8601, UTC.
    std::string time;
    std::string configuration;
    struct Cell {
        std::string cell;
        /// log(median ms) of every process: the raw evidence.
        std::vector<double> log_median_ms;
        /// The smallest change visible to interleaved pairs within one process, as a fraction (infinite: none, null in
        /// the file); rounds it took.
        double visible_paired = 0;
        std::size_t rounds = 0;
    };
    std::vector<Cell> cells;
    RunNoise between_runs;
};

/// Of a run's record (run.json).
MachineKey machine_of(const Json& run);

/// $RELIEFBENCH_STATE_DIR, else $XDG_STATE_HOME/reliefbench, else ~/.local/state/reliefbench.
std::filesystem::path state_folder();

/// One file per machine in the folder. Empty when none is kept; one that cannot be read is an Error.
std::optional<NoiseRecord> read_noise_record(const std::filesystem::path& state_folder, const MachineKey& machine);
void write_noise_record(const std::filesystem::path& state_folder, const NoiseRecord& record);

}  // namespace reliefbench
