#include "scene/surface/base_surface.hpp"

#include "core/error.hpp"
#include "scene/surface/file_base.hpp"
#include "scene/surface/generated_base.hpp"
#include "scene/surface/mesh_view.hpp"

#include <cassert>

namespace reliefbench {

BaseSurface load_base(const BaseSource& source) {
    if (source.is_flat()) return {};
    if (const std::string problem = curvature_problem(source); !problem.empty()) fail("{}", problem);
    if (source.kind == BaseSource::Kind::file)
        return {MeshBase{std::make_shared<const BaseMesh>(load_file_base(source))}};
    return {MeshBase{std::make_shared<const BaseMesh>(generate_base(source))}};
}

BaseSurface triangulated(const BaseSurface& base) {
    static const auto unit_square = std::make_shared<const BaseMesh>(generate_base({.segments = 1}));
    return is_flat(base) ? BaseSurface{MeshBase{unit_square}} : base;
}

bool is_flat(const BaseSurface& base) {
    return std::holds_alternative<Plane>(base.kind);
}

Plane flat_base(const BaseSurface& base) {
    assert(is_flat(base));
    return std::get<Plane>(base.kind);
}

const BaseMesh& curved_base(const BaseSurface& base) {
    assert(!is_flat(base));
    return *std::get<MeshBase>(base.kind).mesh;
}

double nearest_depth(const BaseSurface& base, const Camera& camera, double height_scale, double cosine_of_corner) {
    return is_flat(base) ? nearest_depth(flat_base(base), camera, cosine_of_corner)
                         : nearest_depth(curved_base(base), camera, height_scale);
}

ParallelWindow parallel_window(const BaseSurface& base, const Camera& camera, double height_scale) {
    return is_flat(base) ? ParallelWindow{} : parallel_window(curved_base(base), camera, height_scale);
}

}  // namespace reliefbench
