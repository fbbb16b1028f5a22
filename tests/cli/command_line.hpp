#pragma once

#include "core/json.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// What a finished command left behind.
struct Outcome {
    int code = -1;
    std::string out;
    std::string err;
};

/// Runs the built binary, with the validation layer off unless the arguments turn it on.
class CommandLine : public testing::Test {
protected:
    /// `before`: shell words in front of the binary ("ulimit -f 8;", "NAME=value").
    Outcome reliefbench(const std::vector<std::string>& arguments, const std::string& before = {}) const;

    /// Runs a shell's command in the tests' folder.
    Outcome shell(const std::string& command) const;

    /// Starts the command with its output in the files `out` and `err` of this test's folder.
    pid_t start(std::vector<std::string> arguments) const;
    /// Waits for the first samples of the run in this folder.
    void await_samples(const std::string& run) const;

    /// Runs a configuration into `run/`, which must not come to be, and expects exit code 2 and a message that has all
    /// of `words`.
    void expect_refused(std::vector<std::string> arguments, const std::vector<std::string>& words) const;

    /// In this test's own folder.
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const;
    std::string write_configuration(const std::string& name, const Json& json) const;

    /// A copy of a shipped technique under another id, in `techniques/` of this test's folder.
    std::filesystem::path copy_technique(const std::string& shipped, const std::string& id) const;

private:
    const TemporaryFolder folder_;
};

/// A small matrix with one shipped technique.
Json tiny_configuration();
/// The same with twelve cells in which much is left to do when the first sample is there.
Json long_configuration();

std::string read_file(const std::filesystem::path& path);
/// Each line parsed.
std::vector<Json> read_lines(const std::filesystem::path& path);

}  // namespace reliefbench
