#include "scene/surface/mesh_view.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

/// By how much the floor between the vertices of a triangle, where N keeps its length, may lie beyond the plane through
/// its corners.
double floor_bulge(const BaseMesh& mesh, double height_scale) {
    double shortest = 1;
    for (const BaseMesh::Triangle& corners : mesh.triangles) {
        const glm::dvec3 sum = glm::dvec3(mesh.vertices[corners[0]].normal) +
                               glm::dvec3(mesh.vertices[corners[1]].normal) +
                               glm::dvec3(mesh.vertices[corners[2]].normal);
        shortest = std::min(shortest, glm::length(sum) / 3);
    }
    return height_scale * (1 - shortest);
}

/// Calls see(point) for each vertex and for the floor below it.
template <typename See>
void see_vertices(const BaseMesh& mesh, double height_scale, const See& see) {
    for (const MeshVertex& vertex : mesh.vertices) {
        const glm::dvec3 position(vertex.position);
        see(position);
        see(position - height_scale * glm::dvec3(vertex.normal));
    }
}

}  // namespace

double nearest_depth(const BaseMesh& mesh, const Camera& camera, double height_scale) {
    const CameraFrame frame = camera_frame(camera);
    double nearest = std::numeric_limits<double>::infinity();
    see_vertices(mesh, height_scale, [&](const glm::dvec3& point) {
        nearest = std::min(nearest, glm::dot(point - frame.eye, frame.forward));
    });
    const double smallest = 1e-3 * camera.distance;
    return std::max(nearest - floor_bulge(mesh, height_scale), smallest);
}

ParallelWindow parallel_window(const BaseMesh& mesh, const Camera& camera, double height_scale) {
    const glm::dvec3 forward = camera_frame(camera).forward;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    ParallelWindow window{.low = glm::dvec2(infinity), .high = glm::dvec2(-infinity), .top = -infinity};
    double bottom = infinity;
    see_vertices(mesh, height_scale, [&](const glm::dvec3& point) {
        const glm::dvec2 shadow = glm::dvec2(point) - glm::dvec2(forward) * (point.z / forward.z);
        window.low = glm::min(window.low, shadow);
        window.high = glm::max(window.high, shadow);
        window.top = std::max(window.top, point.z);
        bottom = std::min(bottom, point.z);
    });
    const double bulge = floor_bulge(mesh, height_scale);
    window.low -= bulge / -forward.z;
    window.high += bulge / -forward.z;
    window.top += bulge;
    window.depth = window.top - bottom + bulge;
    return window;
}

}  // namespace reliefbench
