#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
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

/// A number above 0 with three significant digits, rounded up, so that what is above a limit reads as above it:
/// "0.301" of 0.3002, "18400" of 18308.
inline std::string figure_above(double value) {
    constexpr int digits = 3;
    if (!(value > 0) || !std::isfinite(value)) return fmt::format("{}", value);
    const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(value)));
    const double scale = std::pow(10.0, decimals);
    // What is a number of three digits but for its representation is not rounded up.
    constexpr double representation = 1e-9;
    const double rounded = std::ceil(value * scale * (1 - representation)) / scale;
    return fmt::format("{:.{}f}", rounded, std::max(decimals, 0));
}

}  // namespace reliefbench
