#include "scene/png_tags.hpp"

#include "scene/tiff_tags.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace reliefbench {

namespace {

/// "" where the file ends before.
std::string next_bytes(std::istream& file, std::size_t count) {
    std::string bytes(count, '\0');
    return file.read(bytes.data(), static_cast<std::streamsize>(count)) ? bytes : std::string();
}

std::uint32_t big_endian_number(std::string_view bytes) {
    std::uint32_t number = 0;
    for (const char byte : bytes)
        number = number << 8 | static_cast<unsigned char>(byte);
    return number;
}

}  // namespace

PngTags read_png_tags(std::istream& file) {
    PngTags tags;
    constexpr std::uint32_t longest_exif = 65536;
    constexpr std::uint32_t header_length = 13;
    file.seekg(static_cast<std::streamoff>(png_magic.size()));
    // A chunk is a length, a name, so many bytes and a checksum: https://www.w3.org/TR/png-3/#5Chunk-layout
    for (std::string begin = next_bytes(file, 8); !begin.empty(); begin = next_bytes(file, 8)) {
        const std::uint32_t length = big_endian_number(begin.substr(0, 4));
        const std::string_view name = std::string_view(begin).substr(4);
        if (name == "IEND") break;
        if (name == "tRNS") tags.has_transparent_colour = true;
        const bool is_read = (name == "IHDR" && length == header_length) || (name == "eXIf" && length <= longest_exif);
        if (!is_read) {
            file.seekg(std::streamoff{length} + 4, std::ios::cur);
            continue;
        }
        const std::string content = next_bytes(file, length);
        if (content.empty()) break;
        constexpr char palette = 3;
        if (name == "IHDR" && content[9] != palette) tags.bits = content[8];
        if (name == "eXIf") tags.orientation = exif_orientation(content);
        file.seekg(4, std::ios::cur);
    }
    return tags;
}

}  // namespace reliefbench
