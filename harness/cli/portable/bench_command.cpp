#include "cli/command.hpp"
#include "core/error.hpp"

#include <CLI/CLI.hpp>

namespace reliefbench {

void add_bench_command(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("bench", "Not in this portable build, which has no Google Benchmark");
    command->allow_extras();
    command->callback([&chosen] {
        chosen = []() -> ExitCode {
            fail(
                "this portable build has no Google Benchmark: measure with `reliefbench run`, or use a full build for "
                "`bench`");
        };
    });
}

}  // namespace reliefbench
