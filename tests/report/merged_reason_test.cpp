#include "report/merged_reason.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

std::string merged(const std::string& first, const std::string& second) {
    MergedReason reason(first);
    return reason.add(second) ? reason.text() : "";
}

TEST(MergedReason, FiguresThatDifferAreARange) {
    EXPECT_EQ(merged("about 12 s, 3.5 %.", "about 7 s, 3.5 %."), "about 7 to 12 s, 3.5 %.");
    EXPECT_EQ(merged("5 of 32 pixels, s = -2.5 at pixel (5, 2)", "17 of 32 pixels, s = -0.5 at pixel (1, 2)"),
              "5 to 17 of 32 pixels, s = -2.5 to -0.5 at pixel (1 to 5, 2)");
    EXPECT_EQ(merged("it takes 3.", "it takes 10."), "it takes 3 to 10.");
}

TEST(MergedReason, EqualReasonsStayAsTheyAre) {
    EXPECT_EQ(merged("no tessellation", "no tessellation"), "no tessellation");
    EXPECT_EQ(merged("", ""), "");
    EXPECT_EQ(merged("100 %", "100 %"), "100 %");
}

TEST(MergedReason, WhatIsPartOfANameIsNoFigure) {
    for (const auto& [first, second] :
         {std::pair("trace.glsl:3: error", "trace.glsl:4: error"), std::pair("512x512 texels", "513x512 texels"),
          std::pair("max_steps=512 is out", "max_steps=513 is out"), std::pair("pass 'search_2'", "pass 'search_3'"),
          std::pair("$.passes[0]", "$.passes[1]"), std::pair("version 1.2.3", "version 1.2.4"),
          std::pair("12 s", "12 ms"), std::pair("no 12", "no")})
        EXPECT_EQ(merged(first, second), "") << first;
}

}  // namespace
}  // namespace reliefbench
