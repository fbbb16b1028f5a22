#include "command_line.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Selfcheck : public CommandLine {
protected:
    void SetUp() override { setenv("RELIEFBENCH_STATE_DIR", path("state").c_str(), 1); }
    void TearDown() override { unsetenv("RELIEFBENCH_STATE_DIR"); }

    std::vector<std::filesystem::path> kept() const {
        std::vector<std::filesystem::path> files;
        if (!std::filesystem::exists(path("state"))) return files;
        for (const auto& entry : std::filesystem::directory_iterator(path("state"))) {
            files.push_back(entry.path());
        }
        return files;
    }
};

TEST_F(Selfcheck, FindsWhatShowsWithinAndBetweenProcessesAndKeepsIt) {
    const std::string configuration = write_configuration("tiny.json", tiny_configuration());
    const Outcome outcome = reliefbench({"selfcheck", configuration, "--processes", "3", "--budget", "4s"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("within one process"), HasSubstr("between processes (3 of them)"),
                                   HasSubstr("runs a side"), HasSubstr(path("state"))));
    ASSERT_EQ(kept().size(), 1U);
    const Json record = Json::parse(read_file(kept()[0]));
    ASSERT_EQ(record.at("cells").size(), 1U) << record;
    EXPECT_EQ(record.at("cells")[0].at("log_median_ms").size(), 3U) << record;
    EXPECT_FALSE(std::filesystem::exists(path("results"))) << "its runs belong among the temporary files";
}

TEST_F(Selfcheck, BadInputKeepsNothing) {
    const std::string configuration = write_configuration("tiny.json", tiny_configuration());
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"selfcheck", configuration, "--processes", "1"},
                                               {"selfcheck", configuration, "--budget", "long"},
                                               {"selfcheck", path("missing.json")},
                                               {"selfcheck", configuration, "--device", "no such thing"}}) {
        const Outcome outcome = reliefbench(arguments);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments);
        EXPECT_THAT(outcome.out, testing::IsEmpty());
    }
    EXPECT_TRUE(kept().empty());
}

}  // namespace
}  // namespace reliefbench
