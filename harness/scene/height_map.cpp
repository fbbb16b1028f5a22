#include "scene/height_map.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/log.hpp"
#include "core/suggest.hpp"
#include "scene/procedural.hpp"
#include "scene/raster_limits.hpp"
#include "scene/stored_heights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
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

/// How stored values become heights: (value − low) / (high − low), clamped.
/// A file that uses less of its full scale is likely to be meant otherwise: a terrain in metres, say.
constexpr double least_used_scale = 1.0 / 16;

struct ValueMapping {
    double low = 0;
    double high = 1;
    /// The source asks for it; else it is the file's full scale, beyond which there may be no values.
    bool is_given = false;
};

void check_options(const HeightMapSource& source) {
    if (source.normalize && source.height_range) {
        fail("height map '{}': normalize and height_range exclude each other; give one", source.name);
    }
    if (source.packing != Packing::none && !source.channel.empty()) {
        fail("height map '{}': packing and channel exclude each other; give one", source.name);
    }
    if (source.raw && (source.packing != Packing::none || !source.channel.empty() || !source.part.empty())) {
        fail("height map '{}' has numbers without a header: part, channel and packing are for images", source.name);
    }
    if (source.height_range) {
        const auto [low, high] = *source.height_range;
        if (!std::isfinite(low) || !std::isfinite(high) || low >= high) {
            fail("height map '{}': height_range [{}, {}] must be two finite numbers, the first less than the second{}",
                 source.name, low, high, low > high ? " (invert turns heights over)" : "");
        }
    }
}

/// "column 3, row 4 from the bottom".
std::string texel_text(std::size_t index, int width) {
    const auto columns = static_cast<std::size_t>(width);
    return fmt::format("column {}, row {} from the bottom", index % columns, index / columns);
}

void check_values(const std::string& name, const Image<float>& values) {
    for (std::size_t index = 0; index < values.texels.size(); ++index) {
        if (!std::isfinite(values.texels[index])) {
            fail("height map '{}' has the value {} in {}: heights must be finite; repair the file", name,
                 values.texels[index], texel_text(index, values.size.width));
        }
    }
}

/// How a command line says how a file is read; `member` is JSON.
std::string option_with(const std::string& file, std::string_view member) {
    return fmt::format("-a 'heightmap={{\"file\": \"{}\", {}}}'", file, member);
}

