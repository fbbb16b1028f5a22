#include "cli/supervisor.hpp"

#include "cli/interrupt.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/process.hpp"
#include "store/crashes.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>

// glibc 2.36 declares it without the language's linkage.
extern "C" {
#include <sys/pidfd.h>
}

namespace reliefbench {

namespace {

/// Of the environment: the descriptor of the status that a worker shares.
constexpr const char* worker_variable = "RELIEFBENCH_WORKER";
/// How often a hanging pass is looked for.
constexpr int watch_ms = 100;
/// What was stopped and goes on (Ctrl-Z) looks overdue once, before the pass has had the time to end.
constexpr int certain_looks = 2;
constexpr int max_deaths_outside_cells = 2;

/// How a worker ended.
struct Death {
    /// It ended by itself, with this.
    std::optional<ExitCode> code;
    /// Else what ended it, in words; zero when no signal did.
    std::string reason;
    int signal = 0;
};

std::vector<std::string> environment_with(std::vector<std::string> entries) {
    for (char** other = environ; *other != nullptr; ++other)
        entries.emplace_back(*other);
    return entries;
}

/// In the process that fork has just made, where libraries have threads that it lacks: nothing but system calls.
[[noreturn]] void become_worker(pid_t supervisor, const std::array<int, 2>& inherited, char* const* arguments,
                                char* const* environment) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != supervisor) _exit(EXIT_FAILURE);  // it died before that
    // A terminal and a job system send these to both; the supervisor tells what they mean.
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_IGN);
    for (const int descriptor : inherited)
        fcntl(descriptor, F_SETFD, 0);
    execve("/proc/self/exe", arguments, environment);
    _exit(EXIT_FAILURE);
}

pid_t start_worker(const WorkerStatus& status, const Supervision& supervision) {
    std::vector<std::string> words = supervision.command_line;
    std::vector<std::string> entries = environment_with(
        {fmt::format("{}={}", worker_variable, status.descriptor()), supervision.configuration.variable()});
    const std::array<int, 2> inherited{status.descriptor(), supervision.configuration.descriptor()};
    const std::vector<char*> arguments = pointers_to(words);
    const std::vector<char*> environment = pointers_to(entries);
    const pid_t supervisor = getpid();
    const pid_t process = fork();
    if (process < 0) fail("cannot start a worker process: {}", std::strerror(errno));
    if (process == 0) become_worker(supervisor, inherited, arguments.data(), environment.data());
    return process;
}

class Worker {
public:
    explicit Worker(pid_t process) : process_(process), descriptor_(pidfd_open(process, 0)) {
        if (descriptor_ < 0) fail("cannot watch the worker process: {}", std::strerror(errno));
    }
    ~Worker() { close(descriptor_); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// Whether it has ended after a moment, or at a signal at once.
    bool has_ended() const {
        pollfd polled{.fd = descriptor_, .events = POLLIN, .revents = 0};
        return poll(&polled, 1, watch_ms) > 0;
    }

    void kill() const { ::kill(process_, SIGKILL); }

    int status() const { return wait_for_end(process_); }

private:
    pid_t process_;
    int descriptor_;
};

std::optional<ExitCode> own_exit_code(int code) {
    for (const ExitCode known :
         {ExitCode::done, ExitCode::bad_input, ExitCode::cells_failed, ExitCode::internal_error}) {
        if (code == static_cast<int>(known)) return known;
    }
    return std::nullopt;
}

Death describe(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        std::string reason = fmt::format("its worker process was ended by signal {} ({})", signal, strsignal(signal));
        if (signal == SIGKILL) reason += ", as the system does when memory is used up";
        return {.code = {}, .reason = std::move(reason), .signal = signal};
    }
    const int code = WEXITSTATUS(status);
    return {.code = own_exit_code(code), .reason = fmt::format("its worker process ended with exit code {}", code)};
}

Death watch_to_the_end(pid_t process, WorkerStatus& status, const InterruptWatch& interrupts,
                       const std::string& pass_timeout) {
    const Worker worker(process);
    int looks_overdue = 0;
    while (!worker.has_ended()) {
        if (interrupts.signal() != 0) status.interrupt();
        looks_overdue = status.is_overdue() ? looks_overdue + 1 : 0;
        if (looks_overdue < certain_looks) continue;
        worker.kill();
        worker.status();
        return {.code = {}, .reason = fmt::format("a pass ran past {} (--pass-timeout)", pass_timeout)};
    }
    return describe(worker.status());
}

}  // namespace

std::unique_ptr<WorkerStatus> take_worker_status() {
    const char* const text = std::getenv(worker_variable);
    if (text == nullptr) return nullptr;
    const std::optional<int> descriptor = whole_text_as<int>(text);
    if (!descriptor) fail("{} is set by reliefbench itself, for its worker processes; unset it", worker_variable);
    unsetenv(worker_variable);
    return WorkerStatus::of_supervisor(*descriptor);
}

ExitCode supervise(const Supervision& supervision) {
    const InterruptWatch interrupts(
        "\nreliefbench: interrupted; finishing the visit (interrupt again to end at once)\n");
    WorkerStatus status(supervision.pass_timeout_s);
    for (int deaths_outside_cells = 0; deaths_outside_cells < max_deaths_outside_cells;) {
        status.clear();
        const pid_t process = start_worker(status, supervision);
        const Death death = watch_to_the_end(process, status, interrupts, supervision.pass_timeout);
        if (death.code) {
            if (status.ending() == WorkerStatus::Ending::interrupted) throw Interrupted{interrupts.signal()};
            if (status.ending() == WorkerStatus::Ending::device_lost) continue;
            return *death.code;
        }
        // Who was to read the results has gone.
        if (death.signal == SIGPIPE) end_by_signal(death.signal);
        const std::string cell = status.cell();
        fmt::print(stderr, "reliefbench: {}: {}\n", cell.empty() ? "before, between or after cells" : cell,
                   death.reason);
        if (cell.empty()) {
            ++deaths_outside_cells;
        } else {
            deaths_outside_cells = 0;
            append_crash(status.folder(), {cell, death.reason, status.maps()});
        }
    }
    fmt::print(stderr, "reliefbench: no other worker is tried; what is finished is kept\n");
    return ExitCode::internal_error;
}

}  // namespace reliefbench
