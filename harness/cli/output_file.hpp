#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace reliefbench {

/// "-", where a command writes one file.
bool is_standard_output(const std::filesystem::path& file);

/// Whether a file can be written there, before anything is measured: a file in a folder that does not exist, a folder
/// and what is no regular file (which writing would replace) are Errors that name `option`.
void check_output_file(const std::filesystem::path& file, const std::string& option);

/// Replaces the file; or goes to standard output with the other results.
void write_output(const std::filesystem::path& file, std::string_view text);

/// Where a command writes a folder, "-" would be one of this name: an Error that says `why` not.
void refuse_standard_output(const std::filesystem::path& folder, std::string_view why);

}  // namespace reliefbench
