#pragma once

#include "measure/run.hpp"

#include <string>

namespace reliefbench {

/// "0:07", "12:30", "2:00:00".
std::string format_duration(double seconds);

/// One line, without its end: "[ 12/60]  34 %, 0:11 elapsed, 0:21 left: sampling: pom max_steps=8 |
/// view_angle=60".
std::string format_progress(const Progress& progress);

/// Progress on stderr: one line that rewrites itself on a terminal, else plain lines: soon at first, then
/// seldom.
class ProgressPrinter {
public:
    ProgressPrinter();
    /// Clears the rewriting line, so that what follows starts on a clean one.
    ~ProgressPrinter();
    ProgressPrinter(const ProgressPrinter&) = delete;
    ProgressPrinter& operator=(const ProgressPrinter&) = delete;

    void operator()(const Progress& progress);

private:
    bool terminal_ = false;
    double last_s_ = -1;
    std::string last_stage_;
};

}  // namespace reliefbench
