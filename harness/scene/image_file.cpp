#include "scene/image_file.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "scene/netpbm.hpp"
#include "scene/raster_limits.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string_view>

namespace reliefbench {

namespace {

void check_layout(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
    if (spec.deep || spec.depth > 1) {
        fail("image '{}' is {}: give a flat, two-dimensional one", path.string(), spec.deep ? "deep" : "a volume");
    }
    check_raster_size(path, spec.width, spec.height, spec.nchannels);
}

std::string reason(std::string message) {
    while (!message.empty() && (message.back() == '\n' || message.back() == ' '))
        message.pop_back();
    std::replace(message.begin(), message.end(), '\n', ' ');
    return message.empty() ? "no reason given" : message;
}

struct Format {
    std::string_view magic;
    /// OpenImageIO's name of its reader.
    const char* reader;
};

using std::string_view_literals::operator""sv;

/// OpenImageIO has readers of dozens of formats, with as many decoders to trust, and asks all of them in turn.
constexpr std::array<Format, 7> formats{{{"\x89PNG\r\n\x1a\n"sv, "png"},
                                         {"\xff\xd8\xff"sv, "jpeg"},
                                         {"II*\0"sv, "tiff"},
                                         {"MM\0*"sv, "tiff"},
                                         {"II+\0"sv, "tiff"},
                                         {"MM\0+"sv, "tiff"},
                                         {"\x76\x2f\x31\x01"sv, "openexr"}}};

std::string first_bytes(const std::filesystem::path& path, std::size_t count) {
    std::string bytes(count, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

void check_is_file(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        fail("cannot read image '{}': {}", path.string(), error ? error.message() : "no such file");
    }
    if (!std::filesystem::is_regular_file(path, error)) fail("cannot read image '{}': it is not a file", path.string());
}

std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& path) {
    const std::string begin = first_bytes(path, formats.front().magic.size());
    const auto format =
        std::ranges::find_if(formats, [&](const Format& known) { return begin.starts_with(known.magic); });
    if (format == formats.end()) fail("cannot read image '{}': it is not {}", path.string(), readable_images());
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format->reader);
    if (!input) fail("cannot read image '{}': {}", path.string(), reason(OIIO::geterror()));
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageSpec ignored;
    if (!input->open(path.string(), ignored, hints)) {
        fail("cannot read image '{}': {}; the file is damaged, or not {}", path.string(), reason(input->geterror()),
             readable_images());
    }
    check_layout(path, input->spec());
    return input;
}

RasterFile header_of(const OIIO::ImageSpec& spec) {
    RasterFile raster;
    raster.size = {spec.width, spec.height};
    raster.channel_names = spec.channelnames;
    raster.bits = static_cast<int>(spec.format.basesize() * 8);
    return raster;
}

/// OpenImageIO multiplies integers by a rounded reciprocal; this restores stored/maximum to the last bit.
void divide_exactly(std::vector<float>& values, OIIO::TypeDesc stored) {
    if (stored != OIIO::TypeDesc::UINT8 && stored != OIIO::TypeDesc::UINT16) return;
    const double maximum = stored == OIIO::TypeDesc::UINT8 ? 255.0 : 65535.0;
    for (float& value : values)
        value = static_cast<float>(std::round(value * maximum) / maximum);
}

std::string encoded(const std::filesystem::path& path, const RasterFile& raster, bool as_png) {
    OIIO::ImageSpec spec(raster.size.width, raster.size.height, raster.channels(),
                         as_png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    spec.channelnames = raster.channel_names;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (!as_png) spec.attribute("compression", "zip");
    // Into memory: OpenImageIO does not notice that a disk is full when it closes a PNG file.
    OIIO::Filesystem::IOVecOutput bytes;
    void* proxy = static_cast<OIIO::Filesystem::IOProxy*>(&bytes);
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);

    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(as_png ? "png" : "exr");
    if (!output) fail("cannot write image '{}': {}", path.string(), reason(OIIO::geterror()));
    bool written = output->open(path.filename().string(), spec);
    if (written && as_png) {
        written = output->write_image(OIIO::TypeDesc::UINT8, to_bytes(raster.values).data());
    } else if (written) {
        written = output->write_image(OIIO::TypeDesc::FLOAT, raster.values.data());
    }
    written = written && output->close();
    if (!written) fail("cannot write image '{}': {}", path.string(), reason(output->geterror()));
    return {bytes.buffer().begin(), bytes.buffer().end()};
}

}  // namespace

std::string readable_images() {
    return "a PNG, JPEG, TIFF, OpenEXR, PFM, or binary PGM or PPM image";
}

RasterFile read_raster_header(const std::filesystem::path& path) {
    check_is_file(path);
    const std::string begin = first_bytes(path, longest_netpbm_header);
    return is_netpbm(begin) ? parse_netpbm_header(begin, path) : header_of(open_image(path)->spec());
}

RasterFile read_raster_file(const std::filesystem::path& path) {
    check_is_file(path);
    // OpenImageIO 2.4 rounds 16-bit grey maps down: 65535 comes as 65534.
    if (is_netpbm(first_bytes(path, netpbm_magic_length))) return parse_netpbm(read_text_file(path), path);

    const std::unique_ptr<OIIO::ImageInput> input = open_image(path);
    const OIIO::ImageSpec& spec = input->spec();
    RasterFile raster = header_of(spec);
    check_raster_memory(path, raster);
    raster.values.resize(raster.size.pixels() * raster.channel_names.size());
    const bool complete = input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, raster.values.data());
    // Some readers fill the rest of a truncated file and report it as an error only.
    if (!complete || input->has_error()) {
        fail("cannot read image '{}': {}; the file is damaged or cut short", path.string(), reason(input->geterror()));
    }
    divide_exactly(raster.values, spec.format);
    return raster;
}

void write_raster_file(const std::filesystem::path& path, const RasterFile& raster) {
    assert(raster.values.size() == raster.size.pixels() * raster.channel_names.size());
    const std::string extension = path.extension().string();
    if (extension != ".png" && extension != ".exr") {
        fail("cannot write image '{}': its name must end in .png or .exr", path.string());
    }
    const bool as_png = extension == ".png";
    if (as_png && (raster.channels() < 1 || raster.channels() > 4)) {
        fail("cannot write image '{}': PNG takes one to four channels, not {}; use .exr", path.string(),
             raster.channels());
    }
    write_text_file(path, encoded(path, raster, as_png));
}

}  // namespace reliefbench
