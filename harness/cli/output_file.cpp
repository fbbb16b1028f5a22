#include "cli/output_file.hpp"

#include "cli/results.hpp"
#include "core/error.hpp"
#include "core/file.hpp"

namespace reliefbench {

namespace {

constexpr const char* standard_output_argument = "-";

}  // namespace

bool is_standard_output(const std::filesystem::path& file) {
    return file == standard_output_argument;
}

void check_output_file(const std::filesystem::path& file, const std::string& option) {
    if (is_standard_output(file)) return;
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
        fail("{}: there is no folder {} to write {} into; make it first", option, folder.string(),
             file.filename().string());
    }
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored)) {
        fail("{}: {} is no regular file; name another, or - for standard output", option, file.string());
    }
}

void write_output(const std::filesystem::path& file, std::string_view text) {
    if (is_standard_output(file)) {
        print_results(text);
    } else {
        write_text_file(file, text);
    }
}

void refuse_standard_output(const std::filesystem::path& folder, std::string_view why) {
    if (is_standard_output(folder)) fail("the output '-' would be standard output: {}; name a folder", why);
}

}  // namespace reliefbench
