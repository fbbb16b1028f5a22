#include "metrics/image_errors.hpp"

#include "metrics/flip.hpp"
#include "metrics/ssim.hpp"
#include "metrics/window.hpp"
#include "patterns.hpp"
#include "scene/colour.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace reliefbench;

namespace {

using Colour = std::array<float, 3>;

const Hit hit{0.5F, 0.5F, 0.5F, 1};
const Hit miss{};
/// The encoding of 1 is 1.055 − 0.055, which rounds.
constexpr double rounding = 1e-15;
const Colour black{0, 0, 0};
const Colour white{1, 1, 1};

template <typename Texel>
Image<Texel> row(const std::vector<Texel>& texels) {
    Image<Texel> image(Resolution{static_cast<int>(texels.size()), 1});
    image.texels = texels;
    return image;
}

/// Where all pixels are of the footprint.
ImageErrors compare_images(const Image<Colour>& technique, const HitImage& technique_hits, const Image<Colour>& truth,
                           const HitImage& truth_hits) {
    const Image<std::uint8_t> everywhere(truth.size, 1);
    return compare_images(technique, technique_hits, truth, truth_hits, {everywhere, black}).whole;
}

TEST(ImageErrors, IdenticalImagesHaveNoPsnr) {
    const auto image = row<Colour>({{0.25F, 0.5F, 0.75F}, white});
    const ImageErrors errors = compare_images(image, row<Hit>({hit, hit}), image, row<Hit>({hit, hit}));
    EXPECT_EQ(errors.rmse, 0.0);
    EXPECT_FALSE(errors.psnr);
    EXPECT_EQ(errors.flip, 0.0);
    EXPECT_NEAR(*errors.ssim, 1, rounding);
}

TEST(ImageErrors, ValuesAreComparedAsEncodedForTheScreen) {
    // Linear 0.21404114 is 0.5 in sRGB (IEC 61966-2-1): a difference of one half in every channel.
    const Colour middle{0.21404114F, 0.21404114F, 0.21404114F};
    const ImageErrors errors =
        compare_images(row<Colour>({middle}), row<Hit>({hit}), row<Colour>({black}), row<Hit>({hit}));
    EXPECT_NEAR(*errors.rmse, 0.5, 1e-7);  // the colour is a float
    EXPECT_NEAR(*errors.psnr, 6.0206, 1e-5);
}

TEST(ImageErrors, EveryChannelCounts) {
    const ImageErrors errors = compare_images(row<Colour>({{1, 0, 0}, {0, 0, 0}}), row<Hit>({hit, hit}),
                                              row<Colour>({black, black}), row<Hit>({hit, hit}));
    EXPECT_NEAR(*errors.rmse, std::sqrt(1.0 / 6), rounding);
}

TEST(ImageErrors, TheUnionOfBothCoveragesIsCompared) {
    // Covered by the technique, by the truth, by both, by none: the last pixel differs but does not count.
    const ImageErrors errors =
        compare_images(row<Colour>({white, black, white, white}), row<Hit>({hit, miss, hit, miss}),
                       row<Colour>({black, white, white, black}), row<Hit>({miss, hit, hit, miss}));
    EXPECT_NEAR(*errors.rmse, std::sqrt(2.0 / 3), rounding);
    EXPECT_NEAR(*errors.psnr, 10 * std::log10(1.5), 1e-12);
}

TEST(ImageErrors, FlipAndSsimAreMeansOverTheUnion) {
    const auto image = [](const Colour& left, const Colour& right) {
        Image<Colour> halves(Resolution{100, 8}, left);
        for (int y = 0; y < halves.size.height; ++y) {
            for (int x = halves.size.width / 2; x < halves.size.width; ++x) {
                halves.at(x, y) = right;
            }
        }
        return halves;
    };
    // The left edge alone is covered, too far from the right half for any filter: black against white there.
    HitImage coverage(Resolution{100, 8});
    for (int y = 0; y < coverage.size.height; ++y) {
        coverage.at(0, y) = hit;
    }
    const ImageErrors errors = compare_images(image(black, white), coverage, image(white, white), coverage);
    EXPECT_NEAR(*errors.flip, 0.967388, 5e-5);               // the authors' tool
    EXPECT_NEAR(*errors.ssim, 1e-4 / (1 + 1e-4), rounding);  // C1 / (1 + C1): no variance, means 0 and 1
}

TEST(ImageErrors, NothingCoveredIsUndefined) {
    const ImageErrors errors =
        compare_images(row<Colour>({white}), row<Hit>({miss}), row<Colour>({black}), row<Hit>({miss}));
    EXPECT_FALSE(errors.rmse);
    EXPECT_FALSE(errors.psnr);
    EXPECT_FALSE(errors.ssim);
    EXPECT_FALSE(errors.flip);
}

/// A slanted patch in the middle of Patterns.
struct PatchOfPatterns {
    static constexpr Colour background{0.02F, 0.02F, 0.03F};
    Patterns patterns;
    Image<std::uint8_t> inside{patterns.first.size};
    HitImage hits{patterns.first.size};

