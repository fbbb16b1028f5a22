#include "report/text_layout.hpp"

#include <gtest/gtest.h>

using namespace reliefbench;

namespace {

using Lines = std::vector<std::string>;

TEST(TextLayout, WidthCountsCodePoints) {
    EXPECT_EQ(text_width("1 ± 2"), 5U);
    EXPECT_EQ(pad_left("±", 3), "  ±");
    EXPECT_EQ(pad_right("±", 3), "±  ");
    EXPECT_EQ(pad_left("long", 2), "long");
}

TEST(TextLayout, WrapsAtSpaces) {
    EXPECT_EQ(wrap("one two three", 7), (Lines{"one two", "three"}));
    EXPECT_EQ(wrap("one two", 6), (Lines{"one", "two"}));
    EXPECT_EQ(wrap("unbreakable x", 4), (Lines{"unbreakable", "x"}));
    EXPECT_EQ(wrap("a\nb c", 80), (Lines{"a", "b c"}));
    EXPECT_EQ(wrap("a b\n    x  y = 1\n       ^\nc d", 3), (Lines{"a b", "    x  y = 1", "       ^", "c d"}));
    EXPECT_EQ(wrap("", 80), (Lines{""}));
}

TEST(TextLayout, ThreeSignificantDigits) {
    EXPECT_EQ(significant(0), "0");
    EXPECT_EQ(significant(0.5), "0.500");
    EXPECT_EQ(significant(12.345), "12.3");
    EXPECT_EQ(significant(9.996), "10.0");
    EXPECT_EQ(significant(999.7), "1000");
    EXPECT_EQ(significant(4567), "4567");
    EXPECT_EQ(significant(0.00123456), "0.00123");
    EXPECT_EQ(significant(0.000012), "1.20e-05");
    EXPECT_EQ(significant(-0.25), "-0.250");
    EXPECT_EQ(significant(16.1234, 4), "16.12");
}

}  // namespace
