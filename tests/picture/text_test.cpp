#include "picture/text.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace reliefbench {
namespace {

constexpr Rgb8 white{255, 255, 255};
constexpr Rgb8 black{0, 0, 0};

std::ptrdiff_t inked(const Picture& picture) {
    return std::count_if(picture.texels.begin(), picture.texels.end(),
                         [](const Rgb8& colour) { return colour != white; });
}

Picture drawn(const Font& font, const std::string& text, int size = 20) {
    Picture picture({font.width(text, size) + 2, font.line_height(size)}, white);
    font.draw(picture, 1, 0, text, size, black);
    return picture;
}

TEST(Text, DrawsLettersInsideTheirLine) {
    const Font font;
    const Picture picture = drawn(font, "Hg 10°");
    EXPECT_GT(inked(picture), 100);
    for (int x = 0; x < picture.size.width; ++x) {
        EXPECT_EQ(picture.at(x, 0), white) << "nothing reaches above the line at " << x;
    }
}

TEST(Text, LettersDiffer) {
    const Font font;
    EXPECT_NE(drawn(font, "l").texels, drawn(font, "I").texels);
    EXPECT_GT(font.width("WWW", 20), 2 * font.width("iii", 20)) << "it is a proportional font";
    EXPECT_GT(font.width("W", 40), 1.9 * font.width("W", 20));
}

TEST(Text, ALetterOfSeveralBytesIsOneLetter) {
    const Font font;
    EXPECT_LT(font.width("θ", 20), font.width("nn", 20));
    EXPECT_GT(inked(drawn(font, "θ")), 20);
}

TEST(Text, IsClippedByThePicture) {
    const Font font;
    Picture picture({10, 6}, white);
    font.draw(picture, -4, -5, "wide and tall", 20, black);
    font.draw(picture, 8, 4, "outside", 20, black);
    font.draw(picture, 200, 200, "far outside", 20, black);
    EXPECT_GT(inked(picture), 0);
}

TEST(Text, IsShortenedToWhatFits) {
    const Font font;
    EXPECT_EQ(font.shortened("fits", 12, 1000), "fits");
    const std::string shorter = font.shortened("θθθθθθθθθθθθθθθ", 12, 60);
    EXPECT_LE(font.width(shorter, 12), 60);
    EXPECT_EQ(shorter.substr(shorter.size() - 3), "…");
    EXPECT_EQ(shorter.size() % 2, 1U) << "cut between letters of two bytes, before an ellipsis of three";
    EXPECT_EQ(font.shortened("x", 12, 0), "…");
}

}  // namespace
}  // namespace reliefbench
