#include "cli/usage_complaint.hpp"

#include "core/number_text.hpp"
#include "core/suggest.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace reliefbench {

namespace {

std::vector<std::string> command_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::App* each : command.get_subcommands({}))
        names.push_back(each->get_name());
    return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options({})) {
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    }
    return names;
}

/// A command and how it is called: "reliefbench list".
struct NamedCommand {
    const CLI::App* command;
    std::string name;
};

/// The command that was named, as far as it was understood, behind those that it belongs to.
std::vector<NamedCommand> named_commands(const CLI::App& app) {
    std::vector<NamedCommand> named{{&app, app.get_name()}};
    for (std::vector<CLI::App*> next = app.get_subcommands(); !next.empty();
         next = named.back().command->get_subcommands()) {
        named.push_back({next.front(), named.back().name + " " + next.front()->get_name()});
    }
    return named;
}

/// Where one of several commands has to follow and none does.
std::string complain_of_command(const NamedCommand& named) {
    const std::vector<std::string> names = command_names(*named.command);
    const std::vector<std::string> words = named.command->remaining();
    const auto word = std::ranges::find_if(words, [](const std::string& each) { return !each.starts_with('-'); });
    const bool is_whole_program = named.command->get_parent() == nullptr;
    if (word == words.end()) {
        return is_whole_program ? fmt::format("a command is missing; the commands are {}", join(names))
                                : fmt::format("`{}` of what? There are {}", named.name, join(names));
    }
    return is_whole_program ? fmt::format("there is no command '{}'{}; the commands are {}", *word,
                                          did_you_mean(*word, names), join(names))
                            : fmt::format("there is no `{}` of '{}'{}; there are {}", named.name, *word,
                                          did_you_mean(*word, names), join(names));
}

/// Of an option or an argument that the command does not take; empty where it takes all that there are.
std::string complain_of_extra(const NamedCommand& named) {
    const std::vector<std::string> extras = named.command->remaining();
    if (extras.empty()) return {};
    const auto option = std::ranges::find_if(extras, [](const std::string& each) { return each.starts_with('-'); });
    if (option == extras.end()) {
        return fmt::format("`{}` takes no {} '{}'", named.name, extras.size() == 1 ? "argument" : "arguments",
                           join(extras, "' '"));
    }
    const std::string name = option->substr(0, option->find('='));
    return fmt::format("`{}` has no option '{}'{}", named.name, name, did_you_mean(name, option_names(*named.command)));
}

/// Of an option whose value is no number: all others take words, and judge them themselves.
std::string complain_of_number(const NamedCommand& named, const std::string& message) {
    for (const CLI::Option* option : named.command->get_options({})) {
        for (const std::string& value : option->results()) {
            if (message != fmt::format("Could not convert: {} = {}", option->get_name(), value)) continue;
            const bool is_number = whole_text_as<double>(value).has_value();
            return fmt::format("{}: expected a {}number, found '{}'", option->get_name(), is_number ? "whole " : "",
                               value);
        }
    }
    return message;
}

std::string complaint_of(const std::vector<NamedCommand>& commands, const CLI::ParseError& error) {
    const NamedCommand& named = commands.back();
    const bool needs_command = named.command->get_require_subcommand_min() > 0;
    const bool lacks_something = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    const bool has_extras = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
    if (lacks_something && needs_command) return complain_of_command(named);
    if (lacks_something || has_extras) {
        // A mistyped option first: for it, or its value, something seems to be missing.
        for (const NamedCommand& each : commands) {
            if (const std::string complaint = complain_of_extra(each); !complaint.empty()) return complaint;
        }
    }
    if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) return complain_of_number(named, error.what());
    return error.what();
}

}  // namespace

std::string usage_complaint(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<NamedCommand> commands = named_commands(app);
    return fmt::format("{}; see `{} --help`", complaint_of(commands, error), commands.back().name);
}

}  // namespace reliefbench
