#include "cli/man_page.hpp"

#include "core/suggest.hpp"
#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace reliefbench {

namespace {

/// As text: no line is a request, and hyphens that are typed stay hyphens.
std::string roff_text(std::string_view text) {
    std::string escaped;
    for (const char character : text) {
        if (character == '\\') {
            escaped += "\\e";
        } else if (character == '-') {
            escaped += "\\-";
        } else {
            escaped += character;
        }
    }
    const bool looks_like_request = escaped.starts_with('.') || escaped.starts_with('\'');
    return looks_like_request ? "\\&" + escaped : escaped;
}

/// Broken into lines as sources of manuals are; roff fills them again.
std::string roff_paragraph(const std::string& text) {
    constexpr std::size_t source_columns = 72;
    std::string lines;
    for (const std::string& line : wrap(text, source_columns)) {
        lines += roff_text(line) + '\n';
    }
    return lines;
}

std::string bold(std::string_view text) {
    return "\\fB" + roff_text(text) + "\\fR";
}

std::string italic(std::string_view text) {
    return "\\fI" + roff_text(text) + "\\fR";
}

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char character) { return static_cast<char>(std::toupper(character)); });
    return text;
}

std::string option_entry(const OptionDescription& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.names) {
        names.push_back(bold(name));
    }
    std::string title = join(names, ", ");
    if (!option.argument.empty()) title += (title.empty() ? "" : " ") + italic(option.argument);
    return fmt::format(".TP\n{}\n{}", title, roff_paragraph(option.help));
}

std::string examples_text(const std::string& footer) {
    std::string text;
    for (const std::string& line : examples_of(footer)) {
        text += roff_text(line) + '\n';
    }
    return text.empty() ? "" : ".PP\nExample:\n.PP\n.RS 4\n.nf\n" + text + ".fi\n.RE\n";
}

std::string synopsis(const CommandDescription& command) {
    std::string text = bold(join(command.path, " "));
    if (!command.options.empty()) text += " [" + italic("OPTION") + "...]";
    for (const OptionDescription& positional : command.positionals) {
        const std::string argument = italic(positional.argument) + (positional.repeated ? "..." : "");
        text += positional.required ? " " + argument : " [" + argument + "]";
    }
    return text;
}

/// Of a command that can be run: those that only hold others are seen in their names.
std::string command_section(const CommandDescription& command) {
    std::string text;
    if (command.commands.empty()) {
        text = fmt::format(".SS {}\n{}", synopsis(command), roff_paragraph(command.help + '.'));
        for (const auto* options : {&command.positionals, &command.options}) {
            for (const OptionDescription& option : *options) {
                text += option_entry(option);
            }
        }
        // Lines of one paragraph: footers are broken for the terminal.
        const std::vector<std::string> lines = paragraphs_of(command.footer);
        if (!lines.empty()) text += ".PP\n";
        for (const std::string& line : lines) {
            text += roff_paragraph(line);
        }
        text += examples_text(command.footer);
    }
    for (const CommandDescription& below : command.commands) {
        text += command_section(below);
    }
    return text;
}

}  // namespace

std::string man_page(const CommandDescription& program, const std::string& version) {
    const std::string& name = program.name();
    std::string text = fmt::format(".TH {} 1 \"\" \"{} {}\" \"User Commands\"\n", upper(name), name, version);
    // Names of options are not hyphenated.
    text += ".nh\n.ad l\n";
    text += fmt::format(".SH NAME\n{} \\- {}", name, roff_paragraph(program.help));
    text += fmt::format(".SH SYNOPSIS\n{} {} [{}...]\n", bold(name), italic("COMMAND"), italic("OPTION"));
    text += ".SH COMMANDS\n";
    for (const CommandDescription& command : program.commands) {
        text += command_section(command);
    }
    // "Exit codes: 0 done, ..." is a section.
    for (const std::string& paragraph : paragraphs_of(program.footer)) {
        const std::size_t colon = paragraph.find(": ");
        if (colon == std::string::npos) continue;
        text +=
            fmt::format(".SH {}\n{}", upper(paragraph.substr(0, colon)), roff_paragraph(paragraph.substr(colon + 2)));
    }
    return text;
}

}  // namespace reliefbench
