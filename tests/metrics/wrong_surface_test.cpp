#include "metrics/wrong_surface.hpp"

#include <gtest/gtest.h>

#include <vector>

using namespace reliefbench;

namespace {

double compare(const std::vector<Front>& technique, const std::vector<Front>& truth,
               const std::vector<std::uint8_t>& inside) {
    const Resolution size{static_cast<int>(truth.size()), 1};
    Image<Front> ours(size);
    Image<Front> theirs(size);
    Image<std::uint8_t> footprint(size);
    ours.texels = technique;
    theirs.texels = truth;
    footprint.texels = inside;
    return wrong_surface(ours, theirs, footprint);
}

TEST(WrongSurface, IsAFractionOfTheFootprint) {
    using enum Front;
    EXPECT_EQ(compare({object, relief, relief, object}, {relief, object, relief, object}, {1, 1, 1, 1}), 0.5);
    // Outside of the footprint nothing counts.
    EXPECT_EQ(compare({object, relief, relief, object}, {relief, object, relief, object}, {1, 0, 1, 0}), 0.5);
    EXPECT_EQ(compare({object}, {relief}, {0}), 0);
}

// A hit that a technique misses is not the object's affair, unless the object is seen in its place.
TEST(WrongSurface, CountsTheObjectOnly) {
    using enum Front;
    EXPECT_EQ(compare({nothing, object}, {relief, relief}, {1, 1}), 0.5);
    EXPECT_EQ(compare({nothing}, {object}, {1}), 1);
}

}  // namespace
