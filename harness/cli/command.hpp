#pragma once

#include "cli/exit_code.hpp"

#include <functional>
#include <string>
#include <vector>

/// Only forward: CLI11 costs seconds per file.
namespace CLI {
class App;
}

namespace reliefbench {

/// What the command line asked for: set by the subcommand that was parsed.
using ChosenCommand = std::function<ExitCode()>;

/// Each declares one subcommand with its options; when the command line names it, `chosen` runs it.
void add_list_command(CLI::App& app, ChosenCommand& chosen);
/// `command_line` goes into the run's record.
void add_run_command(CLI::App& app, ChosenCommand& chosen, const std::vector<std::string>& command_line);
void add_render_command(CLI::App& app, ChosenCommand& chosen);
void add_verify_command(CLI::App& app, ChosenCommand& chosen);
void add_compare_command(CLI::App& app, ChosenCommand& chosen);
void add_history_command(CLI::App& app, ChosenCommand& chosen);
void add_ab_command(CLI::App& app, ChosenCommand& chosen);
void add_selfcheck_command(CLI::App& app, ChosenCommand& chosen);
void add_export_command(CLI::App& app, ChosenCommand& chosen);
void add_advise_command(CLI::App& app, ChosenCommand& chosen, const std::vector<std::string>& command_line);
void add_report_command(CLI::App& app, ChosenCommand& chosen);
void add_merge_command(CLI::App& app, ChosenCommand& chosen);
void add_bench_command(CLI::App& app, ChosenCommand& chosen);
/// Both write what they print from the other commands' own declarations; `app` must outlive `chosen`.
void add_completion_command(CLI::App& app, ChosenCommand& chosen);
void add_man_command(CLI::App& app, ChosenCommand& chosen);

}  // namespace reliefbench
