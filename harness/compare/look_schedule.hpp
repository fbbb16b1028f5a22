#pragma once

#include <cstddef>

namespace reliefbench {

/// When a growing series may be looked at, and what each look may spend of a two-sided error level of 0.05, so that
/// stopping at the first clear look does not raise the rate of false alarms: looks at 16, 32, 64, ... rounds; the
/// k-th (from 1) spends 0.05 / (k (k + 1)), which sums to 0.05 over all of them.
bool is_look(std::size_t rounds);

/// Of the last look at or before `rounds`, which is at least the first.
double level_of_look(std::size_t rounds);

/// The first look after `rounds`.
std::size_t next_look(std::size_t rounds);

}  // namespace reliefbench
