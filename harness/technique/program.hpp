#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/pipeline.hpp"
#include "scene/relief.hpp"
#include "technique/technique.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// Whether shaders read scene.glsl's values through an index that no compiler knows to be 0: on a CPU device. lavapipe
/// (Mesa 22.3) otherwise writes those that conditions depend on into a copy of the shader at every draw and compiles
/// that, within the timestamps (3 ms and more a draw), and keeps it until the pipeline is gone (1 MB a submission).
bool indexes_scene(const gpu::Device& device);

/// Whether shaders interpolate what is over w, and divide by w themselves: on a CPU device, with several samples for
/// each pixel. lavapipe (Mesa 22.3) divides what it interpolates at a sample by the w of the pixel's centre.
bool divides_by_own_w(const gpu::Device& device, const View& view);

/// What shaders that know the pixels' rays are compiled with: empty over a flat base, for a picture by itself with one
/// sample for each pixel.
std::string declare_rays(const BaseSurface& base, const View& view);

/// The two compilations of a technique's draw, and of its passes.
enum class Variant { timed, probed };

/// All stages of a technique's draw, from the device's shader cache where they have been compiled before. What does not
/// compile is an Error that names technique, file and line. Of the parameters, those of compile time count; of the
/// view, what its stages are compiled for, which is decided here alone.
std::vector<gpu::CompiledStage> compile_draw(const gpu::Device& device, const Technique& technique,
                                             const ParameterValues& parameters, Variant variant, const View& view);

/// Probed it does the same work, writes nothing, and tells whether the device ended its loops.
gpu::CompiledStage compile_pass(const gpu::Device& device, const Technique& technique,
                                const ParameterValues& parameters, const PassDeclaration& pass, Variant variant);

/// The parameters' values as the 32 bits of their specialization constants, without those of compile time, which have
/// none.
gpu::SpecializationValues parameter_constants(const Manifest& manifest, const ParameterValues& values);

/// The specialization constants that are the view's.
gpu::SpecializationValues view_constants(const View& view);

/// Maps that a pass may read: those finished by earlier passes. Indices into manifest.maps.
std::vector<std::size_t> maps_before(const Manifest& manifest, const PassDeclaration& pass);

}  // namespace reliefbench
