#include "report/run_format.hpp"

#include "core/error.hpp"
#include "run_sample.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(RunFormat, JsonIsTheCellsAsTheFileHasThem) {
    const reliefbench::Run run = sample_run();  // testing::Test has a Run of its own
    const Json cells = Json::parse(format_run(run, RunFormat::json, {}));
    ASSERT_EQ(cells.size(), run.cells.size());
    for (std::size_t cell = 0; cell < run.cells.size(); ++cell) {
        EXPECT_EQ(cells[cell], to_json(run.cells[cell]));
    }
    EXPECT_EQ(Json::parse(format_run({}, RunFormat::json, {})), Json::array());
}

TEST(RunFormat, EachHasItsOwnText) {
    const reliefbench::Run run = sample_run();  // testing::Test has a Run of its own
    EXPECT_THAT(format_run(run, parse_run_format("table"), {}), testing::StartsWith("heightmap=bricks\n"));
    EXPECT_THAT(format_run(run, parse_run_format("markdown"), {}), testing::StartsWith("### heightmap=bricks\n"));
    EXPECT_THAT(format_run(run, parse_run_format("csv"), {}), testing::StartsWith("cell,technique,"));
}

TEST(RunFormat, TimesMadeOnASharedDeviceSaySo) {
    reliefbench::Run run = sample_run();
    for (const char* format : {"table", "markdown"}) {
        run.run["environment"]["shared_device"] = false;
        EXPECT_THAT(format_run(run, parse_run_format(format), {}), Not(HasSubstr("share-device"))) << format;
        run.run["environment"].erase("shared_device");
        EXPECT_THAT(format_run(run, parse_run_format(format), {}), Not(HasSubstr("share-device"))) << format;
        run.run["environment"]["shared_device"] = true;
        EXPECT_THAT(format_run(run, parse_run_format(format), {}), HasSubstr("were made with --share-device"))
            << format;
    }
}

TEST(RunFormat, AnUnknownNameIsAnError) {
    EXPECT_EQ(error_message([] { parse_run_format("cvs"); }),
              "--format: there is no 'cvs' (did you mean 'csv'?); the formats are table, markdown, csv, json");
}

}  // namespace
}  // namespace reliefbench
