#include "gpu/executable_statistics.hpp"

#include <gtest/gtest.h>

namespace reliefbench::gpu {
namespace {

TEST(ExecutableStatistics, NamesAreNormalized) {
    EXPECT_EQ(normalized_statistic_name("Register Count"), "register_count");
    EXPECT_EQ(normalized_statistic_name("Spill/fill (bytes)"), "spill_fill_bytes");
    EXPECT_EQ(normalized_statistic_name(" SGPRs "), "sgprs");
    EXPECT_EQ(normalized_statistic_name(""), "");
}

}  // namespace
}  // namespace reliefbench::gpu
