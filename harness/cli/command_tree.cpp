#include "cli/command_tree.hpp"

#include "core/split.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace reliefbench {

namespace {

constexpr std::string_view example = "Example: ";

/// CLI11 appends what a check says of itself: "DIR:FILE in ...", ":{plain,force}".
std::string argument_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    return type.substr(0, type.find(':'));
}

OptionDescription describe(const CLI::Option& option) {
    OptionDescription description;
    for (const std::string& name : option.get_snames()) {
        description.names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        description.names.push_back("--" + name);
    }
    if (option.get_items_expected_max() > 0) description.argument = argument_of(option);
    description.help = option.get_description();
    description.required = option.get_required();
    description.repeated =
        option.get_items_expected_max() > 1 || option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    return description;
}

CommandDescription describe(const CLI::App& app, std::vector<std::string> path) {
    path.push_back(app.get_name());
    CommandDescription description;
    description.path = path;
    description.help = app.get_description();
    description.footer = app.get_footer();
    for (const CLI::Option* option : app.get_options({})) {
        (option->get_positional() ? description.positionals : description.options).push_back(describe(*option));
    }
    for (const CLI::App* command : app.get_subcommands({})) {
        description.commands.push_back(describe(*command, path));
    }
    return description;
}

}  // namespace

std::vector<std::string> OptionDescription::choices() const {
    const bool lists_values = argument.find('|') != std::string::npos &&
                              std::none_of(argument.begin(), argument.end(),
                                           [](unsigned char character) { return std::isupper(character) != 0; });
    return lists_values ? split(argument, '|') : std::vector<std::string>();
}

CommandDescription describe_commands(const CLI::App& app) {
    return describe(app, {});
}

std::vector<std::string> examples_of(const std::string& footer) {
    std::vector<std::string> examples;
    for (const std::string& line : split(footer, '\n')) {
        if (line.starts_with(example)) examples.push_back(line.substr(example.size()));
    }
    return examples;
}

std::vector<std::string> paragraphs_of(const std::string& footer) {
    std::vector<std::string> paragraphs;
    for (const std::string& line : split(footer, '\n')) {
        if (line.empty() || line.starts_with(example)) continue;
        if (line.starts_with(' ') && !paragraphs.empty()) {
            paragraphs.back() += line.substr(line.find_first_not_of(' ') - 1);
        } else {
            paragraphs.push_back(line);
        }
    }
    return paragraphs;
}

}  // namespace reliefbench
