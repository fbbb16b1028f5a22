// Configurations from pipes, and output to standard output: read once, written whole.

#include "command_line.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class ConfigurationInput : public CommandLine {
protected:
    ConfigurationInput() { write_configuration("tiny.json", tiny_configuration()); }

    static std::string binary() { return RELIEFBENCH_BINARY; }
};

TEST_F(ConfigurationInput, AnyPipeIsReadOnce) {
    const std::string plan = reliefbench({"run", path("tiny.json"), "--dry-run"}).out;
    ASSERT_THAT(plan, HasSubstr("1 cell in 1 block, 0 skipped"));
    const std::vector<std::string> commands = {
        "cat tiny.json | " + binary() + " run - --dry-run",
        "cat tiny.json | " + binary() + " run /dev/stdin --dry-run",
        binary() + " run /dev/fd/5 --dry-run 5< <(cat tiny.json)",
        "mkfifo fifo && { cat tiny.json > fifo & timeout 60 " + binary() + " run fifo --dry-run; }",
    };
    for (const std::string& command : commands) {
        const Outcome outcome = shell("bash -c '" + command + "'");
        EXPECT_EQ(outcome.code, 0) << command << outcome.err;
        EXPECT_EQ(outcome.out, plan) << command;
    }
}

TEST_F(ConfigurationInput, AMessageNamesThePipe) {
    const Outcome typo = shell("echo '{\"techniqes\": []}' | " + binary() + " run - --dry-run");
    EXPECT_EQ(typo.code, 2);
    EXPECT_THAT(typo.err, AllOf(HasSubstr("standard input: $: unknown key"), HasSubstr("'techniques'")));
    EXPECT_THAT(shell(binary() + " run - --dry-run").err, HasSubstr("standard input: it is empty"));
}

TEST_F(ConfigurationInput, ARunFromAPipeIsResumedAndItsRecordRepeated) {
    const Outcome first = shell("cat tiny.json | " + binary() + " run - -o run");
    ASSERT_EQ(first.code, 0) << first.err;
    const Outcome resumed = shell("cat tiny.json | " + binary() + " run - -o run --resume");
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_THAT(resumed.err, HasSubstr("finished already: 1 cell"));
    EXPECT_EQ(reliefbench({"run", path("run/run.json"), "-o", path("run"), "--resume"}).code, 0);
    const Outcome again = shell("cat run/run.json | " + binary() + " run - -o again");
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(read_lines(path("again/cells.jsonl"))[0].at("cell"), read_lines(path("run/cells.jsonl"))[0].at("cell"));
}

TEST_F(ConfigurationInput, WithoutANameOrAFileOfItsOwnTheRunIsCalledConfiguration) {
    Json json = tiny_configuration();
    json.erase("name");
    write_configuration("unnamed.json", json);
    for (const std::string input : {"-", "/dev/stdin"}) {
        ASSERT_EQ(shell("cat unnamed.json | " + binary() + " run " + input).code, 0);
        for (const auto& entry : std::filesystem::directory_iterator(path("results")))
            EXPECT_THAT(entry.path().filename().string(), StartsWith("configuration-"));
        // Two runs of one second would have one folder.
        std::filesystem::remove_all(path("results"));
    }
}

TEST_F(ConfigurationInput, ANameLeadsNowhereButIntoResults) {
    std::string long_name = "x";
    for (int letter = 0; letter < 100; ++letter)
        long_name += "é";
    const std::vector<std::string> names = {"../../evil", "/somewhere/absolute", "a b/ü|<i>", "..", ".hidden",
                                            "",           "line\nend",           long_name};
    for (const std::string& name : names) {
        std::filesystem::create_directories(path("inner"));
        Json json = tiny_configuration();
        json["name"] = name;
        write_configuration("named.json", json);
        const Outcome outcome = shell("cd inner && " + binary() + " run ../named.json");
        EXPECT_EQ(outcome.code, 0) << name << outcome.err;
        std::vector<std::filesystem::path> made;
        for (const auto& entry : std::filesystem::directory_iterator(path("inner/results")))
            made.push_back(entry.path());
        ASSERT_EQ(made.size(), 1U) << name;
        EXPECT_THAT(made[0].filename().string(), AllOf(Not(StartsWith(".")), Not(HasSubstr("\n"))));
        EXPECT_NO_THROW(Json(made[0].filename().string()).dump()) << "a character was cut";
        EXPECT_EQ(Json::parse(read_file(made[0] / "run.json")).at("configuration").at("name"), name);
        std::filesystem::remove_all(path("inner"));
    }
}