/// `full_scale` is the value that stands for 1.
void check_heights(const std::string& name, float smallest, float largest, double full_scale) {
    if (smallest < 0 || largest > static_cast<float>(full_scale)) {
        fail(
            "height map '{}' has values from {} to {}: heights must lie in [0, {}]; give height_range or normalize: {}",
            name, smallest, largest, full_scale, option_with(name, "\"normalize\": true"));
    }
    const double used = (largest - smallest) / full_scale;
    if (used > 0 && used < least_used_scale) {
        log_warning(
            "height map '{}' has values from {} to {}, {:.2g} % of [0, {}], and is almost flat; where that is not "
            "meant, "
            "give height_range or normalize: {}",
            name, smallest, largest, 100 * used, full_scale, option_with(name, "\"normalize\": true"));
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

/// Of the texels that something is known of, in the file's own numbers.
struct ValueRange {
    float smallest = std::numeric_limits<float>::infinity();
    float largest = -std::numeric_limits<float>::infinity();
};

/// Gives texels of which nothing is known the value that the source has for them.
ValueRange fill_gaps(const HeightMapSource& source, std::optional<double> nodata, Image<float>& values) {
    ValueRange range;
    std::size_t gaps = 0;
    std::size_t first_gap = 0;
    for (std::size_t index = 0; index < values.texels.size(); ++index) {
        float& value = values.texels[index];
        if (std::isnan(value) || (nodata && value == static_cast<float>(*nodata))) {
            if (gaps++ == 0) first_gap = index;
            if (!source.fill) continue;
            value = static_cast<float>(*source.fill);
        } else {
            range.smallest = std::min(range.smallest, value);
            range.largest = std::max(range.largest, value);
        }
    }
    if (gaps == 0) return range;
    const std::string what = nodata ? fmt::format("{} or NaN", *nodata) : "NaN";
    const std::string where = texel_text(first_gap, values.size.width);
    if (!source.fill) {
        fail(
            "height map '{}' has no data ({}) in {} of {} texels, the first in {}: heights must be finite; give "
            "\"fill\", the value that they get, or repair the file: {}",
            source.name, what, gaps, values.texels.size(), where, option_with(source.name, "\"fill\": 0"));
    }
    if (gaps == values.texels.size()) fail("height map '{}' has no data ({}) in any texel", source.name, what);
    log_warning("height map '{}' has no data ({}) in {} of {} texels, the first in {}: they get {}", source.name, what,
                gaps, values.texels.size(), where, *source.fill);
    return range;
}

void check_range_is_used(const HeightMapSource& source, const Image<float>& values, ValueRange range) {
    const double low = source.height_range->front();
    const double high = source.height_range->back();
    const std::string what =
        fmt::format("height map '{}' has values from {} to {}", source.name, range.smallest, range.largest);
    if (range.smallest > high || range.largest < low) {
        fail("{}, and none inside height_range [{}, {}]: give it in the file's own numbers", what, low, high);
    }
    const auto clamped = static_cast<std::size_t>(
        std::ranges::count_if(values.texels, [&](float value) { return value < low || value > high; }));
    if (clamped > values.texels.size() / 2) {
        log_warning("{}: {} of {} texels lie outside height_range [{}, {}] and are clamped", what, clamped,
                    values.texels.size(), low, high);
    }
}

ValueMapping mapping_of(const HeightMapSource& source, const StoredHeights& stored, ValueRange range) {
    if (source.normalize) return {range.smallest, range.largest, true};
    if (source.height_range) return {(*source.height_range)[0], (*source.height_range)[1], true};
    return {0, stored.full_scale, false};
}

HeightMap load_image(const HeightMapSource& source, HeightFormat format) {
    StoredHeights stored = read_stored_heights(source);
    Image<float>& values = stored.values;
    check_size(source.name, values.size);
    if (!source.nodata && !stored.unread_nodata.empty()) {
        fail(
            "height map '{}' marks texels without data by '{}' (GDAL_NODATA), which is no number: give it as the file "
            "has it: {}",
            source.name, stored.unread_nodata, option_with(source.name, "\"nodata\": -9999"));
    }
    const ValueRange range = fill_gaps(source, source.nodata ? source.nodata : stored.nodata, values);
    check_values(source.name, values);
    if (source.height_range) check_range_is_used(source, values, range);

    const ValueMapping mapping = mapping_of(source, stored, range);
    if (!mapping.is_given) {
        const auto [smallest, largest] = std::minmax_element(values.texels.begin(), values.texels.end());
        check_heights(source.name, *smallest, *largest, stored.full_scale);
    }
    // A constant map has no extent to stretch: its smallest value goes to 0.
    const double extent = mapping.high > mapping.low ? mapping.high - mapping.low : 1.0;
    const bool inverted = source.invert != stored.zero_is_white;
    for (float& value : values.texels) {
        const double height = std::clamp((value - mapping.low) / extent, 0.0, 1.0);
        value = static_cast<float>(inverted ? 1.0 - height : height);
    }

    std::vector<std::string> steps = std::move(stored.notes);
    if (mapping.is_given) steps.push_back(fmt::format("[{}, {}] → [0, 1]", mapping.low, mapping.high));
    if (source.invert) steps.push_back("inverted");
    if (source.fill) steps.push_back(fmt::format("filled with {}", *source.fill));
    if (steps.empty()) steps.push_back("as stored");
    return finish(std::move(values), format, std::filesystem::path(source.name).filename().string(), join(steps));
}

HeightMap generate(const HeightMapSource& source, HeightFormat format) {
    check_size(source.name, source.size);
    HeightMapSource plain;
    plain.name = source.name;
    plain.size = source.size;
    plain.seed = source.seed;
    plain.albedo = source.albedo;
    if (source != plain) {
        fail("height map '{}' is procedural: what says how a file is read is not for it; leave it out", source.name);
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
    const Resolution size = is_procedural(source.name) ? source.size : stored_heights_size(source);
    check_size(source.name, size);
    return size;
}

HeightMap make_height_map(const Image<float>& heights, HeightFormat format, std::string name) {
    check_size(name, heights.size);
    assert(heights.texels.size() == heights.size.pixels());
    check_values(name, heights);
    const auto [smallest, largest] = std::minmax_element(heights.texels.begin(), heights.texels.end());
    check_heights(name, *smallest, *largest, 1);
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
