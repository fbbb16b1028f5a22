#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace reliefbench {

/// Where what took long to make is cached for later runs: $RELIEFBENCH_CACHE_DIR, else $XDG_CACHE_HOME/reliefbench,
/// else ~/.cache/reliefbench. Empty where none of these variables is set: nothing is cached. The folder may be removed
/// at any time.
std::filesystem::path cache_folder();

/// The files of one kind in a cache folder, each the content of one key behind a line with its hash. A kind has a limit
/// of its own, so that another one's files never push its out.
struct CachedFiles {
    /// Made when something is written; empty: nothing is cached.
    std::filesystem::path folder;
    /// With its dot; tells kinds apart.
    std::string extension;
    /// What one of them is, in the plural, for messages: "derived maps".
    std::string content;
    std::uint64_t max_bytes = std::uint64_t{2} << 30;

    /// Calls take(content) with what the key's file holds. False where there is no such file, or where it is damaged or
    /// `take` throws Error, of which a warning tells: it is to be made anew.
    bool read(const std::string& key, const std::function<void(std::string_view)>& take) const;

    /// Files appear whole or not at all. Those used longest ago are removed where the kind would have more than
    /// `max_bytes`. What the disk refuses is a warning. `key` is fit for a file's name.
    void write(const std::string& key, std::string bytes) const;

private:
    std::filesystem::path file_of(const std::string& key) const;
    void make_room() const;
};

/// Splits off what stands before the first line's end.
std::string_view take_line(std::string_view& text);

}  // namespace reliefbench
