#include "core/suggest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace reliefbench {

namespace {

char lower(char character) {
    return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
}

/// Insertions, deletions, substitutions and swaps of neighbours (optimal string alignment); letter case is free.
std::size_t edit_distance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> before_previous;
    std::vector<std::size_t> previous(to.size() + 1);
    for (std::size_t column = 0; column <= to.size(); ++column) {
        previous[column] = column;
    }
    for (std::size_t row = 1; row <= from.size(); ++row) {
        std::vector<std::size_t> current(to.size() + 1, row);
        for (std::size_t column = 1; column <= to.size(); ++column) {
            const bool same = lower(from[row - 1]) == lower(to[column - 1]);
            current[column] =
                std::min({previous[column] + 1, current[column - 1] + 1, previous[column - 1] + (same ? 0 : 1)});
            const bool swapped = row > 1 && column > 1 && lower(from[row - 1]) == lower(to[column - 2]) &&
                                 lower(from[row - 2]) == lower(to[column - 1]);
            if (swapped) current[column] = std::min(current[column], before_previous[column - 2] + 1);
        }
        before_previous = std::move(previous);
        previous = std::move(current);
    }
    return previous.back();
}

}  // namespace

std::optional<std::size_t> nearest(std::string_view word, const std::vector<std::string>& candidates) {
    std::optional<std::size_t> found;
    std::size_t nearest_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (std::size_t index = 0; index < candidates.size(); ++index) {
        const std::size_t distance = edit_distance(word, candidates[index]);
        if (distance < nearest_distance) {
            nearest_distance = distance;
            found = index;
        }
    }
    return found;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
    const std::optional<std::size_t> found = nearest(word, candidates);
    return found ? fmt::format(" (did you mean '{}'?)", candidates[*found]) : "";
}

std::string join(const std::vector<std::string>& words, std::string_view separator) {
    return fmt::format("{}", fmt::join(words, separator));
}

}  // namespace reliefbench
