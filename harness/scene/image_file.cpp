#include "scene/image_file.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "scene/image_format.hpp"
#include "scene/netpbm.hpp"
#include "scene/pixel_window.hpp"
#include "scene/png_tags.hpp"
#include "scene/raster_limits.hpp"
#include "scene/tiff_tags.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <numeric>
#include <string_view>
#include <utility>

namespace reliefbench {

namespace {

using std::string_view_literals::operator""sv;

struct Format {
    std::string_view magic;
    /// OpenImageIO's name of its reader.
    std::string_view reader;
};

/// OpenImageIO has readers of dozens of formats, with as many decoders to trust, and asks all of them in turn.
constexpr std::array<Format, 7> formats{{{png_magic, "png"},
                                         {"\xff\xd8\xff"sv, "jpeg"},
                                         {"II*\0"sv, "tiff"},
                                         {"MM\0*"sv, "tiff"},
                                         {"II+\0"sv, "tiff"},
                                         {"MM\0+"sv, "tiff"},
                                         {"\x76\x2f\x31\x01"sv, "openexr"}}};
/// Enough for every format that is known, the refused ones too.
constexpr std::size_t longest_magic = 12;

/// A file of which one byte is another.
class PatchedFile : public OIIO::Filesystem::IOFile {
public:
    PatchedFile(const std::string& path, std::uint64_t place, unsigned char byte)
        : IOFile(path, Read), place_(place), byte_(byte) {}

    std::size_t read(void* buffer, std::size_t size) override {
        const std::int64_t begin = tell();
        const std::size_t count = IOFile::read(buffer, size);
        patch(buffer, count, begin);
        return count;
    }
    std::size_t pread(void* buffer, std::size_t size, std::int64_t begin) override {
        const std::size_t count = IOFile::pread(buffer, size, begin);
        patch(buffer, count, begin);
        return count;
    }

private:
    void patch(void* buffer, std::size_t count, std::int64_t begin) const {
        const std::uint64_t from = place_ - static_cast<std::uint64_t>(begin);
        if (from < count) static_cast<unsigned char*>(buffer)[from] = byte_;
    }

    std::uint64_t place_;
    unsigned char byte_;
};

/// What OpenImageIO does not tell, or not of every format.
struct FileTags {
    std::size_t part = 0;
    /// Of the stored numbers; 0: those of the type that they are read as.
    int bits = 0;
    int orientation = 1;
    bool zero_is_white = false;
    std::optional<double> nodata;
    std::string unread_nodata;
};

struct OpenImage {
    std::unique_ptr<PatchedFile> patched;
    std::unique_ptr<OIIO::ImageInput> input;
    std::string_view reader;
    FileTags tags;

    const OIIO::ImageSpec& spec() const { return input->spec(); }
};

std::string reason(std::string message) {
    while (!message.empty() && (message.back() == '\n' || message.back() == ' '))
        message.pop_back();
    std::replace(message.begin(), message.end(), '\n', ' ');
    return message.empty() ? "no reason given" : message;
}

[[noreturn]] void fail_to_open(const std::filesystem::path& path, const std::string& why) {
    fail("cannot read image '{}': {}; the file is damaged, or not {}", path.string(), reason(why), readable_images());
}

void set_proxy(OIIO::ImageSpec& spec, OIIO::Filesystem::IOProxy* proxy) {
    void* pointer = proxy;
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &pointer);
}

/// OpenImageIO turns 8-bit numbers of "0 is white" over, alpha too, and leaves wider ones. Told that 0 is black it
/// leaves all of them.
void open_tiff(OpenImage& image, const std::filesystem::path& path, const std::string& part, OIIO::ImageSpec& hints) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<TiffPage> pages = read_tiff_pages(file, path);
    std::vector<std::size_t> pictures;
    for (std::size_t number = 0; number < pages.size(); ++number) {
        if (!pages[number].is_auxiliary) pictures.push_back(number);
    }
    const std::size_t number = chosen_part(path, part, std::vector<std::string>(pages.size()), pictures);
    const TiffPage& page = pages[number];
    check_tiff_page(page, path);
    image.tags = {.part = number,
                  .bits = static_cast<int>(page.bits.front()),
                  .orientation = static_cast<int>(std::min<std::uint64_t>(page.orientation, 9)),
                  .zero_is_white = page.photometric == 0,
                  .nodata = page.nodata,
                  .unread_nodata = page.unread_nodata};
    if (!image.tags.zero_is_white) return;
    image.patched = std::make_unique<PatchedFile>(path.string(), page.photometric_place, std::uint8_t{1});
    set_proxy(hints, image.patched.get());
}

std::size_t choose_exr_part(OIIO::ImageInput& input, const std::filesystem::path& path, const std::string& part) {
    std::vector<std::string> names;
    for (int number = 0; input.seek_subimage(number, 0); ++number)
        names.push_back(input.spec().get_string_attribute("name"));
    std::vector<std::size_t> pictures(names.size());
    std::iota(pictures.begin(), pictures.end(), std::size_t{0});
    return chosen_part(path, part, names, pictures);
}

