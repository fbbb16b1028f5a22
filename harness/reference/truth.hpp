#pragma once

#include "reference/light_visibility.hpp"
#include "scene/albedo.hpp"
#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/lighting.hpp"
#include "scene/relief.hpp"
#include "scene/scene_object.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace reliefbench {

/// What the truth of a view knows beside where its base is not flat, by pixel.
struct CurvedTruth {
    /// Of the shaded relief in world space, unit vectors; zeros where there is no hit.
    Image<std::array<float, 3>> normals;
    /// The triangle of the base (BaseMesh::triangles) through which the pixel's ray enters; no_triangle outside F.
    Image<std::uint32_t> entry_triangles;
    /// 1 where the hit is on another chart of the base than the entry, else 0.
    Image<std::uint8_t> off_chart;
};

/// The ground truth of one view.
struct Truth {
    /// Row 0 is the top.
    HitImage hits;
    /// F: the ray meets the base from the side that is seen (on the plane: crosses z = 0 inside the unit square). Ties
    /// (ties.hpp) are marked.
    FootprintImage footprint;
    /// Linear RGB, shaded truth; the background colour where there is no hit. The mean of `samples` rays a pixel; all
    /// else is of the ray through its centre.
    Image<std::array<float, 3>> colour;
    int samples = 1;
    /// Of `colour`, linear, by pixel: the root mean square over the channels, whose square is right in the mean. It
    /// comes from what two independent scramblings differ by. Empty with one sample.
    std::optional<Image<float>> standard_error;
    /// The mean over the first scrambling alone. It differs from `colour` by as much as that does from what
    /// infinitely many samples would give. Empty with one sample.
    std::optional<Image<std::array<float, 3>>> half_picture;
    /// Linear RGB.
    std::array<float, 3> background{};
    LightVisibility light_visibility;
    /// What is in front; `hits` are the relief's, whatever covers them. Empty without an object.
    std::optional<Image<Front>> front;
    /// Empty where the base is flat.
    std::optional<CurvedTruth> curved;
    /// Wall time of tracing and shading.
    double trace_ms = 0;
};

constexpr int max_truth_samples = 1024;

/// What a truth's picture shows beside the relief, and how well.
struct TruthPicture {
    /// From 1, a ray through the pixel's centre, to max_truth_samples.
    int samples = 1;
    /// In front of the relief where it is (show_object); null: none. Must outlive the call.
    const SceneObject* object = nullptr;
};

/// Boundary::clip traces every pixel (the relief can be seen outside F); Boundary::repeat those in F. Over a base of
/// triangles the mesh is diced (DicedMesh), and both throw Error in the portable build.
Truth trace_exact_truth(const HeightMap& map, const Albedo& albedo, const View& view, const Lighting& lighting,
                        const TruthPicture& picture = {});
Truth trace_mesh_truth(const HeightMap& map, const Albedo& albedo, const View& view, const Lighting& lighting,
                       int subdivision, const TruthPicture& picture = {});

/// Marks where the object is in front of the relief, and puts it into a picture of one sample. It neither casts nor
/// receives shadows.
void show_object(Truth& truth, const SceneObject& object, const View& view, const Lighting& lighting);

/// Linear RGB of a hit image over the plane, shaded as the truth is; `visibility` of each light at each hit.
Image<std::array<float, 3>> shade_hits(const HitImage& hits, const Image<std::array<float, 3>>& visibility,
                                       const HeightMap& map, const Albedo& albedo, const View& view,
                                       const Lighting& lighting);
/// The same over any base, with the shading normals at the hits.
Image<std::array<float, 3>> shade_hits(const HitImage& hits, const Image<std::array<float, 3>>& visibility,
                                       const Image<std::array<float, 3>>& normals, const Albedo& albedo,
                                       const View& view, const Lighting& lighting);
/// The first without shadows.
Image<std::array<float, 3>> shade_hits(const HitImage& hits, const HeightMap& map, const Albedo& albedo,
                                       const View& view, const Lighting& lighting);

/// Shading normals of hits over a base of triangles, each hit's (u, v) taken to lie on the triangle given for its pixel
/// (on its plane, where they lie beside it); zeros where there is no hit or no_triangle is given.
Image<std::array<float, 3>> normals_over(const HitImage& hits, const Image<std::uint32_t>& triangles,
                                         const HeightMap& map, const Relief& relief);

}  // namespace reliefbench
