#include "measure/pictures.hpp"

#include "metrics/hit_errors.hpp"
#include "scene/colour.hpp"
#include "scene/colour_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace reliefbench {

namespace {

constexpr double smallest_error_texels = 0.01;
constexpr double largest_error_texels = 10;
constexpr std::array<float, 3> missed_colour{0.1F, 0.35F, 1.0F};
constexpr std::array<float, 3> outside_quad_colour{0.0F, 0.75F, 0.85F};
constexpr std::array<float, 3> false_hit_colour{0.1F, 0.8F, 0.2F};
constexpr std::array<float, 3> nothing_colour{0.3F, 0.3F, 0.3F};
constexpr std::array<float, 3> separator_colour{1.0F, 1.0F, 1.0F};
constexpr int separator_width = 2;

RasterFile rgb_raster(Resolution size) {
    RasterFile raster;
    raster.size = size;
    raster.channel_names = {"R", "G", "B"};
    raster.values.resize(size.pixels() * 3);
    raster.bits = 8;
    return raster;
}

void set_pixel(RasterFile& raster, std::size_t pixel, const std::array<float, 3>& colour) {
    std::copy(colour.begin(), colour.end(), raster.values.begin() + static_cast<std::ptrdiff_t>(pixel * 3));
}

std::array<float, 3> error_colour(double error_texels) {
    const double decades = std::log10(largest_error_texels / smallest_error_texels);
    const double position = std::log10(std::max(error_texels, smallest_error_texels) / smallest_error_texels) / decades;
    const std::array<double, 3> colour = magma(position);
    return {static_cast<float>(colour[0]), static_cast<float>(colour[1]), static_cast<float>(colour[2])};
}

}  // namespace

RasterFile display_picture(const Image<std::array<float, 3>>& linear) {
    RasterFile raster = rgb_raster(linear.size);
    for (std::size_t pixel = 0; pixel < linear.texels.size(); ++pixel) {
        std::array<float, 3> encoded{};
        std::transform(linear.texels[pixel].begin(), linear.texels[pixel].end(), encoded.begin(),
                       [](float channel) { return static_cast<float>(srgb_encode(channel)); });
        set_pixel(raster, pixel, encoded);
    }
    return raster;
}

RasterFile error_picture(const HitImage& hits, const Truth& truth, const HeightMap& map, const Relief& relief) {
    const Image<float> errors = uv_error_map(hits, truth.hits, map, relief);
    RasterFile raster = rgb_raster(hits.size);
    for (std::size_t pixel = 0; pixel < hits.texels.size(); ++pixel) {
        const bool hit = hits.texels[pixel].is_hit();
        const bool truth_hit = truth.hits.texels[pixel].is_hit();
        if (hit && truth_hit) {
            set_pixel(raster, pixel, error_colour(errors.texels[pixel]));
        } else if (truth_hit) {
            set_pixel(raster, pixel, truth.footprint.texels[pixel] != 0 ? missed_colour : outside_quad_colour);
        } else {
            set_pixel(raster, pixel, hit ? false_hit_colour : nothing_colour);
        }
    }
    return raster;
}

RasterFile layers(const Probe& probe, const Truth& truth) {
    RasterFile raster;
    raster.size = probe.hits.size;
    raster.bits = 32;
    raster.channel_names = {"hit.u",   "hit.v",   "hit.h",         "hit.t",         "taps",
                            "truth.u", "truth.v", "truth.h",       "truth.t",       "color.R",
                            "color.G", "color.B", "truth_color.R", "truth_color.G", "truth_color.B"};
    const auto covered = std::count_if(probe.covered.texels.begin(), probe.covered.texels.end(),
                                       [](std::uint8_t value) { return value != 0; });
    const float stage_taps = covered > 0 ? static_cast<float>(probe.stages.taps) / static_cast<float>(covered) : 0;
    for (std::size_t pixel = 0; pixel < raster.size.pixels(); ++pixel) {
        const Hit& hit = probe.hits.texels[pixel];
        const Hit& truth_hit = truth.hits.texels[pixel];
        const std::array<float, 3>& colour = probe.colour.texels[pixel];
        const std::array<float, 3>& truth_colour = truth.colour.texels[pixel];
        const float taps =
            static_cast<float>(probe.work.texels[pixel].taps) + (probe.covered.texels[pixel] != 0 ? stage_taps : 0.0F);
        raster.values.insert(raster.values.end(),
                             {hit.u, hit.v, hit.h, hit.t, taps, truth_hit.u, truth_hit.v, truth_hit.h, truth_hit.t,
                              colour[0], colour[1], colour[2], truth_colour[0], truth_colour[1], truth_colour[2]});
    }
    return raster;
}

RasterFile side_by_side(const std::vector<RasterFile>& pictures) {
    assert(!pictures.empty());
    const int height = pictures.front().size.height;
    int width = separator_width * (static_cast<int>(pictures.size()) - 1);
    for (const RasterFile& picture : pictures) {
        assert(picture.size.height == height && picture.channels() == 3);
        width += picture.size.width;
    }
    RasterFile joined = rgb_raster({width, height});
    for (std::size_t pixel = 0; pixel < joined.size.pixels(); ++pixel) {
        set_pixel(joined, pixel, separator_colour);
    }
    std::ptrdiff_t left = 0;
    for (const RasterFile& picture : pictures) {
        const std::ptrdiff_t row_values = std::ptrdiff_t{3} * picture.size.width;
        for (std::ptrdiff_t row = 0; row < height; ++row) {
            std::copy_n(picture.values.begin() + row * row_values, row_values,
                        joined.values.begin() + (row * width + left) * 3);
        }
        left += picture.size.width + separator_width;
    }
    return joined;
}

}  // namespace reliefbench
