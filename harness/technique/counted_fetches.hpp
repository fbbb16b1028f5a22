#pragma once

#include "gpu/shader_compiler.hpp"

namespace reliefbench {

/// Throws Error, a line "file:line: ..." for each place, where a module of a draw, compiled with its lines, fetches
/// past the counted fetches of taps.glsl. Those of shading (surface.glsl) are the harness's own.
void refuse_uncounted_fetches(const gpu::SpirV& module);

}  // namespace reliefbench
