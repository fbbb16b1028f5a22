#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// " (did you mean 'x'?)" for the candidate nearest to `word` by edit distance, or "" when none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b, c".
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");

}  // namespace reliefbench
