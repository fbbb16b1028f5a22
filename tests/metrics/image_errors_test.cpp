#include "metrics/image_errors.hpp"

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

}  // namespace
