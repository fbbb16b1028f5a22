#include "report/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace reliefbench {

namespace {

std::string on_one_line(std::string_view text) {
    std::string line(text);
    std::replace(line.begin(), line.end(), '\n', ' ');
    std::replace(line.begin(), line.end(), '\r', ' ');
    return line;
}

std::string_view rule_of(char alignment) {
    switch (alignment) {
        case 'r':
            return "---:";
        case 'c':
            return ":---:";
        default:
            return "---";
    }
}

std::string row_line(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) {
        line += fmt::format(" {} |", cell);
    }
    return line + '\n';
}

}  // namespace

std::string markdown_text(std::string_view text) {
    std::string escaped;
    for (const char character : on_one_line(text)) {
        if (std::string_view("\\`*_[]<>|~&").find(character) != std::string_view::npos) escaped += '\\';
        escaped += character;
    }
    return escaped;
}

std::string markdown_code(std::string_view text) {
    std::size_t longest = 0;
    std::size_t run = 0;
    std::string escaped;
    for (const char character : on_one_line(text)) {
        run = character == '`' ? run + 1 : 0;
        longest = std::max(longest, run);
        if (character == '|') escaped += '\\';
        escaped += character;
    }
    const std::string fence(longest + 1, '`');
    const char* const space = longest > 0 ? " " : "";
    return fence + space + escaped + space + fence;
}

std::string markdown_table(const std::vector<std::string>& titles, std::string_view alignment,
                           const std::vector<std::vector<std::string>>& rows) {
    assert(alignment.size() == titles.size());
    std::vector<std::string> rules;
    for (const char each : alignment) {
        rules.emplace_back(rule_of(each));
    }
    std::string table = row_line(titles) + row_line(rules);
    for (const std::vector<std::string>& row : rows) {
        assert(row.size() == titles.size());
        table += row_line(row);
    }
    return table;
}

std::string markdown_details(std::string_view summary, std::string_view content) {
    // The empty lines make GitHub read the content as Markdown again.
    return fmt::format("<details><summary>{}</summary>\n\n{}\n</details>\n", summary, content);
}

}  // namespace reliefbench
