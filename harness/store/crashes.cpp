#include "store/crashes.hpp"

#include "core/error.hpp"
#include "core/json.hpp"
#include "store/line_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace reliefbench {

namespace {

constexpr const char* crashes_file = "crashes.jsonl";

}  // namespace

std::vector<Crash> read_crash_lines(const std::filesystem::path& folder) {
    std::vector<Crash> crashes;
    const std::filesystem::path path = folder / crashes_file;
    if (std::error_code ignored; !std::filesystem::exists(path, ignored)) return crashes;
    std::ifstream file(path, std::ios::binary);
    if (!file) fail("cannot read {}: {}", path.string(), std::strerror(errno));
    std::size_t number = 0;
    for (std::string line; std::getline(file, line) && !file.eof();) {
        const std::string where = fmt::format("{} (line {})", path.string(), ++number);
        const Json json = parse_json(line, where);
        const JsonView view(json, where);
        crashes.push_back({view.at("cell").string(), view.at("reason").string(),
                           view.has("maps") ? view.at("maps").string() : std::string()});
    }
    return crashes;
}

void append_crash(const std::filesystem::path& folder, const Crash& crash) {
    Json line = {{"cell", crash.cell}, {"reason", crash.reason}};
    if (!crash.maps.empty()) line["maps"] = crash.maps;
    LineFile(folder / crashes_file, LineFile::Start::continued)
        .append(line.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::map<std::string, std::vector<std::string>> read_crashes(const std::filesystem::path& folder) {
    std::map<std::string, std::vector<std::string>> crashes;
    for (const Crash& crash : read_crash_lines(folder))
        crashes[crash.cell].push_back(crash.reason);
    return crashes;
}

std::map<std::string, std::vector<std::string>> read_crashed_preparations(const std::filesystem::path& folder) {
    std::map<std::string, std::vector<std::string>> crashes;
    for (const Crash& crash : read_crash_lines(folder)) {
        if (!crash.maps.empty()) crashes[crash.maps].push_back(crash.reason);
    }
    return crashes;
}

std::string crashed_cell_reason(const std::vector<std::string>& reasons) {
    return fmt::format("it ended its worker process {} times and is not tried again; the last time {}", reasons.size(),
                       reasons.back());
}

std::string crashed_preparation_reason(const std::vector<std::string>& reasons) {
    return fmt::format("making its maps ended the worker process {} times and is not tried again; the last time {}",
                       reasons.size(), reasons.back());
}

}  // namespace reliefbench
