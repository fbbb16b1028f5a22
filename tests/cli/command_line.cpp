#include "command_line.hpp"

#include "core/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace reliefbench {

namespace {

std::string quoted(const std::string& argument) {
    std::string text = "'";
    for (const char c : argument) {
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return text + "'";
}

}  // namespace

Outcome CommandLine::reliefbench(const std::vector<std::string>& arguments, const std::string& before) const {
    std::string command = fmt::format("{} {}", before, quoted(RELIEFBENCH_BINARY));
    for (const std::string& argument : arguments) {
        command += fmt::format(" {}", quoted(argument));
    }
    return shell(command);
}

Outcome CommandLine::shell(const std::string& command) const {
    // The tests' folder is the working folder, so that nothing is left in anybody else's.
    const std::string in_folder = fmt::format("cd {} && {{ {}; }} >{} 2>{} </dev/null", quoted(folder_.path().string()),
                                              command, quoted(path("stdout")), quoted(path("stderr")));
    const int status = std::system(in_folder.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(path("stdout")), read_file(path("stderr"))};
}

pid_t CommandLine::start(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), RELIEFBENCH_BINARY);
    const pid_t process = fork();
    if (process == 0) {
        constexpr int mode = 0600;
        dup2(open(path("out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, mode), STDOUT_FILENO);
        dup2(open(path("err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, mode), STDERR_FILENO);
        execv(RELIEFBENCH_BINARY, pointers_to(arguments).data());
        _exit(127);
    }
    return process;
}

void CommandLine::await_samples(const std::string& run) const {
    for (int tries = 0; tries < 600 && read_file(path(run + "/samples.jsonl")).empty(); ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ASSERT_FALSE(read_file(path(run + "/samples.jsonl")).empty());
}

void CommandLine::expect_refused(std::vector<std::string> arguments, const std::vector<std::string>& words) const {
    arguments.insert(arguments.begin(), "run");
    arguments.insert(arguments.end(), {"-o", path("run")});
    const Outcome outcome = reliefbench(arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
    EXPECT_THAT(outcome.err, testing::HasSubstr("reliefbench: "));
    for (const std::string& word : words) {
        EXPECT_THAT(outcome.err, testing::HasSubstr(word));
    }
    EXPECT_FALSE(std::filesystem::exists(path("run"))) << "something was half-written";
}

std::string CommandLine::write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
}

std::string CommandLine::write_configuration(const std::string& name, const Json& json) const {
    return write(name, json.dump(2));
}

std::filesystem::path CommandLine::copy_technique(const std::string& shipped, const std::string& id) const {
    const std::filesystem::path copy = folder_ / "techniques" / id;
    std::filesystem::create_directories(copy.parent_path());
    std::filesystem::copy(std::filesystem::path(RELIEFBENCH_SOURCE_DIR) / "techniques" / shipped, copy);
    return copy;
}

Json tiny_configuration() {
    return Json::parse(R"({
        "name": "tiny",
        "techniques": ["steep"],
        "axes": { "heightmap": "bricks", "heightmap_size": 32, "view_angle": 45, "resolution": 32 },
        "sampling": { "rule": "fixed", "rounds": 1, "samples_per_visit": 1, "warm_up": 0, "minimum_pass_ms": 0 }
    })");
}

Json long_configuration() {
    Json json = tiny_configuration();
    json["axes"]["sample_count"] = {4, 8, 16, 32};
    json["axes"]["view_angle"] = {0, 30, 60};
    json["sampling"]["rounds"] = 40;
    return json;
}

std::string read_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<Json> read_lines(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::vector<Json> lines;
    for (std::string line; std::getline(file, line);) {
        lines.push_back(Json::parse(line));
    }
    return lines;
}

}  // namespace reliefbench
