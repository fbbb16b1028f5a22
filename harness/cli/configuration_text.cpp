#include "cli/configuration_text.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "core/number_text.hpp"
#include "sweep/configuration.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace reliefbench {

namespace {

/// Of the environment: the descriptor of the text that a worker was handed.
constexpr const char* configuration_variable = "RELIEFBENCH_CONFIGURATION";
constexpr const char* standard_input_argument = "-";

std::string name_in_messages(const std::string& path) {
    return path == standard_input_argument ? std::string(standard_input) : path;
}

[[noreturn]] void fail_to_hand(std::string_view what) {
    fail("cannot {} the configuration for worker processes: {}", what, std::strerror(errno));
}

}  // namespace

ConfigurationText read_configuration_text(const std::string& path) {
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
