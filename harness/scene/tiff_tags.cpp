#include "scene/tiff_tags.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

namespace reliefbench {

namespace {

/// Numbers of tags, TIFF 6.0 and https://gdal.org/drivers/raster/gtiff.html.
enum Tag : std::uint16_t {
    new_subfile_type = 254,
    bits_per_sample = 258,
    photometric_interpretation = 262,
    orientation_tag = 274,
    sample_format = 339,
    gdal_nodata = 42113,
};

constexpr std::size_t max_pages = 1024;
/// Of the tags that are looked at; the most channels that an image may have.
constexpr std::uint64_t max_numbers = 1024;

/// Signals damage to the functions below: where a damaged file is an Error, they have no path for its message.
struct Damaged {};

struct TiffEntry {
    std::uint16_t type = 0;
    std::uint64_t count = 0;
    /// Of the entry's value, or of what stands in its place.
    std::uint64_t place = 0;
};

class TiffReader {
public:
    explicit TiffReader(std::istream& file) : file_(&file) {
        const std::string order = text(0, 2);
        if (order != "II" && order != "MM") throw Damaged{};
        big_endian_ = order == "MM";
        const std::uint64_t version = number(2, 2);
        if (version != 42 && version != 43) throw Damaged{};
        big_ = version == 43;
    }

    std::vector<TiffPage> pages() const {
        std::vector<TiffPage> pages;
        std::set<std::uint64_t> seen;
        for (std::uint64_t place = first_page_place(); place != 0;) {
            if (pages.size() == max_pages || !seen.insert(place).second) throw Damaged{};
            place = read_page(place, pages.emplace_back());
        }
        if (pages.empty()) throw Damaged{};
        return pages;
    }

    TiffPage first_page() const {
        TiffPage page;
        read_page(first_page_place(), page);
        return page;
    }

private:
    std::uint64_t first_page_place() const { return big_ ? number(8, 8) : number(4, 4); }

    std::string text(std::uint64_t place, std::uint64_t length) const {
        std::string bytes(length, '\0');
        file_->clear();
        file_->seekg(static_cast<std::streamoff>(place));
        if (!file_->read(bytes.data(), static_cast<std::streamsize>(length))) throw Damaged{};
        return bytes;
    }

    std::uint64_t number(std::uint64_t place, std::size_t length) const {
        const std::string bytes = text(place, length);
        std::uint64_t value = 0;
        for (std::size_t index = 0; index < length; ++index)
            value = value << 8 | static_cast<unsigned char>(bytes[big_endian_ ? index : length - 1 - index]);
        return value;
    }

    /// Bytes of a value of an unsigned type, or of text; 0 of the others, which no tag looked at has.
    static std::size_t bytes_of(std::uint16_t type) {
        constexpr std::array<std::size_t, 19> bytes{0, 1, 1, 2, 4, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 8, 0, 8};
        return type < bytes.size() ? bytes[type] : 0;
    }

    /// Where the next one stands.
    std::uint64_t read_page(std::uint64_t place, TiffPage& page) const {
        const std::uint64_t count_bytes = big_ ? 8 : 2;
        const std::uint64_t entry_bytes = big_ ? 20 : 12;
        const std::uint64_t count = number(place, count_bytes);
        if (count > 65535) throw Damaged{};
        std::map<std::uint64_t, TiffEntry> entries;
        std::uint64_t at = place + count_bytes;
        for (std::uint64_t index = 0; index < count; ++index, at += entry_bytes) {
            TiffEntry entry;
            entry.type = static_cast<std::uint16_t>(number(at + 2, 2));
            entry.count = number(at + 4, big_ ? 8 : 4);
            entry.place = at + (big_ ? 12 : 8);
            const std::uint64_t inside = big_ ? 8 : 4;
            if (const std::size_t each = bytes_of(entry.type); each != 0 && entry.count > inside / each)
                entry.place = number(entry.place, inside);
            entries.emplace(number(at, 2), entry);  // of a tag that stands twice, the first, as libtiff has it
        }
        read_entries(entries, page);
        return number(at, big_ ? 8 : 4);
    }

    void read_entries(const std::map<std::uint64_t, TiffEntry>& entries, TiffPage& page) const {
        for (const auto& [tag, entry] : entries) {
            switch (tag) {
                case new_subfile_type: {
                    constexpr std::uint64_t smaller_copy = 1;
                    constexpr std::uint64_t mask = 4;
                    page.is_auxiliary = (numbers(entry).front() & (smaller_copy | mask)) != 0;
                    break;
                }
                case bits_per_sample:
                    page.bits = numbers(entry);
                    break;
                case photometric_interpretation:
                    page.photometric = numbers(entry).front();
                    page.photometric_place = entry.place + (big_endian_ ? bytes_of(entry.type) - 1 : 0);
                    break;
                case orientation_tag:
                    page.orientation = numbers(entry).front();
                    break;
                case sample_format:
                    page.formats = numbers(entry);
                    break;
                case gdal_nodata:
                    read_nodata(entry, page);
                    break;
                default:
                    break;
            }
        }
    }

