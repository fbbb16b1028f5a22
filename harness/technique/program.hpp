#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/pipeline.hpp"
#include "scene/relief.hpp"
#include "technique/technique.hpp"

#include <vector>

namespace reliefbench {

/// Binding numbers of harness/shaders.
namespace binding {
inline constexpr std::uint32_t scene = 0;
inline constexpr std::uint32_t height_map = 1;
inline constexpr std::uint32_t height_texels = 2;
inline constexpr std::uint32_t height_derivatives = 3;
inline constexpr std::uint32_t albedo = 4;
inline constexpr std::uint32_t work = 5;
inline constexpr std::uint32_t target_map = 6;
inline constexpr std::uint32_t previous_map = 7;
/// Of the draw of the scene's object, which has no maps.
inline constexpr std::uint32_t object = 7;
inline constexpr std::uint32_t first_derived_map = 8;
}  // namespace binding

/// constant_id numbers of harness/shaders; parameters follow in the order of the manifest.
namespace constant {
inline constexpr std::uint32_t srgb_target = 0;
inline constexpr std::uint32_t lighting_enabled = 1;
inline constexpr std::uint32_t relief_repeats = 2;
inline constexpr std::uint32_t self_shadow = 6;
inline constexpr std::uint32_t self_shadow_bias = 7;
inline constexpr std::uint32_t self_shadow_min_steps = 8;
inline constexpr std::uint32_t self_shadow_max_steps = 9;
inline constexpr std::uint32_t self_shadow_softening = 10;
inline constexpr std::uint32_t object_is_box = 11;
inline constexpr std::uint32_t first_parameter = 16;
}  // namespace constant

/// Whether shaders read scene.glsl's values through an index that no compiler knows to be 0: on a CPU device. lavapipe
/// (Mesa 22.3) otherwise writes those that conditions depend on into a copy of the shader at every draw and compiles
/// that, within the timestamps (3 ms and more a draw), and keeps it until the pipeline is gone (1 MB a submission).
bool indexes_scene(const gpu::Device& device);

/// The two compilations of a technique's draw, and of its passes.
enum class Variant { timed, probed };

/// All stages of a technique's draw, from the device's shader cache where they have been compiled before. What does not
/// compile is an Error that names technique, file and line. Of the parameters, those of compile time count.
std::vector<gpu::CompiledStage> compile_draw(const gpu::Device& device, const Technique& technique,
                                             const ParameterValues& parameters, Variant variant,
                                             DepthWrite depth_write);

/// Probed it does the same work, writes nothing, and tells whether the device ended its loops.
gpu::CompiledStage compile_pass(const gpu::Device& device, const Technique& technique,
                                const ParameterValues& parameters, const PassDeclaration& pass, Variant variant);

/// A parameter's value as the 32 bits of its specialization constant.
gpu::SpecializationValues parameter_constants(const Manifest& manifest, const ParameterValues& values);

/// The specialization constants of harness/shaders/driver/self_shadow.glsl.
gpu::SpecializationValues self_shadow_constants(const SelfShadow& self_shadow);

/// Maps that a pass may read: those finished by earlier passes. Indices into manifest.maps.
std::vector<std::size_t> maps_before(const Manifest& manifest, const PassDeclaration& pass);

}  // namespace reliefbench
