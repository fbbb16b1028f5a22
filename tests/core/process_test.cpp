#include "core/process.hpp"

#include "core/scratch_folder.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace reliefbench {
namespace {

TEST(Process, BothOutputsAndTheExitCodeAreKept) {
    const FinishedProcess finished = run_process({"sh", "-c", "echo result; echo trouble >&2; exit 7"});
    EXPECT_EQ(finished.exit_code, 7);
    EXPECT_EQ(finished.output, "result\n");
    EXPECT_EQ(finished.errors, "trouble\n");
}

TEST(Process, ArgumentsAreNoShellWords) {
    EXPECT_EQ(run_process({"printf", "%s|", "a b", "$(id)", "'", ""}).output, "a b|$(id)|'||");
}

TEST(Process, OutputLargerThanAPipeDoesNotBlock) {
    EXPECT_EQ(run_process({"head", "-c", "300000", "/dev/zero"}).output.size(), 300000U);
}

TEST(Process, AKilledOneEndsAsInAShell) {
    EXPECT_EQ(run_process({"sh", "-c", "kill -9 $$"}).exit_code, 128 + 9);
}

TEST(Process, UnsetVariablesAreNotInherited) {
    ASSERT_EQ(setenv("RELIEFBENCH_TEST_VARIABLE", "seen", 1), 0);
    const std::vector<std::string> print = {"sh", "-c", "printf %s \"$RELIEFBENCH_TEST_VARIABLE\""};
    EXPECT_EQ(run_process(print).output, "seen");
    EXPECT_EQ(run_process(print, {"RELIEFBENCH_TEST_VARIABLE"}).output, "");
    ASSERT_EQ(unsetenv("RELIEFBENCH_TEST_VARIABLE"), 0);
}

TEST(Process, AMissingProgramIsAnError) {
    EXPECT_THAT(error_message([] { run_process({"no_such_program_at_all"}); }),
                testing::HasSubstr("no_such_program_at_all"));
}

TEST(ScratchFolder, IsGoneWithItsContentAtTheEnd) {
    std::filesystem::path path;
    {
        const ScratchFolder folder;
        path = folder.path();
        std::filesystem::create_directory(path / "inner");
        std::ofstream(path / "inner" / "file") << "text";
        EXPECT_TRUE(std::filesystem::exists(path / "inner" / "file"));
    }
    EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace reliefbench
