#include "scene/raw_heights.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "scene/image_format.hpp"
#include "scene/raster_limits.hpp"

#include <bit>
#include <cassert>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace reliefbench {

namespace {

using SampleType = RawLayout::SampleType;

std::size_t bytes_of_sample(SampleType type) {
    return type == SampleType::uint8 ? 1 : type == SampleType::float32 ? 4 : 2;
}

double largest_sample(SampleType type) {
    switch (type) {
        case SampleType::uint8:
            return std::numeric_limits<std::uint8_t>::max();
        case SampleType::uint16:
            return std::numeric_limits<std::uint16_t>::max();
        case SampleType::int16:
            return std::numeric_limits<std::int16_t>::max();
        case SampleType::float32:
            return 1;
    }
    assert(false);
    return 1;
}

float raw_sample(std::string_view bytes, const RawLayout& layout) {
    std::uint32_t bits = 0;
    for (std::size_t index = 0; index < bytes.size(); ++index)
        bits = bits << 8 | static_cast<unsigned char>(bytes[layout.big_endian ? index : bytes.size() - 1 - index]);
    if (layout.sample_type == SampleType::float32) return std::bit_cast<float>(bits);
    if (layout.sample_type == SampleType::int16) return static_cast<std::int16_t>(bits);
    return static_cast<float>(bits);
}

void check_length(const std::filesystem::path& path, std::uintmax_t bytes, const RawLayout& layout) {
    const std::size_t needed = layout.size.pixels() * bytes_of_sample(layout.sample_type);
    if (bytes == needed) return;
    fail(
        "cannot read '{}': it has {} bytes, and {}x{} numbers of {} bytes take {}: give the \"size\" and "
        "\"sample_type\" that it was written with",
        path.string(), bytes, layout.size.width, layout.size.height, bytes_of_sample(layout.sample_type), needed);
}

}  // namespace

RasterFile read_raw_header(const std::filesystem::path& path, const RawLayout& layout) {
    check_is_image_file(path);
    check_raster_size(path, layout.size.width, layout.size.height, 1);
    check_length(path, std::filesystem::file_size(path), layout);
    RasterFile raster;
    raster.size = layout.size;
    raster.channel_names = {"Y"};
    raster.full_scale = largest_sample(layout.sample_type);
    raster.bits = static_cast<int>(8 * bytes_of_sample(layout.sample_type));
    return raster;
}

RasterFile read_raw_heights(const std::filesystem::path& path, const RawLayout& layout) {
    RasterFile raster = read_raw_header(path, layout);
    check_raster_memory(path, raster, raster.size);
    const std::string bytes = read_text_file(path);
    check_length(path, bytes.size(), layout);
    const std::size_t each = bytes_of_sample(layout.sample_type);
    raster.values.resize(raster.size.pixels());
    for (std::size_t index = 0; index < raster.values.size(); ++index)
        raster.values[index] = raw_sample(std::string_view(bytes).substr(index * each, each), layout);
    return raster;
}

}  // namespace reliefbench