TEST_F(ConfigurationInput, AFileIsWrittenToStandardOutput) {
    ASSERT_EQ(reliefbench({"run", path("tiny.json"), "-o", path("run")}).code, 0);
    const std::string csv = reliefbench({"export", path("run"), "--format", "csv"}).out;
    EXPECT_THAT(csv, StartsWith("cell,technique,"));
    EXPECT_EQ(reliefbench({"export", path("run"), "--format", "csv", "-o", "-"}).out, csv);
    ASSERT_EQ(reliefbench({"report", path("run"), "-o", path("report.html")}).code, 0);
    EXPECT_EQ(reliefbench({"report", path("run"), "-o", "-"}).out, read_file(path("report.html")));
    const Outcome picture = reliefbench({"render", "--technique", "flat", "-a", "resolution=16", "-o", "-"});
    EXPECT_EQ(picture.code, 0) << picture.err;
    EXPECT_THAT(picture.out, StartsWith("\x89PNG"));
    reliefbench({"render", "--technique", "flat", "-a", "resolution=16", "-o", path("file.png")});
    EXPECT_EQ(picture.out, read_file(path("file.png")));
    EXPECT_FALSE(std::filesystem::exists(path("-")));
    const Outcome exported =
        reliefbench({"run", path("tiny.json"), "-o", path("second"), "--export", "github_action=-"});
    EXPECT_TRUE(Json::parse(exported.out).is_array()) << exported.out;
    EXPECT_THAT(exported.err, HasSubstr("steep")) << "the table";
}

TEST_F(ConfigurationInput, WhatIsNoFileIsNoStandardOutput) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> refused = {
        {{"run", path("tiny.json"), "-o", "-"}, "a run is a folder"},
        {{"merge", "-", path("run")}, "a run is a folder"},
        {{"ab", path("tiny.json"), "--baseline", "HEAD", "-o", "-"}, "it is a folder"},
        {{"render", "--technique", "flat", "--animate", "view_angle=0,10", "-o", "-"}, "an animation is many files"},
        {{"run", path("tiny.json"), "--export", "csv=-", "--export", "markdown=-"}, "another export already"},
        {{"run", path("tiny.json"), "--export", "csv=-", "--format", "json"}, "exclude each other"},
    };
    for (const auto& [arguments, words] : refused) {
        const Outcome outcome = reliefbench(arguments);
        EXPECT_EQ(outcome.code, 2) << words;
        EXPECT_THAT(outcome.err, HasSubstr(words));
        EXPECT_THAT(outcome.out, IsEmpty());
    }
}

/// Every subcommand but those that write nothing there.
TEST_F(ConfigurationInput, EveryCommandTellsAFullDisk) {
    ASSERT_EQ(reliefbench({"run", path("tiny.json"), "-o", path("run")}).code, 0);
    Json half = tiny_configuration();
    half["axes"]["view_angle"] = {0, 45};
    write_configuration("half.json", half);
    ASSERT_EQ(reliefbench({"run", path("half.json"), "-o", path("part"), "--shard", "1/1"}).code, 0);
    ASSERT_EQ(reliefbench({"run", path("tiny.json"), "-o", path("run2")}).code, 0);
    const std::string small = "--technique flat -a resolution=16 ";
    const std::map<std::string, std::string> commands = {
        {"list", "list techniques"},
        {"run", "run tiny.json -o another"},
        {"render", "render " + small + "-o -"},
        {"verify", "verify --technique flat"},
        {"ab", "ab tiny.json --baseline " + std::string(RELIEFBENCH_SOURCE_DIR) + " --budget 0.1s"},
        {"selfcheck", "selfcheck tiny.json --budget 1s --processes 3"},
        {"compare", "compare run run2"},
        {"history", "history run run2"},
        {"export", "export run --format csv"},
        {"advise", "advise run --budget 1s"},
        {"report", "report run -o -"},
        {"merge", "merge whole part"},
        {"bench", "bench --config tiny.json --benchmark_list_tests"},
        {"completion", "completion zsh"},
        {"man", "man"},
    };
    const std::vector<std::string> more = {"list heightmaps",
                                           "list devices",
                                           "list axes",
                                           "list bases",
                                           "list figures",
                                           "list axes --format json",
                                           "run tiny.json --dry-run",
                                           "run --help",
                                           "--help",
                                           "--version",
                                           "completion bash"};
    const std::string whole_help = reliefbench({"--help"}).out;
    const std::string help = whole_help.substr(0, whole_help.find("\n\nExit codes:"));
    const auto expect_told = [&](const std::string& command) {
        const Outcome outcome = shell("RELIEFBENCH_STATE_DIR=state " + binary() + " " + command + " > /dev/full");
        EXPECT_EQ(outcome.code, 2) << command << ": " << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("cannot write the results to standard output; is the disk full?"))
            << command;
    };
    for (std::size_t at = help.find("Subcommands:"); (at = help.find("\n  ", at)) != std::string::npos; ++at) {
        const std::string name = help.substr(at + 3, help.find(' ', at + 3) - at - 3);
        if (name.empty() || name.front() < 'a') continue;
        ASSERT_TRUE(commands.contains(name)) << "the new command '" << name << "' is not tried";
        expect_told(commands.at(name));
    }
    for (const std::string& command : more)
        expect_told(command);
}

}  // namespace
}  // namespace reliefbench
