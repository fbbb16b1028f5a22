// Sphere tracing: the distance to the surface is a step that cannot pass through it. It ends where the distance stored is
// none, short of the surface by what the map cannot resolve, or after the steps asked for: a fixed number of them is the
// published method, so that the point which they reach is its answer, not one that a cap cut off.
Trace trace(ReliefRay ray) {
    // Of the whole ray in the space of the distances (metric.glsl): 1 / length is the ray parameter per distance.
    float inverse_length = 1.0 / length(vec3(ray.max_offset, metric_height));
    float s = 0.0;
    for (int steps = 1; steps <= max_steps; ++steps) {
        float distance_to_surface = metric_height * tap_map(surface_distances, vec3(point_on_ray(ray, s), 1.0 - s), 0.0).r;
        if (distance_to_surface <= 0.0 || s >= 1.0) return hit_on_ray(min(s, 1.0), steps);
        s += distance_to_surface * inverse_length;
    }
    return hit_on_ray(min(s, 1.0), max_steps);
}
