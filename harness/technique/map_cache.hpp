#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// The maps of one preparation as they were made.
struct KeptMaps {
    /// Milliseconds of each run, by pass.
    std::map<std::string, std::vector<double>> pass_ms;
    /// One for each level of each map, in the manifest's order, tightly packed.
    std::vector<std::vector<std::byte>> levels;
};

/// In a cache folder (core/cache_folder.hpp): one line of JSON ("format", "pass_ms", "level_bytes"), and then the bytes
/// of the levels. Empty where there is no such file, or where it is damaged: the maps are then made anew.
std::optional<KeptMaps> read_kept_maps(const std::filesystem::path& folder, const std::string& key);

void write_kept_maps(const std::filesystem::path& folder, const std::string& key, const KeptMaps& maps,
                     std::uint64_t max_bytes = std::uint64_t{2} << 30);

}  // namespace reliefbench
