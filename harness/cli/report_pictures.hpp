#pragma once

#include "report/page.hpp"
#include "report/page_pictures.hpp"

#include <cstddef>

namespace reliefbench {

/// The pictures that the run kept in its folder (`"images": true` in its configuration), as many as the page has room
/// for: cells on the Pareto front of their view first, then the others in their order, until `pictures` take
/// `max_bytes` in the page; of each cell its picture, its truth and one error map, and the other maps where there is
/// still room. Pictures with a side above 512 pixels are thinned. A picture that cannot be read is an
/// Error.
CellPictures collect_pictures(const StoredRun& run, std::size_t max_bytes, PagePictures& pictures);

}  // namespace reliefbench
