#pragma once

#include <istream>
#include <string_view>

namespace reliefbench {

inline constexpr std::string_view png_magic = "\x89PNG\r\n\x1a\n";

/// What a PNG file says of its numbers, which decoders hand over stretched to 8 or 16 bits.
struct PngTags {
    /// Of a grey or colour value, 1 to 16; 8 of a palette's colours.
    int bits = 8;
    /// A colour (tRNS) is transparent, which makes a channel of alpha.
    bool has_transparent_colour = false;
    /// 1 to 8, of the eXIf chunk.
    int orientation = 1;
};

/// Of a file that begins with png_magic; what is damaged is left to the decoder.
PngTags read_png_tags(std::istream& file);

}  // namespace reliefbench
