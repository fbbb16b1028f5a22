#pragma once

#include "reference/truth.hpp"

namespace reliefbench {

/// The truth over a base of triangles, by CurvedTracer. Throws Error in the portable build, and where there is not the
/// memory. A warning tells of rays that it could not follow to the end.
Truth trace_curved_truth(const HeightMap& map, const Albedo& albedo, const View& view, const Lighting& lighting,
                         const TruthPicture& picture);

/// Its hits by DicedMesh; ties and lights by CurvedTracer all the same.
Truth trace_diced_truth(const HeightMap& map, const Albedo& albedo, const View& view, const Lighting& lighting,
                        int subdivision, const TruthPicture& picture);

}  // namespace reliefbench
