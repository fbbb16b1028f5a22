#include "picture/text.hpp"

#include <stb_truetype.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

/// The font file, which the linker put into the program (harness/CMakeLists.txt).
extern "C" const unsigned char _binary_font_ttf_start[];

namespace reliefbench {

namespace {

/// Of valid UTF-8; what is not comes out as other letters.
std::vector<int> code_points(const std::string& text) {
    std::vector<int> points;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool continues = (byte & 0xC0U) == 0x80U;
        if (continues && !points.empty()) {
            points.back() = points.back() << 6 | (byte & 0x3F);
        } else if (byte < 0x80) {
            points.push_back(byte);
        } else {
            points.push_back(byte & (byte < 0xE0 ? 0x1F : byte < 0xF0 ? 0x0F : 0x07));
        }
    }
    return points;
}

void blend(Rgb8& below, const Rgb8& colour, unsigned char opacity) {
    for (std::size_t channel = 0; channel < below.size(); ++channel) {
        const int mixed = (colour[channel] * opacity + below[channel] * (255 - opacity) + 127) / 255;
        below[channel] = static_cast<std::uint8_t>(mixed);
    }
}

}  // namespace

struct Font::Face {
    stbtt_fontinfo info{};
    int ascent = 0;
    int line_units = 0;

    float scale(int size) const { return stbtt_ScaleForPixelHeight(&info, static_cast<float>(size)); }

    /// Calls draw(code point, pen position in pixels) for each letter; where the pen ends.
    template <typename Draw>
    float walk(const std::string& text, int size, const Draw& draw) const {
        const std::vector<int> points = code_points(text);
        float pen = 0;
        for (std::size_t at = 0; at < points.size(); ++at) {
            draw(points[at], pen);
            int advance = 0;
            stbtt_GetCodepointHMetrics(&info, points[at], &advance, nullptr);
            const int kerning =
                at + 1 < points.size() ? stbtt_GetCodepointKernAdvance(&info, points[at], points[at + 1]) : 0;
            pen += scale(size) * static_cast<float>(advance + kerning);
        }
        return pen;
    }
};

Font::Font() : face_(std::make_unique<Face>()) {
    [[maybe_unused]] const int loaded = stbtt_InitFont(&face_->info, _binary_font_ttf_start, 0);
    assert(loaded != 0);
    int descent = 0;
    int gap = 0;
    stbtt_GetFontVMetrics(&face_->info, &face_->ascent, &descent, &gap);
    face_->line_units = face_->ascent - descent + gap;
}

Font::~Font() = default;

int Font::line_height(int size) const {
    return static_cast<int>(std::ceil(face_->scale(size) * static_cast<float>(face_->line_units)));
}

int Font::width(const std::string& text, int size) const {
    return static_cast<int>(std::ceil(face_->walk(text, size, [](int, float) {})));
}

void Font::draw(Picture& picture, int left, int top, const std::string& text, int size, const Rgb8& colour) const {
    const float scale = face_->scale(size);
    const int baseline = top + static_cast<int>(std::lround(scale * static_cast<float>(face_->ascent)));
    face_->walk(text, size, [&](int point, float pen) {
        const float whole = std::floor(pen);
        Resolution box;
        int offset_x = 0;
        int offset_y = 0;
        const std::unique_ptr<unsigned char, void (*)(unsigned char*)> opacity(
            stbtt_GetCodepointBitmapSubpixel(&face_->info, scale, scale, pen - whole, 0, point, &box.width, &box.height,
                                             &offset_x, &offset_y),
            [](unsigned char* bitmap) { stbtt_FreeBitmap(bitmap, nullptr); });
        for (int row = 0; row < box.height; ++row) {
            for (int column = 0; column < box.width; ++column) {
                const int x = left + static_cast<int>(whole) + offset_x + column;
                const int y = baseline + offset_y + row;
                if (x < 0 || y < 0 || x >= picture.size.width || y >= picture.size.height) continue;
                blend(picture.at(x, y), colour, opacity.get()[row * box.width + column]);
            }
        }
    });
}

std::string Font::shortened(const std::string& text, int size, int most) const {
    const std::string ellipsis = "…";
    if (width(text, size) <= most) return text;
    std::string start = text;
    while (!start.empty() && width(start + ellipsis, size) > most) {
        // A letter's last byte, and those of one letter that it continues.
        while (start.size() > 1 && (static_cast<unsigned char>(start.back()) & 0xC0U) == 0x80U) {
            start.pop_back();
        }
        start.pop_back();
    }
    return start + ellipsis;
}

}  // namespace reliefbench
