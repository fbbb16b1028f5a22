#pragma once

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace reliefbench {

/// The message of the Error that `action` throws; a failure of the test, and "", when it throws none.
template <typename Action>
std::string error_message(Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "no error was thrown";
    return {};
}

}  // namespace reliefbench
