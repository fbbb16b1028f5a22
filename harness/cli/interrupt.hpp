#pragma once

namespace reliefbench {

/// Thrown when a command has ended early because it was told to, with everything kept: caught by main, which ends the
/// program by the signal, so that shells and job systems see what ended it (a shell reports 128 + signal) and a loop
/// around it stops, too.
struct Interrupted {
    int signal = 0;
};

/// While it lives, the first SIGINT (Ctrl-C) or SIGTERM is only remembered, and `message` is written to standard error;
/// the second one ends the program at once. Signals that were ignored before (nohup) stay so. One at a time.
class InterruptWatch {
public:
    /// `message` must outlive it.
    explicit InterruptWatch(const char* message);
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    /// Zero while there was none.
    int signal() const;
};

/// Ends the program by the signal's own effect.
[[noreturn]] void end_by_signal(int signal);

}  // namespace reliefbench
