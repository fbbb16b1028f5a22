#include "core/suggest.hpp"

#include <gtest/gtest.h>

using namespace reliefbench;

namespace {

TEST(DidYouMean, OneEditInAShortWordIsNear) {
    EXPECT_EQ(did_you_mean("pim", {"qdm", "pom"}), " (did you mean 'pom'?)");
    EXPECT_EQ(did_you_mean("po", {"qdm", "pom"}), " (did you mean 'pom'?)");
    EXPECT_EQ(did_you_mean("xyz", {"qdm", "pom"}), "");
    EXPECT_EQ(did_you_mean("pxx", {"pom"}), "");
}

TEST(DidYouMean, AThirdOfALongWordIsNear) {
    // Three edits of nine letters are; four are not.
    EXPECT_EQ(did_you_mean("max_stxyz", {"max_steps"}), " (did you mean 'max_steps'?)");
    EXPECT_EQ(did_you_mean("max_swxyz", {"max_steps"}), "");
}

TEST(DidYouMean, SwappedNeighboursAreOneEdit) {
    EXPECT_EQ(did_you_mean("pmo", {"pom"}), " (did you mean 'pom'?)");
}

TEST(DidYouMean, LetterCaseIsFree) {
    EXPECT_EQ(did_you_mean("POM", {"qdm", "pom"}), " (did you mean 'pom'?)");
}

TEST(DidYouMean, TheNearestWinsAndTheFirstOfEquals) {
    EXPECT_EQ(did_you_mean("view_angel", {"view_angles", "view_angle"}), " (did you mean 'view_angle'?)");
    EXPECT_EQ(did_you_mean("cat", {"bat", "rat"}), " (did you mean 'bat'?)");
    EXPECT_EQ(did_you_mean("cat", {}), "");
}

TEST(Join, PutsTheSeparatorBetween) {
    EXPECT_EQ(join({"a", "b", "c"}), "a, b, c");
    EXPECT_EQ(join({"a"}, "/"), "a");
    EXPECT_EQ(join({}), "");
}

}  // namespace
