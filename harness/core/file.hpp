#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace reliefbench {

/// Of a file that is read as a whole: 100,000 cells are 200 MB.
inline constexpr std::uint64_t largest_text_file = std::uint64_t{4} << 30;

/// The whole file, or pipe; an Error names the file and the system's reason, or that it is larger than `max_bytes`.
std::string read_text_file(const std::filesystem::path& path, std::uint64_t max_bytes = largest_text_file);

/// Until its end; errors as of read_text_file.
std::string read_standard_input(std::uint64_t max_bytes = largest_text_file);

/// Replaces the file at once (writes beside it, then renames), so that no reader ever sees half of it.
void write_text_file(const std::filesystem::path& path, std::string_view text);

/// False, with errno set, when not all of it could be written.
bool write_all(int descriptor, std::string_view text);

}  // namespace reliefbench
