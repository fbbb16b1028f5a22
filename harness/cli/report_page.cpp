#include "cli/report_page.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace reliefbench {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> page_folders() {
    if (const char* folder = std::getenv("RELIEFBENCH_DATA_DIR")) return {folder};
    std::error_code ignored;
    const fs::path binary_folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    return {binary_folder, binary_folder.parent_path()};
}

}  // namespace

std::string read_report_page() {
    std::error_code ignored;
    const std::vector<fs::path> folders = page_folders();
    for (const fs::path& folder : folders) {
        const fs::path file = folder / "report_page.html";
        if (fs::exists(file, ignored)) return read_text_file(file);
    }
    fail(
        "there is no report_page.html in {}: this build was made without the report's page; build the target "
        "report_page with npm at hand and RELIEFBENCH_REPORT_PAGE=ON",
        folders.front().string());
}

}  // namespace reliefbench
