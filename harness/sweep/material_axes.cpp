#include "sweep/material_axes.hpp"

#include "sweep/axis_kinds.hpp"

namespace reliefbench {

namespace {

constexpr IntegerRange anisotropies{.minimum = 1, .maximum = 16};
constexpr NumberRange mip_biases{.minimum = -16, .maximum = 16};

bool has_material_mips(const View& view) {
    return view.material.has_mips();
}

bool is_anisotropic(const View& view) {
    return view.material.kind == MaterialFilter::Kind::anisotropic;
}

}  // namespace

std::vector<ViewAxis> material_axes() {
    std::vector<ViewAxis> axes;
    axes.push_back(word_axis<MaterialFilter::Kind>(
        "material_filter",
        {.help = "how albedo and normals are read: at level 0, trilinear from mips, or anisotropic from them",
         .also_called = {"filter", "filtering", "mip", "mips", "mipmap", "mipmaps", "texture_filter", "trilinear"}},
        {"lod0", "mip", "anisotropic"}, [](auto& key) -> auto& { return key.view.material.kind; }));
    axes.push_back(
        only_where(is_anisotropic, number_axis(
                                       "anisotropy",
                                       {.unit = "",
                                        .help = "how often a pixel's footprint is longer than wide at most; "
                                                "material_filter=anisotropic only",
                                        .also_called = {"max_anisotropy", "aniso", "anisotropic", "af"}},
                                       anisotropies, [](auto& key) -> auto& { return key.view.material.anisotropy; })));
    axes.push_back(only_where(
        has_material_mips,
        number_axis(
            "mip_bias",
            {.unit = "levels",
             .help = "added to the level of the material's mips; below 0 sharper; not with material_filter=lod0",
             .also_called = {"bias", "lod_bias", "mip_lod_bias", "texture_bias"}},
            mip_biases, [](auto& key) -> auto& { return key.view.material.mip_bias; })));
    axes.push_back(only_where(
        has_material_mips,
        word_axis<MaterialFilter::Gradients>(
            "material_gradients",
            {.help = "what chooses the level: gradients at the entry, of neighbouring answers, or over the relief's "
                     "tangent plane; not with material_filter=lod0",
             .also_called = {"gradients", "gradient", "derivatives", "texture_gradients"}},
            {"before_search", "from_result", "analytic"},
            [](auto& key) -> auto& { return key.view.material.gradients; })));
    return axes;
}

void reset_unused(MaterialFilter& material) {
    if (!material.has_mips()) material = MaterialFilter{};
    if (material.kind != MaterialFilter::Kind::anisotropic) material.anisotropy = MaterialFilter{}.anisotropy;
}

}  // namespace reliefbench
