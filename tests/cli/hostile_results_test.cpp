#include "command_line.hpp"
#include "stored_run_sample.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Two stored runs, of which `bad` gets files from an enemy.
class HostileResults : public CommandLine {
protected:
    void SetUp() override {
        store_run(path("good"), {{"pom | a"}, {"qdm | a"}});
        store_run(path("bad"), {{"pom | a"}, {"qdm | a"}});
    }

    /// Every command that reads runs, over `bad`.
    std::vector<std::vector<std::string>> readers() const {
        return {{"compare", path("good"), "--", path("bad")},
                {"history", path("good"), path("bad")},
                {"advise", path("bad"), "--uv", "1"},
                {"export", path("bad"), "--format", "csv", "-o", path("made/bad.csv")},
                {"export", path("bad"), "--format", "github_action"},
                {"report", path("bad"), "-o", path("made/bad.html")},
                {"merge", path("bad"), path("good"), "-o", path("made/merged")}};
    }

    void expect_no_crash(const std::string& file, const std::string& content) const {
        write("bad/" + file, content);
        for (const std::vector<std::string>& reader : readers()) {
            const Outcome outcome = reliefbench(reader);
            EXPECT_THAT(outcome.code, testing::AnyOf(0, 1, 2, 3))
                << reader.front() << " of " << content.substr(0, 80) << ": " << outcome.err;
        }
    }

    void expect_told(const std::string& file, const std::string& content, const std::string& word) const {
        write("bad/" + file, content);
        const Outcome outcome = reliefbench({"compare", path("good"), "--", path("bad")});
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr(file), HasSubstr(word)));
    }
};

TEST_F(HostileResults, ARecordThatIsNoneIsRefusedWithItsPath) {
    expect_told("run.json", "[]", "$: expected an object");
    expect_told("run.json", R"({"environment": {"time": 3}})", "$.environment.time: expected a string");
    expect_told("run.json", R"({"techniques": [1]})", "$.techniques: expected an object");
    expect_told("run.json", R"({"height_maps": [3]})", "$.height_maps[0]: expected an object");
    expect_told("run.json", R"({"shard": {"index": 1, "count": 4611686018427387904}})", "$.shard.count: expected");
    expect_told("run.json", R"({"a": 1, "a": 2})", "duplicate key");
    expect_told("run.json", std::string(100000, '['), "nested more than");
}

TEST_F(HostileResults, CellsThatAreNoneAreRefusedWithTheirLine) {
    const std::string cells = read_file(path("good/cells.jsonl"));
    expect_told("cells.jsonl", cells + "[]\n", "(line 3): $: expected an object");
    expect_told("cells.jsonl", cells + std::string("\0\n", 2), "(line 3):1:1");
    expect_told("cells.jsonl", cells + "{\"cell\": 1e999}\n", "(line 3)");
    expect_told("cells.jsonl", cells + "{\"cell\": \"\xff\"}\n", "(line 3)");
    expect_told("cells.jsonl", cells + std::string(100000, '[') + "\n", "nested more than");
}

TEST_F(HostileResults, NothingEndsAReader) {
    expect_no_crash("samples.jsonl", "{}\n");
    expect_no_crash("summary.json", "[" + std::string(100000, '['));
    write("bad/summary.json", R"({"total_s": "x"})");
    write("bad/rounds.jsonl", std::string(100000, '[') + "\n");
    expect_no_crash("samples.jsonl", R"({"cell":"x","pass":"draw","round":-1,"order":0,"repeats":1,"ms":["a"]})"
                                     "\n");
    expect_no_crash("run.json", R"({"device": 3, "environment": {}, "configuration": [], "empty_pass": "x"})");
}

TEST_F(HostileResults, NamesInResultsWriteNothingElsewhere) {
    store_run(path("climbing"), {{"../../escaped | a"}, {"/escaped | b"}});
    for (std::vector<std::string> reader : readers()) {
        for (std::string& word : reader) {
            if (word == path("bad")) word = path("climbing");
        }
        EXPECT_THAT(reliefbench(reader).code, testing::AnyOf(0, 1, 2, 3)) << reader.front();
    }
    EXPECT_FALSE(std::filesystem::exists(path("../escaped")));
    EXPECT_FALSE(std::filesystem::exists(path("escaped")));
}

TEST_F(HostileResults, AReportDoesNotRunWhatResultsSay) {
    const std::string script = "</script><script>alert(1)</script> | <img src=x onerror=alert(2)>";
    store_run(path("script"), {{script}});
    const Outcome outcome = reliefbench({"report", path("script"), "-o", path("page.html")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = read_file(path("page.html"));
    EXPECT_THAT(page, testing::Not(AnyOf(HasSubstr("<script>alert"), HasSubstr("<img src=x"))));
    EXPECT_THAT(page, HasSubstr("alert(1)"));
}

}  // namespace
}  // namespace reliefbench
