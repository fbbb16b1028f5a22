#include "scene/netpbm.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "scene/raster_limits.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace reliefbench {

namespace {

/// Both formats: http://netpbm.sourceforge.net/doc/pgm.html and .../pfm.html.
struct Header {
    bool is_float = false;
    Resolution size;
    int channels = 1;
    /// The largest stored integer, or for floats the scale, whose sign tells the byte order.
    double maximum_or_scale = 0;
    /// From the character between header and pixels on.
    std::string_view pixels;
};

[[noreturn]] void fail_damaged(const std::filesystem::path& path, const char* what) {
    fail("cannot read image '{}': {}; the file is damaged or cut short", path.string(), what);
}

bool is_space(char character) {
    return character == ' ' || (character >= '\t' && character <= '\r');
}

/// With the end of its line.
std::size_t length_of_comment(std::string_view text) {
    return std::min(text.find_first_of("\r\n"), text.size() - 1) + 1;
}

/// Takes one word off the front, with the white space and the comments before it.
std::string_view take_word(std::string_view& text) {
    while (!text.empty() && (is_space(text.front()) || text.front() == '#')) {
        text.remove_prefix(text.front() == '#' ? length_of_comment(text) : 1);
    }
    const auto end = std::find_if(text.begin(), text.end(), [](char c) { return is_space(c) || c == '#'; });
    const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(word.size());
    return word;
}

template <typename Number>
Number take_number(std::string_view& text, const std::filesystem::path& path) {
    const auto number = whole_text_as<Number>(take_word(text));
    if (!number) fail_damaged(path, "its header has a word where a number is due");
    return *number;
}

Header parse_header(std::string_view bytes, const std::filesystem::path& path) {
    Header header;
    header.is_float = bytes[1] == 'f' || bytes[1] == 'F';
    header.channels = bytes[1] == '6' || bytes[1] == 'F' ? 3 : 1;
    bytes.remove_prefix(2);
    header.size.width = take_number<int>(bytes, path);
    header.size.height = take_number<int>(bytes, path);
    check_raster_size(path, header.size.width, header.size.height, header.channels);
    header.maximum_or_scale = take_number<double>(bytes, path);
    const bool usable = header.is_float ? std::abs(header.maximum_or_scale) > 0
                                        : header.maximum_or_scale >= 1 && header.maximum_or_scale <= 65535;
    if (!usable) fail_damaged(path, header.is_float ? "its scale is 0" : "its largest value is not in 1 to 65535");
    if (bytes.empty()) fail_damaged(path, "it ends with its header");
    header.pixels = bytes;
    return header;
}

std::size_t bytes_of_value(const Header& header) {
    return header.is_float ? sizeof(float) : header.maximum_or_scale > 255 ? 2 : 1;
}

/// One white space character stands between header and pixels, which may look like white space themselves. A comment
/// may stand before it ("255# depth"): the format's page has its line end belong to the comment, netpbm's programs have
/// it be that character, and the length of the file tells which.
std::string_view pixels_behind(const Header& header, const std::filesystem::path& path) {
    const std::size_t values = header.size.pixels() * static_cast<std::size_t>(header.channels);
    const std::size_t expected = values * bytes_of_value(header);
    std::string_view bytes = header.pixels;
    const bool after_comment = bytes.front() == '#';
    bytes.remove_prefix(after_comment ? length_of_comment(bytes) : 1);
    if (after_comment && bytes.size() == expected + 1 && is_space(bytes.front())) bytes.remove_prefix(1);
    if (bytes.size() < expected) fail_damaged(path, "it has fewer pixels than its header says");
    if (bytes.size() > expected) {
        fail(
            "cannot read image '{}': it has {} {} more than its header says (one white space character, no comment, "
            "stands between header and pixels); write it anew",
            path.string(), bytes.size() - expected, bytes.size() - expected == 1 ? "byte" : "bytes");
    }
    return bytes;
}

/// The stored value at `position`, in units of the format: integers are big-endian.
double stored_integer(std::string_view pixels, std::size_t position, std::size_t bytes_each) {
    const auto byte = [&](std::size_t index) { return static_cast<unsigned char>(pixels[index]); };
    return bytes_each == 1 ? byte(position) : byte(2 * position) * 256 + byte(2 * position + 1);
}

float stored_float(std::string_view pixels, std::size_t position, bool swapped) {
    std::array<char, sizeof(float)> bytes{};
    std::memcpy(bytes.data(), pixels.data() + position * sizeof(float), sizeof(float));
    if (swapped) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<float>(bytes);
}

RasterFile without_values(const Header& header) {
    RasterFile raster;
    raster.size = header.size;
    raster.bits = static_cast<int>(8 * bytes_of_value(header));
    if (!header.is_float) raster.full_scale = header.maximum_or_scale;
    raster.channel_names =
        header.channels == 3 ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"};
    return raster;
}

}  // namespace

bool is_netpbm(std::string_view bytes) {
    constexpr std::array magic_words = {"P5", "P6", "Pf", "PF"};
    return bytes.size() >= netpbm_magic_length && is_space(bytes[2]) &&
           std::any_of(magic_words.begin(), magic_words.end(),
                       [&](const char* magic) { return bytes.starts_with(magic); });
}

RasterFile parse_netpbm_header(std::string_view bytes, const std::filesystem::path& path) {
    assert(is_netpbm(bytes));
    return without_values(parse_header(bytes, path));
}

RasterFile parse_netpbm(std::string_view bytes, const std::filesystem::path& path) {
    assert(is_netpbm(bytes));
    const Header header = parse_header(bytes, path);
    const std::size_t bytes_each = bytes_of_value(header);
    const std::size_t row_values =
        static_cast<std::size_t>(header.size.width) * static_cast<std::size_t>(header.channels);
    const std::size_t count = row_values * static_cast<std::size_t>(header.size.height);
    const std::string_view pixels = pixels_behind(header, path);
    RasterFile raster = without_values(header);
    check_raster_memory(path, raster, raster.size);
    raster.values.resize(count);
    const bool swapped = (header.maximum_or_scale > 0) == (std::endian::native == std::endian::little);
    for (std::size_t index = 0; index < count; ++index) {
        if (header.is_float) {
            // A float map's rows run from the bottom up.
            const std::size_t row = static_cast<std::size_t>(header.size.height) - 1 - index / row_values;
            raster.values[row * row_values + index % row_values] = stored_float(pixels, index, swapped);
        } else {
            raster.values[index] = static_cast<float>(stored_integer(pixels, index, bytes_each));
        }
    }
    return raster;
}

std::string format_pfm(const RasterFile& raster, const std::filesystem::path& path) {
    const int channels = raster.channels();
    if (channels != 1 && channels != 3) {
        fail("cannot write image '{}': a float map takes one channel or three, not {}", path.string(), channels);
    }
    const bool little_endian = std::endian::native == std::endian::little;
    std::string bytes = fmt::format("{}\n{} {}\n{}\n", channels == 3 ? "PF" : "Pf", raster.size.width,
                                    raster.size.height, little_endian ? "-1.0" : "1.0");
    const std::size_t row_values = static_cast<std::size_t>(raster.size.width) * static_cast<std::size_t>(channels);
    for (std::size_t row = static_cast<std::size_t>(raster.size.height); row-- > 0;) {
        bytes.append(reinterpret_cast<const char*>(raster.values.data() + row * row_values),
                     row_values * sizeof(float));
    }
    return bytes;
}

}  // namespace reliefbench
