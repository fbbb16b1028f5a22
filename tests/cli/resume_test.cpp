#include "command_line.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <thread>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Resume : public CommandLine {
protected:
    /// Several blocks, each of several cells.
    std::string configuration(int seed = 1) const {
        Json json = tiny_configuration();
        json["seed"] = seed;
        json["techniques"] = {"steep", "pom", "qdm"};
        json["axes"]["sample_count"] = {4, 8, 16};
        json["axes"]["view_angle"] = {0, 30, 45, 60};
        json["sampling"]["rounds"] = 3;
        return write_configuration("resume.json", json);
    }

    /// Starts the command and kills it after a while; false when it had ended before.
    bool killed(const std::vector<std::string>& arguments, std::chrono::milliseconds after) const {
        const pid_t process = start(arguments);
        std::this_thread::sleep_for(after);
        kill(process, SIGKILL);
        int status = 0;
        waitpid(process, &status, 0);
        return WIFSIGNALED(status);
    }
};

/// What must not depend on interruptions, by cell; a cell that stands there twice is a failure.
std::map<std::string, Json> deterministic_part(const std::vector<Json>& cells) {
    std::map<std::string, Json> kept;
    for (const Json& cell : cells) {
        Json part;
        for (const char* key : {"error", "work", "pipeline", "image", "status", "axes", "parameters"})
            part[key] = cell.at(key);
        part["bytes"] = cell.at("prepare").at("bytes");
        EXPECT_TRUE(kept.emplace(cell.at("cell").get<std::string>(), part).second) << cell.at("cell");
    }
    return kept;
}

/// Visits are neither lost nor repeated.
void expect_every_round_once(const std::vector<Json>& cells, const std::vector<Json>& samples) {
    std::map<std::string, std::set<int>> rounds;
    for (const Json& line : samples) {
        if (line.at("pass") != "draw") continue;
        EXPECT_TRUE(rounds[line.at("cell").get<std::string>()].insert(line.at("round").get<int>()).second);
    }
    for (const Json& cell : cells)
        EXPECT_EQ(cell.at("time").at("draw").at("rounds"), rounds.at(cell.at("cell").get<std::string>()).size());
}

TEST_F(Resume, ARunKilledAgainAndAgainEndsWithEveryCellOnce) {
    const std::string config = configuration();
    ASSERT_EQ(reliefbench({"run", config, "-o", path("whole")}).code, 0);
    const std::vector<std::string> resumed = {"run", config, "-o", path("resumed"), "--resume"};
    // Ever later, so that it is interrupted at the start, amid blocks and near the end, and ends on any machine.
    int kills = 0;
    for (int after_ms = 150; killed(resumed, std::chrono::milliseconds(after_ms)); after_ms = after_ms * 5 / 4)
        ++kills;
    const Outcome last = reliefbench(resumed);
    ASSERT_EQ(last.code, 0) << last.err;
    EXPECT_GE(kills, 2);
    const std::vector<Json> cells = read_lines(path("resumed/cells.jsonl"));
    EXPECT_EQ(deterministic_part(cells), deterministic_part(read_lines(path("whole/cells.jsonl"))));
    expect_every_round_once(cells, read_lines(path("resumed/samples.jsonl")));
}

TEST_F(Resume, RunsKilledAtAHundredRandomMomentsEndAsIfNothingHadBeen) {
    if (std::getenv("RELIEFBENCH_LONG_TESTS") == nullptr) GTEST_SKIP() << "long; RELIEFBENCH_LONG_TESTS is not set";
    const std::string config = configuration();
    ASSERT_EQ(reliefbench({"run", config, "-o", path("whole")}).code, 0);
    const auto whole = deterministic_part(read_lines(path("whole/cells.jsonl")));
    std::mt19937 random(1);
    // From before the worker is there to near the end.
    std::uniform_int_distribution<int> moment_ms(1, 1500);
    for (int kills = 0, run = 0; kills < 100; ++run) {
        const std::string folder = path("run " + std::to_string(run));
        const std::vector<std::string> resumed = {"run", config, "-o", folder, "--resume"};
        std::set<std::string> finished;
        while (kills < 100 && killed(resumed, std::chrono::milliseconds(moment_ms(random)))) {
            ++kills;
            // As it stands, with a last line that may be cut short.
            std::set<std::string> now;
            std::ifstream file(folder + "/cells.jsonl");
            for (std::string line; std::getline(file, line) && !file.eof();)
                now.insert(line);
            EXPECT_TRUE(std::includes(now.begin(), now.end(), finished.begin(), finished.end())) << "a cell was lost";
            finished = now;
        }
        const Outcome last = reliefbench(resumed);
        ASSERT_EQ(last.code, 0) << last.err;
        const std::vector<Json> cells = read_lines(folder + "/cells.jsonl");
        EXPECT_EQ(deterministic_part(cells), whole);
        expect_every_round_once(cells, read_lines(folder + "/samples.jsonl"));
    }
}

