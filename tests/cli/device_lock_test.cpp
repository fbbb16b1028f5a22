// One process at a time measures times on a device.

#include "command_line.hpp"

#include <gmock/gmock.h>
#include <sched.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>

namespace reliefbench {
namespace {

using testing::HasSubstr;
using testing::Not;

class DeviceLock : public CommandLine {
protected:
    /// In a name space of its own, where no other process of the machine has the lock.
    void SetUp() override {
        if (unshare(CLONE_NEWNET) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0)
            GTEST_SKIP() << "no name space of its own may be made here";
        unsetenv("RELIEFBENCH_SHARE_DEVICE");
    }
    void TearDown() override { setenv("RELIEFBENCH_SHARE_DEVICE", "1", 1); }

    std::string tiny() const { return write_configuration("tiny.json", tiny_configuration()); }

    /// Starts a run that goes on until it is interrupted, or for a minute.
    pid_t start_long_run() const {
        Json json = tiny_configuration();
        json["sampling"] = {{"rule", "time"}, {"budget_s", 60}, {"minimum_pass_ms", 0}};
        const pid_t process = start({"run", write_configuration("long.json", json), "-o", path("long")});
        await_samples("long");
        return process;
    }

    static void interrupt(pid_t process) {
        kill(process, SIGINT);
        waitpid(process, nullptr, 0);
    }
};

TEST_F(DeviceLock, WhoComesSecondSaysForWhomItWaitsAndThenMeasures) {
    const pid_t first = start_long_run();
    const std::string command = std::string("(sleep 2; kill -INT ") + std::to_string(first) + ") & ";
    const Outcome second = reliefbench({"run", tiny(), "-o", path("second")}, command);
    waitpid(first, nullptr, 0);
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_THAT(second.err, testing::ContainsRegex("process [0-9]+ measures times on llvmpipe"));
    EXPECT_EQ(read_lines(path("second/cells.jsonl")).size(), 1U);
}

TEST_F(DeviceLock, IsNotWaitedForByWhoSharesTheDevice) {
    const pid_t first = start_long_run();
    const Outcome second = reliefbench({"run", tiny(), "-o", path("second"), "--share-device"});
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_THAT(second.err, Not(HasSubstr("measures times")));
    interrupt(first);
}

}  // namespace
}  // namespace reliefbench
