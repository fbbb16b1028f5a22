#include "bent_way.glsl"

#ifdef RELIEFBENCH_BENT_RAY
// In the space of the distances, where the ray moves by |speed| * s + |bend| * s^2 at most.
float way_within(ReliefRay ray, float s, float distance_to_surface) {
    float speed = length(vec3(way_of_ray(ray, s), metric_height * slope_of_ray(ray, s)));
    return first_at(distance_to_surface, speed, length(vec3(ray.uv_bend, metric_height * ray.bend)));
}
#endif

// Sphere tracing: the distance to the surface is a step that cannot pass through it. It ends where the distance stored is
// none, short of the surface by what the map cannot resolve, or after the steps asked for: a fixed number of them is the
// published method, so that the point which they reach is its answer, not one that a cap cut off.
Trace trace(ReliefRay ray) {
#ifndef RELIEFBENCH_BENT_RAY
    // Of the whole ray in the space of the distances (metric.glsl): 1 / length is the ray parameter per distance.
    float inverse_length = 1.0 / length(vec3(straight_offset(ray), metric_height));
#endif
    float s_end = ray.s_end;
    float s = 0.0;
    for (int steps = 1; steps <= max_steps; ++steps) {
        vec3 point = vec3(point_on_ray(ray, s), height_of_ray(ray, s));
        float distance_to_surface = metric_height * tap_map(surface_distances, point, 0.0).r;
#ifdef RELIEFBENCH_BENT_RAY
        if (s >= s_end && leaves_above(ray)) return miss(steps);
#endif
        if (distance_to_surface <= 0.0 || s >= s_end) return hit_on_ray(min(s, s_end), steps);
#ifdef RELIEFBENCH_BENT_RAY
        s += way_within(ray, s, distance_to_surface);
#else
        s += distance_to_surface * inverse_length;
#endif
    }
    return hit_on_ray(min(s, s_end), max_steps);
}
