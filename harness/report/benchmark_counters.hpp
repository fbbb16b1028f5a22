#pragma once

#include "store/cell_result.hpp"

#include <string>
#include <utility>
#include <vector>

namespace reliefbench {

/// What Google Benchmark shows beside a cell's time, in `bench` and in exports, by names that stay: figures that the
/// cell lacks are left out. Each is finite.
std::vector<std::pair<std::string, double>> benchmark_counters(const CellResult& cell);

}  // namespace reliefbench
