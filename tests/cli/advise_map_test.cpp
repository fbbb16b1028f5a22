#include "command_line.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <csignal>
#include <fstream>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr int map_side = 32;

class AdviseMap : public CommandLine {
protected:
    /// A binary PGM of 8 bits.
    std::string write_map(const std::string& name, const std::function<int(int x, int y)>& grey) const {
        std::string text = "P5\n32 32\n255\n";
        for (int y = 0; y < map_side; ++y) {
            for (int x = 0; x < map_side; ++x)
                text += static_cast<char>(grey(x, y));
        }
        return write(name, text);
    }

    /// Few techniques and pixels, and as many rounds as must be.
    std::vector<std::string> small(std::vector<std::string> arguments) const {
        std::vector<std::string> line = {"advise",
                                         "--view-angle",
                                         "50,65",
                                         "--resolution",
                                         "48x27",
                                         "-a",
                                         "azimuth=-52",
                                         "--filter",
                                         "technique=steep,flat",
                                         "--sampling",
                                         "rule=fixed,rounds=3",
                                         "-o",
                                         path("kept")};
        line.insert(line.end(), arguments.begin(), arguments.end());
        return line;
    }

    /// Of a generated map, which needs no file.
    Outcome ask(const std::vector<std::string>& arguments, const std::string& before = {}) const {
        std::vector<std::string> line = small({"--map", "bricks", "-a", "heightmap_size=32"});
        line.insert(line.end(), arguments.begin(), arguments.end());
        return reliefbench(line, before);
    }

    std::size_t count_status(const std::string& status) const {
        std::size_t count = 0;
        for (const Json& cell : read_lines(path("kept/cells.jsonl")))
            count += cell.at("status") == status ? 1 : 0;
        return count;
    }
};

TEST_F(AdviseMap, SaysWhatToUseInEachViewAndInAllAndKeepsTheRun) {
    const Outcome outcome = ask({"--flip", "0.15"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr("in all of these views, FLIP"), HasSubstr("at view_angle=50"),
                      HasSubstr("at view_angle=65"), HasSubstr("use steep"), HasSubstr("{\"technique\":\"steep\""),
                      HasSubstr("kept in " + path("kept")), HasSubstr("reliefbench report " + path("kept"))));
    EXPECT_EQ(reliefbench({"advise", path("kept"), "--flip", "0.15"}).code, 0);
    EXPECT_GT(count_status("ok"), 4U);
    EXPECT_GT(count_status("skipped"), 4U);
    for (const Json& cell : read_lines(path("kept/cells.jsonl"))) {
        if (cell.at("status") != "skipped") continue;
        EXPECT_THAT(cell.at("reason"), HasSubstr("not measured: "));
    }
}

TEST_F(AdviseMap, TheSameCommandAnswersFromWhatIsKeptAndAnotherQuestionIsRefused) {
    const Outcome first = ask({"--budget", "1s", "--format", "json"});
    ASSERT_EQ(first.code, 0) << first.err;
    const std::string cells = read_file(path("kept/cells.jsonl"));
    const Outcome second = ask({"--budget", "1s", "--format", "json"});
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_EQ(second.out, first.out);
    EXPECT_EQ(read_file(path("kept/cells.jsonl")), cells);
    const Json json = Json::parse(first.out);
    EXPECT_EQ(json.at("all_views").at("best").at("technique"), "steep");
    EXPECT_EQ(json.at("views").size(), 2U);
    EXPECT_EQ(json.at("cells").at("total").get<std::size_t>(),
              json.at("cells").at("measured").get<std::size_t>() + json.at("cells").at("left_out").get<std::size_t>());
    const Outcome other = ask({"--budget", "2s"});
    EXPECT_EQ(other.code, 2);
    EXPECT_THAT(other.err, HasSubstr("another question"));
}

TEST_F(AdviseMap, WhatIsUselessIsRefusedAndWhatMisleadsIsToldBeforeAnythingIsMeasured) {
    const Outcome constant =
        reliefbench(small({"--map", write_map("grey.pgm", [](int, int) { return 99; }), "--flip", "1"}));
    EXPECT_EQ(constant.code, 2);
    EXPECT_THAT(constant.err, HasSubstr("'grey.pgm' is constant"));
    EXPECT_FALSE(std::filesystem::exists(path("kept")));
    const std::string noise =
        write_map("noise.pgm", [](int x, int y) { return ((x * 7919 + y * 104729) * 31 / 7) % 256; });
    const Outcome told = reliefbench(small({"--map", noise, "--flip", "1", "--filter", "technique=flat"}));
    EXPECT_EQ(told.code, 0) << told.err;
    EXPECT_THAT(told.err, HasSubstr("noise at the scale of its texels"));
    EXPECT_LT(told.err.find("noise at the scale"), told.err.find("results in"));
}

