#include "command_line.hpp"
#include "stored_run_sample.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string pom = "pom | view_angle=60";
const std::string steep = "steep | view_angle=60";

class Compare : public CommandLine {
protected:
    // No noise of the machine that runs the tests may play in.
    void SetUp() override { setenv("RELIEFBENCH_STATE_DIR", path("state").c_str(), 1); }

    /// Runs that differ by 1 ‰ from each other: `count` of them, called <name>0, <name>1, ...
    std::vector<std::string> store(const std::string& name, const std::vector<StoredCell>& cells, int count = 4) const {
        std::vector<std::string> names;
        for (int run = 0; run < count; ++run) {
            std::vector<StoredCell> shifted = cells;
            for (StoredCell& cell : shifted) {
                cell.ms *= 1 + 0.001 * run;
            }
            names.push_back(name + std::to_string(run));
            store_run(path(names.back()), shifted);
        }
        return names;
    }

    Outcome compare(const std::vector<std::string>& base, const std::vector<std::string>& changed,
                    const std::vector<std::string>& options = {}) const {
        std::vector<std::string> arguments = {"compare"};
        arguments.insert(arguments.end(), base.begin(), base.end());
        arguments.emplace_back("--");
        arguments.insert(arguments.end(), changed.begin(), changed.end());
        arguments.insert(arguments.end(), options.begin(), options.end());
        return reliefbench(arguments);
    }
};

TEST_F(Compare, ASlowerCellIsARegression) {
    const auto base = store("base", {{pom, 1}, {steep, 2}});
    const auto changed = store("new", {{pom, 1.5}, {steep, 2}});
    const Outcome outcome = compare(base, changed);
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("slower, 1 cell\n"), HasSubstr(pom), Not(HasSubstr(steep)),
                                   HasSubstr("2 cells compared: 1 slower, 0 undecided, 0 faster, 1 same")));
}

TEST_F(Compare, FasterOrTheSameIsFine) {
    const auto base = store("base", {{pom, 1}, {steep, 2}});
    const auto changed = store("new", {{pom, 0.5}, {steep, 2}});
    EXPECT_EQ(compare(base, changed).code, 0);
    EXPECT_THAT(compare(base, changed, {"--all"}).out, HasSubstr(steep));
}

TEST_F(Compare, OneRunASideAtAChangeWithinTheNoiseIsUndecided) {
    store("base", {{pom, 1}}, 1);
    store("new", {{pom, 1.05}}, 1);
    const Outcome outcome = reliefbench({"compare", "base0", "new0"});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("undecided, 1 cell"), HasSubstr("noise between runs")));
}

TEST_F(Compare, WorseQualityIsARegressionHoweverFast) {
    const auto base = store("base", {{pom, 1, 0.5}});
    const auto changed = store("new", {{pom, 0.5, 0.6}});
    const Outcome outcome = compare(base, changed);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.out, HasSubstr("worse by 20 %: error.uv_texels.p99 0.500 → 0.600 texels"));
}

/// An error that fell at the cost of hits, an error that fell, and one that did not change.
const std::vector<StoredCell> before = {{"a | v", 1, 0.5}, {"b | v", 1, 0.5}, {"c | v", 1, 0.5}};
const std::vector<StoredCell> after = {{"a | v", 5, 0.1, CellStatus::ok, 0.01}, {"b | v", 5, 0.1}, {"c | v", 5, 0.5}};

TEST_F(Compare, AMixedQualityIsARegressionUnlessItIsAccepted) {
    store_run(path("base"), before);
    store_run(path("new"), after);
    const Outcome outcome = reliefbench({"compare", "--quality", "base", "new"});
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("mixed quality (some figures better, others worse; --accept-mixed lets it "
                                       "pass), 1 cell\n"
                                       "  a | v\n"
                                       "      worse by 1.0 % of footprint: error.missed+error.false_hits 0 → 1.00 % of "
                                       "footprint\n"
                                       "      better by 80 %: error.uv_texels.p99 0.500 → 0.100 texels\n"));
    EXPECT_EQ(reliefbench({"compare", "--quality", "--accept-mixed", "base", "new"}).code, 0);
    EXPECT_THAT(reliefbench({"compare", "--quality", "--format", "github", "base", "new"}).out,
                HasSubstr("::error title=mixed quality::a | v"));
    EXPECT_THAT(reliefbench({"compare", "--quality", "--accept-mixed", "--format", "github", "base", "new"}).out,
                HasSubstr("::warning title=mixed quality::a | v"));
}

