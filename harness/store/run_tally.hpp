#pragma once

#include "store/cell_result.hpp"

#include <cstddef>
#include <map>

namespace reliefbench {

/// How cells ended: what a run remembers of them, so that its memory does not grow with their number.
struct RunTally {
    std::size_t ok = 0;
    std::size_t skipped = 0;
    std::size_t failed = 0;
    /// Of those that were sampled.
    std::map<StopReason, std::size_t> stops;
    /// Cells that count rounds in which the device was throttled.
    std::size_t throttled_cells = 0;

    void add(const CellResult& cell);
};

}  // namespace reliefbench