OpenImage open_image(const std::filesystem::path& path, const std::string& part) {
    const std::string begin = first_bytes(path, longest_magic);
    const auto format =
        std::ranges::find_if(formats, [&](const Format& known) { return begin.starts_with(known.magic); });
    if (format == formats.end()) fail_unread_format(path, begin, readable_images());
    OpenImage image;
    image.reader = format->reader;
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    if (image.reader == "tiff") open_tiff(image, path, part, hints);
    if (image.reader == "png") {
        std::ifstream file(path, std::ios::binary);
        const PngTags tags = read_png_tags(file);
        image.tags.bits = tags.bits;
        image.tags.orientation = tags.orientation;
    }
    image.input = OIIO::ImageInput::create(std::string(image.reader));
    if (!image.input) fail("cannot read image '{}': {}", path.string(), reason(OIIO::geterror()));
    OIIO::ImageSpec ignored;
    if (!image.input->open(path.string(), ignored, hints)) fail_to_open(path, image.input->geterror());
    if (image.reader == "openexr") {
        image.tags.part = choose_exr_part(*image.input, path, part);
    } else if (image.reader != "tiff") {
        check_single_part(path, part);
    }
    if (image.reader == "jpeg") image.tags.orientation = image.spec().get_int_attribute("Orientation", 1);
    if (!image.input->seek_subimage(static_cast<int>(image.tags.part), 0)) fail_to_open(path, image.input->geterror());
    return image;
}

/// The largest number of an integer type; 0 of floats.
double maximum_of(OIIO::TypeDesc type) {
    switch (type.basetype) {
        case OIIO::TypeDesc::UINT8:
            return 255;
        case OIIO::TypeDesc::INT8:
            return 127;
        case OIIO::TypeDesc::UINT16:
            return 65535;
        case OIIO::TypeDesc::INT16:
            return 32767;
        case OIIO::TypeDesc::UINT32:
            return 4294967295.0;
        case OIIO::TypeDesc::INT32:
            return 2147483647.0;
        default:
            return 0;
    }
}

PixelWindow data_window(const OIIO::ImageSpec& spec) {
    return {spec.x, spec.y, {spec.width, spec.height}};
}

/// Only OpenEXR has a picture apart from the pixels that are there.
PixelWindow display_window(const OpenImage& image) {
    const OIIO::ImageSpec& spec = image.spec();
    if (image.reader != "openexr") return data_window(spec);
    return {spec.full_x, spec.full_y, {spec.full_width, spec.full_height}};
}

void check_picture(const std::filesystem::path& path, const OpenImage& image) {
    const OIIO::ImageSpec& spec = image.spec();
    if (spec.deep || spec.depth > 1) {
        fail("image '{}' is {}: give a flat, two-dimensional one", path.string(), spec.deep ? "deep" : "a volume");
    }
    check_raster_size(path, spec.width, spec.height, spec.nchannels);
    const Resolution size = display_window(image).size;
    check_raster_size(path, size.width, size.height, spec.nchannels);
    const bool inks = spec.get_string_attribute("jpeg:ColorSpace") == "CMYK" ||
                      spec.get_string_attribute("jpeg:ColorSpace") == "YCbCrK";
    if (inks) fail("cannot read image '{}': it stores inks (CMYK); convert it to grey or RGB", path.string());
    if (spec.format.basesize() > 4) {
        fail("cannot read image '{}': numbers of {} bits are not read; save it with 32 at most", path.string(),
             spec.format.basesize() * 8);
    }
}

RasterFile header_of(const OpenImage& image) {
    const OIIO::ImageSpec& spec = image.spec();
    RasterFile raster;
    raster.size = display_window(image).size;
    raster.channel_names = spec.channelnames;
    raster.bits = static_cast<int>(spec.format.basesize() * 8);
    const double maximum = maximum_of(spec.format);
    if (maximum > 0) raster.full_scale = maximum;
    const bool stretched = image.tags.bits > 0 && image.tags.bits < raster.bits && maximum > 0;
    if (stretched) raster.full_scale = std::exp2(image.tags.bits) - 1;
    raster.zero_is_white = image.tags.zero_is_white;
    raster.nodata = image.tags.nodata;
    raster.unread_nodata = image.tags.unread_nodata;
    if (raster.zero_is_white) raster.notes.push_back("0 is white");
    if (display_window(image) != data_window(spec)) raster.notes.push_back("display window");
    return raster;
}

template <typename Integer>
bool read_integers(OIIO::ImageInput& input, int part, int first, int end, OIIO::TypeDesc type,
                   std::vector<float>& values) {
    std::vector<Integer> stored(values.size());
    const bool complete = input.read_image(part, 0, first, end, type, stored.data());
    std::ranges::transform(stored, values.begin(), [](Integer value) { return static_cast<float>(value); });
    return complete;
}

