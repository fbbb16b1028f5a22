#include "picture/picture.hpp"

#include "scene/colour.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace reliefbench {

Rgb8 to_rgb8(const std::array<double, 3>& encoded) {
    Rgb8 colour{};
    std::transform(encoded.begin(), encoded.end(), colour.begin(), [](double channel) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(channel, 0.0, 1.0)));
    });
    return colour;
}

Picture display_picture(const Image<std::array<float, 3>>& linear) {
    Picture picture(linear.size);
    std::transform(linear.texels.begin(), linear.texels.end(), picture.texels.begin(),
                   [](const std::array<float, 3>& colour) {
                       return to_rgb8({srgb_encode(colour[0]), srgb_encode(colour[1]), srgb_encode(colour[2])});
                   });
    return picture;
}

Picture cropped(const Picture& picture, const Rectangle& part) {
    Picture result(part.size);
    for (int y = 0; y < part.size.height; ++y) {
        for (int x = 0; x < part.size.width; ++x) {
            result.at(x, y) = picture.at(part.left + x, part.top + y);
        }
    }
    return result;
}

void fill(Picture& picture, const Rectangle& area, const Rgb8& colour) {
    const int right = std::min(picture.size.width, area.left + area.size.width);
    const int bottom = std::min(picture.size.height, area.top + area.size.height);
    for (int y = std::max(0, area.top); y < bottom; ++y) {
        for (int x = std::max(0, area.left); x < right; ++x) {
            picture.at(x, y) = colour;
        }
    }
}

void paste(Picture& picture, int left, int top, const Picture& part) {
    const int right = std::min(picture.size.width, left + part.size.width);
    const int bottom = std::min(picture.size.height, top + part.size.height);
    for (int y = std::max(0, top); y < bottom; ++y) {
        for (int x = std::max(0, left); x < right; ++x) {
            picture.at(x, y) = part.at(x - left, y - top);
        }
    }
}

RasterFile to_raster(const Picture& picture) {
    RasterFile raster;
    raster.size = picture.size;
    raster.channel_names = {"R", "G", "B"};
    raster.bits = 8;
    raster.values.reserve(picture.texels.size() * 3);
    for (const Rgb8& colour : picture.texels) {
        for (const std::uint8_t channel : colour) {
            raster.values.push_back(static_cast<float>(channel) / 255.0F);
        }
    }
    return raster;
}

}  // namespace reliefbench