TEST_F(Compare, QualityAloneSaysNothingOfTimes) {
    store_run(path("base"), before);
    store_run(path("new"), after, "another device");
    const Outcome table = reliefbench({"compare", "--quality", "base", "new"});
    EXPECT_THAT(table.out, AllOf(Not(HasSubstr("slower")), Not(HasSubstr("undecided")), Not(HasSubstr("threshold")),
                                 HasSubstr("3 cells compared; quality: 0 worse, 1 mixed, 1 better, 1 same\n")));
    const Json json = Json::parse(reliefbench({"compare", "--quality", "--format", "json", "base", "new"}).out);
    EXPECT_FALSE(json.at("cells").at(0).contains("ratio"));
    EXPECT_FALSE(json.contains("threshold"));
    EXPECT_EQ(json.at("cells").at(1).at("quality").at("verdict"), "better");
    EXPECT_THAT(reliefbench({"compare", "--quality", "--format", "markdown", "base", "new"}).out,
                AllOf(HasSubstr("| **mixed** | `a \\| v` |"), Not(HasSubstr("Threshold"))));
}

TEST_F(Compare, ChosenFiguresDecide) {
    store_run(path("base"), before);
    store_run(path("new"), after);
    const auto code_with = [&](const std::string& figures) {
        return reliefbench({"compare", "--quality", "--quality-figures", figures, "base", "new"}).code;
    };
    EXPECT_EQ(code_with("error.uv_texels.p99"), 0);
    EXPECT_EQ(code_with("error.missed"), 1);
    EXPECT_EQ(code_with("error.missed:0.02"), 0);
    EXPECT_EQ(code_with("error.uv_texels.p99,error.missed+error.false_hits:0.001:50%"), 1);
    const Outcome none = reliefbench({"compare", "--quality", "--quality-figures", "image.ssim", "base", "new"});
    EXPECT_EQ(none.code, 3) << "runs that do not have the figure decide nothing";
    EXPECT_THAT(none.out, HasSubstr("quality: 0 worse, 0 mixed, 0 better, 0 same, 3 not comparable"));
    EXPECT_THAT(none.out, HasSubstr("quality is decided by changes beyond these: image.ssim: 0.005\n"));
}

TEST_F(Compare, ACellThatFailedNowWeighsMoreThanASlowerOne) {
    const auto base = store("base", {{pom, 1}, {steep, 1}});
    const auto changed = store("new", {{pom, 2}, {steep, 1, 0.5, CellStatus::failed}});
    const Outcome outcome = compare(base, changed);
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr("slower, 1 cell"), HasSubstr("failed now, 1 cell"), HasSubstr("trace.glsl:3")));
}

TEST_F(Compare, NothingToCompareDecidesNothing) {
    store_run(path("base"), {{pom, 1}});
    store_run(path("new"), {{steep, 1}});
    const Outcome outcome = reliefbench({"compare", "base", "new"});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("only in the base"), HasSubstr("0 cells compared; 2 not compared")));
}

TEST_F(Compare, OptionsMayStandAnywhere) {
    store("base", {{pom, 1}}, 2);
    store("new", {{pom, 4}}, 2);
    const std::vector<std::vector<std::string>> orders = {
        {"compare", "--format", "json", "base0", "base1", "--", "new0", "new1"},
        {"compare", "base0", "--format", "json", "base1", "--", "new0", "new1"},
        {"compare", "base0", "base1", "--", "--format", "json", "new0", "new1"},
        {"compare", "base0", "base1", "--", "new0", "--format=json", "new1"},
        {"compare", "base0", "base1", "--", "new0", "new1", "--format", "json"},
    };
    for (const std::vector<std::string>& arguments : orders) {
        const Outcome outcome = reliefbench(arguments);
        ASSERT_EQ(outcome.code, 1) << testing::PrintToString(arguments) << outcome.err;
        const Json json = Json::parse(outcome.out);
        EXPECT_EQ(json.at("environment").at("base").at("runs"), Json::parse(R"(["base0", "base1"])"));
        EXPECT_EQ(json.at("environment").at("new").at("runs"), Json::parse(R"(["new0", "new1"])"));
        EXPECT_EQ(json.at("cells").at(0).at("verdict"), "slower");
    }
}

