#include "command_line.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <set>

namespace reliefbench {
namespace {

using testing::HasSubstr;

class Shards : public CommandLine {
protected:
    /// Three blocks of one view each would be one: views of 64 cells fill a block.
    std::string configuration() const {
        Json json = tiny_configuration();
        Json steps = Json::array();
        for (int count = 1; count <= 40; ++count)
            steps.push_back(count);
        json["axes"]["sample_count"] = steps;
        json["axes"]["view_angle"] = {0, 30, 60};
        json["axes"]["resolution"] = 16;
        return write_configuration("shards.json", json);
    }
};

std::set<std::string> cell_ids(const std::string& file) {
    std::set<std::string> ids;
    for (const Json& cell : read_lines(file))
        EXPECT_TRUE(ids.insert(cell.at("cell").get<std::string>()).second);
    return ids;
}

TEST_F(Shards, MeasuredApartAndMergedAreTheWholeRun) {
    const std::string config = configuration();
    ASSERT_EQ(reliefbench({"run", config, "-o", path("part1"), "--shard", "1/2"}).code, 0);
    const Outcome missing = reliefbench({"merge", path("early"), path("part1")});
    EXPECT_EQ(missing.code, 2);
    EXPECT_THAT(missing.err, HasSubstr("shard 2/2"));
    // The task of a job array, whose numbers may begin anywhere.
    setenv("SLURM_ARRAY_TASK_ID", "6", 1);
    setenv("SLURM_ARRAY_TASK_MIN", "5", 1);
    setenv("SLURM_ARRAY_TASK_COUNT", "2", 1);
    const Outcome second = reliefbench({"run", config, "-o", path("part2")});
    for (const char* variable : {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_COUNT"})
        unsetenv(variable);
    ASSERT_EQ(second.code, 0) << second.err;
    EXPECT_EQ(cell_ids(path("part1/cells.jsonl")).size() + cell_ids(path("part2/cells.jsonl")).size(), 120U);
    const Outcome merged = reliefbench({"merge", path("whole"), path("part1"), path("part2")});
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_EQ(cell_ids(path("whole/cells.jsonl")).size(), 120U);
    EXPECT_EQ(read_lines(path("whole/samples.jsonl")).size(), 120U);
    EXPECT_EQ(reliefbench({"compare", path("whole"), path("whole") + "/."}).code, 2) << "one run is no comparison";
    EXPECT_EQ(reliefbench({"export", path("whole"), "--format", "csv", "-o", path("whole.csv")}).code, 0);
}

TEST_F(Shards, OneThatMeasuresNothingSaysSo) {
    const std::string config = write_configuration("tiny.json", tiny_configuration());
    EXPECT_THAT(reliefbench({"run", config, "--dry-run", "--shard", "1/3"}).err, testing::IsEmpty());
    const std::string words = "shard 3/3 measures nothing: there is only 1 block to deal to 3 shards";
    EXPECT_THAT(reliefbench({"run", config, "--dry-run", "--shard", "3/3"}).err, HasSubstr(words));
    const Outcome outcome = reliefbench({"run", config, "--shard", "3/3", "-o", path("nothing")});
    EXPECT_EQ(outcome.code, 0) << "its folder is what `merge` asks for";
    EXPECT_THAT(outcome.err, HasSubstr(words));
}

TEST_F(Shards, NonsenseIsRefused) {
    const std::string config = write_configuration("tiny.json", tiny_configuration());
    EXPECT_EQ(reliefbench({"run", config, "-o", path("run"), "--shard", "3/2"}).code, 2);
    setenv("GTEST_SHARD_INDEX", "2", 1);
    setenv("GTEST_TOTAL_SHARDS", "2", 1);
    const Outcome outside = reliefbench({"run", config, "-o", path("run")});
    unsetenv("GTEST_SHARD_INDEX");
    unsetenv("GTEST_TOTAL_SHARDS");
    EXPECT_EQ(outside.code, 2);
    EXPECT_THAT(outside.err, HasSubstr("GTEST_SHARD_INDEX"));
}

}  // namespace
}  // namespace reliefbench
