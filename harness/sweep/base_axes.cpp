#include "sweep/base_axes.hpp"

#include "sweep/axis_kinds.hpp"
#include "sweep/base_value.hpp"

namespace reliefbench {

namespace {

constexpr double largest_curvature = 1000;
constexpr NumberRange curvatures{.minimum = -largest_curvature, .maximum = largest_curvature};
constexpr IntegerRange segment_counts{.minimum = 1, .maximum = 2048};

bool is_generated(const ViewKey& key) {
    return key.base.is_generated();
}

bool is_from_file(const ViewKey& key) {
    return key.base.kind == BaseSource::Kind::file;
}

ViewAxis base_axis() {
    return {"base",
            {.unit = "",
             .values = join(base_words(), "|") + ", a mesh file or an object",
             .help = "what the relief lies on (`list bases`)",
             .also_called = {"mesh", "model", "shape", "surface", "geometry", "object", "base_surface"}},
            [](const JsonView& json) -> ViewSetting {
                return [value = read_base_value(json)](ViewKey& view) {
                    view.base.kind = value.kind;
                    view.base.file = value.file;
                };
            },
            [](const ViewKey& view) { return Json(base_label(view.base)); },
            Json(base_label(plain_view().base))};
}

}  // namespace

std::vector<ViewAxis> base_axes() {
    std::vector<ViewAxis> axes;
    axes.push_back(base_axis());
    axes.push_back(only_for(is_generated, number_axis(
                                              "curvature",
                                              {.unit = "1/patch side",
                                               .help = "of cylinder, sphere and saddle: positive bends away from the "
                                                       "viewer, negative towards",
                                               .also_called = {"kappa", "bend", "radius", "curve"}},
                                              curvatures, [](auto& key) -> auto& { return key.base.curvature; })));
    axes.push_back(only_for(is_generated, number_axis(
                                              "base_segments",
                                              {.unit = "",
                                               .help = "of cylinder, sphere and saddle along each side, each of two "
                                                       "triangles",
                                               .also_called = {"segments", "subdivision", "facets"}},
                                              segment_counts, [](auto& key) -> auto& { return key.base.segments; })));
    axes.push_back(
        only_for(is_from_file, word_axis<BaseSource::Fit>(
                                   "base_fit",
                                   {.help = "of a mesh file: scaled and centred to the patch's size, or left as it is",
                                    .also_called = {"fit", "mesh_scale", "normalize_mesh", "placement"}},
                                   {"unit", "none"}, [](auto& key) -> auto& { return key.base.fit; })));
    return axes;
}

}  // namespace reliefbench
