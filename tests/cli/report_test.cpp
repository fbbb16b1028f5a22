#include "command_line.hpp"
#include "core/file.hpp"
#include "stored_run_sample.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string pom = "pom max_steps=16 | view_angle=60";
const std::string flat = "flat | view_angle=60";

class Report : public CommandLine {
protected:
    /// The data of a report that was written.
    Json data_of(const std::string& file) const {
        const std::string page = read_file(path(file));
        const std::string opening = R"(<script type="application/json" id="data">)";
        const std::size_t begin = page.find(opening) + opening.size();
        return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
    }
};

TEST_F(Report, ARunBecomesOnePage) {
    store_run(path("run"), {{pom, 1}, {flat, 2, 0.5, CellStatus::failed}});
    const Outcome outcome = reliefbench({"report", "run", "-o", "report.html"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "report: report.html (open it in a browser)\n");
    const Json data = data_of("report.html");
    EXPECT_EQ(data.at("runs").at(0).at("name"), "run");
    EXPECT_EQ(data.at("runs").at(0).at("cells").at("id"), Json({pom, flat}));
    EXPECT_EQ(data.at("runs").at(0).at("samples").at(0).at("groups"), Json({9}));
    EXPECT_TRUE(data.at("comparison").is_null());
    const std::string page = read_file(path("report.html"));
    for (const char* outside : {"<link", " src=", "@import", "url("}) {
        EXPECT_THAT(page, testing::Not(HasSubstr(outside))) << "the page must read nothing but itself";
    }
}

TEST_F(Report, TwoRunsAreCompared) {
    store_run(path("before"), {{pom, 1}, {flat, 2}});
    store_run(path("after"), {{pom, 9}, {flat, 2}});
    ASSERT_EQ(reliefbench({"report", "before", "after", "-o", "report.html"}).code, 0);
    const Json comparison = data_of("report.html").at("comparison");
    EXPECT_EQ(comparison.at("base"), Json({"before"}));
    EXPECT_EQ(comparison.at("new"), Json({"after"}));
    EXPECT_EQ(comparison.at("result").at("cells").at("cell").size(), 2U);
}

TEST_F(Report, MoreRunsAreComparedWhereTheSidesAreTold) {
    for (const char* run : {"a", "b", "c"}) {
        store_run(path(run), {{pom, 1}});
    }
    ASSERT_EQ(reliefbench({"report", "a", "b", "c", "-o", "plain.html"}).code, 0);
    EXPECT_TRUE(data_of("plain.html").at("comparison").is_null());
    EXPECT_EQ(data_of("plain.html").at("runs").size(), 3U);
    ASSERT_EQ(reliefbench({"report", "a", "b", "--", "c", "-o", "sides.html"}).code, 0);
    EXPECT_EQ(data_of("sides.html").at("comparison").at("base"), Json({"a", "b"}));
    EXPECT_EQ(data_of("sides.html").at("comparison").at("new"), Json({"c"}));
}

TEST_F(Report, RunsThatCannotBeComparedAreShownAllTheSame) {
    store_run(path("before"), {{pom, 1}});
    store_run(path("after"), {{pom, 1}}, "another device");
    const Outcome outcome = reliefbench({"report", "before", "after", "-o", "report.html"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("another device"));
    EXPECT_THAT(data_of("report.html").at("comparison").at("failure").get<std::string>(), HasSubstr("another device"));
}

TEST_F(Report, BadInputIsRefused) {
    store_run(path("run"), {{pom, 1}});
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{"run"}, "--output"},
        {{"missing", "-o", "report.html"}, "missing holds no run"},
        {{"run", "-o", "missing/report.html"}, "there is no folder missing"},
        {{"run", "-o", "run"}, "run is no regular file"},
        {{"run", "run", "-o", "report.html"}, "named twice"},
        {{"run", "--", "-o", "report.html"}, "report: there is no run after the --"},
        {{"run", "-o", "report.html", "--picture-megabytes", "-1"}, "--picture-megabytes"},
    };
    for (const auto& [arguments, words] : cases) {
        std::vector<std::string> all = {"report"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Outcome outcome = reliefbench(all);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments);
        EXPECT_THAT(outcome.err, HasSubstr(words));
        EXPECT_FALSE(std::filesystem::exists(path("report.html")));
    }
}

TEST_F(Report, PicturesOfARunComeAlong) {
    Json configuration = tiny_configuration();
    configuration["images"] = true;
    ASSERT_EQ(reliefbench({"run", write_configuration("tiny.json", configuration), "-o", "run"}).code, 0);
    ASSERT_EQ(reliefbench({"report", "run", "-o", "report.html"}).code, 0);
    const Json data = data_of("report.html");
    const Json& pictures = data.at("runs").at(0).at("pictures");
    EXPECT_EQ(pictures.at("left_out"), 0);
    for (const Json& position :
         {pictures.at("technique").at(0), pictures.at("truth").at(0), pictures.at("maps").at("uv_error").at(0)}) {
        EXPECT_LT(position.get<std::size_t>(), data.at("pictures").size());
    }
    ASSERT_EQ(reliefbench({"report", "run", "-o", "report.html", "--picture-megabytes", "0"}).code, 0);
    EXPECT_EQ(data_of("report.html").at("runs").at(0).at("pictures").at("left_out"), 1);
}

}  // namespace
}  // namespace reliefbench
