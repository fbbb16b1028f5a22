#pragma once

#include <string>
#include <vector>

/// Only forward: CLI11 costs seconds per file.
namespace CLI {
class App;
}

namespace reliefbench {

/// An option or a positional argument as the command line declares it.
struct OptionDescription {
    /// "-o", "--output"; of a positional argument empty.
    std::vector<std::string> names;
    /// What it takes, as help writes it: "DIR", "csv|markdown"; empty for a flag.
    std::string argument;
    std::string help;
    bool required = false;
    bool repeated = false;

    /// The values, where `argument` lists them ("csv|markdown"); else empty.
    std::vector<std::string> choices() const;
};

/// A command, for what is written from the command line's own words: completion and the manual.
struct CommandDescription {
    /// From the program on: "reliefbench list techniques".
    std::vector<std::string> path;
    std::string help;
    /// Paragraphs and examples below the options.
    std::string footer;
    std::vector<OptionDescription> options;
    std::vector<OptionDescription> positionals;
    std::vector<CommandDescription> commands;

    const std::string& name() const { return path.back(); }
};

CommandDescription describe_commands(const CLI::App& app);

/// A footer's lines that begin with "Example: ", without that; and its other lines, joined where they go on indented.
std::vector<std::string> examples_of(const std::string& footer);
std::vector<std::string> paragraphs_of(const std::string& footer);

}  // namespace reliefbench
