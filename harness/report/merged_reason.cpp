#include "report/merged_reason.hpp"

#include "core/number_text.hpp"

#include <cctype>
#include <cstddef>
#include <string_view>
#include <utility>

namespace reliefbench {

namespace {

struct Parts {
    std::vector<std::string> words{""};
    std::vector<std::string> figures;
};

bool is_digit(char character) {
    return std::isdigit(static_cast<unsigned char>(character)) != 0;
}

/// Of the figure that begins at `at`: digits, one point between digits, a sign before them; 0 where none does. Numbers
/// within words and names ("512x512", "trace.glsl:12", "leaf_2") are none.
std::size_t figure_length(std::string_view text, std::size_t at) {
    constexpr std::string_view before = " (\n";
    constexpr std::string_view after = " ,;)%\n";
    if (at > 0 && before.find(text[at - 1]) == std::string_view::npos) return 0;
    std::size_t end = at + (text[at] == '-' ? 1 : 0);
    const std::size_t first = end;
    bool has_point = false;
    while (end < text.size() && (is_digit(text[end]) || (text[end] == '.' && !has_point && end > first))) {
        has_point = has_point || text[end] == '.';
        ++end;
    }
    if (end > first && text[end - 1] == '.') --end;
    const bool ends = end == text.size() || after.find(text[end]) != std::string_view::npos ||
                      (text[end] == '.' && end + 1 == text.size());
    return end > first && ends ? end - at : 0;
}

Parts parts_of(std::string_view text) {
    Parts parts;
    for (std::size_t at = 0; at < text.size();) {
        if (const std::size_t length = figure_length(text, at); length > 0) {
            parts.figures.emplace_back(text.substr(at, length));
            parts.words.emplace_back();
            at += length;
        } else {
            parts.words.back() += text[at++];
        }
    }
    return parts;
}

bool is_less(const std::string& a, const std::string& b) {
    return whole_text_as<double>(a).value_or(0) < whole_text_as<double>(b).value_or(0);
}

}  // namespace

MergedReason::MergedReason(const std::string& reason) {
    Parts parts = parts_of(reason);
    words_ = std::move(parts.words);
    for (const std::string& figure : parts.figures)
        figures_.push_back({figure, figure});
}

bool MergedReason::add(const std::string& reason) {
    const Parts parts = parts_of(reason);
    if (parts.words != words_) return false;
    for (std::size_t i = 0; i < figures_.size(); ++i) {
        if (is_less(parts.figures[i], figures_[i].least)) figures_[i].least = parts.figures[i];
        if (is_less(figures_[i].greatest, parts.figures[i])) figures_[i].greatest = parts.figures[i];
    }
    return true;
}

std::string MergedReason::text() const {
    std::string text = words_.front();
    for (std::size_t i = 0; i < figures_.size(); ++i) {
        text += figures_[i].least;
        if (is_less(figures_[i].least, figures_[i].greatest)) text += " to " + figures_[i].greatest;
        text += words_[i + 1];
    }
    return text;
}

}  // namespace reliefbench
