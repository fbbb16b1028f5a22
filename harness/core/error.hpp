#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace reliefbench {

/// What the world can cause: a missing file, a bad shader, a lost device, a full disk. The message says what happened,
/// to what, and what to do. Caught where the work that it spoils ends: the cell, or the program (exit code 2).
/// What only a bug can cause is an assertion instead.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

template <typename... Arguments>
[[noreturn]] void fail(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    throw Error(fmt::format(format, std::forward<Arguments>(arguments)...));
}

}  // namespace reliefbench
