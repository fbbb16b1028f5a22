#include "core/log.hpp"

namespace reliefbench {

void log_line(std::string_view severity, std::string_view message) {
    // One write per line, so that lines of different threads do not mix.
    const std::string line = fmt::format("{}: {}\n", severity, message);
    std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace reliefbench
