#include "cli/completion.hpp"

#include "core/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace reliefbench {

namespace {

/// What a value is completed with.
enum class ValueKind { choices, folders, files, techniques, settings, anything };

ValueKind kind_of(const OptionDescription& option) {
    const std::string& argument = option.argument;
    if (!option.choices().empty()) return ValueKind::choices;
    if (argument == "ID") return ValueKind::techniques;
    if (argument.starts_with("NAME=") || argument == "EXPR") return ValueKind::settings;
    if (argument == "FILE" || argument == "CONFIG") return ValueKind::files;
    for (const char* folder : {"DIR", "RUN", "BASE"}) {
        if (argument.starts_with(folder)) return ValueKind::folders;
    }
    return ValueKind::anything;
}

/// Every command, the program first.
void for_each_command(const CommandDescription& command, const std::function<void(const CommandDescription&)>& visit) {
    visit(command);
    for (const CommandDescription& below : command.commands) {
        for_each_command(below, visit);
    }
}

/// "list/techniques"; of the program "".
std::string path_below(const CommandDescription& command) {
    return join({command.path.begin() + 1, command.path.end()}, "/");
}

std::vector<std::string> option_names(const CommandDescription& command) {
    std::vector<std::string> names;
    for (const OptionDescription& option : command.options) {
        names.insert(names.end(), option.names.begin(), option.names.end());
    }
    return names;
}

std::string bash_values(const OptionDescription& option) {
    switch (kind_of(option)) {
        case ValueKind::choices:
            return fmt::format("__reliefbench_words {}", join(option.choices(), " "));
        case ValueKind::folders:
            return "__reliefbench_paths -d";
        case ValueKind::files:
            return "__reliefbench_paths -f";
        case ValueKind::techniques:
            return "__reliefbench_words $(__reliefbench_names techniques)";
        case ValueKind::settings:
            return "__reliefbench_settings";
        case ValueKind::anything:
            return ":";
    }
    return ":";
}

/// The words before the cursor are split at '=', as bash does by default.
constexpr const char* bash_functions = R"(
__reliefbench_words() {
    COMPREPLY=($(compgen -W "$*" -- "$current"))
}

__reliefbench_paths() {
    compopt -o filenames 2>/dev/null
    local IFS=$'\n'
    COMPREPLY=($(compgen "$1" -- "$current"))
}

__reliefbench_names() {
    "${COMP_WORDS[0]}" list "$1" 2>/dev/null | sed -n 's/^\([^ ]\{1,\}\) .*/\1/p' | grep -vx -e or -e in
}
)";

constexpr const char* bash_settings = R"(
__reliefbench_settings() {{
    case "$setting" in
        technique) __reliefbench_words $(__reliefbench_names techniques) ;;
        preset) __reliefbench_words $(__reliefbench_names presets) ;;
        heightmap) __reliefbench_words $(__reliefbench_names heightmaps) ;;
        '')
            compopt -o nospace 2>/dev/null
            COMPREPLY=($(compgen -S = -W "{}" -- "$current"))
            ;;
    esac
}}
)";

constexpr const char* bash_head = R"(
_reliefbench() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command= setting= i
    COMPREPLY=()
    # --format=c and --filter technique=p: the word before the '='.
    if [[ $current == = ]]; then
        current=
        setting=$previous
        previous=${COMP_WORDS[COMP_CWORD-2]}
    elif [[ $previous == = ]]; then
        setting=${COMP_WORDS[COMP_CWORD-2]}
        previous=${COMP_WORDS[COMP_CWORD-3]}
    fi
    if [[ $setting == -* ]]; then
        previous=$setting
        setting=
    fi
    for ((i = 1; i < COMP_CWORD; i++)); do
        case "$command/${COMP_WORDS[i]}" in
)";

std::string zsh_value(const OptionDescription& option) {
    switch (kind_of(option)) {
        case ValueKind::choices:
            return fmt::format("({})", join(option.choices(), " "));
        case ValueKind::folders:
            return "_files -/";
        case ValueKind::files:
            return "_files";
        case ValueKind::techniques:
            return "__reliefbench_techniques";
        case ValueKind::settings:
            return "__reliefbench_settings";
        case ValueKind::anything:
            return " ";
    }
    return " ";
}

/// Inside single quotes, in a specification of _arguments.
std::string zsh_text(const std::string& text) {
    std::string escaped;
    for (const char character : text) {
        if (character == '\'') {
            escaped += "'\\''";
            continue;
        }
        if (character == '[' || character == ']' || character == ':' || character == '\\') escaped += '\\';
        escaped += character;
    }
    return escaped;
}

