#include "command_line.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class UnpackedArchive : public CommandLine {};

TEST_F(UnpackedArchive, TheBinaryTakesTechniquesFromItsOwnFolders) {
    std::filesystem::create_directories(path("bin"));
    std::filesystem::create_directories(path("harness/shaders"));
    std::filesystem::copy_file(RELIEFBENCH_BINARY, path("bin/reliefbench"));
    copy_technique("flat", "mine");
    const std::string command = fmt::format("cd / && '{}' list techniques >'{}'", path("bin/reliefbench"), path("out"));
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_THAT(read_file(path("out")), AllOf(HasSubstr("mine"), Not(HasSubstr("tessellation"))));
}

}  // namespace
}  // namespace reliefbench
