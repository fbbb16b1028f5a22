#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reliefbench {

std::size_t text_width(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;  // UTF-8 continuation bytes take no column
    }));
}

std::string pad_left(std::string_view text, std::size_t width) {
    return std::string(width - std::min(width, text_width(text)), ' ') + std::string(text);
}

std::string pad_right(std::string_view text, std::size_t width) {
    return std::string(text) + std::string(width - std::min(width, text_width(text)), ' ');
}

std::vector<std::string> wrap(std::string_view text, std::size_t width) {
    std::vector<std::string> lines(1);
    std::size_t begin = 0;
    while (begin < text.size()) {
        const bool is_indented = text[begin] == ' ' && (begin == 0 || text[begin - 1] == '\n');
        const std::size_t end = std::min(text.find_first_of(is_indented ? "\n" : " \n", begin), text.size());
        const std::string_view word = text.substr(begin, end - begin);
        std::string& line = lines.back();
        if (line.empty()) {
            line = word;
        } else if (text_width(line) + 1 + text_width(word) <= width) {
            line += ' ';
            line += word;
        } else {
            lines.emplace_back(word);
        }
        if (end < text.size() && text[end] == '\n') lines.emplace_back();
        begin = end + 1;
    }
    return lines;
}

std::string indented(std::string_view text, std::size_t indent, std::size_t width) {
    std::string lines;
    for (const std::string& line : wrap(text, width - std::min(width, indent))) {
        lines += std::string(indent, ' ') + line + '\n';
    }
    return lines;
}

std::string significant(double value, int digits) {
    constexpr double smallest_plain = 1e-4;
    constexpr double largest_plain = 1e7;
    const double magnitude = std::abs(value);
    if (magnitude == 0) return "0";
    if (magnitude < smallest_plain || magnitude >= largest_plain) return fmt::format("{:.{}e}", value, digits - 1);
    // The exponent after rounding: 9.996 has the digits of 10.0.
    const std::string rounded = fmt::format("{:.{}e}", magnitude, digits - 1);
    const int exponent = std::stoi(rounded.substr(rounded.find('e') + 1));
    return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent));
}

}  // namespace reliefbench
