#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace reliefbench {

/// What a child process may take before it is ended.
struct ChildLimits {
    /// Whole seconds of CPU time.
    int cpu_s = 20;
    /// Beyond what this process has at the fork.
    std::uint64_t memory_bytes = std::uint64_t{1} << 30;
    std::size_t result_bytes = std::size_t{8} << 20;
};

/// In the child: what it is about to do, told should it not come back.
using ChildNote = std::function<void(std::string_view)>;

/// Calls `work` in a forked copy of this process and returns what it returns, so that only the copy ends when the work
/// crashes or takes without end. `work` may allocate and read files, but not use what other threads guard (devices,
/// logs). An Error that it throws is thrown here. Its end by a limit or a crash is an Error: `failure`, the reason, the
/// last note.
std::string run_in_child(const std::string& failure, const std::function<std::string(const ChildNote&)>& work,
                         const ChildLimits& limits);

}  // namespace reliefbench
