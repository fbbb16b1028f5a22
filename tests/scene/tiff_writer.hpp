#pragma once

#include "core/file.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace reliefbench {

/// A TIFF file of one strip and one page, put together by hand: what no library writes, and what reading is not checked
/// against.
struct HandmadeTiff {
    int width = 0;
    std::vector<std::int64_t> values;
    int bits = 16;
    /// 1 unsigned, 2 signed, 3 floating point, of which `values` are the bits.
    int format = 1;
    int photometric = 1;
    int channels = 1;
    bool big_endian = false;
    /// Tag to a number that fits into 16 bits.
    std::map<int, int> more = {};
    /// GDAL_NODATA; empty: none.
    std::string nodata = {};
};

inline std::string tiff_number(std::uint64_t number, int bytes, bool big_endian) {
    std::string text;
    for (int index = 0; index < bytes; ++index) {
        const int shift = 8 * (big_endian ? bytes - 1 - index : index);
        text += static_cast<char>(number >> shift & 0xff);
    }
    return text;
}

/// Rows begin with a byte; within, numbers of fewer bits than a byte, or of an odd number of them, follow each other
/// from the highest bit down.
inline std::string tiff_strip(const HandmadeTiff& tiff) {
    std::string strip;
    const auto row_values = static_cast<std::size_t>(tiff.width * tiff.channels);
    std::string bits;
    for (std::size_t index = 0; index < tiff.values.size(); ++index) {
        const auto value = static_cast<std::uint64_t>(tiff.values[index]);
        if (tiff.bits % 8 == 0) {
            strip += tiff_number(value, tiff.bits / 8, tiff.big_endian);
            continue;
        }
        for (int bit = tiff.bits - 1; bit >= 0; --bit)
            bits += static_cast<char>('0' + (value >> bit & 1));
        if ((index + 1) % row_values != 0) continue;
        bits.resize((bits.size() + 7) / 8 * 8, '0');
        for (std::size_t at = 0; at < bits.size(); at += 8)
            strip += static_cast<char>(std::stoi(bits.substr(at, 8), nullptr, 2));
        bits.clear();
    }
    return strip;
}

inline void write_handmade_tiff(const std::filesystem::path& path, const HandmadeTiff& tiff) {
    const std::string strip = tiff_strip(tiff);
    const auto rows = static_cast<int>(tiff.values.size()) / (tiff.width * tiff.channels);
    std::map<int, int> shorts{{256, tiff.width},       {257, rows},          {259, 1},
                              {262, tiff.photometric}, {277, tiff.channels}, {278, rows}};
    shorts.insert(tiff.more.begin(), tiff.more.end());
    constexpr std::size_t header = 8;
    const auto number = [&](std::uint64_t value, int bytes) { return tiff_number(value, bytes, tiff.big_endian); };
    const auto lists = static_cast<std::size_t>(2 * tiff.channels);
    const std::size_t entries = shorts.size() + 4 + (tiff.nodata.empty() ? 0 : 1);
    const std::size_t behind = header + 2 + 12 * entries + 4;
    // Behind the directory: bits, formats, the text of nodata, the strip.
    const std::size_t nodata_place = behind + 2 * lists;
    const std::size_t strip_place = nodata_place + tiff.nodata.size() + 1;
    const auto entry = [&](int tag, int type, std::size_t count, const std::string& value) {
        std::string four = value;
        four.resize(4, '\0');
        return number(static_cast<std::uint64_t>(tag), 2) + number(static_cast<std::uint64_t>(type), 2) +
               number(count, 4) + four;
    };
    const auto list = [&](int tag, std::size_t place, int value) {
        const auto count = static_cast<std::size_t>(tiff.channels);
        std::string inside;
        for (std::size_t index = 0; index < count; ++index)
            inside += number(static_cast<std::uint64_t>(value), 2);
        return entry(tag, 3, count, count > 2 ? number(place, 4) : inside);
    };
    std::map<int, std::string> directory;
    for (const auto& [tag, value] : shorts)
        directory[tag] = entry(tag, 3, 1, number(static_cast<std::uint64_t>(value), 2));
    directory[258] = list(258, behind, tiff.bits);
    directory[339] = list(339, behind + lists, tiff.format);
    directory[273] = entry(273, 4, 1, number(strip_place, 4));
    directory[279] = entry(279, 4, 1, number(strip.size(), 4));
    const std::string text = tiff.nodata + '\0';
    if (!tiff.nodata.empty())
        directory[42113] = entry(42113, 2, text.size(), text.size() > 4 ? number(nodata_place, 4) : text);

    std::string bytes = (tiff.big_endian ? "MM" : "II") + number(42, 2) + number(header, 4);
    bytes += number(directory.size(), 2);
    for (const auto& [tag, content] : directory)
        bytes += content;
    bytes += number(0, 4);
    for (int index = 0; index < tiff.channels; ++index)
        bytes += number(static_cast<std::uint64_t>(tiff.bits), 2);
    for (int index = 0; index < tiff.channels; ++index)
        bytes += number(static_cast<std::uint64_t>(tiff.format), 2);
    write_text_file(path, bytes + text + strip);
}

}  // namespace reliefbench
