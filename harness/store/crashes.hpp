#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace reliefbench {

/// A worker process that ended abruptly while it was on a cell.
struct Crash {
    std::string cell;
    /// What ended it, in words.
    std::string reason;
    /// The derived maps that it was making (Renderer::maps_key); empty: none.
    std::string maps = {};
};

/// A cell that so many workers died on is not tried again; nor are maps.
inline constexpr std::size_t max_crashes = 2;

/// One line more in crashes.jsonl of a run's folder; an Error when it cannot be written.
void append_crash(const std::filesystem::path& folder, const Crash& crash);

/// In their order. Strict as read_run, but for a last line that was cut short, which is left out.
std::vector<Crash> read_crash_lines(const std::filesystem::path& folder);

/// Reasons by cell, in their order.
std::map<std::string, std::vector<std::string>> read_crashes(const std::filesystem::path& folder);

/// The same by the maps that were being made.
std::map<std::string, std::vector<std::string>> read_crashed_preparations(const std::filesystem::path& folder);

/// The reason of a cell that is not tried again.
std::string crashed_cell_reason(const std::vector<std::string>& reasons);
/// The reason of every cell whose maps are not tried again.
std::string crashed_preparation_reason(const std::vector<std::string>& reasons);

}  // namespace reliefbench
