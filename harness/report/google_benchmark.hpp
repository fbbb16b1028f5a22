#pragma once

#include "store/read_samples.hpp"
#include "store/run_folder.hpp"

#include <string>

namespace reliefbench {

/// A run as Google Benchmark 1.7.1 writes JSON, for its tools/compare.py and what else reads it. A cell is a benchmark;
/// each round is a repetition with its median of the draw, so that compare.py's U test has something to test, and mean,
/// median, standard deviation and coefficient of variation follow. A cell without rounds in `rounds` is one repetition.
/// `cpu_time` repeats the device's time: a run keeps no CPU time, and compare.py divides by it. Cells that failed or
/// were skipped are left out: compare.py would take their time for 0.
std::string format_google_benchmark(const Run& run, const RoundMedians& rounds);

}  // namespace reliefbench
