// Disks that are full or read-only, folders that vanish, two processes on one folder: a clear end, an intact file.

#include "command_line.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Storage : public CommandLine {
protected:
    /// Whole lines only, each JSON: read_lines fails on others.
    void expect_whole_lines(const std::string& file) const {
        const std::string text = read_file(path(file));
        EXPECT_TRUE(text.empty() || text.back() == '\n') << file;
        read_lines(path(file));
    }
};

TEST_F(Storage, AFileThatMayNotGrowEndsTheRunAndItGoesOnWhenItMay) {
    const std::string configuration = write_configuration("long.json", long_configuration());
    const Outcome outcome = reliefbench({"run", configuration, "-o", path("run")}, "ulimit -f 64;");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("cannot write"), HasSubstr("samples.jsonl"), HasSubstr("make room")));
    expect_whole_lines("run/samples.jsonl");
    expect_whole_lines("run/cells.jsonl");
    const Outcome resumed = reliefbench({"run", configuration, "-o", path("run"), "--resume"});
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_EQ(read_lines(path("run/cells.jsonl")).size(), 12U);
}

/// A file system of its own for the folder `disk`, which is gone with the command.
class SmallDisk : public Storage {
protected:
    void SetUp() override {
        std::filesystem::create_directories(path("disk"));
        if (std::system((in_namespace("size=64k") + "true'").c_str()) != 0)
            GTEST_SKIP() << "no file systems may be mounted here, not in a name space either";
    }

    /// The beginning of a shell command in which `disk` is mounted; the quote is to be closed.
    std::string in_namespace(const std::string& options) const {
        return "unshare --mount --map-root-user sh -c 'mount -t tmpfs -o " + options + " tmpfs " + path("disk") +
               " && ";
    }
};

TEST_F(SmallDisk, ThatIsFullEndsTheRunWithWholeLines) {
    const std::string command = in_namespace("size=64k") + RELIEFBENCH_BINARY + " run " +
                                write_configuration("long.json", long_configuration()) + " -o " + path("disk/run") +
                                " >/dev/null 2>" + path("err") + "; code=$?; cp -r " + path("disk/run") + " " +
                                path("copy") + "; exit $code'";
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 2) << read_file(path("err"));
    EXPECT_THAT(read_file(path("err")), AllOf(HasSubstr("No space left on device"), HasSubstr("make room")));
    expect_whole_lines("copy/samples.jsonl");
    expect_whole_lines("copy/cells.jsonl");
    EXPECT_FALSE(read_file(path("copy/samples.jsonl")).empty());
}

TEST_F(SmallDisk, ThatIsReadOnlyIsToldBeforeAnythingIsMeasured) {
    const std::string command = in_namespace("size=64k,ro") + RELIEFBENCH_BINARY + " run " +
                                write_configuration("long.json", long_configuration()) + " -o " + path("disk/run") +
                                " >/dev/null 2>" + path("err") + "'";
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 2) << read_file(path("err"));
    EXPECT_THAT(read_file(path("err")), AllOf(HasSubstr("Read-only file system"), HasSubstr("choose another folder")));
}

TEST_F(Storage, AFolderThatIsRemovedMeanwhileEndsTheRun) {
    const pid_t process = start({"run", write_configuration("long.json", long_configuration()), "-o", path("run")});
    await_samples("run");
    std::filesystem::remove_all(path("run"));
    int status = 0;
    waitpid(process, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 2);
    EXPECT_THAT(read_file(path("err")), HasSubstr("was removed while it was being written"));
    EXPECT_FALSE(std::filesystem::exists(path("run")));
}

TEST_F(Storage, TwoProcessesDoNotWriteOneRun) {
    const std::string configuration = write_configuration("tiny.json", tiny_configuration());
    ASSERT_EQ(reliefbench({"run", configuration, "-o", path("run")}).code, 0);
    const std::string cells = read_file(path("run/cells.jsonl"));
    const Outcome second = reliefbench({"run", configuration, "-o", path("run")});
    EXPECT_EQ(second.code, 2);
    EXPECT_THAT(second.err, HasSubstr("already holds a run"));
    // As a process that writes it does.
    const int held = open(path("run/cells.jsonl").c_str(), O_RDWR);
    ASSERT_EQ(flock(held, LOCK_EX), 0);
    const Outcome beside = reliefbench({"run", configuration, "-o", path("run"), "--resume"});
    close(held);
    EXPECT_EQ(beside.code, 2);
    EXPECT_THAT(beside.err, HasSubstr("is being written by another process"));
    EXPECT_EQ(read_file(path("run/cells.jsonl")), cells);
}

}  // namespace
}  // namespace reliefbench
