#include "store/run_tally.hpp"

namespace reliefbench {

void RunTally::add(const CellResult& cell) {
    switch (cell.status) {
        case CellStatus::ok:
            ++ok;
            break;
        case CellStatus::skipped:
            ++skipped;
            break;
        case CellStatus::failed:
            ++failed;
            break;
    }
    if (cell.stop) ++stops[*cell.stop];
    if (cell.throttled_rounds > 0) ++throttled_cells;
}

}  // namespace reliefbench
