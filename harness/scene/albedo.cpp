#include "scene/albedo.hpp"

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "scene/colour.hpp"
#include "scene/image_file.hpp"
#include "scene/raster_limits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

namespace {

/// Linear RGB of the default albedo at height 0 and at height 1.
constexpr std::array<double, 3> dark_stone{0.09, 0.07, 0.06};
constexpr std::array<double, 3> light_stone{0.62, 0.57, 0.50};

float quantise_channel(double linear) {
    return quantise(std::clamp(linear, 0.0, 1.0), HeightFormat::r16);
}

void check_albedo_size(const std::string& name, Resolution size) {
    if (size.width > largest_side || size.height > largest_side) {
        fail("albedo '{}' of {}x{}: each side must have at most {} texels; scale it down", name, size.width,
             size.height, largest_side);
    }
}

/// R, G and B, or the one channel of grey.
using ColourChannels = std::vector<std::size_t>;

std::optional<ColourChannels> rgb_of_layer(const std::vector<std::string>& names, const std::string& layer) {
    ColourChannels channels;
    for (const char* colour : {"R", "G", "B"}) {
        const auto found = std::ranges::find(names, layer + colour);
        if (found == names.end()) return std::nullopt;
        channels.push_back(static_cast<std::size_t>(found - names.begin()));
    }
    return channels;
}

/// Alpha and what else there is is left out. A colour picture that is a layer among others is taken where it is the
/// only one.
ColourChannels colour_channels(const std::string& path, const std::vector<std::string>& names) {
    if (const auto plain = rgb_of_layer(names, "")) return *plain;
    std::vector<ColourChannels> layers;
    for (const std::string& name : names) {
        if (!name.ends_with(".R")) continue;
        if (const auto layer = rgb_of_layer(names, name.substr(0, name.size() - 1))) layers.push_back(*layer);
    }
    if (layers.size() == 1) return layers.front();
    const bool is_grey = names.size() == 1 || (names.size() == 2 && names[0] == "Y" && names[1] == "A");
    if (layers.empty() && is_grey) return {0};
    fail("albedo '{}' has the channels {}, which are not one colour picture; save it as a file of its own", path,
         join(names));
}

Albedo default_albedo(const HeightMap& map) {
    Albedo albedo;
    albedo.texels = Image<std::array<float, 4>>(map.heights.size);
    for (std::size_t index = 0; index < map.heights.texels.size(); ++index) {
        const double height = map.heights.texels[index];
        std::array<float, 4>& texel = albedo.texels.texels[index];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            texel[channel] = quantise_channel(std::lerp(dark_stone[channel], light_stone[channel], height));
        }
        texel[3] = 1;
    }
    return albedo;
}

}  // namespace

std::array<double, 3> Albedo::sample(double u, double v) const {
    const Resolution size = texels.size;
    const double x = u * size.width - 0.5;
    const double y = v * size.height - 0.5;
    const double left = std::floor(x);
    const double below = std::floor(y);
    const auto wrap = [](double index, int count) {
        return static_cast<int>(index - std::floor(index / count) * count) % count;
    };
    std::array<double, 3> colour{};
    for (int corner = 0; corner < 4; ++corner) {
        const int right = corner % 2;
        const int above = corner / 2;
        const double weight = (right ? x - left : 1 - (x - left)) * (above ? y - below : 1 - (y - below));
        const auto& texel = texels.at(wrap(left + right, size.width), wrap(below + above, size.height));
        for (std::size_t channel = 0; channel < 3; ++channel)
            colour[channel] += weight * texel[channel];
    }
    return colour;
}

Resolution albedo_size(const HeightMapSource& source, Resolution height_map) {
    if (source.albedo.empty()) return height_map;
    const RasterFile header = read_raster_header(source.albedo);
    check_albedo_size(source.albedo, header.size);
    colour_channels(source.albedo, header.channel_names);
    return header.size;
}

Albedo load_albedo(const HeightMapSource& source, const HeightMap& map) {
    if (source.albedo.empty()) return default_albedo(map);
    const ColourChannels channels = colour_channels(source.albedo, read_raster_header(source.albedo).channel_names);
    const RasterFile raster = read_raster_file(source.albedo, {.part = "", .channels = channels});
    const Resolution size = raster.size;
    check_albedo_size(source.albedo, size);
    Albedo albedo;
    albedo.texels = Image<std::array<float, 4>>(size);
    for (int y = 0; y < size.height; ++y) {
        const auto row = static_cast<std::size_t>(size.height - 1 - y) * size.width;
        for (int x = 0; x < size.width; ++x) {
            std::array<float, 4>& texel = albedo.texels.at(x, y);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const std::size_t stored = std::min(channel, channels.size() - 1);
                const double encoded = raster.fraction((row + x) * channels.size() + stored);
                if (!std::isfinite(encoded)) {
                    fail("albedo '{}' has the value {} in column {}, row {} from the bottom: repair the file",
                         source.albedo, encoded, x, y);
                }
                texel[channel] = quantise_channel(srgb_decode(encoded));
            }
            texel[3] = 1;
        }
    }
    return albedo;
}

}  // namespace reliefbench
