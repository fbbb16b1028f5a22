#pragma once

#include "core/figure.hpp"
#include "scene/hit.hpp"
#include "scene/image.hpp"
#include "scene/scene_object.hpp"

#include <vector>

namespace reliefbench {

/// The fraction of the footprint's pixels, but ties, in which one shows the object and the other does not; 0 where the
/// footprint is empty.
double wrong_surface(const Image<Front>& technique, const Image<Front>& truth, const FootprintImage& footprint);

std::vector<FigureDeclaration> wrong_surface_figures();
FigureValueList figures_of_wrong_surface(double fraction);

}  // namespace reliefbench
