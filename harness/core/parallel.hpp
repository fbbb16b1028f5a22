#pragma once

#include <cstddef>
#include <functional>

namespace reliefbench {

/// Calls body(begin, end) on disjoint ranges of at most `grain` that cover [0, count), on all cores. Ranges are always
/// the same, [k·grain, (k+1)·grain), so that a reduction kept per range and folded in order does not depend on
/// scheduling. The exception of the lowest failing range is rethrown after all threads have ended.
void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace reliefbench
