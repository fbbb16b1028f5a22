#include "store/merge.hpp"

#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace reliefbench;

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

NamedRun shard(int index, int count, const std::vector<std::string>& cells) {
    NamedRun run;
    run.name = fmt::format("part{}", index);
    run.run.run = Json::parse(R"({
        "configuration": {"seed": 1}, "filters": [], "shaders": "s",
        "techniques": {"first": "t"},
        "defaults": {"parameters": {"first": {"steps": 8}}, "axes": {"fov": 45}},
        "height_maps": [{"name": "rock", "format": "r16", "size": [64, 64], "hash": "h"}],
        "bases": [{"name": "car.glb", "base_fit": "unit", "hash": "m"}],
        "device": {"name": "gpu", "type": "discrete GPU", "driver": "d", "driver_version": "1"},
        "environment": {"cpu": "c", "tool_version": "1"}
    })");
    run.run.run["shard"] = {{"index", index}, {"count", count}};
    for (const std::string& cell : cells) {
        CellResult result;
        result.cell = cell;
        result.technique = "first";
        run.run.cells.push_back(result);
    }
    return run;
}

std::string refusal(const std::vector<NamedRun>& runs) {
    return error_message([&] { merge_runs(runs); });
}

TEST(Merge, PutsShardsTogetherAndKeepsEachCellsMachine) {
    NamedRun second = shard(2, 2, {"c"});
    second.run.run["environment"]["cpu"] = "another";
    second.run.run["techniques"] = {{"second", "u"}};
    second.run.run["defaults"]["parameters"] = {{"second", {{"leaf", "exact"}}}};
    second.run.run["height_maps"][0]["name"] = "bricks";
    second.run.run["bases"][0]["base_fit"] = "none";
    const MergedRun merged = merge_runs(std::vector{shard(1, 2, {"a", "b"}), second});
    EXPECT_THAT(merged.missing, IsEmpty());
    ASSERT_EQ(merged.run.cells.size(), 3U);
    EXPECT_EQ(merged.run.cells[2].cell, "c");
    const Json& record = merged.run.run;
    EXPECT_FALSE(record.contains("shard"));
    EXPECT_EQ(record.at("techniques"), Json::parse(R"({"first": "t", "second": "u"})"));
    EXPECT_EQ(record.at("defaults"), Json::parse(R"({"parameters": {"first": {"steps": 8}, "second": {"leaf": "exact"}},
                                                     "axes": {"fov": 45}})"));
    EXPECT_EQ(record.at("height_maps").size(), 2U);
    EXPECT_EQ(record.at("bases").size(), 2U);
    EXPECT_EQ(record.at("merged").at(1).at("environment").at("cpu"), "another");
    EXPECT_EQ(record.at("merged").at(1).at("cells"), Json::array({"c"}));
}

TEST(Merge, TellsMissingShards) {
    EXPECT_THAT(merge_runs(std::vector{shard(2, 3, {"a"})}).missing, ElementsAre("shard 1/3", "shard 3/3"));
}

TEST(Merge, TellsMissingCells) {
    const std::vector<PlannedCell> planned = {{"a", 1}, {"b", 1}, {"c", 2}, {"d", 2}, {"e", 2}, {"f", 3}};
    EXPECT_THAT(
        merge_runs(std::vector{shard(1, 3, {"b"}), shard(2, 3, {"d"})}, planned).missing,
        ElementsAre("shard 3/3", "a cell of shard 1/3 (part1): 'a'", "2 cells of shard 2/3 (part2): 'c' and others"));
    EXPECT_THAT(merge_runs(std::vector{shard(1, 1, {"f", "e", "d", "c", "b", "a"})}, planned).missing, IsEmpty());
}

TEST(Merge, RefusesWhatIsThereTwice) {
    EXPECT_THAT(refusal({shard(1, 2, {"a"}), shard(1, 2, {"b"})}), HasSubstr("both shard 1/2"));
    EXPECT_THAT(refusal({shard(1, 2, {"a"}), shard(2, 2, {"a"})}),
                AllOf(HasSubstr("'a'"), HasSubstr("part1"), HasSubstr("part2")));
}

TEST(Merge, NeverMixesRunsOrDevices) {
    const auto refused_with = [](const char* pointer, const Json& value) {
        NamedRun other = shard(2, 2, {"b"});
        other.run.run[Json::json_pointer(pointer)] = value;
        return refusal({shard(1, 2, {"a"}), other});
    };
    EXPECT_THAT(refused_with("/configuration/seed", 2), HasSubstr("seed was 1 and is 2"));
    EXPECT_THAT(refused_with("/device/name", "slow gpu"), HasSubstr("'slow gpu'"));
    EXPECT_THAT(refused_with("/device/driver_version", "2"), HasSubstr("driver's version"));
    EXPECT_THAT(refused_with("/shaders", "x"), HasSubstr("shaders"));
    EXPECT_THAT(refused_with("/techniques/first", "x"), HasSubstr("technique 'first'"));
    EXPECT_THAT(refused_with("/height_maps/0/hash", "x"), HasSubstr("height map 'rock'"));
    EXPECT_THAT(refused_with("/bases/0/hash", "x"), HasSubstr("base 'car.glb'"));
    EXPECT_THAT(refused_with("/shard/count", 3), HasSubstr("different runs"));
}

TEST(Merge, RefusesWhatIsNoShard) {
    NamedRun whole = shard(1, 1, {"a"});
    whole.run.run.erase("shard");
    EXPECT_THAT(refusal({whole}), HasSubstr("is no shard"));
    EXPECT_THAT(refusal({shard(3, 2, {"a"})}), HasSubstr("cannot be"));
}

}  // namespace
