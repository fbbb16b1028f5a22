#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace reliefbench {
namespace {

TEST(TestSupport, AnErrorThatDoesNotComeIsAFailure) {
    EXPECT_EQ(error_message([] { fail("no {}", "disk"); }), "no disk");
    EXPECT_NONFATAL_FAILURE(error_message([] {}), "no error was thrown");
}

TEST(TestSupport, TemporaryFoldersAreApartAndEndWithTheirScope) {
    std::filesystem::path kept;
    {
        const TemporaryFolder first;
        const TemporaryFolder second;
        EXPECT_NE(first.path(), second.path());
        std::filesystem::create_directories(first / "a" / "b");
        kept = first.path();
    }
    EXPECT_FALSE(std::filesystem::exists(kept));
}

}  // namespace
}  // namespace reliefbench
