#include "picture/map_picture.hpp"

#include "picture/colour_map.hpp"
#include "picture/style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace reliefbench {

namespace {

constexpr Rgb8 missed_colour{26, 89, 255};
constexpr Rgb8 missed_outside_colour{0, 191, 217};
constexpr Rgb8 false_hit_colour{26, 204, 51};
constexpr Rgb8 tie_colour{150, 110, 60};
constexpr Rgb8 nothing_colour{77, 77, 77};
constexpr Rgb8 both_colour{225, 225, 225};

constexpr int narrowest_legend = 150;
constexpr int bar_height = 10;
constexpr int mark_height = 3;
constexpr int swatch_side = 9;
constexpr int gap = 4;

Rgb8 colour_of(Coverage coverage) {
    switch (coverage) {
        case Coverage::missed:
            return missed_colour;
        case Coverage::missed_outside:
            return missed_outside_colour;
        case Coverage::false_hit:
            return false_hit_colour;
        case Coverage::tie:
            return tie_colour;
        case Coverage::both:
            return both_colour;
        case Coverage::neither:
            break;
    }
    return nothing_colour;
}

/// Lines of swatches, none wider than `width` where that can be.
std::vector<std::vector<Swatch>> in_lines(const std::vector<Swatch>& swatches, int width, const Font& font) {
    std::vector<std::vector<Swatch>> lines;
    int left = 0;
    for (const Swatch& swatch : swatches) {
        const int needed = swatch_side + gap + font.width(swatch.text, style::small_text) + 2 * gap;
        if (lines.empty() || left + needed > width + 2 * gap) {
            lines.emplace_back();
            left = 0;
        }
        lines.back().push_back(swatch);
        left += needed;
    }
    return lines;
}

void draw_bar(Picture& picture, int top, const PixelMapScale& scale, const Font& font) {
    const int width = picture.size.width;
    for (int x = 0; x < width; ++x) {
        fill(picture, {x, top, {1, bar_height}}, to_rgb8(magma(x / (width - 1.0))));
    }
    for (const double mark : scale.marks) {
        const int x = static_cast<int>(std::lround(scale.position(mark) * (width - 1)));
        fill(picture, {x, top + bar_height, {1, mark_height}}, style::ink);
        const std::string number = fmt::format("{:.6g}", mark);
        const int number_width = font.width(number, style::small_text);
        const int left = std::clamp(x - number_width / 2, 0, width - number_width);
        font.draw(picture, left, top + bar_height + mark_height, number, style::small_text, style::ink);
    }
}

}  // namespace

Picture map_picture(const PixelMapScale& scale, const Image<float>& values, const Image<Coverage>& coverage) {
    assert(values.size == coverage.size);
    const bool by_coverage = scale.undefined == PixelMapScale::Undefined::coverage;
    Picture picture(values.size);
    for (std::size_t pixel = 0; pixel < values.texels.size(); ++pixel) {
        const float value = values.texels[pixel];
        const bool is_tie = by_coverage && coverage.texels[pixel] == Coverage::tie;
        if (!scale.marks.empty() && std::isfinite(value) && !is_tie) {
            picture.texels[pixel] = to_rgb8(magma(scale.position(value)));
        } else {
            // Undefined though both hit: on another chart, where coordinates are no more an error than in a tie.
            const bool is_off_chart = !scale.marks.empty() && coverage.texels[pixel] == Coverage::both;
            picture.texels[pixel] = !by_coverage   ? nothing_colour
                                    : is_off_chart ? tie_colour
                                                   : colour_of(coverage.texels[pixel]);
        }
    }
    return picture;
}

std::vector<Swatch> swatches_of(const PixelMapScale& scale) {
    std::vector<Swatch> swatches;
    if (scale.map == PixelMap::coverage) swatches.push_back({both_colour, "hit in both"});
    if (scale.undefined == PixelMapScale::Undefined::coverage) {
        swatches.push_back({missed_colour, "missed"});
        swatches.push_back({false_hit_colour, "false hit"});
        swatches.push_back({missed_outside_colour, "relief outside the base"});
        swatches.push_back({tie_colour, "tie"});
    }
    const bool outside = scale.undefined == PixelMapScale::Undefined::outside;
    swatches.push_back({nothing_colour, outside ? "outside the footprint" : "nothing"});
    return swatches;
}

Picture legend(const PixelMapScale& scale, int width, const Font& font) {
    width = std::max(width, narrowest_legend);
    const int line = font.line_height(style::small_text);
    const std::vector<std::vector<Swatch>> lines = in_lines(swatches_of(scale), width, font);
    const int bar = scale.marks.empty() ? 0 : bar_height + mark_height + line;
    Picture picture({width, line + bar + static_cast<int>(lines.size()) * line}, style::paper);

    const std::string title = scale.unit.empty() ? scale.title : fmt::format("{}, {}", scale.title, scale.unit);
    font.draw(picture, 0, 0, title, style::small_text, style::ink);
    if (!scale.marks.empty()) draw_bar(picture, line, scale, font);
    int top = line + bar;
    for (const std::vector<Swatch>& swatches : lines) {
        int left = 0;
        for (const auto& [colour, text] : swatches) {
            fill(picture, {left, top + (line - swatch_side) / 2, {swatch_side, swatch_side}}, colour);
            left += swatch_side + gap;
            font.draw(picture, left, top, text, style::small_text, style::ink);
            left += font.width(text, style::small_text) + 2 * gap;
        }
        top += line;
    }
    return picture;
}

}  // namespace reliefbench
