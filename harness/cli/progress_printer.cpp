#include "cli/progress_printer.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace reliefbench {

namespace {

constexpr double terminal_interval_s = 0.1;
/// Lines of a log: soon at first, so that it shows what goes on, then seldom.
constexpr double shortest_plain_interval_s = 1;
constexpr double longest_plain_interval_s = 5;
constexpr std::size_t default_columns = 80;

std::size_t terminal_columns() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
        return size.ws_col;
    }
    return default_columns;
}

}  // namespace

std::string format_duration(double seconds) {
    const auto whole = static_cast<long long>(std::llround(std::max(seconds, 0.0)));
    if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string format_progress(const Progress& progress) {
    const std::string total = std::to_string(progress.cells_total);
    std::string share;
    std::string left;
    if (progress.share >= 0) share = fmt::format(" {:3.0f} %,", 100 * progress.share);
    if (progress.remaining_s >= 0) {
        left = fmt::format(", {} left", format_duration(progress.remaining_s));
    }
    return fmt::format("[{:>{}}/{}]{} {} elapsed{}: {}{}{}", progress.cells_done, total.size(), total, share,
                       format_duration(progress.elapsed_s), left, progress.stage, progress.stage.empty() ? "" : ": ",
                       progress.current);
}

ProgressPrinter::ProgressPrinter() : terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressPrinter::~ProgressPrinter() {
    if (terminal_ && last_s_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressPrinter::operator()(const Progress& progress) {
    const bool last = progress.cells_done == progress.cells_total;
    const double interval_s = terminal_
                                  ? terminal_interval_s
                                  : std::clamp(progress.elapsed_s, shortest_plain_interval_s, longest_plain_interval_s);
    // A stage that takes long is to be seen while it does.
    const bool begins = terminal_ && progress.stage != last_stage_;
    if (!last && !begins && last_s_ >= 0 && progress.elapsed_s - last_s_ < interval_s) return;
    last_s_ = progress.elapsed_s;
    last_stage_ = progress.stage;
    if (terminal_) {
        fmt::print(stderr, "\r\033[K{:.{}}", format_progress(progress), terminal_columns() - 1);
        std::fflush(stderr);
    } else {
        fmt::print(stderr, "{}\n", format_progress(progress));
    }
}

}  // namespace reliefbench
