#include "metrics/image_errors.hpp"

#include "core/parallel.hpp"
#include "metrics/flip.hpp"
#include "metrics/ssim.hpp"
#include "metrics/window.hpp"
#include "scene/colour.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace reliefbench {

namespace {

using Colours = Image<std::array<float, 3>>;
using Mask = Image<std::uint8_t>;
constexpr std::size_t channels = 3;

Mask covered_by_either(const HitImage& first, const HitImage& second) {
    Mask mask(first.size);
    for (std::size_t pixel = 0; pixel < mask.texels.size(); ++pixel) {
        mask.texels[pixel] = first.texels[pixel].is_hit() || second.texels[pixel].is_hit() ? 1 : 0;
    }
    return mask;
}

/// One channel, encoded to sRGB.
Image<double> encoded_channel(const Colours& linear, std::size_t channel) {
    constexpr std::size_t pixels_at_once = 1 << 14;
    Image<double> encoded(linear.size);
    parallel_for(linear.texels.size(), pixels_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
            encoded.texels[pixel] = srgb_encode(linear.texels[pixel][channel]);
        }
    });
    return encoded;
}

/// On sRGB-encoded values, pixel by pixel: squared differences and structural similarity, means of the channels.
struct EncodedMaps {
    Image<double> squares;
    Image<double> ssim;
};

/// Channel by channel, so that few images are in memory at once.
EncodedMaps encoded_maps(const Colours& first, const Colours& second) {
    EncodedMaps maps{Image<double>(first.size), Image<double>(first.size)};
    for (std::size_t channel = 0; channel < channels; ++channel) {
        const Image<double> encoded_first = encoded_channel(first, channel);
        const Image<double> encoded_second = encoded_channel(second, channel);
        const Image<double> ssim = ssim_map(encoded_first, encoded_second);
        for (std::size_t pixel = 0; pixel < first.texels.size(); ++pixel) {
            const double difference = encoded_first.texels[pixel] - encoded_second.texels[pixel];
            maps.squares.texels[pixel] += difference * difference / channels;
            maps.ssim.texels[pixel] += ssim.texels[pixel] / channels;
        }
    }
    return maps;
}

template <typename Value>
double mean_over(const Mask& mask, std::size_t pixels, const Image<Value>& map) {
    double sum = 0;
    for (std::size_t pixel = 0; pixel < mask.texels.size(); ++pixel) {
        if (mask.texels[pixel] != 0) sum += map.texels[pixel];
    }
    return sum / static_cast<double>(pixels);
}

/// Of a window of both pictures, over the mask of that window.
ImageErrors errors_over(const Mask& mask, const EncodedMaps& encoded, const Image<float>& flip) {
    const auto outside = static_cast<std::size_t>(std::count(mask.texels.begin(), mask.texels.end(), 0));
    const std::size_t pixels = mask.texels.size() - outside;
    ImageErrors errors;
    if (pixels == 0) return errors;
    errors.rmse = std::sqrt(mean_over(mask, pixels, encoded.squares));
    if (*errors.rmse > 0) errors.psnr = -20 * std::log10(*errors.rmse);
    errors.ssim = mean_over(mask, pixels, encoded.ssim);
    errors.flip = mean_over(mask, pixels, flip);
    return errors;
}

/// All that the errors in the pixels of a mask depend on: no filter of theirs reaches beyond this window.
Window needed_for(const Mask& mask) {
    return window_around(mask, std::max(flip_reach(), ssim_reach));
}

Mask either(Mask first, const Mask& second) {
    std::transform(first.texels.begin(), first.texels.end(), second.texels.begin(), first.texels.begin(),
                   [](std::uint8_t a, std::uint8_t b) { return a != 0 || b != 0 ? 1 : 0; });
    return first;
}

/// Pictures with the background outside F, as far as the errors over F depend on them.
struct FootprintPictures {
    Window window;
    Mask inside;
    Colours technique;
    Colours truth;
};

FootprintPictures footprint_pictures(const Colours& technique, const Colours& truth, const Footprint& footprint) {
    const Window window = needed_for(footprint.inside);
    FootprintPictures pictures{window, part_of(footprint.inside, window), part_of(technique, window),
                               part_of(truth, window)};
    for (Colours* picture : {&pictures.technique, &pictures.truth}) {
        set_background_outside(*picture, {pictures.inside, footprint.background});
    }
    return pictures;
}

/// As large as the whole picture, with `part` in the pixels of F.
template <typename Value>
Image<float> spread(const Image<Value>& part, const Footprint& footprint, const Window& window) {
    Image<float> map(footprint.inside.size, std::numeric_limits<float>::quiet_NaN());
    for (int y = 0; y < window.size.height; ++y) {
        for (int x = 0; x < window.size.width; ++x) {
            if (footprint.inside.at(window.left + x, window.top + y) == 0) continue;
            map.at(window.left + x, window.top + y) = static_cast<float>(part.at(x, y));
        }
    }
    return map;
}

