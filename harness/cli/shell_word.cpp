#include "cli/shell_word.hpp"

namespace reliefbench {

std::string shell_word(std::string_view text) {
    if (!text.empty() && text.find_first_of(" \t\n'\"\\$`*?[]#~&;|<>(){}!") == std::string_view::npos)
        return std::string(text);
    std::string quoted = "'";
    for (const char character : text) {
        quoted += character == '\'' ? std::string("'\\''") : std::string(1, character);
    }
    return quoted + "'";
}

}  // namespace reliefbench
