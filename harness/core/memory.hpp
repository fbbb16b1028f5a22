#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace reliefbench {

/// Bytes that this process can still take without swapping or being killed: what the kernel calls available, or less
/// where a control group (a container) is limited. RELIEFBENCH_MEMORY_MB, in 10⁶ bytes, takes its place. `root` is
/// where /proc and /sys are looked for.
std::uint64_t available_memory(const std::filesystem::path& root = "/");

/// "3.2 GB", "640 MB".
std::string memory_text(std::uint64_t bytes);

}  // namespace reliefbench
