#include "core/memory.hpp"

#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace reliefbench {
namespace {

/// A machine's /proc and /sys.
class Memory : public testing::Test {
protected:
    void write(const std::string& file, const std::string& text) const {
        const std::filesystem::path path = folder_ / file;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path) << text;
    }
    std::uint64_t available() const { return available_memory(folder_.path()); }

    void SetUp() override { write("proc/meminfo", "MemTotal:  9000 kB\nMemFree:  1 kB\nMemAvailable:   4000 kB\n"); }

    const TemporaryFolder folder_;
};

TEST_F(Memory, IsWhatTheKernelCallsAvailable) {
    EXPECT_EQ(available(), 4000u * 1024);
}

TEST_F(Memory, IsWhatTheTightestControlGroupLeaves) {
    write("proc/self/cgroup", "0::/box/job\n");
    write("sys/fs/cgroup/box/memory.max", "3000000\n");
    write("sys/fs/cgroup/box/memory.current", "2500000\n");
    write("sys/fs/cgroup/box/memory.stat", "anon 1\ninactive_file 1500000\n");
    write("sys/fs/cgroup/box/job/memory.max", "max\n");
    EXPECT_EQ(available(), 2000000u);
    write("sys/fs/cgroup/box/job/memory.max", "1000\n");
    write("sys/fs/cgroup/box/job/memory.current", "5000\n");
    EXPECT_EQ(available(), 0u) << "a group may be above its limit for a moment";
}

TEST_F(Memory, AVariableTakesItsPlace) {
    setenv("RELIEFBENCH_MEMORY_MB", "12", 1);
    EXPECT_EQ(available(), 12000000u);
    setenv("RELIEFBENCH_MEMORY_MB", "-1", 1);
    EXPECT_THAT(error_message([&] { available(); }), testing::HasSubstr("RELIEFBENCH_MEMORY_MB is '-1'"));
    unsetenv("RELIEFBENCH_MEMORY_MB");
}

TEST(MemoryText, IsShort) {
    EXPECT_EQ(memory_text(1), "1 MB");
    EXPECT_EQ(memory_text(640000000), "640 MB");
    EXPECT_EQ(memory_text(3210000000), "3.2 GB");
}

}  // namespace
}  // namespace reliefbench
