// --techniques: which folders count, and what of them is a run's source.

#include "command_line.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <map>
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

TEST_F(TechniqueSourcesOfRuns, WhatAShaderDeclaresConcernsItsOwnCellAlone) {
    const auto declare = [&](const std::string& id, const std::string& declaration, const std::string& use) {
        const std::string file = "techniques/" + id + "/trace.glsl";
        std::string text = read_file(path(file));
        const std::string call = "Trace trace(ReliefRay ray) {";
        const std::size_t body = text.find(call);
        ASSERT_NE(body, std::string::npos);
        text.insert(body + call.size(), use);
        text.insert(body, declaration + "\n");
        write(file, text);
    };
    const std::string sampler = "layout(set = 0, binding = 30) uniform sampler mine;";
    copy_technique("steep", "other");
    declare("mine", sampler + " layout(set = 0, binding = 31) uniform texture2D other;",
            "if (textureSize(sampler2D(other, mine), 0).x > 9) return hit_on_ray(0.0, 0);");
    declare("other", sampler + " layout(push_constant) uniform Pushed { mat4 pushed; };", "");
    Json json = tiny_configuration();
    json["techniques"] = {"mine", "other", "pom"};
    write_configuration("mine.json", json);

    const Outcome outcome = run(path("run"));
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    std::map<std::string, Json> cells;
    for (const Json& cell : read_lines(path("run/cells.jsonl")))
        cells[cell.at("technique")] = cell;
    ASSERT_EQ(cells.size(), 3U);
    EXPECT_EQ(cells["mine"].at("status"), "failed");
    EXPECT_THAT(cells["mine"].at("reason").get<std::string>(),
                HasSubstr("use the Sampler 'mine', to which nothing is bound"));
    EXPECT_EQ(cells["other"].at("status"), "ok") << cells["other"].dump();
    EXPECT_EQ(cells["pom"].at("status"), "ok");
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
