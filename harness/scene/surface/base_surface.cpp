#include "scene/surface/base_surface.hpp"

namespace reliefbench {

Plane flat_base(const BaseSurface& base) {
    return std::visit([](const Plane& plane) { return plane; }, base.kind);
}

glm::dvec3 base_point(const BaseSurface& base, glm::dvec2 uv, double above) {
    return std::visit([&](const auto& one) { return base_point(one, uv, above); }, base.kind);
}

TangentFrame tangent_frame(const BaseSurface& base, glm::dvec2 uv) {
    return std::visit([&](const auto& one) { return tangent_frame(one, uv); }, base.kind);
}

glm::dvec3 relief_normal(const BaseSurface& base, glm::dvec2 uv, glm::dvec2 slope) {
    return std::visit([&](const auto& one) { return relief_normal(one, uv, slope); }, base.kind);
}

std::optional<BaseEntry> find_entry(const BaseSurface& base, const Ray& ray) {
    return std::visit([&](const auto& one) { return find_entry(one, ray); }, base.kind);
}

std::optional<Ray> light_ray(const BaseSurface& base, glm::dvec2 uv, const glm::dvec3& point,
                             const glm::dvec3& to_light) {
    return std::visit([&](const auto& one) { return light_ray(one, uv, point, to_light); }, base.kind);
}

Ray started_above(const BaseSurface& base, const Ray& ray, double height) {
    return std::visit([&](const auto& one) { return started_above(one, ray, height); }, base.kind);
}

Ray shifted(const BaseSurface& base, const Ray& ray, const glm::dvec3& by) {
    return std::visit([&](const auto& one) { return shifted(one, ray, by); }, base.kind);
}

double nearest_depth(const BaseSurface& base, const Camera& camera, double cosine_of_corner) {
    return std::visit([&](const auto& one) { return nearest_depth(one, camera, cosine_of_corner); }, base.kind);
}

ParallelWindow parallel_window(const BaseSurface& base, const Camera& camera, double height_scale) {
    return std::visit([&](const auto& one) { return parallel_window(one, camera, height_scale); }, base.kind);
}

PatchRegion visible_region(const BaseSurface& base, const Camera& camera, double height_scale) {
    return std::visit([&](const auto& one) { return visible_region(one, camera, height_scale); }, base.kind);
}

}  // namespace reliefbench
