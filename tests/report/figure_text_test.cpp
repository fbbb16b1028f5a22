#include "report/figure_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace reliefbench {
namespace {

TEST(FigureText, FractionsArePerCentAndOthersInTheirUnit) {
    EXPECT_EQ(figure_value_text(0.005, "fraction of footprint") + figure_unit_text("fraction of footprint"),
              "0.500 % of footprint");
    EXPECT_EQ(figure_value_text(0.75, "texels") + figure_unit_text("texels"), "0.750 texels");
    EXPECT_EQ(figure_value_text(0.75, "") + figure_unit_text(""), "0.750");
}

TEST(FigureText, ThePsnrOfAPictureWithoutAnErrorIsInfinite) {
    EXPECT_EQ(figure_value_text(std::numeric_limits<double>::infinity(), "dB"), "∞");
}

}  // namespace
}  // namespace reliefbench
