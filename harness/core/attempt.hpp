#pragma once

#include <functional>
#include <string>

namespace reliefbench {

/// The reason of what failed for it.
inline constexpr const char* memory_used_up = "the host's memory is used up; choose a smaller height map or resolution";

/// Whether the work went without using up the host's memory. Errors pass.
bool fits_in_memory(const std::function<void()>& work);

/// Does what belongs to one cell or one check, where its failure ends. Empty, or the reason that it has failed for: the
/// message of its Error, or that the host's memory is used up. (Of the device's own memory that is an Error.)
std::string failure_of(const std::function<void()>& work);

}  // namespace reliefbench
