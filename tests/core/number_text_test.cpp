#include "core/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace reliefbench {
namespace {

TEST(NumberText, IsReadWhenItIsTheWholeText) {
    EXPECT_EQ(whole_text_as<std::int64_t>("-12"), -12);
    EXPECT_EQ(whole_text_as<double>("-12"), -12.0);
    EXPECT_EQ(whole_text_as<double>("1.5e3"), 1500.0);
    EXPECT_TRUE(std::isnan(whole_text_as<double>("nan").value()));
}

TEST(NumberText, TakesNothingBesideTheNumber) {
    for (const char* text : {"", " 1", "1 ", "+1", "1x", "0x1", "x"}) {
        EXPECT_EQ(whole_text_as<std::int64_t>(text), std::nullopt) << text;
        EXPECT_EQ(whole_text_as<double>(text), std::nullopt) << text;
    }
    EXPECT_EQ(whole_text_as<std::int64_t>("1.5"), std::nullopt);
    EXPECT_EQ(whole_text_as<double>("1,5"), std::nullopt);
}

TEST(NumberText, MustFitTheType) {
    EXPECT_EQ(whole_text_as<std::uint8_t>("255"), 255);
    EXPECT_EQ(whole_text_as<std::uint8_t>("256"), std::nullopt);
    EXPECT_EQ(whole_text_as<unsigned>("-1"), std::nullopt);
    EXPECT_EQ(whole_text_as<double>("1e999"), std::nullopt);
}

TEST(FigureAbove, HasThreeDigitsAndIsNeverBelow) {
    EXPECT_EQ(figure_above(0.3002), "0.301");
    EXPECT_EQ(figure_above(0.3), "0.300");
    EXPECT_EQ(figure_above(18308), "18400");
    EXPECT_EQ(figure_above(999.5), "1000");
    EXPECT_EQ(figure_above(60.01), "60.1");
    EXPECT_EQ(figure_above(0.00012345), "0.000124");
    for (double value = 1e-4; value < 1e6; value *= 1.37)
        EXPECT_GE(std::stod(figure_above(value)), value * (1 - 1e-9)) << value;
}

}  // namespace
}  // namespace reliefbench
