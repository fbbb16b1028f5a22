#include "cli/read_maps.hpp"

#include "cli/progress_printer.hpp"
#include "measure/clock.hpp"

#include <string>

namespace reliefbench {

std::vector<HeightMapRecord> read_maps(const std::vector<Cell>& cells) {
    ProgressPrinter printer;
    const double start_s = steady_clock().seconds();
    return inspect_height_maps(cells, [&](const std::string& map) {
        printer({.cells_total = cells.size(),
                 .stage = "reading height maps",
                 .current = map,
                 .elapsed_s = steady_clock().seconds() - start_s});
    });
}

}  // namespace reliefbench
