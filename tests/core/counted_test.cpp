#include "core/counted.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

TEST(Counted, OnlyOneIsSingular) {
    EXPECT_EQ(counted(0, "cell"), "0 cells");
    EXPECT_EQ(counted(1, "cell"), "1 cell");
    EXPECT_EQ(counted(2, "cell"), "2 cells");
}

}  // namespace
}  // namespace reliefbench