    PatchOfPatterns() {
        for (int y = 8; y < 22; ++y) {
            for (int x = 10 + y / 3; x < 28 + y / 2; ++x) {
                inside.at(x, y) = 1;
                hits.at(x, y) = hit;
            }
        }
    }

    ImageComparison compare() const {
        return reliefbench::compare_images(patterns.first, hits, patterns.second, hits, {inside, background});
    }
};

TEST(FootprintErrors, AreOfPicturesWithTheBackgroundAroundTheFootprintBeforeAnyFilter) {
    // In double: FLIP from the paper's equations with SciPy's direct convolution in two dimensions, SSIM by
    // scikit-image 0.19. Had the surroundings been left as they are, the means over F would be 0.484529 and 0.719053.
    const ImageErrors errors = PatchOfPatterns().compare().footprint;
    EXPECT_NEAR(*errors.flip, 0.45276841, 5e-6);
    EXPECT_NEAR(*errors.ssim, 0.74108654, 1e-7);
    EXPECT_NEAR(*errors.rmse, 0.28050946, 1e-7);
    EXPECT_NEAR(*errors.psnr, 11.0410499, 1e-5);
}

TEST(FootprintErrors, WhatLiesBeyondTheFootprintIsNoError) {
    // The same relief in F; beyond it the truth alone has more.
    PatchOfPatterns patch;
    patch.patterns.second = patch.patterns.first;
    HitImage truth_hits = patch.hits;
    for (std::size_t pixel = 0; pixel < patch.inside.texels.size(); ++pixel) {
        if (patch.inside.texels[pixel] != 0) continue;
        patch.patterns.first.texels[pixel] = PatchOfPatterns::background;
        truth_hits.texels[pixel] = hit;
    }
    const auto [whole, footprint] = reliefbench::compare_images(patch.patterns.first, patch.hits, patch.patterns.second,
                                                                truth_hits, {patch.inside, patch.background});
    EXPECT_GT(*whole.flip, 0.3);
    EXPECT_GT(*whole.rmse, 0.3);
    EXPECT_EQ(footprint.flip, 0.0);
    EXPECT_EQ(footprint.rmse, 0.0);
    EXPECT_FALSE(footprint.psnr);
    EXPECT_NEAR(*footprint.ssim, 1, rounding);
}

TEST(FootprintErrors, EachErrorIsTheMeanOfItsMapOverTheFootprint) {
    const PatchOfPatterns patch;
    const Footprint footprint{patch.inside, patch.background};
    const Image<float> flip = footprint_flip_map(patch.patterns.first, patch.patterns.second, footprint);
    const Image<float> ssim = footprint_ssim_map(patch.patterns.first, patch.patterns.second, footprint);
    double sum_of_flip = 0, sum_of_ssim = 0, pixels = 0;
    for (std::size_t pixel = 0; pixel < flip.texels.size(); ++pixel) {
        ASSERT_EQ(std::isnan(flip.texels[pixel]), patch.inside.texels[pixel] == 0);
        ASSERT_EQ(std::isnan(ssim.texels[pixel]), patch.inside.texels[pixel] == 0);
        if (patch.inside.texels[pixel] == 0) continue;
        sum_of_flip += flip.texels[pixel];
        sum_of_ssim += ssim.texels[pixel];
        ++pixels;
    }
    EXPECT_NEAR(*patch.compare().footprint.flip, sum_of_flip / pixels, 1e-12);
    EXPECT_NEAR(*patch.compare().footprint.ssim, sum_of_ssim / pixels, 1e-7);
}

TEST(FootprintErrors, AreThoseOfTheWholePictureWhereItShowsNothingElse) {
    PatchOfPatterns patch;
    set_background_outside(patch.patterns.first, {patch.inside, patch.background});
    set_background_outside(patch.patterns.second, {patch.inside, patch.background});
    const auto [whole, footprint] = patch.compare();
    EXPECT_EQ(whole.flip, footprint.flip);
    EXPECT_EQ(whole.ssim, footprint.ssim);
    EXPECT_EQ(whole.rmse, footprint.rmse);
    EXPECT_EQ(whole.psnr, footprint.psnr);
    EXPECT_NEAR(*footprint.flip, 0.45276841, 5e-6) << "as above";
}

TEST(FootprintErrors, NoFootprintHasNone) {
    PatchOfPatterns patch;
    patch.inside = Image<std::uint8_t>(patch.inside.size);
    const auto [whole, footprint] = patch.compare();
    EXPECT_TRUE(whole.flip);
    EXPECT_FALSE(footprint.flip || footprint.ssim || footprint.rmse || footprint.psnr);
}

TEST(FootprintErrors, PixelsBeyondTheFiltersReachChangeNothing) {
    // A small patch in a large picture, of which only the surroundings are filtered.
    const Resolution size{200, 150};
    Image<Colour> first(size), second(size);
    HitImage hits(size);
    Image<std::uint8_t> inside(size);
    const Patterns patterns;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            first.at(x, y) = patterns.first.at(x % 40, y % 30);
            second.at(x, y) = patterns.second.at(x % 40, y % 30);
            if (x < 90 || x >= 110 || y < 70 || y >= 77) continue;
            hits.at(x, y) = hit;
            inside.at(x, y) = 1;
        }
    }
    const ImageErrors whole = reliefbench::compare_images(first, hits, second, hits, {inside, black}).whole;
    const Image<float> flip = flip_map(first, second);
    double sum = 0;
    for (int y = 70; y < 77; ++y) {
        for (int x = 90; x < 110; ++x) {
            sum += flip.at(x, y);
        }
    }
    EXPECT_NEAR(*whole.flip, sum / 140, 1e-12);
    double sum_of_ssim = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto encoded = [channel](const Image<Colour>& image) {
            Image<double> values(image.size);
            for (std::size_t pixel = 0; pixel < values.texels.size(); ++pixel) {
                values.texels[pixel] = srgb_encode(image.texels[pixel][channel]);
            }
            return values;
        };
        const Image<double> ssim = ssim_map(encoded(first), encoded(second));
        for (int y = 70; y < 77; ++y) {
            for (int x = 90; x < 110; ++x) {
                sum_of_ssim += ssim.at(x, y) / 3;
            }
        }
    }
    EXPECT_NEAR(*whole.ssim, sum_of_ssim / 140, 1e-12);
}

TEST(Window, ReachesAsFarAsTheImageAndIsEmptyAroundNothing) {
    Image<std::uint8_t> mask({20, 10});
    EXPECT_EQ(window_around(mask, 3).size.pixels(), 0U);
    mask.at(2, 5) = 1;
    mask.at(11, 8) = 1;
    const Window window = window_around(mask, 3);
    EXPECT_EQ(window.left, 0);
    EXPECT_EQ(window.top, 2);
    EXPECT_EQ(window.size, (Resolution{15, 8}));
    EXPECT_EQ(part_of(mask, window).at(11, 6), 1);
}

}  // namespace
