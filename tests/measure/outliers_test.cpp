#include "measure/outliers.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace reliefbench {
namespace {

TEST(Outliers, LieBeyondThreeAndAHalfScaledDeviations) {
    // Median 10, MAD 1: the limit is 10 ± 5.1891.
    EXPECT_EQ(count_outliers(std::vector<double>{8, 9, 9, 10, 11, 11, 15.18}), 0U);
    EXPECT_EQ(count_outliers(std::vector<double>{8, 9, 9, 10, 11, 11, 15.2}), 1U);
    EXPECT_EQ(count_outliers(std::vector<double>{4.8, 9, 9, 10, 11, 11, 15.2}), 2U);
}

TEST(Outliers, AreFoundWhereMostValuesAreEqual) {
    std::vector<double> values(20, 5);
    EXPECT_EQ(count_outliers(values), 0U);
    // The mean deviation is 1/21: the limit is 5 ± 0.209.
    values.push_back(6);
    EXPECT_EQ(count_outliers(values), 1U);
}

TEST(Outliers, OfOneOrNoneThereAreNone) {
    EXPECT_EQ(count_outliers(std::vector<double>{3}), 0U);
    EXPECT_EQ(count_outliers(std::vector<double>{}), 0U);
}

}  // namespace
}  // namespace reliefbench
