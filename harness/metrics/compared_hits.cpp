#include "metrics/compared_hits.hpp"

#include "scene/shading_normal.hpp"
#include "scene/surface/charts.hpp"

#include <cassert>

namespace reliefbench {

namespace {

glm::dvec3 to_vector(const std::array<float, 3>& normal) {
    return {normal[0], normal[1], normal[2]};
}

}  // namespace

glm::dvec2 ComparedHits::chart_period(std::size_t pixel) const {
    if (!curved) return glm::dvec2(0);
    return reliefbench::chart_period(curved_base(relief.base), curved->entry_triangles.texels[pixel]);
}

ShadingNormals::ShadingNormals(const ComparedHits& hits) : hits_(hits) {
    assert(hits.curved.has_value() != is_flat(hits.relief.base));
    if (!hits.curved) derivatives_ = height_derivatives(hits.map);
}

glm::dvec3 ShadingNormals::of_technique(std::size_t pixel) const {
    if (hits_.curved) return to_vector(hits_.curved->technique_normals.texels[pixel]);
    const Hit& hit = hits_.technique.texels[pixel];
    return shading_normal(derivatives_, hits_.relief, hit.u, hit.v);
}

glm::dvec3 ShadingNormals::of_truth(std::size_t pixel) const {
    if (hits_.curved) return to_vector(hits_.curved->truth_normals.texels[pixel]);
    const Hit& hit = hits_.truth.texels[pixel];
    return shading_normal(derivatives_, hits_.relief, hit.u, hit.v);
}

}  // namespace reliefbench
