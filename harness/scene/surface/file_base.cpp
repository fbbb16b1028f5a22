#include "scene/surface/file_base.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "scene/surface/charts.hpp"
#include "scene/surface/mesh_file.hpp"
#include "scene/surface/vertex_places.hpp"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

/// A triangle thinner than this times its longest side, squared, has no area.
constexpr double thinnest = 1e-9;
/// Of (u, v) and, in patch sides, of positions: beyond it single precision has no digits left for a relief.
constexpr float largest_coordinate = 1e5f;

bool is_finite(const glm::vec3& vector) {
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

glm::dvec3 position_of(const FileMesh& mesh, std::uint32_t vertex) {
    return glm::dvec3(mesh.vertices[vertex].position);
}

void check_vertices(const std::string& name, const FileMesh& mesh) {
    for (const BaseMesh::Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            const MeshVertex& vertex = mesh.vertices[corner];
            if (!is_finite(vertex.position))
                fail("mesh '{}' has a position that is not finite (NaN, or too large): export it again", name);
            const glm::vec2 size = glm::abs(vertex.uv);
            if (!(size.x <= largest_coordinate) || !(size.y <= largest_coordinate)) {
                fail("mesh '{}' has texture coordinates ({}, {}), and no more than ±{} are read: export it again", name,
                     vertex.uv.x, vertex.uv.y, largest_coordinate);
            }
        }
    }
}

bool has_area(const FileMesh& mesh, const BaseMesh::Triangle& corners) {
    const glm::dvec3 first = position_of(mesh, corners[1]) - position_of(mesh, corners[0]);
    const glm::dvec3 second = position_of(mesh, corners[2]) - position_of(mesh, corners[0]);
    const glm::dvec3 third = second - first;
    const double longest = std::max({glm::dot(first, first), glm::dot(second, second), glm::dot(third, third)});
    return glm::length(glm::cross(first, second)) > thinnest * longest;
}

bool has_chart_area(const FileMesh& mesh, const BaseMesh::Triangle& corners) {
    const glm::dvec2 from(mesh.vertices[corners[0]].uv);
    const glm::dvec2 first = glm::dvec2(mesh.vertices[corners[1]].uv) - from;
    const glm::dvec2 second = glm::dvec2(mesh.vertices[corners[2]].uv) - from;
    const glm::dvec2 third = second - first;
    const double longest = std::max({glm::dot(first, first), glm::dot(second, second), glm::dot(third, third)});
    const double area = std::abs(first.x * second.y - second.x * first.y);
    // One of 10⁷ triangles over the unit square has 10⁻⁷.
    return area > thinnest * longest && area > 1e-16;
}

std::size_t drop(FileMesh& mesh, bool (*stays)(const FileMesh&, const BaseMesh::Triangle&)) {
    return std::erase_if(mesh.triangles, [&](const BaseMesh::Triangle& corners) { return !stays(mesh, corners); });
}

/// By vertex, the sum over the facets around its place, each weighted by its area and its angle there. Vertices that a
/// file has several times share one.
std::vector<glm::dvec3> normal_sums(const FileMesh& mesh) {
    const std::vector<std::uint32_t> first = first_in_place(mesh.vertices);
    std::vector<glm::dvec3> sums(mesh.vertices.size(), glm::dvec3(0));
    for (const BaseMesh::Triangle& corners : mesh.triangles) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const glm::dvec3 here = position_of(mesh, corners[corner]);
            const glm::dvec3 next = position_of(mesh, corners[(corner + 1) % 3]) - here;
            const glm::dvec3 last = position_of(mesh, corners[(corner + 2) % 3]) - here;
            const glm::dvec3 doubled_area = glm::cross(next, last);
            const double angle = std::atan2(glm::length(doubled_area), glm::dot(next, last));
            sums[first[corners[corner]]] += angle * doubled_area;
        }
    }
    for (std::size_t vertex = 0; vertex < sums.size(); ++vertex)
        sums[vertex] = sums[first[vertex]];
    return sums;
}

/// (0, 0, 0) where facets cancel out.
glm::vec3 unit_or_zero(const glm::dvec3& sum) {
    const double length = glm::length(sum);
    return length > 0 && std::isfinite(length) ? glm::vec3(sum / length) : glm::vec3(0);
}

/// How many vertices still have none then.
std::size_t add_missing_normals(FileMesh& mesh) {
    const auto has_none = [](const MeshVertex& vertex) { return vertex.normal == glm::vec3(0); };
    if (std::ranges::none_of(mesh.vertices, has_none)) return 0;
    const std::vector<glm::dvec3> sums = normal_sums(mesh);
    std::size_t without = 0;
    for (const BaseMesh::Triangle& corners : mesh.triangles) {
        const glm::dvec3 facet =
            glm::normalize(glm::cross(position_of(mesh, corners[1]) - position_of(mesh, corners[0]),
                                      position_of(mesh, corners[2]) - position_of(mesh, corners[0])));
        for (const std::uint32_t corner : corners) {
            MeshVertex& vertex = mesh.vertices[corner];
            if (!has_none(vertex)) continue;
            vertex.normal = unit_or_zero(sums[corner]);
            if (!has_none(vertex)) continue;
            vertex.normal = glm::vec3(facet);
            ++without;
        }
    }
    return without;
}

