#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

namespace reliefbench {

/// stderr carries everything that is not a result; stdout carries results.
void log_line(std::string_view severity, std::string_view message);

template <typename... Arguments>
void log_warning(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    log_line("warning", fmt::format(format, std::forward<Arguments>(arguments)...));
}

template <typename... Arguments>
void log_error(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    log_line("error", fmt::format(format, std::forward<Arguments>(arguments)...));
}

}  // namespace reliefbench
