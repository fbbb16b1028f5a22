#include "command_line.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class Bench : public CommandLine {
protected:
    /// Of the tiny configuration changed so, with these arguments.
    Outcome bench(const std::vector<std::string>& arguments, const std::function<void(Json&)>& change = {}) const {
        Json json = tiny_configuration();
        json["techniques"] = {"steep", "flat"};
        json["axes"]["view_angle"] = {0, 45};
        if (change) change(json);
        std::vector<std::string> all{"bench", "--config", write_configuration("tiny.json", json)};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return reliefbench(all);
    }

    static std::vector<std::string> lines(const std::string& text) {
        std::istringstream stream(text);
        std::vector<std::string> found;
        for (std::string line; std::getline(stream, line);)
            found.push_back(line);
        return found;
    }
};

TEST_F(Bench, ListsTheCellsUnderNamesThatAreTheirOwnFilters) {
    // Without a device: listing prepares nothing.
    const Outcome list = bench({"--benchmark_list_tests", "--device", "no such thing"});
    ASSERT_EQ(list.code, 0) << list.err;
    const std::vector<std::string> names = lines(list.out);
    ASSERT_EQ(names.size(), 4U) << list.out;
    for (const std::string& name : names) {
        EXPECT_EQ(name.find_first_of(" |+*()[]{}^$\\"), std::string::npos) << name;
        EXPECT_THAT(lines(bench({"--benchmark_list_tests", "--benchmark_filter=^" + name + "$"}).out),
                    ElementsAre(name));
    }
    EXPECT_EQ(std::count_if(names.begin(), names.end(), [](const auto& name) { return name.starts_with("steep/"); }),
              2);
}

TEST_F(Bench, WritesJsonWithTheDrawsTimeAndCounters) {
    const Outcome outcome =
        bench({"--benchmark_filter=^steep.*view_angle", "--benchmark_out=out.json", "--benchmark_context=run=first"},
              [](Json& json) {
                  json["sampling"]["rounds"] = 2;
                  json["sampling"]["samples_per_visit"] = 3;
              });
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json json = Json::parse(read_file(path("out.json")));
    const Json& context = json.at("context");
    for (const char* key : {"device", "driver", "driver_version", "tool_version"})
        EXPECT_FALSE(context.at(key).get<std::string>().empty()) << key;
    EXPECT_EQ(context.at("run"), "first");
    EXPECT_EQ(context.at("executable"), "reliefbench");
    ASSERT_EQ(json.at("benchmarks").size(), 1U);
    const Json& cell = json.at("benchmarks").front();
    EXPECT_THAT(cell.at("name").get<std::string>(), AllOf(testing::StartsWith("steep/"), HasSubstr("manual_time")));
    EXPECT_EQ(cell.at("iterations"), 2 * 3) << "rounds times samples per visit";
    EXPECT_GT(cell.at("real_time").get<double>(), 0);
    EXPECT_EQ(cell.at("time_unit"), "ms");
    EXPECT_GT(cell.at("taps").get<double>(), 0);
    EXPECT_GT(cell.at("uv_error_p99_texels").get<double>(), 0);
    EXPECT_GE(cell.at("missed_and_false_hits").get<double>(), 0);
    EXPECT_EQ(cell.at("prepare_bytes"), 0);
}

