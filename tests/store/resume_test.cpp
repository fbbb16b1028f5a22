#include "store/resume.hpp"

#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace reliefbench;

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Json recorded = Json::parse(R"({
    "configuration": {"axes": {"heightmap": ["/somewhere/rocks.png"], "view_angle": [0, 60]}, "seed": 1},
    "filters": [],
    "techniques": {"first": "aa"},
    "shaders": "bb",
    "source_hashes": "included files",
    "height_maps": [{"name": "rocks.png", "hash": "cc"}],
    "device": {"name": "fast", "type": "discrete GPU", "driver": "d", "driver_version": "1"},
    "environment": {"cpu": "old", "tool_version": "0.1.0", "time": "yesterday"}
})");

std::vector<std::string> differences_after(const char* pointer, const Json& value) {
    Json now = recorded;
    now[Json::json_pointer(pointer)] = value;
    return resume_differences(recorded, now);
}

TEST(ResumeDifferences, WhenWhereAndByWhomDoNotMatter) {
    EXPECT_THAT(differences_after("/environment/time", "today"), IsEmpty());
    EXPECT_THAT(differences_after("/configuration/axes/heightmap/0", "/elsewhere/rocks.png"), IsEmpty());
    EXPECT_THAT(differences_after("/empty_pass", 1), IsEmpty());
    EXPECT_THAT(differences_after("/environment/cpu", "new"), IsEmpty()) << "the device is no CPU";
}

TEST(ResumeDifferences, AllThatMovesAFigureIsTold) {
    EXPECT_THAT(differences_after("/configuration/axes/view_angle/1", 61),
                ElementsAre("the configuration differs: the axis view_angle was 0, 60 and is 0, 61"));
    EXPECT_THAT(differences_after("/configuration/axes/azimuth", Json::array({45})),
                ElementsAre("the configuration differs: the axis azimuth was not set and is 45"));
    EXPECT_THAT(differences_after("/configuration/sampling", Json::parse(R"({"rounds": 6})")),
                ElementsAre("the configuration differs: sampling differs"));
    EXPECT_THAT(differences_after("/configuration/seed", 2),
                ElementsAre("the configuration differs: seed was 1 and is 2"));
    EXPECT_THAT(differences_after("/filters", Json::array({"technique=first"})), ElementsAre("the filters differ"));
    EXPECT_THAT(differences_after("/techniques/first", "ab"), ElementsAre("the content of techniques differs (first)"));
    EXPECT_THAT(differences_after("/shaders", "ab"), ElementsAre("the content of shaders differs"));
    EXPECT_THAT(differences_after("/height_maps/0/hash", "ab"),
                ElementsAre("the content of height maps differs (rocks.png)"));
    EXPECT_THAT(differences_after("/bases", Json::parse(R"([{"name": "car.glb", "hash": "dd"}])")),
                ElementsAre("the content of bases differs"));
    EXPECT_THAT(differences_after("/device/name", "slow"), ElementsAre("the device was 'fast' and is 'slow'"));
    EXPECT_THAT(differences_after("/device/driver_version", "2"),
                ElementsAre("the driver's version was '1' and is '2'"));
    EXPECT_THAT(differences_after("/environment/tool_version", "0.2.0"),
                ElementsAre("the tool's version was '0.1.0' and is '0.2.0'"));
}

TEST(ResumeDifferences, HashesOfWholeFoldersMayDifferByOtherFiles) {
    Json before = recorded;
    before.erase("source_hashes");
    EXPECT_THAT(resume_differences(before, recorded), IsEmpty());
    before["techniques"]["first"] = "ab";
    EXPECT_THAT(resume_differences(before, recorded),
                ElementsAre("the content of techniques differs (first), or of other files in their folders"));
    before = recorded;
    before.erase("source_hashes");
    before["height_maps"][0]["hash"] = "ab";
    EXPECT_THAT(resume_differences(before, recorded), ElementsAre("the content of height maps differs (rocks.png)"));
}

TEST(ResumeDifferences, OfACpuDeviceTheCpuIsTold) {
    Json before = recorded;
    before["device"]["type"] = "CPU";
    Json after = before;
    after["environment"]["cpu"] = "new";
    EXPECT_THAT(resume_differences(before, after), ElementsAre("the CPU was 'old' and is 'new'"));
}

TEST(EarlierWork, HasWhatIsFinishedAndTheVisitsOfWhatIsNot) {
    const TemporaryFolder folder;
    {
        RunWriter writer(folder / "run", Json::object());
        CellResult done;
        done.cell = "done";
        done.technique = "first";
        writer.append_samples({"done", "draw", 0, 0, 1, {1}});
        writer.append_samples({"half", "tree", 0, 0, 1, {9}});
        writer.append_samples({"half", "draw", 1, 0, 4, {2, 3}});
        writer.append_samples({"half", "draw", 0, 0, 4, {4}});
        writer.append_samples({"half", "draw", 2, 0, 4, {5}, true});
        writer.append_cell(done);
    }
    const EarlierWork earlier = read_earlier_work(folder / "run", "draw");
    EXPECT_EQ(earlier.finished.size(), 1U);
    EXPECT_TRUE(earlier.finished.contains("done"));
    ASSERT_EQ(earlier.visits.size(), 1U);
    const std::vector<RawSamples>& visits = earlier.visits.at("half");
    ASSERT_EQ(visits.size(), 2U) << "throttled visits do not count";
    EXPECT_THAT(visits[0].ms, ElementsAre(4));
    EXPECT_THAT(visits[1].ms, ElementsAre(2, 3));
    EXPECT_EQ(visits[1].repeats, 4);
}

}  // namespace
