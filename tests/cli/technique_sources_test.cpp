// --techniques: which folders count, and what of them is a run's source.

#include "command_line.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// One technique of its own, "mine", in techniques/ of the test's folder.
class TechniqueSourcesOfRuns : public CommandLine {
protected:
    void SetUp() override {
        copy_technique("steep", "mine");
        Json json = tiny_configuration();
        json["techniques"] = {"mine"};
        write_configuration("mine.json", json);
    }

    Outcome run(const std::string& folder, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"run", path("mine.json"), "--techniques", path("techniques"), "-o", folder};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return reliefbench(arguments);
    }
};

TEST_F(TechniqueSourcesOfRuns, WhatAnEditorLeavesBehindChangesNoSource) {
    ASSERT_EQ(run(path("before")).code, 0);
    for (const char* file : {".trace.glsl.swp", "trace.glsl~", "4913"})
        write(std::string("techniques/mine/") + file, "anything");
    const Outcome resumed = run(path("before"), {"--resume"});
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    ASSERT_EQ(run(path("after")).code, 0);
    const Outcome compared = reliefbench({"compare", path("before"), path("after")});
    EXPECT_THAT(compared.out, Not(HasSubstr("the sources of these techniques"))) << compared.out;

    write("techniques/mine/trace.glsl", read_file(path("techniques/mine/trace.glsl")) + "// edited\n");
    const Outcome refused = run(path("before"), {"--resume"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("the content of techniques differs (mine)"));
    ASSERT_EQ(run(path("edited")).code, 0);
    EXPECT_THAT(reliefbench({"compare", path("before"), path("edited")}).out,
                HasSubstr("the sources of these techniques changed: mine"));
}

TEST_F(TechniqueSourcesOfRuns, OneDirectoryCountsOnceByWhateverPath) {
    std::filesystem::create_directory_symlink(path("techniques"), path("link"));
    std::filesystem::create_directory_symlink(std::string(RELIEFBENCH_SOURCE_DIR) + "/techniques", path("shipped"));
    for (const std::string& again : {path("techniques"), path("techniques/../techniques"), path("link"),
                                     path("shipped"), std::string(RELIEFBENCH_SOURCE_DIR) + "/techniques"}) {
        const Outcome outcome =
            reliefbench({"list", "techniques", "--techniques", path("techniques"), "--techniques", again});
        EXPECT_EQ(outcome.code, 0) << again << outcome.err;
        EXPECT_THAT(outcome.out, HasSubstr("\nmine "));
    }
}

TEST_F(TechniqueSourcesOfRuns, AFolderWithoutTechniquesSaysSo) {
    std::filesystem::create_directory(path("empty"));
    const Outcome empty = reliefbench({"list", "techniques", "--techniques", path("empty")});
    EXPECT_EQ(empty.code, 2);
    EXPECT_THAT(empty.err, AllOf(HasSubstr("--techniques: " + path("empty")), HasSubstr("holds no technique folder")));
    const Outcome own = reliefbench({"run", path("mine.json"), "--techniques", path("techniques/mine"), "--dry-run"});
    EXPECT_EQ(own.code, 2);
    EXPECT_THAT(own.err, HasSubstr("is one technique's folder; name the folder that holds it: " + path("techniques")));
    const Outcome slash = reliefbench({"verify", "--techniques", path("techniques/mine/")});
    EXPECT_THAT(slash.err, HasSubstr("name the folder that holds it: " + path("techniques")));
    EXPECT_EQ(reliefbench({"list", "techniques", "--techniques", path("nowhere")}).code, 2);
}

TEST_F(TechniqueSourcesOfRuns, WhatATechniqueNeedsOfTheMapIsSeenBeforeARun) {
    const std::string manifest = "techniques/mine/technique.json";
    Json json = Json::parse(read_file(path(manifest)));
    json["needs"] = {{"map", {"untiled"}}};
    write(manifest, json.dump());
    const Outcome planned = run(path("none"), {"-a", "tiling=1,2", "--dry-run"});
    EXPECT_THAT(planned.out, AllOf(HasSubstr("1 cell in 1 block, 1 skipped"), HasSubstr("here the tiling is 2")))
        << planned.err;

    const std::string listed = reliefbench({"list", "techniques", "--techniques", path("techniques")}).out;
    const std::size_t name = listed.find("\nmine ");
    ASSERT_NE(name, std::string::npos) << listed;
    EXPECT_GT(listed.find("needs of the height map: untiled"), name);
}

TEST_F(TechniqueSourcesOfRuns, ARecordedDirectoryMayHoldNoneAnyMore) {
    ASSERT_EQ(run(path("before")).code, 0);
    Json record = Json::parse(read_file(path("before/run.json")));
    std::filesystem::create_directory(path("empty"));
    record["technique_directories"].push_back(path("empty"));
    write("record.json", record.dump());
    EXPECT_EQ(reliefbench({"run", path("record.json"), "--dry-run"}).code, 0);
    EXPECT_EQ(reliefbench({"run", path("record.json"), "--dry-run", "--techniques", path("empty")}).code, 2);
}

}  // namespace
}  // namespace reliefbench
