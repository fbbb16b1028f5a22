#pragma once

#include "report/export.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// `--export FORMAT=FILE` of `run`; the file may be standard output (cli/output_file.hpp).
struct ExportTarget {
    ExportFormat format = ExportFormat::csv;
    std::filesystem::path file;
};

/// Checked; an unknown format, a missing file name, and more than one for standard output are Errors.
std::vector<ExportTarget> parse_export_targets(const std::vector<std::string>& texts);

/// One of them is for standard output, where nothing else may go then.
bool take_standard_output(const std::vector<ExportTarget>& targets);

/// Writes what the run in `folder` is in each format.
void write_exports(const std::filesystem::path& folder, const std::vector<ExportTarget>& targets);

}  // namespace reliefbench
