#include "cli/terminal.hpp"

#include "report/comparison_table.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace reliefbench {

std::size_t table_columns() {
    winsize size{};
    // A pseudo-terminal that nobody gave a size says 0.
    const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? std::min<std::size_t>(size.ws_col, widest_table) : widest_table;
}

}  // namespace reliefbench
