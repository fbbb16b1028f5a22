#pragma once

#include "scene/height_map.hpp"
#include "scene/lighting.hpp"
#include "scene/relief.hpp"
#include "technique/technique.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace reliefbench {

inline constexpr std::size_t max_lights = 3;

/// SceneValues of harness/shaders/contract/scene.glsl, std140.
struct SceneUniforms {
    glm::mat4 clip_from_world;
    glm::vec3 eye;
    float height_scale;
    glm::vec3 forward;
    float tiling;
    glm::vec3 right;
    std::int32_t parallel_rays;
    glm::vec3 up;
    std::int32_t light_count;
    std::array<glm::vec4, max_lights> light_direction;
    std::array<glm::vec4, max_lights> light_colour;
    glm::vec3 ambient;
    float shininess;
    glm::vec3 specular;
    float fog_start;
    glm::vec3 fog_colour;
    float fog_range;
    glm::ivec2 resolution;
    glm::ivec2 patches_per_side;
    glm::ivec2 first_patch;
    glm::ivec2 patch_count;
    /// From here on of bases that are not flat only: of parallel rays, ParallelWindow.
    glm::vec2 window_low;
    glm::vec2 window_size;
    float window_top;
    /// From here on of frames of a sequence only: View::frame and Camera::shift.
    std::int32_t frame;
    glm::vec2 shift;
    /// Of a polygon that does not lie at h = 1 only: Relief::polygon_height.
    float polygon_height;
    float padding;
};
static_assert(offsetof(SceneUniforms, eye) == 64);
static_assert(offsetof(SceneUniforms, light_direction) == 128);
static_assert(offsetof(SceneUniforms, ambient) == 224);
static_assert(offsetof(SceneUniforms, resolution) == 272);
static_assert(offsetof(SceneUniforms, window_low) == 304);
static_assert(offsetof(SceneUniforms, shift) == 328);
static_assert(offsetof(SceneUniforms, polygon_height) == 336);
static_assert(sizeof(SceneUniforms) == 344);

/// The name of the uniform block in harness/shaders/contract/scene.glsl.
inline constexpr const char* scene_block_name = "scene_block";

/// That block, std140.
struct SceneBlock {
    std::int32_t index;
    std::array<std::int32_t, 3> padding;
    SceneUniforms values;
};
static_assert(offsetof(SceneBlock, values) == 16);

/// A grid of patches over at least the part of the plane that is seen, in whole patches from the corner of the unit
/// square.
struct PatchGrid {
    glm::ivec2 per_side{1, 1};
    glm::ivec2 first{0, 0};
    glm::ivec2 count{1, 1};
};

/// At most `max_lights` lights, and directions of any length but zero: else an Error.
SceneUniforms make_scene_uniforms(const View& view, const Lighting& lighting, const PatchGrid& patches);

}  // namespace reliefbench
