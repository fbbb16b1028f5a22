#include "report/page_pictures.hpp"

#include "core/hash.hpp"

#include <zlib.h>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <unordered_map>
#include <utility>

namespace reliefbench {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t channels = 3;
/// What base64 makes of bytes.
constexpr double text_per_byte = 4.0 / 3.0;
/// Of one picture in the page beside its pixels: names and numbers.
constexpr std::size_t record_bytes = 80;

Bytes deflated(const Bytes& bytes) {
    constexpr int level = 6;
    uLongf size = compressBound(bytes.size());
    Bytes packed(size);
    [[maybe_unused]] const int result = compress2(packed.data(), &size, bytes.data(), bytes.size(), level);
    assert(result == Z_OK);  // the buffer is as large as zlib asks for
    packed.resize(size);
    return packed;
}

/// One way of writing a picture; the smallest is taken.
struct PagePacking {
    Json record;
    Bytes data;
    std::size_t bytes = 0;
};

PagePacking make_packing(Json record, const Bytes& raw, std::size_t bytes_beside) {
    PagePacking packing{std::move(record), deflated(raw), 0};
    packing.bytes = packing.data.size() + bytes_beside;
    return packing;
}

PagePacking as_rgb(const PagePicture& picture) {
    return make_packing({{"packing", "rgb"}}, picture.rgb, 0);
}

PagePacking as_difference(const PagePicture& picture, const PagePicture& base, std::size_t base_at) {
    Bytes difference(picture.rgb.size());
    std::transform(picture.rgb.begin(), picture.rgb.end(), base.rgb.begin(), difference.begin(),
                   [](std::uint8_t value, std::uint8_t from) { return static_cast<std::uint8_t>(value - from); });
    return make_packing({{"packing", "difference"}, {"base", base_at}}, difference, 0);
}

/// 0xRRGGBB.
using Colour = std::uint32_t;

Colour colour_at(const PagePicture& picture, std::size_t pixel) {
    const std::uint8_t* rgb = &picture.rgb[channels * pixel];
    return static_cast<Colour>(rgb[0]) << 16 | static_cast<Colour>(rgb[1]) << 8 | rgb[2];
}

std::array<std::uint8_t, channels> bytes_of(Colour colour) {
    return {static_cast<std::uint8_t>(colour >> 16), static_cast<std::uint8_t>(colour >> 8),
            static_cast<std::uint8_t>(colour)};
}

int brightness(Colour colour) {
    const auto [red, green, blue] = bytes_of(colour);
    return red + green + blue;
}

/// Colours in the order of their brightness, so that near values of a colour map have near indices. Empty where there
/// are too many to be worth while.
std::optional<PagePacking> as_palette(const PagePicture& picture) {
    const std::size_t pixels = picture.rgb.size() / channels;
    const std::size_t max_colours = std::min<std::size_t>(4096, pixels / 8);
    std::unordered_map<Colour, std::size_t> index;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        index.try_emplace(colour_at(picture, pixel), 0);
        if (index.size() > max_colours) return std::nullopt;
    }
    std::vector<Colour> palette;
    for (const auto& [colour, unused] : index) {
        palette.push_back(colour);
    }
    std::sort(palette.begin(), palette.end(),
              [](Colour a, Colour b) { return std::pair(brightness(a), a) < std::pair(brightness(b), b); });
    Bytes colours;
    for (std::size_t at = 0; at < palette.size(); ++at) {
        index[palette[at]] = at;
        const auto bytes = bytes_of(palette[at]);
        colours.insert(colours.end(), bytes.begin(), bytes.end());
    }
    constexpr std::size_t one_byte = 256;
    Bytes indices(palette.size() > one_byte ? 2 * pixels : pixels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        const std::size_t at = index[colour_at(picture, pixel)];
        indices[pixel] = static_cast<std::uint8_t>(at % one_byte);
        if (palette.size() > one_byte) indices[pixels + pixel] = static_cast<std::uint8_t>(at / one_byte);
    }
    return make_packing({{"packing", "palette"}, {"palette", base64(colours)}}, indices, colours.size());
}

PagePacking smallest_packing(const PagePicture& picture, const PagePicture* base, std::size_t base_at) {
    // At most two bytes a pixel and a short palette are fewer than three: such a picture need not be tried without.
    std::optional<PagePacking> palette = as_palette(picture);
    PagePacking best = palette ? std::move(*palette) : as_rgb(picture);
    if (base == nullptr) return best;
    PagePacking difference = as_difference(picture, *base, base_at);
    return difference.bytes < best.bytes ? std::move(difference) : std::move(best);
}

}  // namespace

PagePicture every_nth_pixel(const PagePicture& picture, int step) {
    assert(step > 0);
    PagePicture reduced;
    reduced.width = (picture.width + step - 1) / step;
    reduced.height = (picture.height + step - 1) / step;
    for (int y = 0; y < picture.height; y += step) {
        for (int x = 0; x < picture.width; x += step) {
            const auto pixel = picture.rgb.begin() + channels * (static_cast<std::ptrdiff_t>(y) * picture.width + x);
            reduced.rgb.insert(reduced.rgb.end(), pixel, pixel + channels);
        }
    }
    return reduced;
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
    using namespace boost::archive::iterators;
    using Digits = base64_from_binary<transform_width<Bytes::const_iterator, 6, 8>>;
    std::string text(Digits(bytes.begin()), Digits(bytes.end()));
    text.append((3 - bytes.size() % 3) % 3, '=');
    return text;
}

std::size_t PagePictures::add(const PagePicture& picture, std::optional<std::size_t> base) {
    assert(picture.rgb.size() == channels * static_cast<std::size_t>(picture.width) * picture.height);
    const std::string content = fmt::format("{}x{}:", picture.width, picture.height) +
                                content_hash({reinterpret_cast<const char*>(picture.rgb.data()), picture.rgb.size()});
    const auto [known, is_new] = by_content_.try_emplace(content, pictures_.size());
    if (!is_new) return known->second;

    const bool fits_base = base && pictures_[*base].width == picture.width && pictures_[*base].height == picture.height;
    PagePacking packing = smallest_packing(picture, fits_base ? &pictures_[*base] : nullptr, base.value_or(0));
    Json record = {{"width", picture.width}, {"height", picture.height}};
    record.update(packing.record);
    record["data"] = base64(packing.data);
    bytes_ += static_cast<std::size_t>(text_per_byte * static_cast<double>(packing.bytes)) + record_bytes;
    pool_.push_back(std::move(record));
    pictures_.push_back(picture);
    return known->second;
}

}  // namespace reliefbench