TEST_F(Bench, CountersAreThoseOfARun) {
    const Outcome outcome =
        bench({"--filter", "technique=steep", "--filter", "view_angle=45", "--benchmark_format=json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json counters = Json::parse(outcome.out).at("benchmarks").front();
    ASSERT_EQ(reliefbench({"run", path("tiny.json"), "--filter", "technique=steep", "--filter", "view_angle=45", "-o",
                           path("run")})
                  .code,
              0);
    const Json cell = read_lines(path("run/cells.jsonl")).front();
    // The file has doubles in full.
    EXPECT_DOUBLE_EQ(counters.at("taps").get<double>(), cell.at("work").at("taps_mean").get<double>());
    EXPECT_DOUBLE_EQ(counters.at("uv_error_p99_texels").get<double>(),
                     cell.at("error").at("uv_texels").at("p99").get<double>());
}

TEST_F(Bench, RepetitionsInterleavedGiveJsonWithoutNaN) {
    // Coefficients of variation of counters that are zero are NaN to Google Benchmark.
    const Outcome outcome = bench({"--benchmark_repetitions=3", "--benchmark_enable_random_interleaving",
                                   "--benchmark_format=json", "--benchmark_out=out.json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const std::string& text : {outcome.out, read_file(path("out.json"))}) {
        const Json runs = Json::parse(text).at("benchmarks");
        EXPECT_EQ(
            std::count_if(runs.begin(), runs.end(), [](const Json& run) { return run.at("run_type") == "iteration"; }),
            4 * 3);
        EXPECT_EQ(std::count_if(runs.begin(), runs.end(),
                                [](const Json& run) { return run.value("aggregate_name", "") == "cv"; }),
                  4);
    }
}

TEST_F(Bench, OtherFlagsWork) {
    const Outcome csv = bench({"--benchmark_filter=flat", "--benchmark_out=out.csv", "--benchmark_out_format=csv",
                               "--benchmark_time_unit=us", "--benchmark_min_time=0.001"});
    ASSERT_EQ(csv.code, 0) << csv.err;
    EXPECT_THAT(csv.out, AllOf(HasSubstr("flat/"), HasSubstr(" us"), Not(HasSubstr("steep"))));
    EXPECT_THAT(read_file(path("out.csv")), AllOf(HasSubstr("name,iterations"), HasSubstr("flat/")));
}

TEST_F(Bench, AFailedCellIsReportedAndTheOthersGoOn) {
    std::ofstream(copy_technique("steep", "mine") / "trace.glsl", std::ios::app) << "\nthis is no GLSL;\n";
    const Outcome outcome = bench({"--techniques", path("techniques"), "--benchmark_out=out.json"}, [](Json& json) {
        json["techniques"] = {"mine", "flat"};
    });
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("cell failed"), HasSubstr("trace.glsl")));
    const Json written = Json::parse(read_file(path("out.json")));
    for (const Json& cell : written.at("benchmarks")) {
        const bool broken = cell.at("name").get<std::string>().starts_with("mine/");
        EXPECT_EQ(cell.value("error_occurred", false), broken) << cell;
        if (broken) {
            EXPECT_THAT(cell.at("error_message").get<std::string>(), HasSubstr("trace.glsl"));
        }
    }
}

TEST_F(Bench, CellsThatAreFilteredOutAreNotPrepared) {
    std::ofstream(copy_technique("steep", "mine") / "trace.glsl", std::ios::app) << "\nthis is no GLSL;\n";
    const Outcome outcome = bench({"--techniques", path("techniques"), "--benchmark_filter=^flat"}, [](Json& json) {
        json["techniques"] = {"mine", "flat"};
    });
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(Bench, CellsThatWereFreedMeanwhileAreMadeReadyAgain) {
    // More than stay prepared, each visited twice in random order.
    const Outcome outcome =
        bench({"--benchmark_repetitions=2", "--benchmark_enable_random_interleaving", "--benchmark_format=json"},
              [](Json& json) {
                  Json caps = Json::array();
                  for (int cap = 64; cap < 64 + 70; ++cap)
                      caps.push_back(cap);
                  json["techniques"] = {{{"technique", "qdm"}, {"parameters", {{"max_steps", caps}}}}};
                  json["axes"] = {{"heightmap", "bricks"}, {"heightmap_size", 16}, {"resolution", 8}};
              });
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::map<std::string, std::vector<double>> taps;
    const Json runs = Json::parse(outcome.out).at("benchmarks");
    for (const Json& run : runs) {
        if (run.at("run_type") == "iteration")
            taps[run.at("name").get<std::string>()].push_back(run.at("taps").get<double>());
    }
    EXPECT_EQ(taps.size(), 70U);
    for (const auto& [cell, counted] : taps)
        EXPECT_THAT(counted, ElementsAre(counted.front(), counted.front())) << cell;
}

TEST_F(Bench, ASkippedCellTellsItsReasonAndIsNoFailure) {
    const std::filesystem::path manifest = copy_technique("steep", "mine") / "technique.json";
    Json json = Json::parse(read_file(manifest));
    for (Json& parameter : json.at("parameters")) {
        if (parameter.at("name") == json.at("sample_count")) parameter["range"] = {1, 64};
    }
    std::ofstream(manifest) << json.dump();
    const Outcome outcome = bench({"--techniques", path("techniques"), "--benchmark_filter=mine"}, [](Json& tiny) {
        tiny["techniques"] = {"mine", "steep"};
        tiny["axes"]["sample_count"] = 128;
    });
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("skipped: "), HasSubstr("64")));
}

TEST_F(Bench, RefusesWhatItCannotDo) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{"--benchmark_no_such_flag"}, "--benchmark_no_such_flag"},
        {{"--benchmark_repetitions=many"}, "--benchmark_repetitions=many"},
        {{"--benchmark_format=xml"}, "console, json, csv"},
        {{"--benchmark_out_format=xml", "--benchmark_out=x"}, "json, console, csv"},
        {{"--benchmark_time_unit=h"}, "ms, ns, us, s"},
        {{"--benchmark_color="}, "--benchmark_color"},
        {{"--benchmark_out=no/such/folder/out.json"}, "no/such/folder/out.json"},
        {{"--benchmark_filter=no_such_cell"}, "no_such_cell"},
        {{"--benchmark_filter=["}, "--benchmark_list_tests"},
        {{"--no-such-option"}, "--no-such-option"},
        {{"--filter", "technique=qdm"}, "qdm"},
        {{"-a", "view_angel=3"}, "did you mean 'view_angle'?"},
        {{"-a", "heightmap=missing.png"}, "missing.png"},
    };
    for (const auto& [arguments, word] : cases) {
        const Outcome outcome = bench(arguments);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments) << outcome.out;
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("reliefbench: "), HasSubstr(word)));
    }
}

TEST_F(Bench, TheDefaultConfigurationIsTheShippedQuickOne) {
    const Outcome outcome = reliefbench({"bench", "--benchmark_list_tests", "--filter", "technique=flat"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("flat/heightmap=rock"));
}

}  // namespace
}  // namespace reliefbench
