#pragma once

#include "scene/image.hpp"

#include <cstdint>

namespace reliefbench {

/// Blue noise by void-and-cluster (Ulichney, The void-and-cluster method for dither array generation, 1993): each rank
/// from 0 up to the number of texels less one, once, so that the texels below any rank lie as evenly as they can. It
/// wraps around. `sigma`: of the Gaussian by which texels lie close to each other, in texels; published: 1.5. The same
/// on every machine.
Image<std::uint16_t> void_and_cluster(int side, double sigma);

}  // namespace reliefbench
