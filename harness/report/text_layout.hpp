#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// Stands where a figure has no value.
inline constexpr const char* undefined = "-";
/// Spaces between a table's columns.
inline constexpr std::size_t space_between = 2;

/// Terminal columns, one per code point.
std::size_t text_width(std::string_view text);

std::string pad_left(std::string_view text, std::size_t width);
std::string pad_right(std::string_view text, std::size_t width);

/// Breaks at spaces and line ends into lines of at most `width` columns; a longer word stays whole, and so does a line of
/// the text that begins with a space: it is code, or points at code. At least one line.
std::vector<std::string> wrap(std::string_view text, std::size_t width);

/// Wrapped to `width` columns, each line indented and ended.
std::string indented(std::string_view text, std::size_t indent, std::size_t width);

/// At least `digits` significant ones, without an exponent where it reads better: "0.00123", "12.3", "4567",
/// "1.20e-05".
std::string significant(double value, int digits = 3);

}  // namespace reliefbench
