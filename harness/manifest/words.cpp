#include "manifest/words.hpp"

namespace reliefbench {

std::vector<std::string> words(std::string_view text) {
    std::vector<std::string> found;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        if (!word.empty()) found.emplace_back(word);
        text.remove_prefix(word.size() == text.size() ? word.size() : word.size() + 1);
    }
    return found;
}

}  // namespace reliefbench
