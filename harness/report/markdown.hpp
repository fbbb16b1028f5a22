#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// Text that Markdown (GitHub's) and HTML show as it stands, on one line.
std::string markdown_text(std::string_view text);

/// A code span that may stand inside a table: `|` is escaped there, and backticks inside are fenced by more of them.
std::string markdown_code(std::string_view text);

/// `cells` are Markdown already. `alignment`: one of 'l', 'c', 'r' per column.
std::string markdown_table(const std::vector<std::string>& titles, std::string_view alignment,
                           const std::vector<std::vector<std::string>>& rows);

/// Folded until it is clicked on. `content` is Markdown.
std::string markdown_details(std::string_view summary, std::string_view content);

}  // namespace reliefbench
