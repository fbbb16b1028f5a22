#include "bilinear_patch.glsl"

struct SurfacePoint {
    float h;
    vec3 normal;
};

// One tap has both, as one texel of a normal map with height in its alpha.
SurfacePoint tap_surface(ReliefRay ray, vec2 uv) {
    vec2 size = vec2(height_map_size());
    vec2 place = uv * size - 0.5;
    vec2 cell = floor(place);
    vec2 position = place - cell;
    vec4 corners = tap_height_cell(ivec2(cell));
    vec2 rise = vec2(mix(corners.y - corners.x, corners.w - corners.z, position.y),
                     mix(corners.z - corners.x, corners.w - corners.y, position.x));
    // How far H goes along tangent and bitangent, in texels.
    mat2 rates = ray.height_scale * ray.uv_per_length;
    mat2 texels = mat2(rates[0] * size, rates[1] * size);
    return SurfacePoint(patch_height(corners, position), normalize(vec3(-rise * texels, 1.0)));
}

// From the entry, again and again: move along the view vector by the height between ray and surface, not divided by V.z
// (offset limiting) and damped by the slope. The ray may pass through the surface and come back.
Trace trace(ReliefRay ray) {
    float s = 0.0;
    for (int i = 0; i < iterations; ++i) {
        SurfacePoint surface = tap_surface(ray, point_on_ray(ray, s));
        float gap = height_of_ray(ray, s) - surface.h;
        s += gap * (slope ? surface.normal.z : 1.0) * ray.to_eye.z;
    }
    return hit_on_ray(s, iterations);
}
