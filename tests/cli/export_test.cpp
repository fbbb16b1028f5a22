#include "command_line.hpp"
#include "stored_run_sample.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string pom = "pom max_steps=16 | view_angle=60";

/// Debian's, with Debian's SciPy.
constexpr const char* compare_py = "/usr/share/benchmark/compare.py";
constexpr const char* python = "/usr/bin/python3";

class Export : public CommandLine {
protected:
    std::string exported(const std::string& run, const std::string& format) const {
        const Outcome outcome = reliefbench({"export", run, "--format", format});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    }
};

TEST_F(Export, TheStockComparePyReadsGoogleBenchmarkJson) {
    ASSERT_TRUE(std::filesystem::exists(compare_py)) << "it is in libbenchmark-tools: scripts/install_packages";
    store_run(path("before"), {{pom, 1}, {"flat | view_angle=60", 2}});
    store_run(path("after"), {{pom, 1.5}, {"flat | view_angle=60", 2, 0.5, CellStatus::failed}});
    for (const char* run : {"before", "after"}) {
        ASSERT_EQ(reliefbench({"export", run, "--format", "google_benchmark", "-o", run + std::string(".json")}).code,
                  0);
    }
    const std::string command = std::string("cd '") + path("") + "' && " + python + " " + compare_py +
                                " --no-color benchmarks before.json after.json >compared 2>complaints";
    ASSERT_EQ(std::system(command.c_str()), 0) << read_file(path("complaints"));
    const std::string compared = read_file(path("compared"));
    EXPECT_EQ(read_file(path("complaints")), "");
    EXPECT_THAT(compared, HasSubstr("Comparing before.json to after.json"));
    // The last round is 1 ‰ above the median; times are in nanoseconds.
    EXPECT_THAT(compared,
                testing::ContainsRegex("\npom max_steps=16 \\| view_angle=60 +\\+0\\.5000 +\\+0\\.5000 +1001000 "
                                       "+1501500 +1001000 +1501500\n"));
    EXPECT_THAT(compared,
                testing::ContainsRegex("pom max_steps=16 \\| view_angle=60_pvalue +0\\.000[0-9] +0\\.000[0-9] "
                                       "+U Test, Repetitions: 9 vs 9\n"));
    EXPECT_THAT(compared, HasSubstr("pom max_steps=16 | view_angle=60_median"));
    EXPECT_THAT(compared, testing::Not(HasSubstr("nan")));
    // A cell without a time on one side must not look infinitely fast.
    EXPECT_THAT(compared, testing::Not(HasSubstr("flat")));
}

TEST_F(Export, EveryFormatGoesToStandardOutputOrToAFile) {
    store_run(path("run"), {{pom, 1}});
    EXPECT_EQ(Json::parse(exported("run", "github_action")).at(0).at("name"), pom);
    EXPECT_THAT(exported("run", "csv"), AllOf(testing::StartsWith("cell,technique,"), HasSubstr("\n" + pom + ",pom,")));
    EXPECT_THAT(exported("run", "markdown"), HasSubstr("### view"));
    const Outcome outcome = reliefbench({"export", "run", "--format", "csv", "-o", "cells.csv"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(outcome.out.empty());
    EXPECT_EQ(read_file(path("cells.csv")), exported("run", "csv"));
}

TEST_F(Export, BadInputIsRefused) {
    store_run(path("run"), {{pom, 1}});
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{"run"}, "--format"},
        {{"run", "--format", "cvs"}, "did you mean 'csv'?"},
        {{"missing", "--format", "csv"}, "missing holds no run"},
        {{"run", "--format", "csv", "-o", "missing/cells.csv"}, "there is no folder missing"},
        {{"run", "--format", "csv", "-o", "run"}, "run is no regular file"},
    };
    for (const auto& [arguments, words] : cases) {
        std::vector<std::string> all = {"export"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Outcome outcome = reliefbench(all);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments);
        EXPECT_THAT(outcome.err, HasSubstr(words));
        EXPECT_TRUE(outcome.out.empty());
    }
}

TEST_F(Export, ARunWritesItsExportsWhenItIsDone) {
    const std::string configuration = write_configuration("tiny.json", tiny_configuration());
    const Outcome outcome = reliefbench(
        {"run", configuration, "-o", "run", "--export", "csv=cells.csv", "--export", "google_benchmark=google.json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(read_file(path("cells.csv")), exported("run", "csv"));
    EXPECT_EQ(read_file(path("google.json")), exported("run", "google_benchmark"));
    EXPECT_EQ(Json::parse(read_file(path("google.json"))).at("benchmarks").size(), 1U);
}

TEST_F(Export, AnExportThatCannotBeIsRefusedBeforeARunBegins) {
    const std::string configuration = write_configuration("tiny.json", tiny_configuration());
    expect_refused({configuration, "--export", "cvs=cells.csv"}, {"cvs", "did you mean 'csv'?"});
    expect_refused({configuration, "--export", "csv"}, {"FORMAT=FILE", "google_benchmark"});
    expect_refused({configuration, "--export", "csv="}, {"FORMAT=FILE"});
    expect_refused({configuration, "--export", "csv=missing/cells.csv"}, {"there is no folder missing"});
}

}  // namespace
}  // namespace reliefbench