TEST_F(Resume, WhatIsFinishedIsShownAndNotMeasuredAgain) {
    const std::string config = write_configuration("tiny.json", tiny_configuration());
    const Outcome first = reliefbench({"run", config, "-o", path("run"), "--resume"});
    ASSERT_EQ(first.code, 0) << first.err;
    const std::string cells = read_file(path("run/cells.jsonl"));
    const Outcome second = reliefbench({"run", config, "-o", path("run"), "--resume"});
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_THAT(second.err, HasSubstr("finished already: 1 cell"));
    EXPECT_THAT(second.out, HasSubstr("steep"));
    EXPECT_EQ(read_file(path("run/cells.jsonl")), cells);
    EXPECT_EQ(Json::parse(read_file(path("run/run.json"))).at("resumed").size(), 1U);
}

TEST_F(Resume, AnotherConfigurationIsRefusedUnlessForced) {
    Json json = tiny_configuration();
    json["axes"]["view_angle"] = {30, 45};
    ASSERT_EQ(reliefbench({"run", write_configuration("first.json", json), "-o", path("run")}).code, 0);
    // As if it had been interrupted after the first cell.
    const std::string cells = read_file(path("run/cells.jsonl"));
    std::ofstream(path("run/cells.jsonl")) << cells.substr(0, cells.find('\n') + 1);
    json["seed"] = 2;
    const std::string changed = write_configuration("first.json", json);
    const Outcome refused = reliefbench({"run", changed, "-o", path("run"), "--resume"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err,
                AllOf(HasSubstr("cannot be resumed"), HasSubstr("seed was "), HasSubstr("--resume=force")));
    const Outcome forced = reliefbench({"run", changed, "-o", path("run"), "--resume=force"});
    EXPECT_EQ(forced.code, 0) << forced.err;
    const std::vector<Json> lines = read_lines(path("run/cells.jsonl"));
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_FALSE(lines[0].contains("forced_resume"));
    EXPECT_EQ(lines[1].at("forced_resume"), true);
    const Json record = Json::parse(read_file(path("run/run.json")));
    EXPECT_THAT(record.at("resumed").at(0).at("differences").dump(), HasSubstr("seed was "));
}

TEST_F(Resume, ByForceWithOtherCellsLeavesTheEarlierOnesAlone) {
    Json json = tiny_configuration();
    ASSERT_EQ(reliefbench({"run", write_configuration("first.json", json), "-o", path("run")}).code, 0);
    json["axes"]["view_angle"] = {30, 60};
    const Outcome forced = reliefbench(
        {"run", write_configuration("second.json", json), "-o", path("run"), "--resume=force", "--format", "json"});
    EXPECT_EQ(forced.code, 0) << forced.err;
    EXPECT_EQ(Json::parse(forced.out).size(), 2U);
    EXPECT_EQ(read_lines(path("run/cells.jsonl")).size(), 3U);
    EXPECT_EQ(Json::parse(read_file(path("run/summary.json"))).at("cells").at("ok"), 2);
}

TEST_F(Resume, NeedsAFolderAndAKnownWord) {
    const std::string config = write_configuration("tiny.json", tiny_configuration());
    EXPECT_THAT(reliefbench({"run", config, "--resume"}).err, HasSubstr("--resume needs -o"));
    const Outcome unknown = reliefbench({"run", config, "-o", path("run"), "--resume=perhaps"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("force"));
}

}  // namespace
}  // namespace reliefbench
