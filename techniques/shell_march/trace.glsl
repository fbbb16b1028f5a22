#include "shell_ray.glsl"

// Uniform steps through the piece; the surface between the last one above it and the first at or beneath it is taken for a
// straight line.
Trace trace_shell(ShellRay ray) {
    float texels = length(ray.way.xy * vec2(height_map_size()));
    int steps = clamp(int(ceil(texels * steps_per_texel)), 1, max_steps);
    float h = tap_height(point_on_ray(ray, 0.0));
    if (ray.from_base && enters_surface(h)) return hit_on_ray(0.0, 0);
    float gap = height_of_ray(ray, 0.0) - h;
    for (int i = 1; i <= steps; ++i) {
        float s = float(i) / float(steps);
        float next_gap = height_of_ray(ray, s) - tap_height(point_on_ray(ray, s));
        // Only from above: a piece that begins beneath the surface came through the side of the relief.
        if (gap > 0.0 && next_gap <= 0.0) return hit_on_ray((float(i - 1) + gap / (gap - next_gap)) / float(steps), i);
        gap = next_gap;
    }
    return miss(steps);
}
