#include "metrics/raster_mismatch.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

TEST(RasterMismatch, IsWhatEitherHasAndTheOtherNotByTheFootprint) {
    Image<std::uint8_t> covered({6, 1});
    FootprintImage footprint({6, 1});
    covered.texels = {1, 1, 0, 0, 1, 0};
    footprint.texels = {in_footprint, tie_in_footprint, in_footprint, in_footprint, 0, 0};
    EXPECT_EQ(raster_mismatch(covered, footprint), 3.0 / 4);
    EXPECT_EQ(raster_mismatch(footprint, footprint), 0);
    EXPECT_EQ(raster_mismatch(covered, FootprintImage({6, 1})), 0) << "no footprint, no fraction";
}

}  // namespace
}  // namespace reliefbench
