#pragma once

#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/image.hpp"
#include "scene/relief.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace reliefbench {

/// What is known of hits beside (u, v) where the base is not flat: they do not name a point of it. Images of the hits'
/// size, which must outlive it.
struct CurvedHits {
    /// Shading normals in world space, unit vectors where there is a hit.
    const Image<std::array<float, 3>>& technique_normals;
    const Image<std::array<float, 3>>& truth_normals;
    /// Of the base's triangles: by which the pixel's ray enters; beyond the last one outside F.
    const Image<std::uint32_t>& entry_triangles;
    /// Not 0 where the truth hits on another chart than the one that its ray entered by.
    const Image<std::uint8_t>& off_chart;
};

/// A technique's hits, and the truth's of the same view. Images of equal size; all must outlive it.
struct ComparedHits {
    const HitImage& technique;
    const HitImage& truth;
    const FootprintImage& footprint;
    const HeightMap& map;
    const Relief& relief;
    /// Empty where the base is flat.
    std::optional<CurvedHits> curved = {};

    /// Whether the truth hits on another chart than the one that the pixel's ray entered by, so that coordinates do not
    /// tell how far apart hits are.
    bool is_off_chart(std::size_t pixel) const { return curved && curved->off_chart.texels[pixel] != 0; }
    /// After how much of u, and of v, the chart that the pixel's ray entered by meets itself again; 0 where it does
    /// not.
    glm::dvec2 chart_period(std::size_t pixel) const;
    /// Whether nothing is right or wrong outside F: over a plane with Boundary::repeat, whose relief goes on past it for
    /// ever and whose truth ends with it. A base of triangles ends by itself.
    bool ends_with_footprint() const { return relief.boundary == Boundary::repeat && !curved; }
};

/// The shading normals in world space of both, by pixel; where a pixel has a hit.
class ShadingNormals {
public:
    explicit ShadingNormals(const ComparedHits& hits);

    glm::dvec3 of_technique(std::size_t pixel) const;
    glm::dvec3 of_truth(std::size_t pixel) const;

private:
    const ComparedHits& hits_;
    /// Of a flat base, where (u, v) have the normal with them.
    Image<std::array<float, 2>> derivatives_;
};

}  // namespace reliefbench
