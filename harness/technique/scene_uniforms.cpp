#include "technique/scene_uniforms.hpp"

#include "core/error.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cassert>
#include <cmath>

namespace reliefbench {

namespace {

/// PatchGrid before its numbers are known to be integers of 32 bits.
struct RealGrid {
    glm::dvec2 per_side{1, 1};
    glm::dvec2 first{0, 0};
    glm::dvec2 count{1, 1};
};

RealGrid real_grid(const Manifest& manifest, const ParameterValues& values, const View& view, Resolution height_map) {
    RealGrid grid;
    if (manifest.shape.kind == Shape::Kind::quad) return grid;
    const auto asked = std::get<std::int64_t>(values.at(manifest.shape.patches_parameter));
    const glm::dvec2 texels = view.relief.tiling * glm::dvec2(height_map.width, height_map.height);
    grid.per_side = asked > 0 ? glm::dvec2(static_cast<double>(asked))
                              : glm::max(glm::ceil(texels / double(manifest.shape.texels_per_patch)), 1.0);
    const PatchRegion region = view.relief.boundary == Boundary::clip
                                   ? PatchRegion{}
                                   : visible_region(view.relief.base, view.camera, view.relief.height_scale);
    grid.first = glm::floor(region.low * grid.per_side);
    grid.count = glm::ceil(region.high * grid.per_side) - grid.first;
    return grid;
}

}  // namespace

PatchGrid patch_grid(const Manifest& manifest, const ParameterValues& values, const View& view, Resolution height_map) {
    const RealGrid grid = real_grid(manifest, values, view, height_map);
    return {glm::ivec2(grid.per_side), glm::ivec2(grid.first), glm::ivec2(grid.count)};
}

double patch_count(const Manifest& manifest, const ParameterValues& values, const View& view, Resolution height_map) {
    const RealGrid grid = real_grid(manifest, values, view, height_map);
    return grid.count.x * grid.count.y;
}

SceneUniforms make_scene_uniforms(const View& view, const Lighting& lighting, const PatchGrid& patches) {
    if (lighting.lights.size() > max_lights)
        fail("{} lights are asked for; there can be {}", lighting.lights.size(), max_lights);
    const CameraFrame frame = camera_frame(view.camera);
    const double half_height = std::tan(glm::radians(view.camera.fov) / 2);
    const double half_width = half_height * view.resolution.width / view.resolution.height;

    SceneUniforms uniforms{};
    uniforms.clip_from_world = glm::mat4(clip_from_world(view));
    uniforms.eye = glm::vec3(frame.eye);
    uniforms.height_scale = static_cast<float>(view.relief.height_scale);
    uniforms.forward = glm::vec3(frame.forward);
    uniforms.tiling = static_cast<float>(view.relief.tiling);
    uniforms.right = glm::vec3(frame.right * half_width);
    uniforms.parallel_rays = view.camera.projection == Projection::parallel ? 1 : 0;
    uniforms.up = glm::vec3(frame.up * half_height);
    uniforms.light_count = static_cast<std::int32_t>(lighting.lights.size());
    for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
        const DirectionalLight& light = lighting.lights[i];
        if (glm::length(light.direction) == 0) fail("light {} has no direction", i);
        uniforms.light_direction[i] = glm::vec4(glm::vec3(glm::normalize(light.direction)), 0);
        uniforms.light_colour[i] = glm::vec4(glm::vec3(light.colour), 0);
    }
    uniforms.ambient = glm::vec3(lighting.ambient);
    uniforms.shininess = static_cast<float>(lighting.shininess);
    uniforms.specular = glm::vec3(lighting.specular);
    if (lighting.fog) {
        uniforms.fog_start = static_cast<float>(lighting.fog->start);
        uniforms.fog_colour = glm::vec3(lighting.fog->colour);
        uniforms.fog_range = static_cast<float>(lighting.fog->range);
    }
    uniforms.resolution = {view.resolution.width, view.resolution.height};
    uniforms.patches_per_side = patches.per_side;
    uniforms.first_patch = patches.first;
    uniforms.patch_count = patches.count;
    return uniforms;
}

}  // namespace reliefbench
