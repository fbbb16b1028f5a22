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

}  // namespace
}  // namespace reliefbench
