#include "manifest/shape.hpp"

#include "manifest/manifest.hpp"
#include "manifest/parse_names.hpp"

#include <algorithm>
#include <cassert>
#include <set>

namespace reliefbench {

namespace {

void parse_patches(const JsonView& patches, const Manifest& manifest, Shape& shape) {
    patches.require_only({"parameter", "texels_per_patch", "triangles"});
    shape.patches_parameter = parse_integer_name(patches.at("parameter"), manifest);
    if (manifest.find_parameter(shape.patches_parameter)->minimum < 0) {
        patches.at("parameter").fail_here("the number of patches must not be negative; let its range begin at 0 or 1");
    }
    if (patches.has("texels_per_patch")) {
        constexpr int largest_map = 16384;
        shape.texels_per_patch = static_cast<int>(patches.at("texels_per_patch").integer(1, largest_map));
    }
    if (patches.has("triangles")) shape.triangles_with = parse_values(patches.at("triangles"), manifest);
}

std::string forms() {
    std::string text;
    for (const ShapeKind& kind : shape_kinds())
        text += (text.empty() ? "" : " or ") + kind.form;
    return text;
}

}  // namespace

const std::vector<ShapeKind>& shape_kinds() {
    static const std::vector<ShapeKind> kinds{
        // The quad of the patch; the technique is one function.
        {.word = "quad",
         .form = R"("quad")",
         .stage_files = {"quad.vert", "quad.frag"},
         .traces = true,
         .draws_base = true,
         .own_files = {"trace.glsl"},
         .features = {},
         .parameter_set = "quad.json"},
        // A grid of patches through the technique's own tessellation stages.
        {.word = "patches",
         .form = R"({"patches": {"parameter": ...}})",
         .stage_files = {"patches.vert", "control.tesc", "evaluation.tese", "patches.frag"},
         .own_files = {"control.tesc", "evaluation.tese"},
         .features = {"tessellationShader"},
         .parameter_set = {},
         .parse_settings = parse_patches},
        // The tetrahedra between the base and its floor; the technique is one function, of a piece of a ray in each.
        {.word = "shell",
         .form = R"("shell")",
         .stage_files = {"shell.vert", "shell.frag"},
         .own_files = {"trace.glsl"},
         .features = {},
         .parameter_set = {}},
    };
    return kinds;
}

const ShapeKind& shape_kind(const std::string& word) {
    const auto found = std::ranges::find(shape_kinds(), word, &ShapeKind::word);
    assert(found != shape_kinds().end());
    return *found;
}

const std::vector<std::string>& stage_files(const std::string& kind) {
    return shape_kind(kind).stage_files;
}

int Shape::patch_corners(const ParameterValues& values) const {
    const bool triangles = !triangles_with.empty() && std::ranges::all_of(triangles_with, [&](const auto& named) {
        return values.at(named.first) == named.second;
    });
    return triangles ? 3 : 4;
}

Shape parse_shape(const JsonView& view, const Manifest& manifest) {
    const bool has_settings = view.json().is_object();
    if (has_settings) {
        std::vector<std::string> words;
        for (const ShapeKind& kind : shape_kinds()) {
            if (kind.parse_settings) words.push_back(kind.word);
        }
        view.require_only(words);
    }
    for (const ShapeKind& kind : shape_kinds()) {
        const bool is_meant = has_settings ? view.has(kind.word) : view.json() == Json(kind.word);
        if (!is_meant || has_settings != (kind.parse_settings != nullptr)) continue;
        Shape shape;
        shape.kind = kind.word;
        if (has_settings) kind.parse_settings(view.at(kind.word), manifest, shape);
        return shape;
    }
    view.fail_expected(forms());
}

}  // namespace reliefbench