/// Over no pixel an error is undefined, not missing.
template <auto Part, auto Member>
std::optional<double> error_of(const ImageComparison& comparison) {
    return (comparison.*Part.*Member).value_or(std::numeric_limits<double>::quiet_NaN());
}

FigureDeclaration of_picture(std::string path, std::string label, std::string unit, Better better) {
    return {.path = std::move(path),
            .label = std::move(label),
            .unit = std::move(unit),
            .better = better,
            .needs = {std::string(figure_needs::truth), std::string(figure_needs::lighting)}};
}

/// A PSNR that is null has no error beside it.
FigureDeclaration psnr_figure(std::string path, std::string label, std::string rmse) {
    FigureDeclaration figure = of_picture(std::move(path), std::move(label), "dB", Better::higher);
    figure.infinite_at_zero = std::move(rmse);
    return figure;
}

/// Runs of version 0.1.0 have figures of the whole picture only.
FigureDeclaration over_footprint(FigureDeclaration figure, std::string of_whole) {
    figure.stand_in = std::move(of_whole);
    return figure;
}

const std::vector<FigureOf<ImageComparison>>& image_error_table() {
    constexpr Better lower = Better::lower;
    constexpr Better higher = Better::higher;
    constexpr auto whole = &ImageComparison::whole;
    constexpr auto footprint = &ImageComparison::footprint;
    using Errors = ImageErrors;
    static const std::vector<FigureOf<ImageComparison>> table = {
        {in_short(of_picture("image.flip", "FLIP, whole picture", "", lower), "flip", "0 to 1, of the whole picture"),
         error_of<whole, &Errors::flip>},
        {psnr_figure("image.psnr", "PSNR, whole picture", "image.rmse"), error_of<whole, &Errors::psnr>},
        {of_picture("image.ssim", "SSIM, whole picture", "", higher), error_of<whole, &Errors::ssim>},
        {of_picture("image.rmse", "RMSE, whole picture", "", lower), error_of<whole, &Errors::rmse>},
        {in_short(over_footprint(of_picture("image.footprint.flip", "FLIP, footprint", "", lower), "image.flip"),
                  "flip", "0 to 1, over the footprint"),
         error_of<footprint, &Errors::flip>},
        {over_footprint(psnr_figure("image.footprint.psnr", "PSNR, footprint", "image.footprint.rmse"), "image.psnr"),
         error_of<footprint, &Errors::psnr>},
        {over_footprint(of_picture("image.footprint.ssim", "SSIM, footprint", "", higher), "image.ssim"),
         error_of<footprint, &Errors::ssim>},
        {over_footprint(of_picture("image.footprint.rmse", "RMSE, footprint", "", lower), "image.rmse"),
         error_of<footprint, &Errors::rmse>},
    };
    return table;
}

}  // namespace

ImageComparison compare_images(const Colours& technique, const HitImage& technique_hits, const Colours& truth,
                               const HitImage& truth_hits, const Footprint& footprint) {
    assert(technique.size == truth.size && technique_hits.size == truth.size && truth_hits.size == truth.size);
    const Mask covered = covered_by_either(technique_hits, truth_hits);
    // Where both show nothing but the background outside F, they are F's pictures: one set of maps serves both means.
    const bool as_footprint = is_background_outside(technique, footprint) && is_background_outside(truth, footprint);
    const Window window = needed_for(as_footprint ? either(covered, footprint.inside) : covered);
    const Colours technique_part = part_of(technique, window);
    const Colours truth_part = part_of(truth, window);
    const EncodedMaps encoded = encoded_maps(technique_part, truth_part);
    const Image<float> flip = flip_map(technique_part, truth_part);
    ImageComparison comparison;
    comparison.whole = errors_over(part_of(covered, window), encoded, flip);
    if (as_footprint) {
        comparison.footprint = errors_over(part_of(footprint.inside, window), encoded, flip);
    } else {
        const FootprintPictures pictures = footprint_pictures(technique, truth, footprint);
        comparison.footprint = errors_over(pictures.inside, encoded_maps(pictures.technique, pictures.truth),
                                           flip_map(pictures.technique, pictures.truth));
    }
    return comparison;
}

std::vector<FigureDeclaration> image_error_figures() {
    return declarations_in(image_error_table());
}

FigureValueList figures_of(const ImageComparison& comparison) {
    return values_in(image_error_table(), comparison);
}

Image<float> footprint_flip_map(const Colours& technique, const Colours& truth, const Footprint& footprint) {
    const FootprintPictures pictures = footprint_pictures(technique, truth, footprint);
    return spread(flip_map(pictures.technique, pictures.truth), footprint, pictures.window);
}

Image<float> footprint_ssim_map(const Colours& technique, const Colours& truth, const Footprint& footprint) {
    const FootprintPictures pictures = footprint_pictures(technique, truth, footprint);
    return spread(encoded_maps(pictures.technique, pictures.truth).ssim, footprint, pictures.window);
}

}  // namespace reliefbench
