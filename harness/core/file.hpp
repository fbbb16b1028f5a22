#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace reliefbench {

/// The whole file; an Error names the file and the system's reason.
std::string read_text_file(const std::filesystem::path& path);

/// Replaces the file at once (writes beside it, then renames), so that no reader ever sees half of it.
void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace reliefbench
