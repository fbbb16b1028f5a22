#pragma once

#include "manifest/manifest.hpp"
#include "reference/truth.hpp"
#include "technique/renderer.hpp"

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace reliefbench {

/// The name of a map that is 1 everywhere: no procedural one.
inline constexpr const char* map_of_ones = "ones";

/// What a technique is looked at under: a map, procedural or of ones, and a view of it.
struct Circumstance {
    std::string map;
    Resolution map_size;
    View view;
};

std::string describe(const Circumstance& circumstance);
/// "max_steps=64 leaf=exact": those that differ from the technique's defaults; "defaults" when none does.
std::string describe(const ParameterValues& parameters, const Manifest& manifest);

/// A height map with its texture, lit as nothing: the albedo's red and green are the texture coordinates of each texel,
/// so that a colour tells where it was fetched.
struct CoordinateScene {
    HeightMap map;
    Albedo albedo;
    SceneOnDevice on_device;

    CoordinateScene(const gpu::Device& device, HeightMap height_map);
};

/// No lighting; a background that no texture coordinate can be taken for.
Lighting coordinate_lighting();

/// Scenes by map, made once: heights in r16, the format that bounds are stated for.
class SceneCollection {
public:
    explicit SceneCollection(const gpu::Device& device) : device_(&device) {}
    const CoordinateScene& get(const std::string& map, Resolution size);

private:
    const gpu::Device* device_;
    std::map<std::tuple<std::string, int, int>, std::unique_ptr<CoordinateScene>> scenes_;
};

/// The direction of a pixel's ray in the tangent space of the base where it enters: what it travels in u, in v and
/// upwards over its length. The pixel must lie in F.
glm::dvec3 tangent_direction(const View& view, int i, int j);

/// Texels that the ray of a pixel in F travels from h = 1 to h = 0: H·tanθ·N·tiling.
double texels_through_relief(const View& view, const HeightMap& map, int i, int j);

/// The largest of texels_through_relief over the footprint.
double most_texels_through_relief(const View& view, const HeightMap& map, const Image<std::uint8_t>& footprint);

/// The circumstance, with a size that the technique's needs allow, no larger than this one's, and the map once on the
/// patch where that is needed: so that what a technique does not do leaves no check out.
Circumstance as_needed(const Manifest& manifest, Circumstance circumstance);

/// The manifest's defaults with those of `changed` in their place.
ParameterValues with_values(const Manifest& manifest, const ParameterValues& changed);

}  // namespace reliefbench
