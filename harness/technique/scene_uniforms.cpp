#include "technique/scene_uniforms.hpp"

#include "core/error.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace reliefbench {

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
    const ParallelWindow window = parallel_window(view.relief.base, view.camera, view.relief.height_scale);
    uniforms.window_low = glm::vec2(window.low);
    uniforms.window_size = glm::vec2(window.high - window.low);
    uniforms.window_top = static_cast<float>(window.top);
    uniforms.frame = view.frame.value_or(0);
    uniforms.shift = glm::vec2(view.camera.shift);
    uniforms.polygon_height = static_cast<float>(view.relief.polygon_height);
    return uniforms;
}

}  // namespace reliefbench
