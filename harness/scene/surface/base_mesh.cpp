#include "scene/surface/base_mesh.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace reliefbench {

namespace {

std::array<MeshVertex, 3> corners_of(const BaseMesh& mesh, std::size_t triangle) {
    const BaseMesh::Triangle& corners = mesh.triangles[triangle];
    return {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
}

}  // namespace

BaseTriangle base_triangle(const BaseMesh& mesh, std::size_t triangle) {
    const std::array<MeshVertex, 3> corners = corners_of(mesh, triangle);
    const glm::dvec2 uv(corners[0].uv);
    const glm::dvec2 first = glm::dvec2(corners[1].uv) - uv;
    const glm::dvec2 second = glm::dvec2(corners[2].uv) - uv;
    const double area = first.x * second.y - second.x * first.y;
    // Of any vector that is linear over the triangle, from its changes along both sides.
    const auto per_uv = [&](const glm::dvec3& along_first, const glm::dvec3& along_second) {
        return std::array<glm::dvec3, 2>{(along_first * second.y - along_second * first.y) / area,
                                         (along_second * first.x - along_first * second.x) / area};
    };
    const glm::dvec3 position(corners[0].position);
    const glm::dvec3 normal(corners[0].normal);
    const glm::dvec3 side = glm::dvec3(corners[1].position) - position;
    const glm::dvec3 other_side = glm::dvec3(corners[2].position) - position;
    const auto along = per_uv(side, other_side);
    const auto normal_along = per_uv(glm::dvec3(corners[1].normal) - normal, glm::dvec3(corners[2].normal) - normal);
    return {.origin = position - uv.x * along[0] - uv.y * along[1],
            .along_u = along[0],
            .along_v = along[1],
            .normal_origin = normal - uv.x * normal_along[0] - uv.y * normal_along[1],
            .normal_along_u = normal_along[0],
            .normal_along_v = normal_along[1],
            .facet_normal = glm::normalize(glm::cross(side, other_side))};
}

double chart_area(const BaseMesh& mesh, std::size_t triangle) {
    const std::array<MeshVertex, 3> corners = corners_of(mesh, triangle);
    const glm::dvec2 first = glm::dvec2(corners[1].uv) - glm::dvec2(corners[0].uv);
    const glm::dvec2 second = glm::dvec2(corners[2].uv) - glm::dvec2(corners[0].uv);
    return (first.x * second.y - second.x * first.y) / 2;
}

TangentFrame tangent_frame(const BaseTriangle& triangle, glm::dvec2 uv) {
    return {
        .along_u = triangle.along_u, .along_v = triangle.along_v, .normal = glm::normalize(triangle.linear_normal(uv))};
}

std::array<glm::dvec3, 2> normal_derivatives(const BaseTriangle& triangle, glm::dvec2 uv) {
    const glm::dvec3 linear = triangle.linear_normal(uv);
    const double length = glm::length(linear);
    const glm::dvec3 normal = linear / length;
    const auto tangential = [&](const glm::dvec3& change) {
        return (change - normal * glm::dot(normal, change)) / length;
    };
    return {tangential(triangle.normal_along_u), tangential(triangle.normal_along_v)};
}

glm::dvec3 relief_normal(const BaseTriangle& triangle, glm::dvec2 uv, double above, glm::dvec2 slope) {
    const glm::dvec3 normal = glm::normalize(triangle.linear_normal(uv));
    const auto [normal_u, normal_v] = normal_derivatives(triangle, uv);
    const glm::dvec3 along_u = triangle.along_u + slope.x * normal + above * normal_u;
    const glm::dvec3 along_v = triangle.along_v + slope.y * normal + above * normal_v;
    const glm::dvec3 across = glm::normalize(glm::cross(along_u, along_v));
    const bool is_mirrored = glm::dot(glm::cross(triangle.along_u, triangle.along_v), triangle.facet_normal) < 0;
    return is_mirrored ? -across : across;
}

}  // namespace reliefbench
