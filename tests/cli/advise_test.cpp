#include "command_line.hpp"
#include "stored_run_sample.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class AdviseCommand : public CommandLine {
protected:
    void SetUp() override {
        store_run(path("run"), {{"pom max_steps=8 | view_angle=60", 1, 10.4}, {"qdm | view_angle=60", 2.76, 0.095}});
    }

    Outcome advise(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"advise", path("run"), "--rank-by", "error.uv_texels.p99"});
        return reliefbench(arguments);
    }
};

TEST_F(AdviseCommand, SaysWhatTheBudgetBuysAndWhatMoreWould) {
    for (const char* budget : {"2ms", "2", "2000us", "0.002s"}) {
        const Outcome outcome = advise({"--budget", budget});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_THAT(outcome.out, testing::ContainsRegex("use +1\\.000 .* 10\\.4 .*pom max_steps=8\n"));
        EXPECT_THAT(outcome.out, testing::ContainsRegex("beyond the budget +2\\.760 .* 0\\.0950 .*qdm\n"));
    }
}

TEST_F(AdviseCommand, TakesSeveralLimitsAtOnceAndSaysWhereNothingKeepsToThem) {
    EXPECT_THAT(advise({"--budget", "3ms", "--uv", "0.5"}).out, testing::ContainsRegex("use +2\\.760"));
    EXPECT_THAT(advise({"--budget", "2ms", "--limit", "error.uv_texels.p99=0.5"}).out,
                AllOf(HasSubstr("nothing does that"), HasSubstr("nearest")));
    const Json json = Json::parse(advise({"--uv", "0.5", "--format", "json"}).out);
    EXPECT_EQ(json.at("views").at(0).at("best").at("setting"), "qdm");
}

TEST_F(AdviseCommand, BadInputIsRefused) {
    struct Bad {
        std::vector<std::string> arguments;
        std::string word;
    };
    const std::vector<Bad> cases = {
        {{}, "at least one limit"},
        {{"--budget", "2 parsecs"}, "--budget: expected a time such as 2ms"},
        {{"--budget", "-1ms"}, "above 0"},
        {{"--flip", "0.02"}, "no measured cell of the run has image.footprint.flip"},
        {{"--limit", "error.uv_texels.p98=1"},
         "there is no figure 'error.uv_texels.p98' (did you mean 'error.uv_texels.p95'?)"},
        {{"--limit", "error.compared=1"}, "neither more nor less"},
        {{"--limit", "error.missed"}, "FIGURE=VALUE"},
        {{"--limit", "error.missed=x"}, "FIGURE=VALUE"},
        {{"--uv", "nan"}, "not a number"},
        {{"--uv", "1", "--rank-by", "speed"}, "there is no figure 'speed'"},
        {{"--uv", "1", "--cell", "steep"}, "no cell's id contains 'steep'"},
        {{"--uv", "1", "--format", "xml"}, "there is no format 'xml'"},
    };
    for (const auto& [arguments, word] : cases) {
        std::vector<std::string> line = {"advise", path("run")};
        line.insert(line.end(), arguments.begin(), arguments.end());
        const Outcome outcome = reliefbench(line);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments);
        EXPECT_THAT(outcome.err, HasSubstr(word));
    }
    EXPECT_EQ(reliefbench({"advise", path("no_run"), "--uv", "1"}).code, 2);
}

}  // namespace
}  // namespace reliefbench
