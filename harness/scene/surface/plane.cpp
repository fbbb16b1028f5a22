#include "scene/surface/plane.hpp"

#include <glm/common.hpp>

#include <algorithm>

namespace reliefbench {

namespace {

constexpr TangentFrame plane_frame{.along_u = {1, 0, 0}, .along_v = {0, 1, 0}, .normal = {0, 0, 1}};

}  // namespace

glm::dvec3 base_point(const Plane& /*plane*/, glm::dvec2 uv, double above) {
    return {uv.x - 0.5, uv.y - 0.5, above};
}

TangentFrame tangent_frame(const Plane& /*plane*/, glm::dvec2 /*uv*/) {
    return plane_frame;
}

std::optional<BaseEntry> find_entry(const Plane& plane, const Ray& ray) {
    if (ray.direction.z >= 0 || ray.origin.z < 0) return std::nullopt;
    const double t = crossing_t(plane, ray);
    const glm::dvec2 uv{ray.origin.x + t * ray.direction.x + 0.5, ray.origin.y + t * ray.direction.y + 0.5};
    if (uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1) return std::nullopt;
    return BaseEntry{.uv = uv, .t = t, .frame = plane_frame};
}

std::optional<Ray> light_ray(const Plane& /*plane*/, const glm::dvec3& point, const glm::dvec3& to_light) {
    if (to_light.z <= 0) return std::nullopt;
    return Ray{point - to_light * (point.z / to_light.z), -to_light};
}

Ray started_above(const Plane& plane, const Ray& ray, double height) {
    return {ray.origin + ray.direction * rise_t(plane, ray, height), ray.direction};
}

Ray shifted(const Plane& /*plane*/, const Ray& ray, const glm::dvec3& by) {
    return {ray.origin + by, ray.direction};
}

double nearest_depth(const Plane& /*plane*/, const Camera& camera, double cosine_of_corner) {
    // Two bounds hold: that of the patch's nearest corner, and, for an eye above the patch itself, the eye's height
    // over the plane seen at the picture's corner.
    const glm::dvec3 eye = camera_frame(camera).eye;
    double nearest_corner = camera.distance - (std::abs(eye.x) + std::abs(eye.y)) / (2 * camera.distance);
    // The plane lies above what the camera looks at, and rays that meet that within the patch may enter beside it.
    if (camera.target_height != 0)
        nearest_corner += camera.target_height * camera.distance / (eye.z - camera.target_height);
    return std::max(nearest_corner, eye.z * cosine_of_corner);
}

PatchRegion visible_region(const Plane& /*plane*/, const Camera& camera, double height_scale) {
    // Where a ray leaves the slab depends linearly on where it enters: the corners bound it.
    PatchRegion region;
    const CameraFrame frame = camera_frame(camera);
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1)}) {
        const auto include = [&](double z) {
            const double from_target = camera.target_height - z;
            glm::dvec2 reached;
            if (camera.projection == Projection::parallel) {
                reached = corner - glm::dvec2(frame.forward) * (from_target / frame.forward.z);
            } else {
                const glm::dvec2 below_eye = glm::dvec2(frame.eye) + 0.5;
                const double above_target = frame.eye.z - camera.target_height;
                reached = below_eye + (corner - below_eye) * ((above_target + from_target) / above_target);
            }
            region.low = glm::min(region.low, reached);
            region.high = glm::max(region.high, reached);
        };
        include(-height_scale);
        if (camera.target_height != 0) include(0);
    }
    return region;
}

}  // namespace reliefbench
