#include "sweep/override.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"

#include <cmath>
#include <cstdint>
#include <optional>

namespace reliefbench {

namespace {

constexpr double most_values = 100000;
/// 2^53: up to it doubles hold every integer.
constexpr double largest_exact_integer = 9007199254740992;

/// 0.1 + 2·0.1 as 0.3: without the last digits, which would make ids of their own.
double without_rounding_noise(double number) {
    return whole_text_as<double>(fmt::format("{:.12g}", number)).value_or(number);
}

[[noreturn]] void fail_range(const std::string& text, const Override& target, std::string_view why) {
    fail("{}: the range '{}' {}; write [start:stop:step], for example [0:80:20]", target.argument, text, why);
}

void append_range(const std::string& text, Override& target) {
    std::vector<double> numbers;
    bool whole_numbers = true;
    const std::string inside = text.substr(1, text.size() - 2);
    for (std::size_t begin = 0; begin <= inside.size();) {
        const std::size_t end = std::min(inside.find(':', begin), inside.size());
        const std::string part = inside.substr(begin, end - begin);
        const std::optional<double> number = whole_text_as<double>(part);
        if (!number || !std::isfinite(*number)) fail_range(text, target, fmt::format("has '{}' for a number", part));
        const bool exact = std::abs(*number) <= largest_exact_integer;
        whole_numbers = whole_numbers && exact && whole_text_as<std::int64_t>(part).has_value();
        numbers.push_back(*number);
        begin = end + 1;
    }
    if (numbers.size() != 3) fail_range(text, target, "does not have three numbers");
    const double start = numbers[0];
    const double stop = numbers[1];
    const double step = numbers[2];
    if (step == 0) fail_range(text, target, "has a step of zero");
    // A hair beyond, so that a stop that rounding just misses is met.
    const double steps = std::floor((stop - start) / step + 1e-9);
    if (steps < 0) fail_range(text, target, "steps away from its stop");
    if (steps >= most_values) fail_range(text, target, fmt::format("has more than {} values", most_values));
    for (double index = 0; index <= steps; ++index) {
        const double number = start + index * step;
        if (whole_numbers) {
            target.values.emplace_back(static_cast<std::int64_t>(number));
        } else {
            target.values.emplace_back(without_rounding_noise(number));
        }
    }
}

}  // namespace

Json scalar_from_text(const std::string& text) {
    if (text == "true") return true;
    if (text == "false") return false;
    if (const auto number = whole_text_as<std::int64_t>(text)) return *number;
    if (const auto number = whole_text_as<double>(text); number && std::isfinite(*number)) return *number;
    return text;
}

std::vector<std::string> split_list(const std::string& text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    for (const char c : text) {
        if (c == '[') ++depth;
        if (c == ']') --depth;
        if (c == ',' && depth == 0) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

Override parse_override(const std::string& argument) {
    Override parsed;
    parsed.argument = "-a " + argument;
    const std::size_t equals = argument.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == argument.size()) {
        fail("-a {}: expected name=value,value or name=[start:stop:step]", argument);
    }
    parsed.name = argument.substr(0, equals);
    const std::string text = argument.substr(equals + 1);
    if (text.front() == '{') {
        parsed.values.push_back(parse_json(text, parsed.argument));
        return parsed;
    }
    for (const std::string& part : split_list(text)) {
        if (part.empty()) fail("-a {}: a value is missing between commas", argument);
        if (part.front() == '[') {
            if (part.back() != ']') fail("-a {}: '{}' lacks its closing bracket", argument, part);
            append_range(part, parsed);
        } else {
            parsed.values.push_back(scalar_from_text(part));
        }
    }
    return parsed;
}

}  // namespace reliefbench
