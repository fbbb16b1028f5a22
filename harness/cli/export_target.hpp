#pragma once

#include "report/export.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// `--export FORMAT=FILE` of `run`.
struct ExportTarget {
    ExportFormat format = ExportFormat::csv;
    std::filesystem::path file;
};

/// Whether an export can be written there, before anything is measured: a file in a folder that does not exist, a
/// folder and what is no regular file (which writing would replace) are Errors that name `option`.
void check_export_file(const std::filesystem::path& file, const std::string& option);

/// Checked; an unknown format and a missing file name are Errors.
std::vector<ExportTarget> parse_export_targets(const std::vector<std::string>& texts);

/// Writes what the run in `folder` is in each format.
void write_exports(const std::filesystem::path& folder, const std::vector<ExportTarget>& targets);

}  // namespace reliefbench
