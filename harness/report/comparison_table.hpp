#pragma once

#include "compare/comparison.hpp"

#include <cstddef>
#include <string>

namespace reliefbench {

/// The widest that tables are made for, however wide the terminal.
inline constexpr std::size_t widest_table = 140;

struct ComparisonTableOptions {
    /// Lists the cells that stayed the same, too, and every change of quality.
    bool all = false;
    std::size_t columns = widest_table;
};

/// For the terminal: what slowed down first, then what is undecided, then what became faster; cells that stayed the
/// same are counted only. Then what changed in quality, what could not be compared and why, and on what all of it
/// rests. Of the cells of the same quality those are listed of which some other figure changed by more than its
/// tolerance.
std::string format_comparison_table(const Comparison& comparison, const ComparisonTableOptions& options = {});

}  // namespace reliefbench
