// Runs of a version that is still to come: it has figures that this one does not know, and declares them in run.json.
#include "command_line.hpp"
#include "stored_run_sample.hpp"

#include <gmock/gmock.h>

#include <fstream>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class LaterVersion : public CommandLine {
protected:
    /// A run of two cells with a figure of its own.
    void store(const std::string& name, double torn_sides) const {
        store_run(path(name), {{"pom | view_angle=60", 1}, {"steep | view_angle=60", 2}});
        Json record = Json::parse(read_file(path(name + "/run.json")));
        record["figures"] = {{{"path", "error.torn_sides.mean"},
                              {"label", "Torn sides"},
                              {"unit", "fraction of footprint"},
                              {"better", "lower"},
                              {"needs", {"truth"}}}};
        write(name + "/run.json", record.dump());
        std::string lines;
        for (Json line : read_lines(path(name + "/cells.jsonl"))) {
            line["error"]["torn_sides"]["mean"] = torn_sides;
            lines += line.dump() + '\n';
        }
        write(name + "/cells.jsonl", lines);
    }
};

TEST_F(LaterVersion, ItsFiguresAreExportedAndReportedWithTheirLabels) {
    store("run", 0.25);
    const Outcome csv = reliefbench({"export", path("run"), "--format", "csv"});
    ASSERT_EQ(csv.code, 0) << csv.err;
    EXPECT_THAT(csv.out, AllOf(HasSubstr(",error.torn_sides.mean,"), HasSubstr(",0.25,")));
    ASSERT_EQ(reliefbench({"report", path("run"), "-o", path("report.html")}).code, 0);
    EXPECT_THAT(read_file(path("report.html")),
                AllOf(HasSubstr("Torn sides"), HasSubstr(R"("error.torn_sides.mean":[0.25,0.25])")));
}

TEST_F(LaterVersion, ItsFiguresAreComparedAndDecideWhereTheyAreChosen) {
    store("before", 0.25);
    store("after", 0.5);
    const Outcome informed = reliefbench({"compare", "--quality", "--format", "json", path("before"), path("after")});
    EXPECT_EQ(informed.code, 0) << informed.err;
    EXPECT_THAT(informed.out, HasSubstr("error.torn_sides.mean"));
    const std::vector<std::string> chosen = {"compare", "--quality", "--quality-figures", "error.torn_sides.mean"};
    const auto with = [&chosen](std::vector<std::string> runs) {
        runs.insert(runs.begin(), chosen.begin(), chosen.end());
        return runs;
    };
    EXPECT_EQ(reliefbench(with({path("before"), path("after")})).code, 1);
    EXPECT_EQ(reliefbench(with({path("after"), path("before")})).code, 0);
}

TEST_F(LaterVersion, AdviceGoesByItsFigures) {
    store("run", 0.25);
    const auto advise = [&](const std::string& limit) {
        return reliefbench({"advise", path("run"), "--limit", limit, "--rank-by", "error.uv_texels.p99"});
    };
    EXPECT_THAT(advise("error.torn_sides.mean=0.3").out,
                AllOf(HasSubstr("Torn sides at most 30.0 % of footprint"), HasSubstr("use")));
    EXPECT_THAT(advise("error.torn_sides.mean=0.2").out, HasSubstr("nothing does that"));
    EXPECT_THAT(advise("torn_sides=0.2").err, HasSubstr("did you mean error.torn_sides.mean?"));
}

TEST_F(LaterVersion, WhatItDoesNotDeclareIsAnError) {
    store("run", 0.25);
    Json record = Json::parse(read_file(path("run/run.json")));
    record.erase("figures");
    write("run/run.json", record.dump());
    const Outcome refused = reliefbench({"export", path("run"), "--format", "csv"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr(R"($.error: unknown key "torn_sides")"));
}

}  // namespace
}  // namespace reliefbench
