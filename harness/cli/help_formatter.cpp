#include "cli/help_formatter.hpp"

#include <CLI/CLI.hpp>

namespace reliefbench {

std::string HelpFormatter::make_option_name(const CLI::Option* option, bool is_positional) const {
    const std::string name = Formatter::make_option_name(option, is_positional);
    return is_positional ? name : name.substr(0, name.find('{'));
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
    // Of a flag that takes a value all the same: "[=force]", right behind its name.
    if (option->get_option_text().starts_with('[')) return option->get_option_text();
    std::string text = Formatter::make_option_opts(option);
    const std::string type = option->get_type_name();
    if (const std::size_t note = type.find(':'); note != std::string::npos) {
        const std::size_t found = text.find(type);
        if (found != std::string::npos) text.erase(found + note, type.size() - note);
    }
    return text;
}

}  // namespace reliefbench
