#include "core/limited_child.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/memory.hpp"
#include "core/process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

namespace reliefbench {

namespace {

constexpr std::size_t room_for_notes = 1 << 20;

/// What a message of the child is; its length and its bytes follow.
enum class Kind : char { note, result, error, out_of_memory };

class Pipe {
public:
    Pipe() {
        if (pipe2(ends_.data(), O_CLOEXEC) != 0) fail("cannot make a pipe: {}", std::strerror(errno));
    }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int reader() const { return ends_[0]; }
    int writer() const { return ends_[1]; }
    void close_end(std::size_t end) {
        if (ends_[end] >= 0) close(ends_[end]);
        ends_[end] = -1;
    }

private:
    std::array<int, 2> ends_{-1, -1};
};

void send(int descriptor, Kind kind, std::string_view text) {
    std::string message(1, static_cast<char>(kind));
    const std::uint64_t length = text.size();
    message.append(reinterpret_cast<const char*>(&length), sizeof length);
    message.append(text);
    if (!write_all(descriptor, message)) _exit(1);
}

/// Everything until the child closes its end, or until it is more than `most`.
std::string receive(int descriptor, std::size_t most) {
    std::string text;
    std::array<char, 65536> buffer{};
    while (text.size() <= most) {
        const ssize_t count = read(descriptor, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text;
}

struct Message {
    Kind kind = Kind::note;
    std::string_view text;
};

/// False when no whole message is left.
bool take(std::string_view& received, Message& message) {
    std::uint64_t length = 0;
    constexpr std::size_t head = 1 + sizeof length;
    if (received.size() < head) return false;
    std::memcpy(&length, received.data() + 1, sizeof length);
    if (received.size() - head < length) return false;
    message = {static_cast<Kind>(received.front()), received.substr(head, length)};
    received.remove_prefix(head + length);
    return true;
}

/// Of address space: a process has far more of it than of memory.
std::uint64_t address_space() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void set_limit(decltype(RLIMIT_CPU) resource, rlim_t value) {
    rlimit limit{};
    getrlimit(resource, &limit);
    // Below the hard limit, at which the kernel kills without telling why.
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, value);
    setrlimit(resource, &limit);
}

[[noreturn]] void work_and_exit(const std::function<std::string(const ChildNote&)>& work, const ChildLimits& limits,
                                std::uint64_t address_bytes, int descriptor) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    set_limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu_s));
    set_limit(RLIMIT_AS, address_bytes + limits.memory_bytes);
    set_limit(RLIMIT_CORE, 0);
    try {
        const std::string result = work([descriptor](std::string_view note) { send(descriptor, Kind::note, note); });
        send(descriptor, Kind::result, result);
    } catch (const std::bad_alloc&) {
        send(descriptor, Kind::out_of_memory, "");
    } catch (const std::exception& error) {
        send(descriptor, Kind::error, error.what());
    }
    // Neither destructors nor handlers of this process's end: they are the parent's.
    _exit(0);
}

std::string how_it_ended(int status, const ChildLimits& limits) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGXCPU) return fmt::format("it took more than {} s of CPU time", limits.cpu_s);
        return fmt::format("it was ended by a signal ({})", strsignal(signal));
    }
    return "it ended without a result";
}

std::string result_of(const std::string& failure, std::string_view received, int status, const ChildLimits& limits) {
    std::string last_note;
    std::string problem = how_it_ended(status, limits);
    bool too_large = received.size() > limits.result_bytes + room_for_notes;
    for (Message message; take(received, message);) {
        too_large = too_large || message.text.size() > limits.result_bytes;
        if (message.kind == Kind::result && !too_large) return std::string(message.text);
        if (message.kind == Kind::error) fail("{}", message.text);
        if (message.kind == Kind::out_of_memory)
            problem = fmt::format("it took more than {} of memory", memory_text(limits.memory_bytes));
        if (message.kind == Kind::note) last_note = message.text;
    }
    if (too_large) problem = fmt::format("what it made is larger than {}", memory_text(limits.result_bytes));
    fail("{}: {}{}{}", failure, problem, last_note.empty() ? "" : "; at last ", last_note);
}

}  // namespace

std::string run_in_child(const std::string& failure, const std::function<std::string(const ChildNote&)>& work,
                         const ChildLimits& limits) {
    Pipe pipe;
    const std::uint64_t address_bytes = address_space();
    const pid_t child = fork();
    if (child < 0) fail("cannot start a child process: {}", std::strerror(errno));
    if (child == 0) {
        pipe.close_end(0);
        work_and_exit(work, limits, address_bytes, pipe.writer());
    }
    pipe.close_end(1);
    const std::string received = receive(pipe.reader(), limits.result_bytes + room_for_notes);
    // A child that still writes is stopped by that: its pipe has no reader.
    pipe.close_end(0);
    return result_of(failure, received, wait_for_end(child), limits);
}

}  // namespace reliefbench
