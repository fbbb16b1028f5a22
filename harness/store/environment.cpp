#include "store/environment.hpp"

#include <fmt/chrono.h>
#include <sys/utsname.h>

#include <cstdio>
#include <ctime>
#include <fstream>
#include <string_view>
#include <thread>

namespace reliefbench {

namespace {

/// What a shell command prints, or nothing when it fails.
std::optional<std::string> output_of(const std::string& command) {
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return std::nullopt;
    std::string output;
    char buffer[4096];
    while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, pipe)) {
        output.append(buffer, count);
    }
    if (pclose(pipe) != 0) return std::nullopt;
    return output;
}

std::string quoted_for_shell(const std::string& text) {
    std::string quoted(1, '\'');
    for (const char character : text) {
        if (character == '\'') {
            quoted.append("'\\''");
        } else {
            quoted.push_back(character);
        }
    }
    quoted.push_back('\'');
    return quoted;
}

/// The value after `key` and `separator` in the first such line of a file.
std::string value_in_file(const char* path, std::string_view key, char separator) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        const std::size_t at = line.find(separator);
        if (!line.starts_with(key) || at == std::string::npos) continue;
        const std::size_t first = line.find_first_not_of(" \t\"", at + 1);
        const std::size_t last = line.find_last_not_of(" \t\"");
        if (first != std::string::npos && first <= last) return line.substr(first, last - first + 1);
    }
    return "";
}

std::string operating_system() {
    utsname system{};
    uname(&system);
    const std::string kernel = fmt::format("{} {} {}", system.sysname, system.release, system.machine);
    const std::string distribution = value_in_file("/etc/os-release", "PRETTY_NAME", '=');
    return distribution.empty() ? kernel : distribution + ", " + kernel;
}

template <typename Value>
Json known_or_null(const Value& value, bool known) {
    return known ? Json(value) : Json(nullptr);
}

}  // namespace

std::optional<SourceRevision> read_source_revision(const std::filesystem::path& folder) {
    const std::string git = "git --no-optional-locks -C " + quoted_for_shell(folder.string());
    // The first line is the way up to the top of the work tree: empty there, and not so where a folder without a
    // repository of its own lies within another one.
    const auto top_and_commit = output_of(git + " rev-parse --show-cdup --verify HEAD 2>/dev/null");
    if (!top_and_commit || !top_and_commit->starts_with('\n')) return std::nullopt;
    SourceRevision revision;
    revision.commit = top_and_commit->substr(1, top_and_commit->find('\n', 1) - 1);
    if (const auto changes = output_of(git + " status --porcelain 2>/dev/null")) revision.dirty = !changes->empty();
    return revision;
}

Environment collect_environment() {
    Environment environment;
    environment.tool_version = RELIEFBENCH_VERSION;
    const SourceRevision at_configuration{RELIEFBENCH_GIT_REVISION, std::nullopt};
    environment.source = read_source_revision(RELIEFBENCH_SOURCE_DIR).value_or(at_configuration);
    environment.cpu = value_in_file("/proc/cpuinfo", "model name", ':');
    environment.cores = std::thread::hardware_concurrency();
    environment.os = operating_system();
    environment.time = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    return environment;
}

Json to_json(const Environment& environment) {
    Json json;
    json["tool_version"] = environment.tool_version;
    json["git_revision"] = known_or_null(environment.source.commit, !environment.source.commit.empty());
    json["git_dirty"] = known_or_null(environment.source.dirty.value_or(false), environment.source.dirty.has_value());
    json["cpu"] = known_or_null(environment.cpu, !environment.cpu.empty());
    json["cores"] = environment.cores;
    json["os"] = environment.os;
    json["time"] = environment.time;
    return json;
}

Json environment_to_json() {
    return to_json(collect_environment());
}

}  // namespace reliefbench
