#pragma once

#include "core/json.hpp"
#include "manifest/parameter.hpp"

#include <string>
#include <vector>

namespace reliefbench {

struct Manifest;

/// How the technique draws.
struct Shape {
    /// The word of its ShapeKind.
    std::string kind = "quad";
    /// Grids of patches only: the integer parameter that says how many patches a side has; at 0 there is one patch for
    /// each `texels_per_patch` texels.
    std::string patches_parameter;
    int texels_per_patch = 64;
    /// Grids of patches only: with these parameter values each quad of the grid is two triangles; empty: never.
    ParameterValues triangles_with;

    /// Of a patch: 4 or 3. Grids of patches only.
    int patch_corners(const ParameterValues& values) const;
};

/// A way to draw as technique.json knows it. What draws it is technique/pipeline.
struct ShapeKind {
    std::string word;
    /// How "shape" says it, for messages.
    std::string form;
    /// The files that a draw is compiled from, in the pipeline's order: of the shared shaders, and the technique's own
    /// stages. The shared ones include what else there is (quad.frag the technique's trace.glsl).
    std::vector<std::string> stage_files;
    /// Whether the technique is a search along rays, trace(), which the rays of lights can take, too.
    bool traces = false;
    /// Whether its fragments are those of the base surface, no more and no fewer.
    bool draws_base = false;
    /// Files that the technique's folder must hold.
    std::vector<std::string> own_files;
    /// Of the device, implied by the shape.
    std::vector<std::string> features;
    /// The set of parameters (included_sets.hpp) that belongs to every technique of the shape; may be empty.
    std::string parameter_set;
    /// Reads {"<word>": settings} into a shape, with the parameters of a manifest that has them; null where "shape" is
    /// the word alone.
    void (*parse_settings)(const JsonView& settings, const Manifest& manifest, Shape& shape) = nullptr;
};

/// Every one there is.
const std::vector<ShapeKind>& shape_kinds();

/// Of a shape that has been parsed.
const ShapeKind& shape_kind(const std::string& word);

/// Its stage_files.
const std::vector<std::string>& stage_files(const std::string& kind);

/// "shape" of technique.json.
Shape parse_shape(const JsonView& view, const Manifest& manifest);

}  // namespace reliefbench
