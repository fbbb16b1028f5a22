// One tap at the entry stands for the height under the whole ray.
Trace trace(ReliefRay ray) {
    float h = tap_height(ray.uv);
    float depth = scale * (1.0 - h) - bias;
    vec2 full_offset = offset_limiting ? -ray.height_scale * ray.uv_per_length * ray.to_eye.xy : straight_offset(ray);
    return hit_off_ray(ray.uv + depth * full_offset, h, 1);
}
