#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// Where derived maps that took long to make are kept: $RELIEFBENCH_CACHE_DIR, else $XDG_CACHE_HOME/reliefbench, else
/// ~/.cache/reliefbench. Empty where none of these variables is set: nothing is kept. The folder may be removed at any
/// time.
std::filesystem::path map_cache_folder();

/// The maps of one preparation as they were made.
struct KeptMaps {
    /// Milliseconds of each run, by pass.
    std::map<std::string, std::vector<double>> pass_ms;
    /// One for each level of each map, in the manifest's order, tightly packed.
    std::vector<std::vector<std::byte>> levels;
};

/// Empty where there is no such file, or where it is damaged, of which a warning tells: the maps are then made anew.
/// A file is one line with the hash of what follows, one of JSON ("format", "pass_ms", "level_bytes"), and then the
/// bytes of the levels.
std::optional<KeptMaps> read_kept_maps(const std::filesystem::path& folder, const std::string& key);

/// Files appear whole or not at all. Those used longest ago are removed where the folder would hold more than
/// `max_bytes`. What the disk refuses is a warning.
void write_kept_maps(const std::filesystem::path& folder, const std::string& key, const KeptMaps& maps,
                     std::uint64_t max_bytes = std::uint64_t{2} << 30);

}  // namespace reliefbench
