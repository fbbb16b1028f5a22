#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// `arguments`, without the program's name, with the `--` of `compare BASE... -- NEW...`
/// (and of `report`) put into a form that passes
/// through CLI11: it would take all that follows `--` for folders, options too, and not say where `--` stood.
std::vector<std::string> keep_separator(std::vector<std::string> arguments);

struct RunSides {
    std::vector<std::string> base;
    std::vector<std::string> changed;
};

/// Of the folders that CLI11 handed over; complaints name the `command`. Two need no separator; more without one are an
/// Error that says how.
RunSides split_sides(const std::vector<std::string>& folders, std::string_view command);

/// Whether `--` stands between the folders.
bool has_separator(const std::vector<std::string>& folders);

}  // namespace reliefbench
