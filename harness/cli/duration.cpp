#include "cli/duration.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"

#include <optional>
#include <string_view>
#include <utility>

namespace reliefbench {

double parse_duration(const std::string& text, const std::string& option) {
    constexpr double longest_s = 7 * 24 * 3600;
    std::string_view digits = text;
    double unit_s = 1;
    if (digits.ends_with('m')) unit_s = 60;
    if (digits.ends_with('h')) unit_s = 3600;
    if (!digits.empty() && std::string_view("smh").find(digits.back()) != std::string_view::npos) {
        digits.remove_suffix(1);
    }
    const std::optional<double> number = whole_text_as<double>(digits);
    if (!number) fail("{}: expected a time such as 90s, 5m or 1h, found '{}'", option, text);
    const double seconds = *number * unit_s;
    if (!(seconds > 0 && seconds <= longest_s)) {
        fail("{}: expected a time above 0 and of at most a week, found '{}'", option, text);
    }
    return seconds;
}

double parse_milliseconds(const std::string& text, const std::string& option) {
    constexpr double longest_ms = 7.0 * 24 * 3600 * 1000;
    constexpr std::pair<std::string_view, double> units[] = {{"ms", 1}, {"us", 1e-3}, {"ns", 1e-6}, {"s", 1000}};
    std::string_view digits = text;
    double unit_ms = 1;
    for (const auto& [unit, ms] : units) {
        if (!digits.ends_with(unit)) continue;
        digits.remove_suffix(unit.size());
        unit_ms = ms;
        break;
    }
    const std::optional<double> number = whole_text_as<double>(digits);
    if (!number) fail("{}: expected a time such as 2ms or 500us, found '{}'", option, text);
    const double milliseconds = *number * unit_ms;
    if (!(milliseconds > 0 && milliseconds <= longest_ms)) {
        fail("{}: expected a time above 0 and of at most a week, found '{}'", option, text);
    }
    return milliseconds;
}

}  // namespace reliefbench
