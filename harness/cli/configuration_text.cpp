#include "cli/configuration_text.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "core/number_text.hpp"
#include "core/suggest.hpp"
#include "store/run_folder.hpp"
#include "sweep/configuration.hpp"
#include "technique/technique.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

namespace reliefbench {

namespace {

/// Of the environment: the descriptor of the text that a worker was handed.
constexpr const char* configuration_variable = "RELIEFBENCH_CONFIGURATION";
constexpr const char* standard_input_argument = "-";

std::string name_in_messages(const std::string& path) {
    return path == standard_input_argument ? std::string(standard_input) : path;
}

/// As it can be typed: from the working directory where it lies below.
std::string typed_path(const std::filesystem::path& file) {
    std::error_code ignored;
    const std::filesystem::path relative = std::filesystem::relative(file, ignored);
    return relative.empty() || *relative.begin() == ".." ? file.string() : relative.string();
}

/// The shipped configuration that has the path's name, or one that is spelled much like it; else all of them.
std::string suggest_configuration(const std::filesystem::path& path) {
    std::vector<std::string> names;
    std::vector<std::string> paths;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(configuration_root(), ignored)) {
        const std::filesystem::path& file = entry.path();
        if (file.extension() != ".json" || file.filename() == "schema.json") continue;
        names.push_back(file.stem().string());
        paths.push_back(typed_path(file));
    }
    const std::optional<std::size_t> near = nearest(path.stem().string(), names);
    if (near) return fmt::format(" (did you mean '{}'?)", paths[*near]);
    std::sort(paths.begin(), paths.end());
    return paths.empty() ? "" : "; those that come with reliefbench are " + join(paths);
}

void refuse_what_is_no_file(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (std::filesystem::is_directory(status)) {
        fail("cannot read {}: it is a folder; name a configuration{}", path.string(),
             holds_run(path) ? fmt::format(", or {} to repeat the run", (path / "run.json").string()) : " in it");
    }
    if (status.type() == std::filesystem::file_type::not_found) {
        fail("cannot read {}: No such file or directory{}", path.string(), suggest_configuration(path));
    }
}

[[noreturn]] void fail_to_hand(std::string_view what) {
    fail("cannot {} the configuration for worker processes: {}", what, std::strerror(errno));
}

}  // namespace

ConfigurationText read_configuration_text(const std::string& path) {
    if (path != standard_input_argument) refuse_what_is_no_file(path);
    return {name_in_messages(path), path == standard_input_argument ? read_standard_input(largest_json_file)
                                                                    : read_text_file(path, largest_json_file)};
}

HandedConfiguration::HandedConfiguration(const ConfigurationText& configuration)
    : descriptor_(memfd_create("configuration", MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail_to_hand("keep");
    if (!write_all(descriptor_, configuration.text)) {
        close(descriptor_);
        fail_to_hand("keep");
    }
}

HandedConfiguration::~HandedConfiguration() {
    close(descriptor_);
}

std::string HandedConfiguration::variable() const {
    return fmt::format("{}={}", configuration_variable, descriptor_);
}

std::optional<ConfigurationText> take_handed_configuration(const std::string& path) {
    const char* const value = std::getenv(configuration_variable);
    if (value == nullptr) return std::nullopt;
    const std::optional<int> descriptor = whole_text_as<int>(value);
    if (!descriptor)
        fail("{} is set by reliefbench itself, for its worker processes; unset it", configuration_variable);
    unsetenv(configuration_variable);
    // Opened anew, as all workers share the place in the file that the descriptor stands at.
    const std::string file = fmt::format("/proc/self/fd/{}", *descriptor);
    ConfigurationText handed{name_in_messages(path), read_text_file(file, largest_json_file)};
    close(*descriptor);
    return handed;
}

}  // namespace reliefbench