std::string zsh_specification(const OptionDescription& option) {
    const std::string value =
        option.argument.empty() ? "" : fmt::format(":{}:{}", zsh_text(option.argument), zsh_text(zsh_value(option)));
    const std::string rest = fmt::format("[{}]{}'", zsh_text(option.help), value);
    const std::string repeated = option.repeated ? "*" : "";
    std::string text;
    for (const std::string& name : option.names) {
        // One name excludes the others, unless it may be given again.
        const std::string excluded =
            option.repeated || option.names.size() == 1 ? "" : fmt::format("({})", join(option.names, " "));
        text += fmt::format(" \\\n        '{}{}{}{}", excluded, repeated, name, rest);
    }
    return text;
}

std::string zsh_function_name(const CommandDescription& command) {
    return "_" + join(command.path, "_");
}

std::string zsh_function(const CommandDescription& command) {
    std::string text = fmt::format("{}() {{\n    local state\n    _arguments -C", zsh_function_name(command));
    for (const OptionDescription& option : command.options) {
        text += zsh_specification(option);
    }
    for (const OptionDescription& positional : command.positionals) {
        text += fmt::format(" \\\n        '{}:{}:{}'", positional.repeated ? "*" : "", zsh_text(positional.argument),
                            zsh_text(zsh_value(positional)));
    }
    if (command.commands.empty()) return text + "\n}\n\n";
    text +=
        " \\\n        '1:command:->command' '*::argument:->argument'\n    case $state in\n        command)\n"
        "            local -a commands=(";
    for (const CommandDescription& below : command.commands) {
        text += fmt::format("\n                '{}:{}'", below.name(), zsh_text(below.help));
    }
    text += ")\n            _describe command commands ;;\n        argument)\n            case $words[1] in\n";
    for (const CommandDescription& below : command.commands) {
        text += fmt::format("                {}) {} ;;\n", below.name(), zsh_function_name(below));
    }
    return text + "            esac ;;\n    esac\n}\n\n";
}

constexpr const char* zsh_head = R"(#compdef reliefbench
# Written by `reliefbench completion zsh`.

__reliefbench_names() {
    reliefbench list $1 2>/dev/null | sed -n 's/^\([^ ]\{1,\}\) .*/\1/p' | grep -vx -e or -e in
}

__reliefbench_techniques() {
    compadd -- $(__reliefbench_names techniques)
}

)";

constexpr const char* zsh_settings = R"(__reliefbench_settings() {{
    if compset -P 'technique='; then
        compadd -- $(__reliefbench_names techniques)
    elif compset -P 'preset='; then
        compadd -- $(__reliefbench_names presets)
    elif compset -P 'heightmap='; then
        compadd -- $(__reliefbench_names heightmaps)
    elif [[ $PREFIX != *=* ]]; then
        compadd -S = -- {}
    fi
}}

)";

}  // namespace

std::string bash_completion(const CommandDescription& program, const std::vector<std::string>& axes) {
    std::string commands;
    std::string cases;
    for_each_command(program, [&](const CommandDescription& command) {
        const std::string path = path_below(command);
        if (!path.empty()) {
            const std::string above = path.substr(0, path.size() - command.name().size());
            commands += fmt::format("            {}) command={} ;;\n", above.empty() ? "/" + path : path, path);
        }
        cases += fmt::format("        '{}')\n            case \"$previous\" in\n", path);
        for (const OptionDescription& option : command.options) {
            if (option.argument.empty()) continue;
            cases += fmt::format("                {}) {}; return ;;\n", join(option.names, "|"), bash_values(option));
        }
        std::vector<std::string> below;
        for (const CommandDescription& each : command.commands) {
            below.push_back(each.name());
        }
        std::string words = fmt::format("__reliefbench_words {}", join(below, " "));
        if (!command.positionals.empty()) words = bash_values(command.positionals.front());
        cases += fmt::format(
            "            esac\n            if [[ $current == -* ]]; then __reliefbench_words {}; else {}; fi ;;\n",
            join(option_names(command), " "), words);
    });
    return "# Written by `reliefbench completion bash`.\n" + std::string(bash_functions) +
           fmt::format(bash_settings, join(axes, " ")) + bash_head + commands +
           "        esac\n    done\n    case \"$command\" in\n" + cases +
           "    esac\n}\n\ncomplete -F _reliefbench reliefbench\n";
}

std::string zsh_completion(const CommandDescription& program, const std::vector<std::string>& axes) {
    std::string text = zsh_head + fmt::format(zsh_settings, join(axes, " "));
    for_each_command(program, [&](const CommandDescription& command) { text += zsh_function(command); });
    return text +
           "if [[ $funcstack[1] == _reliefbench ]]; then\n    _reliefbench \"$@\"\nelse\n"
           "    compdef _reliefbench reliefbench\nfi\n";
}

}  // namespace reliefbench
