#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace reliefbench {

/// Where the segments of a series start (the first at 0; none for an empty series): the partition of least total
/// absolute deviation from the segments' medians plus a penalty for each segment (Jackson et al. 2005), each at least
/// `shortest_segment` long. The penalty is low, 1.5 σ log n with σ taken from the series' successive differences: it
/// finds candidates. A series too short to be split is one segment. Takes O(n² log n) time.
std::vector<std::size_t> optimal_segments(std::span<const double> series, std::size_t shortest_segment);

}  // namespace reliefbench