TEST_F(Compare, EveryFormatSaysTheSame) {
    const auto base = store("base", {{pom, 1}});
    const auto changed = store("new", {{pom, 1.5}});
    EXPECT_THAT(compare(base, changed, {"--format", "markdown"}).out,
                HasSubstr("| **slower** | `pom \\| view_angle=60`"));
    EXPECT_THAT(compare(base, changed, {"--format", "github"}).out, HasSubstr("::error title=slower +50 %25::pom"));
    for (const char* format : {"table", "markdown", "json", "github"}) {
        EXPECT_EQ(compare(base, changed, {"--format", format}).code, 1) << format;
    }
}

TEST_F(Compare, TheThresholdIsPerCentOrAFraction) {
    const auto base = store("base", {{pom, 1}});
    const auto changed = store("new", {{pom, 1.5}});
    for (const char* threshold : {"5%", "5 %", "0.05"}) {
        const Outcome outcome = compare(base, changed, {"--threshold", threshold, "--format", "json"});
        ASSERT_EQ(outcome.code, 1) << outcome.err;
        EXPECT_DOUBLE_EQ(Json::parse(outcome.out).at("threshold").get<double>(), 0.05);
    }
    EXPECT_EQ(compare(base, changed, {"--threshold", "90%"}).code, 0);
}

TEST_F(Compare, AnotherDeviceIsRefusedUnlessAskedFor) {
    store_run(path("here"), {{pom, 1}});
    store_run(path("there"), {{pom, 2}}, "another device");
    const Outcome refused = reliefbench({"compare", "here", "there"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("another device"), HasSubstr("--across-devices")));
    EXPECT_TRUE(refused.out.empty());
    const Outcome allowed = reliefbench({"compare", "here", "there", "--across-devices"});
    EXPECT_EQ(allowed.code, 1);
    EXPECT_THAT(allowed.out, HasSubstr("another device"));
}

struct BadComparison {
    std::vector<std::string> arguments;
    std::string words;
};

TEST_F(Compare, BadInputIsRefused) {
    std::filesystem::create_directory(path("runs"));
    store_run(path("runs/a"), {{pom, 1}});
    store_run(path("runs/b"), {{pom, 1}});
    store_run(path("c"), {{pom, 1}});
    const std::vector<BadComparison> cases = {
        {{"runs/a"}, "one run is nothing to compare"},
        {{"runs/a", "runs/b", "c"}, "which of the 3 runs are the base? Put -- between"},
        {{"runs/a", "--", "runs/b", "--", "c"}, "more than one --"},
        {{"--", "runs/a"}, "no run before the --"},
        {{"runs/a", "runs/b", "--"}, "no run after the --"},
        {{"runs", "c"}, "runs is no run, but a folder of 2 runs (runs/a, runs/b)"},
        {{"c", "missing"}, "missing holds no run"},
        {{"c", "./c/"}, "named twice"},
        {{"runs/a", "c", "--threshold", "2"}, "per cent are written with their sign, 2%"},
        {{"runs/a", "c", "--threshold", "0"}, "more than 0"},
        {{"runs/a", "c", "--threshold", "-1%"}, "more than 0"},
        {{"runs/a", "c", "--threshold", "nan"}, "more than 0"},
        {{"runs/a", "c", "--threshold", "two"}, "expected a fraction such as 2% or 0.02, found 'two'"},
        {{"runs/a", "c", "--threshold", "%"}, "expected a fraction"},
        {{"runs/a", "c", "--format", "jsn"}, "did you mean 'json'?"},
        {{"runs/a", "c", "--quality", "--threshold", "2%"}, "--threshold excludes --quality"},
        {{"runs/a", "c", "--quality-figures", "image.flop"}, "did you mean 'image.flip'?"},
        {{"runs/a", "c", "--quality-figures", "time.draw.median_ms"}, "is a time, which has a verdict of its own"},
        {{"runs/a", "c", "--quality-figures", "error.depth.mean"}, "neither less nor more is better"},
        {{"runs/a", "c", "--quality-figures", "image.flip:x"}, "expected a tolerance such as 0.05"},
        {{"runs/a", "c", "--quality-figures", "image.flip,image.flip:0.1"}, "named twice"},
        {{"runs/a", "c", "--quality-figures", "image.flip+error.missed"}, "their sum means nothing"},
        {{}, "--help"},
    };
    for (const BadComparison& bad : cases) {
        std::vector<std::string> arguments = {"compare"};
        arguments.insert(arguments.end(), bad.arguments.begin(), bad.arguments.end());
        const Outcome outcome = reliefbench(arguments);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(bad.arguments);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("reliefbench: "), HasSubstr(bad.words)));
        EXPECT_TRUE(outcome.out.empty()) << outcome.out;
    }
}

