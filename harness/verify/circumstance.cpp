#include "verify/circumstance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace reliefbench {

namespace {

Albedo coordinates_as_albedo(Resolution size) {
    Albedo albedo{Image<std::array<float, 4>>(size), Albedo::Format::float32};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            albedo.texels.at(x, y) = {(static_cast<float>(x) + 0.5F) / static_cast<float>(size.width),
                                      (static_cast<float>(y) + 0.5F) / static_cast<float>(size.height), 0, 1};
        }
    }
    return albedo;
}

HeightMap make_map(const std::string& name, Resolution size) {
    if (name == map_of_ones) return make_height_map(Image<float>(size, 1.0F), HeightFormat::r16, name);
    HeightMapSource source;
    source.name = name;
    source.size = size;
    return load_height_map(source, HeightFormat::r16);
}

}  // namespace

std::string describe(const Circumstance& circumstance) {
    const View& view = circumstance.view;
    std::string text = fmt::format("{} {}×{}, {} {}°, azimuth {}°, H {}", circumstance.map, circumstance.map_size.width,
                                   circumstance.map_size.height, to_string(view.camera.projection),
                                   view.camera.view_angle, view.camera.azimuth, view.relief.height_scale);
    if (view.relief.tiling != 1) text += fmt::format(", tiling {}", view.relief.tiling);
    if (view.relief.boundary == Boundary::repeat) text += ", repeated";
    return text;
}

std::string describe(const ParameterValues& parameters, const Manifest& manifest) {
    const ParameterValues defaults = manifest.defaults();
    std::string text;
    for (const auto& [name, value] : parameters) {
        if (defaults.at(name) == value) continue;
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, to_string(value));
    }
    return text.empty() ? "defaults" : text;
}

CoordinateScene::CoordinateScene(const gpu::Device& device, HeightMap height_map)
    : map(std::move(height_map)), albedo(coordinates_as_albedo(map.heights.size)), on_device(device, map, albedo) {}

Lighting coordinate_lighting() {
    Lighting lighting;
    lighting.enabled = false;
    lighting.background = {-1, -1, -1};
    return lighting;
}

const CoordinateScene& SceneCollection::get(const std::string& map, Resolution size) {
    auto& scene = scenes_[{map, size.width, size.height}];
    if (!scene) scene = std::make_unique<CoordinateScene>(*device_, make_map(map, size));
    return *scene;
}

glm::dvec3 tangent_direction(const View& view, int i, int j) {
    const Ray ray = pixel_ray(view, i, j);
    const std::optional<BaseEntry> entry = find_entry(flat_base(view.relief.base), ray);
    assert(entry);
    return entry->frame.from_world(ray.direction);
}

double texels_through_relief(const View& view, const HeightMap& map, int i, int j) {
    const glm::dvec3 direction = tangent_direction(view, i, j);
    return view.relief.height_scale * view.relief.tiling *
           std::hypot(direction.x * map.width(), direction.y * map.height()) / std::abs(direction.z);
}

double most_texels_through_relief(const View& view, const HeightMap& map, const Image<std::uint8_t>& footprint) {
    double most = 0;
    for (int j = 0; j < view.resolution.height; ++j) {
        for (int i = 0; i < view.resolution.width; ++i) {
            if (footprint.at(i, j) != 0) most = std::max(most, texels_through_relief(view, map, i, j));
        }
    }
    return most;
}

Circumstance as_needed(const Manifest& manifest, Circumstance circumstance) {
    auto& [width, height] = circumstance.map_size;
    for (const MapNeed need : manifest.map_needs) {
        switch (need) {
            case MapNeed::square:
                width = height = std::min(width, height);
                break;
            case MapNeed::power_of_two:
                width = static_cast<int>(std::bit_floor(static_cast<unsigned>(width)));
                height = static_cast<int>(std::bit_floor(static_cast<unsigned>(height)));
                break;
            case MapNeed::untiled:
                circumstance.view.relief.tiling = 1;
                circumstance.view.relief.boundary = Boundary::clip;
                break;
        }
    }
    return circumstance;
}

ParameterValues with_values(const Manifest& manifest, const ParameterValues& changed) {
    ParameterValues values = manifest.defaults();
    for (const auto& [name, value] : changed)
        values.at(name) = value;
    return values;
}

}  // namespace reliefbench