TEST_F(AdviseMap, EndsWhenTheTimeIsOverAndTheSameCommandGoesOn) {
    const Outcome first = ask({"--budget", "1s", "--time", "0.01s"});
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_THAT(first.out, AllOf(HasSubstr("the time (--time) was over"), HasSubstr("--resume")));
    EXPECT_FALSE(std::filesystem::exists(path("kept/summary.json")));
    const Outcome second = ask({"--budget", "1s", "--time", "5m"});
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_THAT(second.out, AllOf(HasSubstr("use steep"), Not(HasSubstr("was over"))));
    EXPECT_TRUE(std::filesystem::exists(path("kept/summary.json")));
}

TEST_F(AdviseMap, InterruptedItKeepsItsSamplesAndTheSameCommandGoesOn) {
    std::vector<std::string> line = small({"--map", "bricks", "-a", "heightmap_size=32", "--budget", "1s"});
    const pid_t process = start(line);
    await_samples("kept");
    kill(process, SIGINT);
    int status = 0;
    waitpid(process, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    const std::size_t samples = read_lines(path("kept/samples.jsonl")).size();
    EXPECT_GT(samples, 0U);
    const Outcome outcome = reliefbench(line);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("use steep"));
    EXPECT_GT(read_lines(path("kept/samples.jsonl")).size(), samples);
}

TEST_F(AdviseMap, AShaderThatCrashesTheDriverIsNotTheEnd) {
    const Outcome outcome =
        ask({"--budget", "1s"}, std::string("VK_ADD_LAYER_PATH=") + RELIEFBENCH_FAULTY_LAYER_FOLDER +
                                    " VK_INSTANCE_LAYERS=VK_LAYER_RELIEFBENCH_faulty "
                                    "RELIEFBENCH_CRASH_AT=15");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("use steep"), HasSubstr("failed")));
}

TEST_F(AdviseMap, WhatARunLeftOutCanBeMeasuredAfterwards) {
    ASSERT_EQ(ask({"--budget", "1s", "--time", "0.01s"}).code, 0);
    const Outcome rest = reliefbench({"run", path("kept/run.json"), "-o", path("kept"), "--resume"});
    EXPECT_EQ(rest.code, 0) << rest.err;
    EXPECT_EQ(count_status("skipped"), 0U);
    EXPECT_THAT(read_file(path("kept/summary.json")), HasSubstr("stop"));
}

TEST_F(AdviseMap, BadInputIsRefused) {
    struct Bad {
        std::vector<std::string> arguments;
        std::string words;
    };
    const std::vector<Bad> cases = {
        {{"--map", "bricks"}, "at least one limit"},
        {{"--map", "briks", "--flip", "1"}, "bricks"},
        {{"--map", "bricks,rock", "--flip", "1"}, "one height map"},
        {{"--map", "bricks", "--flip", "1", "--time", "soon"}, "--time"},
        {{"--map", "bricks", "--flip", "1", "--view-angle", "steep"}, "--view-angle steep: expected degrees"},
        {{"--map", "bricks", "--flip", "1", "--resolution", "big"}, "resolution"},
        {{"--map", "bricks", "--flip", "1", "-o", "-"}, "a run is a folder"},
        {{"--map", "bricks", "--shadow", "0.1"}, "-a self_shadow=hard"},
        {{"--map", "bricks", "--limit", "motion.flip.mean=0.1"}, "needs what a configuration alone has"},
        {{"--map", "bricks", "--flip", "1", "--cell", "pom"}, "--filter"},
        {{"--flip", "1"}, "--map heights.png"},
        {{"run", "--map", "bricks", "--flip", "1"}, "--map heights.png"},
        {{"run", "--flip", "1", "--resolution", "8x8"}, "--resolution says how a height map is measured"},
    };
    for (const auto& [arguments, words] : cases) {
        std::vector<std::string> line = {"advise"};
        line.insert(line.end(), arguments.begin(), arguments.end());
        const Outcome outcome = reliefbench(line);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments);
        EXPECT_THAT(outcome.err, HasSubstr(words));
    }
}

}  // namespace
}  // namespace reliefbench