TEST_F(Compare, NowhereToKeepNoiseMeansTheDefault) {
    store_run(path("a"), {{pom, 1}});
    store_run(path("b"), {{pom, 9}});
    for (const char* variable : {"RELIEFBENCH_STATE_DIR", "XDG_STATE_HOME", "HOME"}) {
        unsetenv(variable);
    }
    const Outcome outcome = reliefbench({"compare", "a", "b"});
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("default"));
}

class HistoryCommand : public Compare {
protected:
    std::vector<std::string> store_series(const std::vector<double>& ms) const {
        std::vector<std::string> arguments = {"history"};
        for (std::size_t run = 0; run < ms.size(); ++run) {
            arguments.push_back("run" + std::to_string(run));
            store_run(path(arguments.back()), {{pom, ms[run]}, {steep, 2 + 0.001 * static_cast<double>(run % 3)}});
        }
        return arguments;
    }
};

TEST_F(HistoryCommand, MarksWhereACellChanged) {
    std::vector<std::string> arguments = store_series({1, 1.01, 0.99, 1, 1.01, 1.5, 1.51, 1.49, 1.5, 1.51});
    const Outcome table = reliefbench(arguments);
    EXPECT_EQ(table.code, 0) << table.err;
    EXPECT_THAT(table.out, AllOf(HasSubstr("│"), HasSubstr("at 6"), HasSubstr("2 cells over 10 runs: 1 changed")));
    arguments.insert(arguments.end(), {"--cell", "pom", "--format", "json"});
    const Json json = Json::parse(reliefbench(arguments).out);
    ASSERT_EQ(json.at("cells").size(), 1U);
    ASSERT_EQ(json.at("cells").at(0).at("changes").size(), 1U);
    EXPECT_EQ(json.at("cells").at(0).at("changes").at(0).at("run"), 5);
    EXPECT_EQ(json.at("groups").at(0).at("cells").at(0), pom);
}

TEST_F(HistoryCommand, BadInputIsRefused) {
    const std::vector<std::string> series = store_series({1, 1, 1});
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = series;
        arguments.insert(arguments.end(), more.begin(), more.end());
        return reliefbench(arguments);
    };
    EXPECT_THAT(with({}).err, HasSubstr("3 runs are too few for change points"));
    EXPECT_EQ(with({}).code, 0);
    EXPECT_EQ(with({"--cell", "qdm"}).code, 2);
    EXPECT_THAT(with({"--cell", "qdm"}).err, HasSubstr("no cell's id contains 'qdm'"));
    EXPECT_EQ(with({"--format", "github"}).code, 2);
    EXPECT_EQ(with({"--threshold", "x"}).code, 2);
    EXPECT_THAT(with({"run0"}).err, HasSubstr("named twice"));
    EXPECT_EQ(reliefbench({"history"}).code, 2);
}

}  // namespace
}  // namespace reliefbench
