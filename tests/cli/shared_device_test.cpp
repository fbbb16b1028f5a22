// Times that were made beside other processes say so.

#include "command_line.hpp"

#include <gmock/gmock.h>

#include <fstream>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class SharedDevice : public CommandLine {
protected:
    std::string tiny() const { return write_configuration("tiny.json", tiny_configuration()); }

    Outcome run(const std::string& folder, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"run", tiny(), "-o", path(folder), "--share-device"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return reliefbench(arguments);
    }

    Json record(const std::string& folder) const { return Json::parse(read_file(path(folder + "/run.json"))); }

    /// As if it had been made so; null: by a version that did not say.
    void make_shared(const std::string& folder, const Json& shared) const {
        Json json = record(folder);
        if (shared.is_null()) {
            json["environment"].erase("shared_device");
        } else {
            json["environment"]["shared_device"] = shared;
        }
        write(folder + "/run.json", json.dump());
    }
};

TEST_F(SharedDevice, TheRunRecordAndTheTableSaySo) {
    const Outcome outcome = run("run");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(record("run").at("environment").at("shared_device"), true);
    EXPECT_THAT(outcome.out, HasSubstr("note: the times were made with --share-device"));
}

TEST_F(SharedDevice, CompareWarnsOfEachRunThatWasShared) {
    ASSERT_EQ(run("before").code, 0);
    ASSERT_EQ(run("after").code, 0);
    const auto notes = [&](const Json& before, const Json& after) {
        make_shared("before", before);
        make_shared("after", after);
        return reliefbench({"compare", "before", "after"}).out;
    };
    EXPECT_THAT(notes(true, true), AllOf(HasSubstr("the times of before were made with --share-device"),
                                         HasSubstr("the times of after were made with --share-device")));
    EXPECT_THAT(notes(false, true), AllOf(Not(HasSubstr("the times of before were")),
                                          HasSubstr("the times of after were made with --share-device")));
    EXPECT_THAT(notes(false, false), Not(HasSubstr("--share-device")));
    EXPECT_THAT(notes(nullptr, nullptr), Not(HasSubstr("--share-device"))) << "nothing is known of older runs";
}

TEST_F(SharedDevice, ARunThatWasResumedSoIsPartlyShared) {
    ASSERT_EQ(run("run").code, 0);
    make_shared("run", false);
    write("run/cells.jsonl", "");
    const Outcome resumed = run("run", {"--resume"});
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_EQ(record("run").at("resumed").at(0).at("environment").at("shared_device"), true);
    EXPECT_THAT(resumed.out, HasSubstr("note: the times were partly made with --share-device"));
}

TEST_F(SharedDevice, AbAndBenchSaySo) {
    const std::string techniques = std::string(RELIEFBENCH_SOURCE_DIR) + "/techniques";
    const Outcome ab = reliefbench({"ab", tiny(), "--baseline", techniques, "--budget", "0.5s", "--share-device"});
    EXPECT_THAT(ab.out, HasSubstr("the times were made with --share-device")) << ab.err;
    const Outcome bench = reliefbench({"bench", "--config", tiny(), "--share-device", "--benchmark_format=json"});
    ASSERT_EQ(bench.code, 0) << bench.err;
    EXPECT_EQ(Json::parse(bench.out).at("context").at("shared_device"), "true");
}

}  // namespace
}  // namespace reliefbench
