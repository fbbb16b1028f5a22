// What a run shows while it goes on and when it ends, and how it is interrupted.

#include "command_line.hpp"

#include "core/process.hpp"

#include <gmock/gmock.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <optional>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Terminal : public CommandLine {
protected:
    std::string tiny() const { return write_configuration("tiny.json", tiny_configuration()); }

    /// Several blocks, in which much is left to do when the first sample is there.
    std::string long_configuration() const {
        Json json = tiny_configuration();
        json["techniques"] = {"steep", "pom"};
        json["axes"]["sample_count"] = {4, 8, 16, 32};
        json["axes"]["view_angle"] = {0, 15, 30, 45, 60};
        json["sampling"]["rounds"] = 20;
        return write_configuration("long.json", json);
    }

    /// What the command writes to a terminal of 100 columns.
    static std::string on_terminal(std::vector<std::string> words, bool no_color) {
        words.insert(words.begin(), RELIEFBENCH_BINARY);
        winsize size{.ws_row = 40, .ws_col = 100, .ws_xpixel = 0, .ws_ypixel = 0};
        int terminal = -1;
        const pid_t process = forkpty(&terminal, nullptr, nullptr, &size);
        if (process == 0) {
            setenv("TERM", "xterm", 1);
            if (no_color) {
                setenv("NO_COLOR", "1", 1);
            } else {
                unsetenv("NO_COLOR");
            }
            execv(RELIEFBENCH_BINARY, pointers_to(words).data());
            _exit(127);
        }
        std::string text;
        char buffer[4096];
        for (ssize_t count = 0; (count = read(terminal, buffer, sizeof(buffer))) > 0;)
            text.append(buffer, static_cast<std::size_t>(count));
        waitpid(process, nullptr, 0);
        close(terminal);
        return text;
    }
};

constexpr const char* bold_mark = "\033[1m*\033[0m";

TEST_F(Terminal, EveryStageIsSeenWhileItLasts) {
    EXPECT_THAT(on_terminal({"run", tiny(), "-o", path("seen")}, true),
                AllOf(HasSubstr("reading height maps: bricks"), HasSubstr("preparing 1 of 1, compiling: steep"),
                      HasSubstr("preparing 1 of 1, tracing the truth: steep"), HasSubstr("warming up 1 of 1: steep")));
}

TEST_F(Terminal, APictureIsNotSentToIt) {
    const std::string seen = on_terminal({"render", "--technique", "flat", "-o", "-"}, true);
    EXPECT_THAT(seen, AllOf(HasSubstr("standard output is a terminal"), Not(HasSubstr("PNG"))));
}

TEST_F(Terminal, TheTableHasColoursWhereItIsSeenAndWanted) {
    const std::string seen = on_terminal({"run", tiny(), "-o", path("seen")}, false);
    EXPECT_THAT(seen, AllOf(HasSubstr(bold_mark), HasSubstr("elapsed"), HasSubstr("[1/1]")));
    EXPECT_THAT(on_terminal({"run", tiny(), "-o", path("plain")}, true), Not(HasSubstr(bold_mark)));
    EXPECT_THAT(reliefbench({"run", tiny(), "-o", path("pipe")}).out, Not(HasSubstr("\033")));
    EXPECT_THAT(reliefbench({"run", tiny(), "-o", path("always"), "--color=always"}).out, HasSubstr(bold_mark));
    const Outcome unknown = reliefbench({"run", tiny(), "-o", path("unknown"), "--color", "pink"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.err, AllOf(HasSubstr("--color"), HasSubstr("pink")));
}

TEST_F(Terminal, ScriptsGetTheirFormatAndNothingElseOnStandardOutput) {
    const Outcome json = reliefbench({"run", tiny(), "-o", path("json"), "--format", "json"});
    ASSERT_EQ(json.code, 0) << json.err;
    EXPECT_EQ(Json::parse(json.out), Json(read_lines(path("json/cells.jsonl"))));
    EXPECT_THAT(json.err, HasSubstr("in all"));
    const Outcome csv = reliefbench({"run", tiny(), "-o", path("csv"), "--format", "csv"});
    EXPECT_EQ(csv.out, reliefbench({"export", path("csv"), "--format", "csv"}).out);
    expect_refused({tiny(), "--format", "cvs"}, {"--format", "'csv'"});
}

TEST_F(Terminal, AnInterruptedRunKeepsWhatIsDoneAndSaysHowToGoOn) {
    const std::string configuration = long_configuration();
    const pid_t process = start({"run", configuration, "-o", path("run")});
    await_samples("run");
    kill(process, SIGINT);
    int status = 0;
    waitpid(process, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << read_file(path("err"));
    EXPECT_EQ(WTERMSIG(status), SIGINT);
    const std::string resume = "reliefbench run " + path("run/run.json") + " -o " + path("run") + " --resume\n";
    EXPECT_THAT(read_file(path("err")), AllOf(HasSubstr("finishing the visit"), HasSubstr(resume)));
    EXPECT_FALSE(std::filesystem::exists(path("run/summary.json")));
    const std::size_t finished = read_lines(path("run/cells.jsonl")).size();
    EXPECT_LT(finished, 40U);
    const std::string samples = read_file(path("run/samples.jsonl"));
    EXPECT_EQ(samples.back(), '\n');

    const Outcome whole = reliefbench({"run", path("run/run.json"), "-o", path("run"), "--resume"});
    ASSERT_EQ(whole.code, 0) << whole.err;
    EXPECT_EQ(read_lines(path("run/cells.jsonl")).size(), 40U);
    EXPECT_THAT(read_file(path("run/samples.jsonl")), testing::StartsWith(samples));
}

TEST_F(Terminal, ASecondInterruptEndsAtOnceAndAnIgnoredOneStaysIgnored) {
    const std::string configuration = long_configuration();
    const pid_t process = start({"run", configuration, "-o", path("run")});
    await_samples("run");
    kill(process, SIGTERM);
    kill(process, SIGTERM);
    int status = 0;
    waitpid(process, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), SIGTERM);

    // As nohup does for SIGHUP, and shells for the SIGINT of commands in the background.
    const auto before = std::signal(SIGINT, SIG_IGN);
    const pid_t background = start({"run", tiny(), "-o", path("background")});
    std::signal(SIGINT, before);
    await_samples("background");
    kill(background, SIGINT);
    waitpid(background, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace
}  // namespace reliefbench
