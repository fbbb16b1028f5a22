#include "scene/plain_image_file.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "scene/image_format.hpp"
#include "scene/netpbm.hpp"
#include "scene/png_tags.hpp"
#include "scene/raster_limits.hpp"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

namespace reliefbench {

namespace {

constexpr const char* plain_images =
    "a PNG, PFM, or binary PGM or PPM image, which is what this portable build reads (one with OpenImageIO reads JPEG, "
    "TIFF and OpenEXR, too)";

struct FreePixels {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};

[[noreturn]] void fail_to_read(const std::filesystem::path& path) {
    const char* reason = stbi_failure_reason();
    fail("cannot read image '{}': {}; the file is damaged or cut short", path.string(),
         reason ? reason : "no reason given");
}

std::vector<std::string> names_of_channels(int count) {
    switch (count) {
        case 1:
            return {"Y"};
        case 2:
            return {"Y", "A"};
        case 3:
            return {"R", "G", "B"};
        default:
            return {"R", "G", "B", "A"};
    }
}

/// The stored numbers, which the decoder has stretched to the whole of its type.
template <typename Decoded>
std::vector<float> stored_numbers(const Decoded* decoded, std::size_t count, double full_scale) {
    const double stretched = std::numeric_limits<Decoded>::max() / full_scale;
    std::vector<float> values(count);
    std::transform(decoded, decoded + count, values.begin(),
                   [stretched](Decoded value) { return static_cast<float>(std::round(value / stretched)); });
    return values;
}

const stbi_uc* data_of(std::string_view bytes) {
    return reinterpret_cast<const stbi_uc*>(bytes.data());
}

PngTags png_tags(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return read_png_tags(file);
}

/// As stored, before its orientation is applied.
RasterFile parse_png_header(std::string_view bytes, const std::filesystem::path& path, const PngTags& tags) {
    if (bytes.size() > std::numeric_limits<int>::max()) fail("cannot read image '{}': it is too large", path.string());
    const int length = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (!stbi_info_from_memory(data_of(bytes), length, &width, &height, &channels)) fail_to_read(path);
    // Of a palette's the decoder knows by itself.
    if (tags.has_transparent_colour && channels % 2 == 1) ++channels;
    check_raster_size(path, width, height, channels);
    RasterFile raster;
    raster.size = {width, height};
    raster.channel_names = names_of_channels(channels);
    raster.bits = stbi_is_16_bit_from_memory(data_of(bytes), length) ? 16 : 8;
    raster.full_scale = std::exp2(std::clamp(tags.bits, 1, raster.bits)) - 1;
    return raster;
}

RasterFile parse_png(std::string_view bytes, const std::filesystem::path& path) {
    const PngTags tags = png_tags(path);
    RasterFile raster = parse_png_header(bytes, path, tags);
    check_raster_memory(path, raster, raster.size);
    const stbi_uc* const data = data_of(bytes);
    const int length = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = raster.channels();
    const std::size_t count = raster.size.pixels() * static_cast<std::size_t>(channels);
    if (raster.bits == 16) {
        const std::unique_ptr<stbi_us, FreePixels> pixels(
            stbi_load_16_from_memory(data, length, &width, &height, &channels, channels));
        if (!pixels) fail_to_read(path);
        raster.values = stored_numbers(pixels.get(), count, raster.full_scale);
    } else {
        const std::unique_ptr<stbi_uc, FreePixels> pixels(
            stbi_load_from_memory(data, length, &width, &height, &channels, channels));
        if (!pixels) fail_to_read(path);
        raster.values = stored_numbers(pixels.get(), count, raster.full_scale);
    }
    return oriented(std::move(raster), tags.orientation);
}

std::string format_png(const RasterFile& raster, const std::filesystem::path& path) {
    check_png_channels(path, raster.channels());
    std::string bytes;
    const auto append = [](void* target, void* data, int size) {
        static_cast<std::string*>(target)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
    };
    const std::vector<std::uint8_t> pixels = to_bytes(raster.values);
    const bool written =
        stbi_write_png_to_func(append, &bytes, raster.size.width, raster.size.height, raster.channels(), pixels.data(),
                               raster.size.width * raster.channels()) != 0;
    if (!written) fail("cannot write image '{}': the picture cannot be encoded as PNG", path.string());
    return bytes;
}

}  // namespace

RasterFile read_plain_image(const std::filesystem::path& path, const ImageChoice& choice) {
    check_is_image_file(path);
    check_single_part(path, choice.part);
    const std::string bytes = read_text_file(path);
    if (!is_netpbm(bytes) && !bytes.starts_with(png_magic)) fail_unread_format(path, bytes, plain_images);
    RasterFile raster = is_netpbm(bytes) ? parse_netpbm(bytes, path) : parse_png(bytes, path);
    return choice.channels.empty() ? std::move(raster) : with_channels(raster, choice.channels);
}

RasterFile read_plain_header(const std::filesystem::path& path, const std::string& part) {
    check_is_image_file(path);
    check_single_part(path, part);
    const std::string bytes = read_text_file(path);
    if (is_netpbm(bytes)) return parse_netpbm_header(bytes, path);
    if (!bytes.starts_with(png_magic)) fail_unread_format(path, bytes, plain_images);
    const PngTags tags = png_tags(path);
    return oriented(parse_png_header(bytes, path, tags), tags.orientation);
}

void write_plain_image(const std::filesystem::path& path, const RasterFile& raster) {
    assert(raster.values.size() == raster.size.pixels() * raster.channel_names.size() && raster.full_scale == 1);
    const std::string extension = path.extension().string();
    if (extension == ".png") {
        write_text_file(path, format_png(raster, path));
    } else if (extension == ".pfm") {
        write_text_file(path, format_pfm(raster, path));
    } else {
        fail("cannot write image '{}': this portable build writes .png and .pfm; .exr takes a build with OpenImageIO",
             path.string());
    }
}

}  // namespace reliefbench
