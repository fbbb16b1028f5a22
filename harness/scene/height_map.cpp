#include "scene/height_map.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/log.hpp"
#include "core/suggest.hpp"
#include "scene/image_file.hpp"
#include "scene/procedural.hpp"
#include "scene/raster_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>

namespace reliefbench {

namespace {

std::int64_t wrap(std::int64_t index, std::int64_t count) {
    const std::int64_t remainder = index % count;
    return remainder < 0 ? remainder + count : remainder;
}

void check_size(const std::string& name, Resolution size) {
    if (size.width < 1 || size.height < 1 || size.width > largest_side || size.height > largest_side) {
        fail("height map '{}' of {}x{}: each side must have 1 to {} texels", name, size.width, size.height,
             largest_side);
    }
}

bool is_procedural(const std::string& name) {
    const auto& maps = procedural_maps();
    return std::any_of(maps.begin(), maps.end(), [&](const ProceduralMap& map) { return map.name == name; });
}

[[noreturn]] void fail_unknown(const std::string& name) {
    std::vector<std::string> known;
    for (const ProceduralMap& map : procedural_maps())
        known.push_back(map.name);
    fail("height map '{}': no such file, and no procedural map of that name{}; the procedural maps are {}", name,
         did_you_mean(name, known), join(known));
}

/// One channel, bottom row first.
Image<float> heights_of_channel(const RasterFile& raster, int channel) {
    Image<float> heights(raster.size);
    const auto channels = static_cast<std::size_t>(raster.channels());
    for (int y = 0; y < raster.size.height; ++y) {
        const auto row = static_cast<std::size_t>(raster.size.height - 1 - y) * raster.size.width;
        for (int x = 0; x < raster.size.width; ++x) {
            heights.at(x, y) = raster.values[(row + x) * channels + channel];
        }
    }
    return heights;
}

/// How stored values become heights: (value − low) / (high − low), clamped when asked.
struct ValueMapping {
    double low = 0;
    double high = 1;
    bool clamped = false;
};

void check_options(const HeightMapSource& source) {
    if (source.normalize && source.height_range) {
        fail("height map '{}': normalize and height_range exclude each other; give one", source.name);
    }
    if (source.height_range) {
        const auto [low, high] = *source.height_range;
        if (!std::isfinite(low) || !std::isfinite(high) || low >= high) {
            fail("height map '{}': height_range [{}, {}] must be two finite numbers, the first less than the second{}",
                 source.name, low, high, low > high ? " (invert turns heights over)" : "");
        }
    }
}

void check_values(const std::string& name, const Image<float>& values) {
    for (std::size_t index = 0; index < values.texels.size(); ++index) {
        if (!std::isfinite(values.texels[index])) {
            const int width = values.size.width;
            fail(
                "height map '{}' has the value {} in column {}, row {} from the bottom: heights must be finite; "
                "repair the file",
                name, values.texels[index], index % width, index / width);
        }
    }
}

void check_heights(const std::string& name, float smallest, float largest) {
    if (smallest < 0 || largest > 1) {
        fail("height map '{}' has values from {} to {}: heights must lie in [0, 1]; give height_range or normalize",
             name, smallest, largest);
    }
}

HeightMap finish(Image<float> heights, HeightFormat format, std::string name, std::string mapping) {
    HeightMap map;
    for (float& height : heights.texels)
        height = quantise(height, format);
    const auto [smallest, largest] = std::minmax_element(heights.texels.begin(), heights.texels.end());
    map.constant = *smallest == *largest;
    const std::string content = content_hash(std::as_bytes(std::span(heights.texels)));
    map.hash =
        content_hash(fmt::format("{}x{} {} {}", heights.size.width, heights.size.height, to_string(format), content));
    map.heights = std::move(heights);
    map.format = format;
    map.name = std::move(name);
    map.mapping = std::move(mapping);
    return map;
}

HeightMap load_image(const HeightMapSource& source, HeightFormat format) {
    const RasterFile raster = read_raster_file(source.name);
    check_size(source.name, raster.size);
    if (source.channel < 0 || source.channel >= raster.channels()) {
        fail("height map '{}' has no channel {}: it has {} ({}), counted from 0", source.name, source.channel,
             raster.channels(), join(raster.channel_names));
    }
    Image<float> values = heights_of_channel(raster, source.channel);
    check_values(source.name, values);

    const auto [smallest, largest] = std::minmax_element(values.texels.begin(), values.texels.end());
    ValueMapping mapping;
    if (source.normalize) mapping = {*smallest, *largest, false};
    if (source.height_range) mapping = {(*source.height_range)[0], (*source.height_range)[1], true};
    const bool mapped = source.normalize || source.height_range.has_value();
    if (!mapped) check_heights(source.name, *smallest, *largest);

    // A constant map has no extent to stretch: its smallest value goes to 0.
    const double extent = mapping.high > mapping.low ? mapping.high - mapping.low : 1.0;
    for (float& value : values.texels) {
        double height = mapped ? (value - mapping.low) / extent : value;
        if (mapping.clamped) height = std::clamp(height, 0.0, 1.0);
        value = static_cast<float>(source.invert ? 1.0 - height : height);
    }

    std::vector<std::string> steps;
    if (raster.channels() > 1) steps.push_back("channel " + raster.channel_names[source.channel]);
    if (mapped) steps.push_back(fmt::format("[{}, {}] → [0, 1]", mapping.low, mapping.high));
    if (source.invert) steps.push_back("inverted");
    if (steps.empty()) steps.push_back("as stored");
    return finish(std::move(values), format, std::filesystem::path(source.name).filename().string(), join(steps));
}

HeightMap generate(const HeightMapSource& source, HeightFormat format) {
    check_size(source.name, source.size);
    if (source.channel != 0 || source.invert || source.normalize || source.height_range) {
        fail(
            "height map '{}' is procedural: channel, invert, normalize and height_range are for image files; "
            "leave them out",
            source.name);
    }
    return finish(generate_height_map(source.name, source.size, source.seed), format, source.name, "as generated");
}

}  // namespace

std::string to_string(HeightFormat format) {
    switch (format) {
        case HeightFormat::r8:
            return "r8";
        case HeightFormat::r16:
            return "r16";
        case HeightFormat::r32f:
            return "r32f";
    }
    assert(false);
    return {};
}

std::optional<HeightFormat> parse_height_format(const std::string& name) {
    for (const HeightFormat format : {HeightFormat::r8, HeightFormat::r16, HeightFormat::r32f}) {
        if (name == to_string(format)) return format;
    }
    return std::nullopt;
}

float quantise(double height, HeightFormat format) {
    assert(height >= 0 && height <= 1);
    if (format == HeightFormat::r32f) return static_cast<float>(height);
    const double largest = format == HeightFormat::r8 ? 255.0 : 65535.0;
    return static_cast<float>(std::round(height * largest) / largest);
}

float HeightMap::texel(std::int64_t x, std::int64_t y) const {
    return heights.at(static_cast<int>(wrap(x, width())), static_cast<int>(wrap(y, height())));
}

double HeightMap::sample(double u, double v) const {
    const double x = u * width() - 0.5;
    const double y = v * height() - 0.5;
    const auto left = static_cast<std::int64_t>(std::floor(x));
    const auto below = static_cast<std::int64_t>(std::floor(y));
    const double right_weight = x - static_cast<double>(left);
    const double above_weight = y - static_cast<double>(below);
    const auto row = [&](std::int64_t j) {
        return (1 - right_weight) * texel(left, j) + right_weight * texel(left + 1, j);
    };
    return (1 - above_weight) * row(below) + above_weight * row(below + 1);
}

HeightMap load_height_map(const HeightMapSource& source, HeightFormat format) {
    check_options(source);
    std::error_code ignored;
    HeightMap map;
    if (is_procedural(source.name)) {
        map = generate(source, format);
    } else if (std::filesystem::exists(source.name, ignored)) {
        map = load_image(source, format);
    } else {
        fail_unknown(source.name);
    }
    if (map.constant) {
        log_warning("height map '{}' is constant: all heights are {}", source.name, map.heights.texels.front());
    }
    return map;
}

Resolution height_map_size(const HeightMapSource& source) {
    const Resolution size = is_procedural(source.name) ? source.size : read_raster_header(source.name).size;
    check_size(source.name, size);
    return size;
}

HeightMap make_height_map(const Image<float>& heights, HeightFormat format, std::string name) {
    check_size(name, heights.size);
    assert(heights.texels.size() == heights.size.pixels());
    check_values(name, heights);
    const auto [smallest, largest] = std::minmax_element(heights.texels.begin(), heights.texels.end());
    check_heights(name, *smallest, *largest);
    return finish(heights, format, std::move(name), "as given");
}

Image<std::array<float, 2>> height_derivatives(const HeightMap& map) {
    Image<std::array<float, 2>> derivatives(map.heights.size);
    const double across = map.width() / 2.0;
    const double up = map.height() / 2.0;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const double du = (double(map.texel(x + 1, y)) - map.texel(x - 1, y)) * across;
            const double dv = (double(map.texel(x, y + 1)) - map.texel(x, y - 1)) * up;
            derivatives.at(x, y) = {static_cast<float>(du), static_cast<float>(dv)};
        }
    }
    return derivatives;
}

}  // namespace reliefbench