/// Stored numbers of the data window, of channels from `first` to before `end`.
std::vector<float> read_window(const OpenImage& image, const std::filesystem::path& path, int first, int end,
                               double full_scale) {
    OIIO::ImageInput& input = *image.input;
    const OIIO::ImageSpec spec = image.spec();
    const int part = static_cast<int>(image.tags.part);
    const OIIO::TypeDesc type = spec.channelformat(first);
    std::vector<float> values(Resolution{spec.width, spec.height}.pixels() * static_cast<std::size_t>(end - first));
    bool complete = false;
    if (type == OIIO::TypeDesc::UINT32) {
        complete = read_integers<std::uint32_t>(input, part, first, end, type, values);
    } else if (type == OIIO::TypeDesc::INT32) {
        complete = read_integers<std::int32_t>(input, part, first, end, type, values);
    } else {
        complete = input.read_image(part, 0, first, end, OIIO::TypeDesc::FLOAT, values.data());
        // OpenImageIO multiplies integers by a rounded reciprocal, and some of few bits it has rounded down before.
        if (maximum_of(type) > 0) {
            for (float& value : values)
                value = static_cast<float>(std::round(double{value} * full_scale));
        }
    }
    // Some readers fill the rest of a truncated file and report it as an error only.
    if (!complete || input.has_error()) {
        fail("cannot read image '{}': {}; the file is damaged or cut short", path.string(), reason(input.geterror()));
    }
    return values;
}

/// The numbers of the channels chosen, interleaved.
std::vector<float> read_channels(const OpenImage& image, const std::filesystem::path& path,
                                 const std::vector<std::size_t>& channels, double full_scale) {
    const OIIO::ImageSpec spec = image.spec();
    const auto [first, last] = std::ranges::minmax(channels);
    const bool adjacent = last - first + 1 == channels.size() && std::ranges::is_sorted(channels);
    if (adjacent && spec.channelformats.empty()) {
        return read_window(image, path, static_cast<int>(first), static_cast<int>(last) + 1, full_scale);
    }
    std::vector<float> values(Resolution{spec.width, spec.height}.pixels() * channels.size());
    for (std::size_t index = 0; index < channels.size(); ++index) {
        const int channel = static_cast<int>(channels[index]);
        if (maximum_of(spec.channelformat(channel)) != maximum_of(spec.channelformat(static_cast<int>(channels[0])))) {
            fail("cannot read image '{}': its channels {} and {} are not of one number format; choose one",
                 path.string(), spec.channelnames[channels[0]], spec.channelnames[channels[index]]);
        }
        const std::vector<float> one = read_window(image, path, channel, channel + 1, full_scale);
        for (std::size_t pixel = 0; pixel < one.size(); ++pixel)
            values[pixel * channels.size() + index] = one[pixel];
    }
    return values;
}

std::string encoded(const std::filesystem::path& path, const RasterFile& raster, bool as_png) {
    OIIO::ImageSpec spec(raster.size.width, raster.size.height, raster.channels(),
                         as_png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    spec.channelnames = raster.channel_names;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (!as_png) spec.attribute("compression", "zip");
    // Into memory: OpenImageIO does not notice that a disk is full when it closes a PNG file.
    OIIO::Filesystem::IOVecOutput bytes;
    set_proxy(spec, &bytes);

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

RasterFile read_raster_header(const std::filesystem::path& path, const std::string& part) {
    check_is_image_file(path);
    if (is_netpbm(first_bytes(path, netpbm_magic_length))) {
        check_single_part(path, part);
        return parse_netpbm_header(first_bytes(path, longest_netpbm_header), path);
    }
    const OpenImage image = open_image(path, part);
    check_picture(path, image);
    return oriented(header_of(image), image.tags.orientation);
}

RasterFile read_raster_file(const std::filesystem::path& path, const ImageChoice& choice) {
    check_is_image_file(path);
    // OpenImageIO 2.4 rounds 16-bit grey maps down: 65535 comes as 65534.
    if (is_netpbm(first_bytes(path, netpbm_magic_length))) {
        check_single_part(path, choice.part);
        const RasterFile raster = parse_netpbm(read_text_file(path), path);
        return choice.channels.empty() ? raster : with_channels(raster, choice.channels);
    }
    const OpenImage image = open_image(path, choice.part);
    check_picture(path, image);
    std::vector<std::size_t> channels = choice.channels;
    if (channels.empty()) {
        channels.resize(image.spec().channelnames.size());
        std::iota(channels.begin(), channels.end(), std::size_t{0});
    }
    RasterFile raster = with_channels(header_of(image), channels);
    const OIIO::ImageSpec spec = image.spec();
    // A channel of integers among others of floats.
    const double maximum = maximum_of(spec.channelformat(static_cast<int>(channels.front())));
    if (!spec.channelformats.empty()) raster.full_scale = maximum > 0 ? maximum : 1;
    const PixelWindow data = data_window(spec);
    const PixelWindow display = display_window(image);
    check_raster_memory(path, raster, data.size);
    raster.values = read_channels(image, path, channels, raster.full_scale);
    if (data != display) raster.values = in_display_window(raster.values, data, display, channels.size(), path);
    return oriented(std::move(raster), image.tags.orientation);
}

void write_raster_file(const std::filesystem::path& path, const RasterFile& raster) {
    assert(raster.values.size() == raster.size.pixels() * raster.channel_names.size() && raster.full_scale == 1);
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
