#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace reliefbench {

/// The number that the whole of `text` writes, whatever the locale. Empty where anything else stands in it (a space, a
/// leading plus, nothing at all) and where `Number` cannot hold it. For a floating-point `Number`, "nan" and "inf" are
/// numbers too.
template <typename Number>
std::optional<Number> whole_text_as(std::string_view text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, number);
    if (status != std::errc() || stop != end) return std::nullopt;
    return number;
}

}  // namespace reliefbench
