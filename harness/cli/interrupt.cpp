#include "cli/interrupt.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace reliefbench {

namespace {

constexpr std::array watched_signals{SIGINT, SIGTERM};

// A signal handler has nothing else to write to.
std::atomic<int> received_signal = 0;
std::atomic<const char*> answer = nullptr;

void remember(int signal) {
    received_signal = signal;
    // Whatever came first, the second one of either kind ends the program.
    for (const int watched : watched_signals) {
        std::signal(watched, SIG_DFL);
    }
    const char* const message = answer;
    if (write(STDERR_FILENO, message, std::strlen(message)) < 0) return;
}

}  // namespace

InterruptWatch::InterruptWatch(const char* message) {
    received_signal = 0;
    answer = message;
    for (const int watched : watched_signals) {
        struct sigaction before {};
        sigaction(watched, nullptr, &before);
        if (before.sa_handler == SIG_IGN) continue;
        struct sigaction action {};
        action.sa_handler = remember;
        // What the program is waiting for goes on.
        action.sa_flags = SA_RESTART;
        sigaction(watched, &action, nullptr);
    }
}

InterruptWatch::~InterruptWatch() {
    for (const int watched : watched_signals) {
        struct sigaction before {};
        sigaction(watched, nullptr, &before);
        if (before.sa_handler == remember) std::signal(watched, SIG_DFL);
    }
}

int InterruptWatch::signal() const {
    return received_signal;
}

void end_by_signal(int signal) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    std::abort();  // not reached: the signal is not blocked
}

}  // namespace reliefbench
