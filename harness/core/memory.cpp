#include "core/memory.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>

namespace reliefbench {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t megabyte = 1000 * 1000;

/// The number after `key` in the first line that begins with it.
std::optional<std::uint64_t> number_in_file(const fs::path& path, const std::string& key) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(key)) continue;
        const std::size_t begin = std::min(line.find_first_not_of(' ', key.size()), line.size());
        const std::size_t end = std::min(line.find_first_not_of("0123456789", begin), line.size());
        return whole_text_as<std::uint64_t>(std::string_view(line).substr(begin, end - begin));
    }
    return std::nullopt;
}

/// Of one control group; pages of files that nobody uses are given up when memory is short.
std::uint64_t left_in_group(const fs::path& group) {
    const auto limit = number_in_file(group / "memory.max", "");
    if (!limit) return no_limit;  // "max", or no such file
    const std::uint64_t used = number_in_file(group / "memory.current", "").value_or(0);
    const std::uint64_t inactive = number_in_file(group / "memory.stat", "inactive_file ").value_or(0);
    return *limit - std::min(*limit, used - std::min(used, inactive));
}

/// The least of this process's control group and those above it.
std::uint64_t left_in_groups(const fs::path& root) {
    const fs::path mount = root / "sys/fs/cgroup";
    std::string group;
    std::ifstream groups(root / "proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {
        if (line.starts_with("0::/")) group = line.substr(4);
    }
    std::uint64_t left = left_in_group(mount);
    fs::path below = mount;
    for (const fs::path& part : fs::path(group)) {
        below /= part;
        left = std::min(left, left_in_group(below));
    }
    return left;
}

std::optional<std::uint64_t> given_memory() {
    const char* const text = std::getenv("RELIEFBENCH_MEMORY_MB");
    if (text == nullptr || *text == '\0') return std::nullopt;
    constexpr std::uint64_t most = no_limit / megabyte;
    const auto megabytes = whole_text_as<std::uint64_t>(text);
    if (!megabytes || *megabytes > most) fail("RELIEFBENCH_MEMORY_MB is '{}': give a number of megabytes", text);
    return *megabytes * megabyte;
}

}  // namespace

std::uint64_t available_memory(const fs::path& root) {
    if (const auto given = given_memory()) return *given;
    constexpr std::uint64_t bytes_per_kilobyte = 1024;
    const auto kilobytes = number_in_file(root / "proc/meminfo", "MemAvailable:");
    const std::uint64_t left = kilobytes ? *kilobytes * bytes_per_kilobyte : no_limit;
    return std::min(left, left_in_groups(root));
}

std::string memory_text(std::uint64_t bytes) {
    constexpr double bytes_per_gigabyte = 1e9;
    if (static_cast<double>(bytes) >= bytes_per_gigabyte)
        return fmt::format("{:.1f} GB", static_cast<double>(bytes) / bytes_per_gigabyte);
    return fmt::format("{} MB", (bytes + megabyte - 1) / megabyte);
}

}  // namespace reliefbench
