#include "core/process.hpp"

#include "core/error.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>

namespace reliefbench {

namespace {

constexpr int killed_by_signal = 128;

/// A file in memory, so that neither of two outputs can fill up and block the child.
class CapturedOutput {
public:
    explicit CapturedOutput(const char* name) : descriptor_(memfd_create(name, MFD_CLOEXEC)) {
        if (descriptor_ < 0) fail("cannot keep the output of a child process: {}", std::strerror(errno));
    }
    ~CapturedOutput() { close(descriptor_); }
    CapturedOutput(const CapturedOutput&) = delete;
    CapturedOutput& operator=(const CapturedOutput&) = delete;

    int descriptor() const { return descriptor_; }

    std::string text() const {
        std::string result;
        char buffer[65536];
        off_t offset = 0;
        for (ssize_t count = 0; (count = pread(descriptor_, buffer, sizeof buffer, offset)) > 0; offset += count) {
            result.append(buffer, static_cast<std::size_t>(count));
        }
        return result;
    }

private:
    int descriptor_;
};

class FileActions {
public:
    FileActions() { posix_spawn_file_actions_init(&actions_); }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    posix_spawn_file_actions_t* get() { return &actions_; }

private:
    posix_spawn_file_actions_t actions_;
};

std::vector<char*> environment_without(const std::vector<std::string>& unset) {
    std::vector<char*> kept;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text(*entry);
        const std::string_view name = text.substr(0, text.find('='));
        if (std::find(unset.begin(), unset.end(), name) == unset.end()) kept.push_back(*entry);
    }
    kept.push_back(nullptr);
    return kept;
}

int shell_exit_code(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : killed_by_signal + WTERMSIG(status);
}

}  // namespace

FinishedProcess run_process(const std::vector<std::string>& arguments, const std::vector<std::string>& unset) {
    const CapturedOutput output("output");
    const CapturedOutput errors("errors");
    FileActions actions;
    posix_spawn_file_actions_addopen(actions.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(actions.get(), output.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(actions.get(), errors.descriptor(), STDERR_FILENO);

    std::vector<std::string> words = arguments;
    const std::vector<char*> words_to_pass = pointers_to(words);
    const std::vector<char*> environment = environment_without(unset);
    pid_t process = 0;
    const int problem =
        posix_spawnp(&process, words_to_pass.front(), actions.get(), nullptr, words_to_pass.data(), environment.data());
    if (problem != 0) fail("cannot run {}: {}; is it installed?", arguments.front(), std::strerror(problem));
    const int exit_code = shell_exit_code(wait_for_end(process));
    return {exit_code, output.text(), errors.text()};
}

int wait_for_end(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) fail("cannot wait for a child process: {}", std::strerror(errno));
    }
    return status;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

}  // namespace reliefbench
