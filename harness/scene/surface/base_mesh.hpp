#pragma once

#include "scene/surface/base_entry.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace reliefbench {

/// In place of a triangle of a mesh where there is none.
inline constexpr std::uint32_t no_triangle = 0xffffffff;

/// A vertex of a base surface. In single precision, which the device has: what the truth stands on is the same mesh.
struct MeshVertex {
    glm::vec3 position;
    /// Unit vector.
    glm::vec3 normal;
    /// Patch coordinates: texture coordinates are `tiling` times these.
    glm::vec2 uv;

    bool operator==(const MeshVertex&) const = default;
};

/// A base surface of triangles. On each of them P is linear in (u, v), and N the normalised linear normal; the relief
/// is S = P + (h − 1)·H·N. Counterclockwise as seen from the side that is seen, whatever way (u, v) turn. Each spans an
/// area, in space as in (u, v).
struct BaseMesh {
    using Triangle = std::array<std::uint32_t, 3>;

    /// For messages: "cylinder", or the file's name.
    std::string name;
    std::vector<MeshVertex> vertices;
    std::vector<Triangle> triangles;
    /// By triangle: where (u, v) go on from one to the next they are of one chart (charts.hpp).
    std::vector<std::uint32_t> charts;
    /// By chart: after how much of u, and of v, it meets itself again along a seam; 0 where it does not. A closed
    /// cylinder whose u run once round it has 1 and 0.
    std::vector<glm::vec2> chart_periods;
    /// What the file's positions were multiplied by (BaseSource::Fit).
    double scale = 1;
    /// What of the file is not drawn as it stands there, as sentences without the file's name.
    std::vector<std::string> warnings;
    /// Whether the one chart covers the unit square and nothing else, as those of generated ones do.
    bool is_unit_square = false;
};

/// One triangle in double precision, whose (u, v) span an area.
struct BaseTriangle {
    /// P(u, v) = origin + u·along_u + v·along_v.
    glm::dvec3 origin;
    glm::dvec3 along_u;
    glm::dvec3 along_v;
    /// The linear normal, not normalised: normal_origin + u·normal_along_u + v·normal_along_v.
    glm::dvec3 normal_origin;
    glm::dvec3 normal_along_u;
    glm::dvec3 normal_along_v;
    /// Unit normal of the facet.
    glm::dvec3 facet_normal;

    glm::dvec3 point(glm::dvec2 uv) const { return origin + uv.x * along_u + uv.y * along_v; }
    glm::dvec3 linear_normal(glm::dvec2 uv) const {
        return normal_origin + uv.x * normal_along_u + uv.y * normal_along_v;
    }
};

BaseTriangle base_triangle(const BaseMesh& mesh, std::size_t triangle);

/// The area that a triangle's (u, v) span, signed: negative where the chart is mirrored.
double chart_area(const BaseMesh& mesh, std::size_t triangle);

/// ∂P/∂u, ∂P/∂v and N at a point of the triangle.
TangentFrame tangent_frame(const BaseTriangle& triangle, glm::dvec2 uv);

/// How N, which has unit length, changes with u (first) and with v.
std::array<glm::dvec3, 2> normal_derivatives(const BaseTriangle& triangle, glm::dvec2 uv);

/// The unit normal ∂S/∂u × ∂S/∂v on the side that is seen, where the relief lies `above` (≤ 0) along N and that offset
/// changes by `slope` with u and v.
glm::dvec3 relief_normal(const BaseTriangle& triangle, glm::dvec2 uv, double above, glm::dvec2 slope);

}  // namespace reliefbench
