#include "scene/relief.hpp"

namespace reliefbench {

std::string to_string(Boundary boundary) {
    return boundary == Boundary::clip ? "clip" : "repeat";
}

View through_centres(View view) {
    view.samples_per_pixel = 1;
    view.frames = 1;
    return view;
}

View frame_of(View view, int frame) {
    if (view.frames == 1) return view;
    view.camera.shift += frame_shift(frame, view.frames, view.resolution, view.samples_per_pixel);
    view.frame = frame;
    view.frames = 1;
    return view;
}

double polygon_z(const Relief& relief) {
    return (relief.polygon_height - 1) * relief.height_scale;
}

void set_polygon_height(View& view, double height) {
    view.relief.polygon_height = height;
    view.camera.target_height = polygon_z(view.relief);
}

bool is_in_footprint(const Ray& ray, const Relief& relief) {
    const bool enters = footprint_entry(ray, relief.base).has_value();
    if (relief.polygon_height == 1) return enters;
    if (ray.direction.z >= 0 || (!enters && relief.boundary == Boundary::clip)) return false;
    const double t = (polygon_z(relief) - ray.origin.z) / ray.direction.z;
    const glm::dvec2 place = glm::dvec2(ray.origin) + t * glm::dvec2(ray.direction) + 0.5;
    return t >= 0 && place.x >= 0 && place.x <= 1 && place.y >= 0 && place.y <= 1;
}

glm::dvec3 surface_point(const Relief& relief, double u, double v, double h) {
    return base_point(flat_base(relief.base), {u, v}, (h - 1) * relief.height_scale);
}

std::optional<glm::dvec2> footprint_entry(const Ray& ray, const BaseSurface& base) {
    const std::optional<BaseEntry> entry = find_entry(flat_base(base), ray);
    if (!entry) return std::nullopt;
    return entry->uv;
}

PixelRays pixel_rays(const View& view) {
    return {view.camera, view.resolution, parallel_window(view.relief.base, view.camera, view.relief.height_scale)};
}

Ray pixel_ray(const View& view, double i, double j) {
    return pixel_rays(view).at(i, j);
}

glm::dmat4 clip_from_world(const View& view) {
    const BaseSurface& base = view.relief.base;
    if (view.camera.projection == Projection::parallel)
        return parallel_clip(view.camera, parallel_window(base, view.camera, view.relief.height_scale));
    const double cosine = cosine_of_picture_corner(view.camera, view.resolution);
    // Half as far as what is nearest: the margin of the near plane.
    return perspective_clip(view.camera, view.resolution,
                            nearest_depth(base, view.camera, view.relief.height_scale, cosine) / 2);
}

}  // namespace reliefbench
