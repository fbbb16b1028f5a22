#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// Formats that other tools read a stored run in.
enum class ExportFormat { google_benchmark, github_action, csv, markdown };

/// In the order of the enumerators, as the command line writes them.
const std::vector<std::string>& export_format_names();
/// An unknown name is an Error.
ExportFormat parse_export_format(const std::string& name);

/// Reads the run in `folder` and writes it in `format`.
std::string export_run(const std::filesystem::path& folder, ExportFormat format);

}  // namespace reliefbench
