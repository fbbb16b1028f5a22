#include "cli/colour_choice.hpp"

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace reliefbench {

namespace {

std::string_view environment_value(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

}  // namespace

void ColourChoice::add_to(CLI::App& command) {
    command
        .add_option("--color", when, "Colours in the table; auto: on a terminal, unless NO_COLOR is set; default: auto")
        ->type_name("auto|always|never")
        ->check(CLI::IsMember({"auto", "always", "never"}).description(""));
}

bool ColourChoice::is_wanted() const {
    if (when != "auto") return when == "always";
    const std::string_view terminal = environment_value("TERM");
    return isatty(STDOUT_FILENO) == 1 && environment_value("NO_COLOR").empty() && !terminal.empty() &&
           terminal != "dumb";
}

}  // namespace reliefbench
