#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// The index of the candidate nearest to `word` by edit distance, or nothing when none is near.
std::optional<std::size_t> nearest(std::string_view word, const std::vector<std::string>& candidates);

/// " (did you mean 'x'?)" for that candidate, or "" when none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b, c".
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");

}  // namespace reliefbench
