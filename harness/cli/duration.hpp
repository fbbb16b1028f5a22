#pragma once

#include <string>

namespace reliefbench {

/// Seconds, written as "300", "90s", "5m" or "1.5h"; more than 0 and at most a week. What is neither is an Error that
/// names `option`.
double parse_duration(const std::string& text, const std::string& option);

/// Milliseconds, written as "2", "2ms", "500us" or "0.1s"; more than 0 and at most a week. Otherwise as above.
double parse_milliseconds(const std::string& text, const std::string& option);

}  // namespace reliefbench
