#include "cli/command.hpp"
#include "cli/output_file.hpp"
#include "core/suggest.hpp"
#include "report/export.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace reliefbench {

namespace {

struct ExportOptions {
    std::string run;
    std::string format;
    std::string output = "-";
};

ExitCode export_stored(const ExportOptions& options) {
    check_output_file(options.output, "--output");
    write_output(options.output, export_run(options.run, parse_export_format(options.format)));
    return ExitCode::done;
}

}  // namespace

void add_export_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* command = app.add_subcommand("export", "Write a stored run in a format that other tools read");
    command->add_option("run", options->run, "Folder of a run")->required()->type_name("RUN");
    command
        ->add_option("--format", options->format,
                     "google_benchmark (JSON for its compare.py), github_action (github-action-benchmark), csv (one "
                     "row per cell) or markdown (quality against cost)")
        ->required()
        ->type_name(join(export_format_names(), "|"));
    command->add_option("-o,--output", options->output, "File to write or replace; default: -, standard output")
        ->type_name("FILE");
    command->footer("Example: reliefbench export results/mine --format csv -o mine.csv\n");
    command->callback([&chosen, options] { chosen = [options] { return export_stored(*options); }; });
}

}  // namespace reliefbench
