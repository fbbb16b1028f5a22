#pragma once

#include "cli/exit_code.hpp"
#include "gpu/device.hpp"
#include "technique/technique.hpp"

#include <optional>
#include <string>
#include <vector>

/// Only forward: CLI11 costs seconds per file.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace reliefbench {

/// Which techniques there are: the shipped ones and those of directories named with --techniques.
struct TechniqueOptions {
    std::vector<std::string> directories;

    void add_to(CLI::App& command);
    /// A directory that holds no technique is an Error.
    void check() const;
    /// Checked. A technique that takes a shipped one's place is told.
    TechniqueLibrary find() const;
    /// The same of directories that may hold none: those of a run's record.
    static TechniqueLibrary find_in(const std::vector<std::string>& directories);
};

/// Which cells of a configuration, with which values.
struct CellChoice {
    /// `-a` (sweep/override.hpp) and `--filter`.
    std::vector<std::string> axes;
    std::vector<std::string> filters;

    void add_to(CLI::App& command);
};

/// How cells are sampled, in place of the configuration's `sampling` (set_sampling).
struct SamplingChoice {
    std::vector<std::string> settings;

    void add_to(CLI::App& command);
};

/// Which device, and whether the validation layer watches.
struct DeviceChoice {
    gpu::DeviceOptions options;

    void add_to(CLI::App& command);
};

/// What making derived maps may cost, in place of the configuration's preparation.limit_s.
struct PreparationOptions {
    std::optional<double> limit_s;

    /// `otherwise`: the limit where none is given, in words.
    void add_to(CLI::App& command, const std::string& otherwise = "the configuration's preparation.limit_s, else 60");
};

/// Says every message of the validation layer; one of them makes the command fail.
ExitCode check_validation(const gpu::Device& device);

/// An option that may be given many times with one argument each: `CONFIG` after it is not swallowed.
CLI::Option* add_repeated_option(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                                 const std::string& help);

}  // namespace reliefbench