/// Vertices of no triangle are nowhere: they would count where a camera looks for all of the base.
void drop_unused_vertices(FileMesh& mesh) {
    constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> places(mesh.vertices.size(), unused);
    for (const BaseMesh::Triangle& corners : mesh.triangles) {
        for (const std::uint32_t corner : corners)
            places[corner] = 0;
    }
    std::uint32_t used = 0;
    for (std::size_t vertex = 0; vertex < places.size(); ++vertex) {
        if (places[vertex] == unused) continue;
        places[vertex] = used;
        mesh.vertices[used++] = mesh.vertices[vertex];
    }
    mesh.vertices.resize(used);
    for (BaseMesh::Triangle& corners : mesh.triangles) {
        for (std::uint32_t& corner : corners)
            corner = places[corner];
    }
}

/// BaseSource::Fit::unit. What positions were multiplied by.
double fit_to_patch(std::vector<MeshVertex>& vertices) {
    const auto [low, high] = position_bounds(vertices);
    const glm::dvec3 size = high - low;
    const double scale = 1 / std::max({size.x, size.y, size.z});
    for (MeshVertex& vertex : vertices)
        vertex.position = glm::vec3((glm::dvec3(vertex.position) - (low + high) / 2.0) * scale);
    return scale;
}

std::string warning_of(std::size_t count, std::string_view noun, std::string_view what) {
    return fmt::format("{} {}", counted(count, noun), what);
}

/// Whether A(t)·n, A(t) = (a + t·da) × (b + t·db), falls to next to nothing or below for some t in [0, 1]: where both
/// sides turn over at once, as on a sphere, it touches 0 and no more.
bool turns_over(const glm::dvec3& a, const glm::dvec3& da, const glm::dvec3& b, const glm::dvec3& db,
                const glm::dvec3& n) {
    const double constant = glm::dot(glm::cross(a, b), n);
    const double linear = glm::dot(glm::cross(a, db) + glm::cross(da, b), n);
    const double square = glm::dot(glm::cross(da, db), n);
    const double nothing = 1e-4 * constant;
    if (constant <= 0 || constant + linear + square <= nothing) return true;
    const double lowest = square > 0 ? -linear / (2 * square) : 0;
    return lowest > 0 && lowest < 1 && constant + lowest * (linear + lowest * square) <= nothing;
}

}  // namespace

BaseMesh load_file_base(const BaseSource& source) {
    const std::string name = source.file.string();
    FileMesh read = read_mesh_file(source.file);
    if (read.triangles.empty() && read.triangles_without_uv > 0) {
        fail("mesh '{}' has no texture coordinates, which say where the relief lies on it: unwrap and export it again",
             name);
    }
    if (read.triangles.empty()) fail("mesh '{}' has no triangles: give one that has", name);
    check_vertices(name, read);
    const std::size_t thin = read.triangles_without_area + drop(read, has_area);
    if (read.triangles.empty()) fail("no triangle of mesh '{}' has an area: give one that has", name);
    const std::size_t flat_charts = drop(read, has_chart_area);
    if (read.triangles.empty()) {
        fail("no triangle of mesh '{}' has texture coordinates that span an area: unwrap and export it again", name);
    }
    drop_unused_vertices(read);

    BaseMesh mesh;
    mesh.name = source.file.filename().string();
    if (source.fit == BaseSource::Fit::unit) mesh.scale = fit_to_patch(read.vertices);
    // Fitting rounds: what is tiny beside the rest may have lost its area.
    const std::size_t lost = drop(read, has_area);
    if (read.triangles.empty()) fail("no triangle of mesh '{}' has an area: give one that has", name);
    drop_unused_vertices(read);
    for (const MeshVertex& vertex : read.vertices) {
        const glm::vec3 size = glm::abs(vertex.position);
        if (std::max({size.x, size.y, size.z}) > largest_coordinate) {
            fail("mesh '{}' reaches {} patch sides from the origin, and no more than {} are drawn: use base_fit=unit",
                 name, std::max({size.x, size.y, size.z}), largest_coordinate);
        }
    }
    const std::size_t without_normal = add_missing_normals(read);
    mesh.vertices = std::move(read.vertices);
    mesh.triangles = std::move(read.triangles);
    find_charts(mesh);
    const auto warn = [&](std::size_t count, std::string_view noun, std::string_view what) {
        if (count > 0) mesh.warnings.push_back(warning_of(count, noun, what));
    };
    warn(read.triangles_without_uv, "triangle", "without texture coordinates, left out");
    warn(thin + lost, "triangle", "of no area, left out");
    warn(flat_charts, "triangle", "whose texture coordinates span no area, left out");
    warn(read.bad_normals, "vertex normal", "of no length or not finite, replaced by the mean of the facets around");
    warn(without_normal, "vertex normal", "where facets around cancel out, replaced by that of one of them");
    warn(count_torn_sides(mesh), "side", "along which normals split: the relief is torn there");
    return mesh;
}

std::size_t count_folded_prisms(const BaseMesh& mesh, double height_scale) {
    std::size_t folded = 0;
    for (const BaseMesh::Triangle& corners : mesh.triangles) {
        const MeshVertex& first = mesh.vertices[corners[0]];
        const auto change = [&](std::size_t corner) {
            return std::pair(
                glm::dvec3(mesh.vertices[corners[corner]].position) - glm::dvec3(first.position),
                -height_scale * (glm::dvec3(mesh.vertices[corners[corner]].normal) - glm::dvec3(first.normal)));
        };
        const auto [a, da] = change(1);
        const auto [b, db] = change(2);
        for (const std::uint32_t corner : corners) {
            if (!turns_over(a, da, b, db, glm::dvec3(mesh.vertices[corner].normal))) continue;
            ++folded;
            break;
        }
    }
    return folded;
}

}  // namespace reliefbench
