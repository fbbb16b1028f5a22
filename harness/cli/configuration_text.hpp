#pragma once

#include <optional>
#include <string>

namespace reliefbench {

/// A configuration or a run.json as read: a pipe gives its text only once.
struct ConfigurationText {
    /// What messages call it, and whose folder its paths are taken from: the path, or `standard_input`.
    std::string file;
    std::string text;
};

/// From a file, a pipe, or standard input ("-"). An Error where it cannot be read.
ConfigurationText read_configuration_text(const std::string& path);

/// A text that worker processes read again and again: each is to inherit the descriptor and to find `variable()` in its
/// environment.
class HandedConfiguration {
public:
    explicit HandedConfiguration(const ConfigurationText& configuration);
    ~HandedConfiguration();
    HandedConfiguration(const HandedConfiguration&) = delete;
    HandedConfiguration& operator=(const HandedConfiguration&) = delete;

    int descriptor() const { return descriptor_; }
    /// "NAME=value".
    std::string variable() const;

private:
    int descriptor_;
};

/// In a worker process, the text that its supervisor read of `path`; its variable is unset. Empty in other processes.
std::optional<ConfigurationText> take_handed_configuration(const std::string& path);

}  // namespace reliefbench
