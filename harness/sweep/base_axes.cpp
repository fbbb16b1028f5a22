#include "sweep/base_axes.hpp"

#include "sweep/axis_kinds.hpp"

namespace reliefbench {

namespace {

constexpr double largest_curvature = 1000;
constexpr NumberRange curvatures{.minimum = -largest_curvature, .maximum = largest_curvature};
constexpr IntegerRange segment_counts{.minimum = 1, .maximum = 2048};

bool is_generated(const ViewKey& key) {
    return key.base.is_generated();
}

}  // namespace

std::vector<ViewAxis> base_axes() {
    std::vector<ViewAxis> axes;
    axes.push_back(word_axis<BaseSource::Kind>(
        "base",
        {.help = "what the relief lies on (`list bases`)",
         .also_called = {"mesh", "model", "shape", "surface", "geometry", "object", "base_surface"}},
        {"plane", "cylinder", "sphere", "saddle"}, [](auto& key) -> auto& { return key.base.kind; }));
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
                                               .also_called = {"segments", "tessellation", "subdivision", "facets"}},
                                              segment_counts, [](auto& key) -> auto& { return key.base.segments; })));
    return axes;
}

}  // namespace reliefbench
