#pragma once

#include "reference/sampled_relief.hpp"
#include "reference/surface_shader.hpp"
#include "reference/truth.hpp"
#include "scene/lighting.hpp"
#include "scene/relief.hpp"

namespace reliefbench {

/// Sets the picture of a truth (colour, samples, standard_error, half_picture) to the mean of picture.samples > 1 rays
/// a pixel, in linear light and double precision. The rays lie in the pixel's box by scrambled Sobol points, in two
/// scramblings of each pixel's own. Each is shaded as the one through the centre would be, by its own hit, normal and
/// light: the light of hard shadows by one ray a light, that of soft ones by so many directions within each light's
/// radius that a pixel has at least as many as one of a truth of one ray.
void filter_picture(Truth& truth, const SampledRelief& relief, const SurfaceShader& shader, const View& view,
                    const Lighting& lighting, const TruthPicture& picture);

}  // namespace reliefbench
