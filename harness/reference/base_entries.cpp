#include "reference/base_entries.hpp"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

/// What a base of these triangles is called in messages.
std::string base_in_words(const BaseMesh& mesh) {
    return fmt::format("the base '{}' of {} triangles", mesh.name, mesh.triangles.size());
}

Box box_around(const BaseMesh& mesh, const BaseMesh::Triangle& corners, double margin) {
    Box box{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto along = [&](std::size_t corner) {
            return static_cast<double>(mesh.vertices[corners[corner]].position[axis]);
        };
        const auto [low, high] = std::minmax({along(0), along(1), along(2)});
        constexpr float beyond = std::numeric_limits<float>::infinity();
        const auto member = static_cast<std::size_t>(axis);
        box.low[member] = std::nextafter(static_cast<float>(low - margin), -beyond);
        box.high[member] = std::nextafter(static_cast<float>(high + margin), beyond);
    }
    return box;
}

}  // namespace

double BoundingSphere::way_to(const Ray& ray) const {
    return std::max(0.0, glm::dot(centre - ray.origin, ray.direction) - radius);
}

double BoundingSphere::box_margin() const {
    // Of the ray's start and of its direction at the far side: a few units in the last place of a float.
    return 0x1p-21 * (glm::length(centre) + 2 * radius);
}

BoundingSphere bounding_sphere(const BaseMesh& mesh, double height_scale) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const MeshVertex& vertex : mesh.vertices) {
        low = glm::min(low, glm::dvec3(vertex.position));
        high = glm::max(high, glm::dvec3(vertex.position));
    }
    return {(low + high) / 2.0, glm::length(high - low) / 2 + 1.01 * height_scale};
}

BaseEntries::BaseEntries(const BaseMesh& mesh) : mesh_(&mesh), sphere_(bounding_sphere(mesh, 0)) {
    std::vector<Box> boxes;
    boxes.reserve(mesh.triangles.size());
    for (const BaseMesh::Triangle& corners : mesh.triangles)
        boxes.push_back(box_around(mesh, corners, sphere_.box_margin()));
    boxes_.emplace(boxes, base_in_words(mesh));
}

std::optional<MeshEntry> BaseEntries::find(const Ray& ray) const {
    const double start = sphere_.way_to(ray);
    const Ray close{ray.origin + start * ray.direction, ray.direction};
    double nearest = std::numeric_limits<double>::infinity();
    std::uint32_t entered = 0;
    boxes_->visit(close, [&](std::uint32_t triangle) {
        const std::optional<double> t = front_t(close, triangle);
        // Of triangles that share the point the lowest, in whatever order they come.
        if (t && *t >= 0 && (*t < nearest || (*t == nearest && triangle < entered))) {
            nearest = *t;
            entered = triangle;
        }
        return nearest;
    });
    if (std::isinf(nearest)) return std::nullopt;
    const BaseTriangle triangle = base_triangle(*mesh_, entered);
    const glm::dvec3 from_origin = close.origin + nearest * close.direction - triangle.origin;
    const glm::dvec3 across = glm::cross(triangle.along_u, triangle.along_v);
    const double area = glm::dot(across, across);
    const glm::dvec2 uv(glm::dot(glm::cross(from_origin, triangle.along_v), across) / area,
                        glm::dot(glm::cross(triangle.along_u, from_origin), across) / area);
    return MeshEntry{{.uv = uv, .t = start + nearest, .frame = tangent_frame(triangle, uv)}, entered};
}

std::optional<double> BaseEntries::front_t(const Ray& ray, std::uint32_t triangle) const {
    const BaseMesh::Triangle& corners = mesh_->triangles[triangle];
    const glm::dvec3 a = glm::dvec3(mesh_->vertices[corners[0]].position) - ray.origin;
    const glm::dvec3 b = glm::dvec3(mesh_->vertices[corners[1]].position) - ray.origin;
    const glm::dvec3 c = glm::dvec3(mesh_->vertices[corners[2]].position) - ray.origin;
    // The volumes of ray and sides. A side's is the exact negative for the triangle on its other side.
    const double of_a = glm::dot(ray.direction, glm::cross(c, b));
    const double of_b = glm::dot(ray.direction, glm::cross(a, c));
    const double of_c = glm::dot(ray.direction, glm::cross(b, a));
    if (of_a < 0 || of_b < 0 || of_c < 0) return std::nullopt;
    const glm::dvec3 across = glm::cross(b - a, c - a);
    const double facing = glm::dot(ray.direction, across);
    if (facing >= 0 || chart_area(*mesh_, triangle) == 0) return std::nullopt;
    return glm::dot(a, across) / facing;
}

}  // namespace reliefbench
