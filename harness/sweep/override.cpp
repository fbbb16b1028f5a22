#include "sweep/override.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"

#include <cmath>
#include <cstdint>
#include <optional>

namespace reliefbench {

namespace {

constexpr double max_values = 100000;
/// 2^53: up to it doubles hold every integer.
constexpr double largest_exact_integer = 9007199254740992;

/// Names and paths, which are no numbers though they may look like one.
bool takes_words(const std::string& name) {
    return name == "technique" || name == "preset" || name == "heightmap" || name == "albedo";
}

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
    if (steps >= max_values) fail_range(text, target, fmt::format("has more than {} values", max_values));
    for (double index = 0; index <= steps; ++index) {
        const double number = start + index * step;
        if (whole_numbers) {
            target.values.emplace_back(static_cast<std::int64_t>(number));
        } else {
            target.values.emplace_back(without_rounding_noise(number));
        }
    }
}

/// A range is bare numbers between colons; what is quoted or nested is JSON.
bool is_range(std::string_view part) {
    return part.find(':') != std::string_view::npos && part.find_first_of("\"{") == std::string_view::npos;
}

/// Behind the string, array or object of JSON that begins at `begin`.
std::size_t end_of_json(const std::string& text, std::size_t begin, const std::string& argument) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t at = begin; at < text.size(); ++at) {
        const char c = text[at];
        if (in_string && c == '\\') {
            ++at;
        } else if (c == '"') {
            in_string = !in_string;
        } else if (!in_string && (c == '[' || c == '{')) {
            ++depth;
        } else if (!in_string && (c == ']' || c == '}')) {
            --depth;
        }
        if (!in_string && depth == 0) return at + 1;
    }
    fail("{}: '{}' lacks its closing {}", argument, text.substr(begin),
         text[begin] == '"'   ? "quote"
         : text[begin] == '[' ? "bracket"
                              : "brace");
}

/// A range, or JSON: a string or an object, or an array of values.
void append_json(const std::string& part, Override& target) {
    if (part.front() == '[' && is_range(part)) {
        append_range(part, target);
        return;
    }
    Json value;
    try {
        value = parse_json(part, target.argument);
    } catch (const Error& error) {
        fail(
            "{}: write words with commas only (a,b), strings with commas or brackets of their own as JSON "
            "([\"a\",\"b,c\"]), "
            "and ranges as [start:stop:step]",
            error.what());
    }
    if (value.is_array() && value.empty()) fail("{}: the list is empty", target.argument);
    if (!value.is_array()) {
        target.values.push_back(std::move(value));
        return;
    }
    for (Json& element : value)
        target.values.push_back(std::move(element));
}

/// A plain value ends at a comma; those in brackets do not count.
std::size_t end_of_word(const std::string& text, std::size_t begin) {
    int depth = 0;
    std::size_t at = begin;
    for (; at < text.size() && (text[at] != ',' || depth > 0); ++at) {
        if (text[at] == '[') ++depth;
        if (text[at] == ']' && depth > 0) --depth;
    }
    return at;
}

void append_values(const std::string& text, Override& target) {
    const bool words = takes_words(target.name);
    for (std::size_t begin = 0; begin <= text.size();) {
        const bool is_json =
            begin < text.size() && std::string_view("\"[{").find(text[begin]) != std::string_view::npos;
        const std::size_t end = is_json ? end_of_json(text, begin, target.argument) : end_of_word(text, begin);
        const std::string part = text.substr(begin, end - begin);
        if (part.empty()) fail("{}: a value is missing between commas", target.argument);
        if (end < text.size() && text[end] != ',') {
            fail("{}: expected a comma behind {}, found '{}'; a value that begins so is quoted as JSON is: [\"...\"]",
                 target.argument, part, text.substr(end));
        }
        if (is_json) {
            append_json(part, target);
        } else {
            target.values.push_back(words ? Json(part) : scalar_from_text(part));
        }
        begin = end + 1;
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

std::vector<Json> parse_values(const std::string& name, const std::string& text, const std::string& argument) {
    Override parsed{name, {}, argument};
    append_values(text, parsed);
    return std::move(parsed.values);
}

Override parse_override(const std::string& argument, const std::string& option) {
    const std::size_t equals = argument.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == argument.size()) {
        fail("{} {}: expected name=value,value or name=[start:stop:step]", option, argument);
    }
    Override parsed{argument.substr(0, equals), {}, option + " " + argument};
    append_values(argument.substr(equals + 1), parsed);
    return parsed;
}

}  // namespace reliefbench
