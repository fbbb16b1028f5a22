// The polygon itself: no relief, whatever the height map says.
Trace trace(ReliefRay ray) {
    Trace polygon = hit_off_ray(ray.uv, 1.0, 0);
    polygon.flat_normal = !normal_mapping;
    return polygon;
}