    std::vector<std::uint64_t> numbers(const TiffEntry& entry) const {
        const std::size_t each = bytes_of(entry.type);
        if (each == 0 || entry.count == 0 || entry.count > max_numbers) throw Damaged{};
        std::vector<std::uint64_t> values;
        for (std::uint64_t index = 0; index < entry.count; ++index)
            values.push_back(number(entry.place + index * each, each));
        return values;
    }

    /// GDAL writes the number in words; older ones on Windows, NaN as the C library there did.
    void read_nodata(const TiffEntry& entry, TiffPage& page) const {
        constexpr std::uint16_t ascii = 2;
        constexpr std::uint64_t longest_number = 256;
        if (entry.type != ascii || entry.count == 0 || entry.count > longest_number) throw Damaged{};
        std::string words = text(entry.place, entry.count);
        words.resize(std::min(words.find('\0'), words.size()));
        words.erase(0, words.find_first_not_of(" +"));
        words.resize(words.find_last_not_of(' ') + 1);
        if (words.empty() || words.find("#QNAN") != std::string::npos || words.find("#IND") != std::string::npos)
            return;
        const auto value = whole_text_as<double>(words);
        if (!value) {
            page.unread_nodata = words;
        } else if (!std::isnan(*value)) {
            page.nodata = value;
        }
    }

    std::istream* file_;
    bool big_endian_ = false;
    /// BigTIFF: places and counts of 64 bits.
    bool big_ = false;
};

bool all_equal(const std::vector<std::uint64_t>& values) {
    return std::ranges::all_of(values, [&](std::uint64_t value) { return value == values.front(); });
}

const char* kind_of_numbers(std::uint64_t format) {
    constexpr std::array names{"integers", "integers", "signed integers", "floating-point numbers", "integers"};
    return format < names.size() ? names[format] : "complex numbers";
}

bool is_readable(std::uint64_t format, std::uint64_t bits) {
    constexpr std::array<std::uint64_t, 9> unsigned_bits{1, 2, 4, 8, 10, 12, 14, 16, 32};
    switch (format) {
        case 2:
            return bits == 8 || bits == 16 || bits == 32;
        case 3:
            return bits == 16 || bits == 32;
        default:
            return format <= 4 && std::ranges::find(unsigned_bits, bits) != unsigned_bits.end();
    }
}

}  // namespace

std::vector<TiffPage> read_tiff_pages(std::istream& file, const std::filesystem::path& path) {
    try {
        return TiffReader(file).pages();
    } catch (const Damaged&) {
        fail("cannot read image '{}': its TIFF directory is damaged or cut short", path.string());
    }
}

void check_tiff_page(const TiffPage& page, const std::filesystem::path& path) {
    if (!all_equal(page.bits) || !all_equal(page.formats)) {
        fail("cannot read image '{}': its samples differ in their bits or their format; save it with all alike",
             path.string());
    }
    const std::uint64_t bits = page.bits.front();
    const std::uint64_t format = page.formats.front();
    if (!is_readable(format, bits)) {
        fail("cannot read image '{}': {} of {} bits are not read; save it as 8- or 16-bit integers or 32-bit floats",
             path.string(), kind_of_numbers(format), bits);
    }
    constexpr std::uint64_t white_is_zero = 0;
    constexpr std::uint64_t black_is_zero = 1;
    constexpr std::uint64_t rgb = 2;
    constexpr std::uint64_t ycbcr = 6;
    const std::uint64_t photometric = page.photometric.value_or(black_is_zero);
    if (photometric != white_is_zero && photometric != black_is_zero && photometric != rgb && photometric != ycbcr) {
        fail("cannot read image '{}': its PhotometricInterpretation {} is neither grey nor RGB; convert it",
             path.string(), photometric);
    }
    if (photometric == ycbcr && (bits != 8 || format == 3 || page.orientation != 1)) {
        fail("cannot read image '{}': YCbCr is read with 8 bits and no orientation only; save it as RGB",
             path.string());
    }
}

int exif_orientation(std::string_view block) {
    std::istringstream file{std::string(block)};
    try {
        const std::uint64_t orientation = TiffReader(file).first_page().orientation;
        return orientation >= 1 && orientation <= 8 ? static_cast<int>(orientation) : 1;
    } catch (const Damaged&) {
        return 1;
    }
}

}  // namespace reliefbench
