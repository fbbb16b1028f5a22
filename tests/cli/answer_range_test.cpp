#include "command_line.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A technique that answers out of range is failed for that wherever it is drawn.
class AnswerRange : public CommandLine {
protected:
    std::string mine(const std::string& trace) const {
        std::filesystem::create_directories(path("techniques/mine"));
        write("techniques/mine/technique.json",
              R"({"title": "Mine", "kind": "march", "citation": "none", "shape": "quad", "promises": [],
                  "parameters": []})");
        write("techniques/mine/trace.glsl", "Trace trace(ReliefRay ray) {" + trace + "}\n");
        return path("techniques");
    }

    std::string configuration() const {
        Json json = tiny_configuration();
        json["techniques"] = {"mine"};
        return write_configuration("tiny.json", json);
    }
};

constexpr const char* negative_s = "return hit_on_ray(-0.5 - tap_height(ray.uv), 1);";
constexpr const char* negative_steps = "return hit_on_ray(1.0 - tap_height(ray.uv), -3);";

TEST_F(AnswerRange, RunFailsTheCellWithTheReasonAndKeepsNoFigure) {
    for (const auto& [trace, words] : {std::pair(negative_s, "s = -"), std::pair(negative_steps, "steps = -3")}) {
        const std::string folder = path(std::string("run of ") + words);
        const Outcome outcome = reliefbench({"run", configuration(), "--techniques", mine(trace), "-o", folder});
        EXPECT_EQ(outcome.code, 4) << outcome.err;
        const Json cell = read_lines(folder + "/cells.jsonl").at(0);
        EXPECT_EQ(cell.at("status"), "failed");
        EXPECT_THAT(cell.at("reason").get<std::string>(),
                    AllOf(HasSubstr("answered out of range"), HasSubstr(words), HasSubstr("at pixel (")));
        EXPECT_TRUE(cell.at("error").is_null());
        EXPECT_TRUE(cell.at("work").is_null());
    }
}

TEST_F(AnswerRange, AbFailsTheCellWithTheReason) {
    const std::string baseline = path("baseline");
    std::filesystem::create_directories(baseline + "/mine");
    const std::string techniques = mine("return hit_on_ray(1.0 - tap_height(ray.uv), 1);");
    std::filesystem::copy(techniques, baseline,
                          std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
    mine(negative_s);
    const Outcome outcome =
        reliefbench({"ab", configuration(), "--baseline", baseline, "--techniques", techniques, "--budget", "1s"});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("new side"), HasSubstr("out of range")));
}

TEST_F(AnswerRange, BenchFailsTheCellWithTheReason) {
    const Outcome outcome = reliefbench({"bench", "--config", configuration(), "--techniques", mine(negative_s)});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("answered out of range"));
}

TEST_F(AnswerRange, RenderDrawsTheCellAndFails) {
    const std::vector<std::string> arguments{"render", "--technique",      "mine", "--techniques",  mine(negative_s),
                                             "-a",     "resolution=32x32", "-o",   path("mine.png")};
    const Outcome outcome = reliefbench(arguments);
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("failed: mine"), HasSubstr("answered out of range")));
    EXPECT_TRUE(std::filesystem::exists(path("mine.png")));
    std::vector<std::string> sheet = arguments;
    sheet.push_back("--contact-sheet");
    EXPECT_EQ(reliefbench(sheet).code, 4);
    std::vector<std::string> frames = arguments;
    frames.insert(frames.end(), {"--animate", "view_angle=0,30"});
    EXPECT_EQ(reliefbench(frames).code, 4);
}

/// What stands behind "to see it: " in each line that has it.
std::vector<std::string> commands_in(const std::string& lines) {
    const std::string mark = "to see it: ";
    std::vector<std::string> commands;
    for (std::size_t at = lines.find(mark); at != std::string::npos; at = lines.find(mark, at)) {
        at += mark.size();
        commands.push_back(lines.substr(at, lines.find('\n', at) - at));
    }
    return commands;
}

TEST_F(AnswerRange, VerifyNamesTheReasonThePixelAndACommandThatDrawsIt) {
    // A folder that a shell would take apart.
    mine(negative_s);
    std::filesystem::rename(path("techniques"), path("my techniques (new)"));
    const Outcome outcome = reliefbench({"verify", "--technique", "mine", "--techniques", path("my techniques (new)")});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("s = -1.48163"), HasSubstr("at pixel (33, 51)")));
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("0 hits")));
    const std::vector<std::string> commands = commands_in(outcome.out);
    ASSERT_GE(commands.size(), 4u);
    const std::string binary = std::filesystem::path(RELIEFBENCH_BINARY).parent_path().string();
    for (const std::string& command : {commands.front(), commands.back()}) {
        std::filesystem::remove(path("mine.png"));
        const Outcome drawn = shell("PATH='" + binary + "':\"$PATH\"; " + command);
        EXPECT_EQ(drawn.code, 4) << command << '\n' << drawn.err;
        EXPECT_THAT(drawn.err, HasSubstr("answered out of range")) << command;
        EXPECT_TRUE(std::filesystem::exists(path("mine.png"))) << command;
    }
    // One of them needs a map that no name stands for.
    EXPECT_TRUE(std::any_of(commands.begin(), commands.end(),
                            [](const std::string& command) { return command.find("ones.pgm") != std::string::npos; }));
}

TEST_F(AnswerRange, TheCommandForAMapOfOnesWorks) {
    const Outcome outcome = reliefbench({"verify", "--technique", "mine", "--techniques", mine(negative_steps)});
    for (const std::string& command : commands_in(outcome.out)) {
        if (command.find("ones.pgm") == std::string::npos) continue;
        const std::string binary = std::filesystem::path(RELIEFBENCH_BINARY).parent_path().string();
        const Outcome drawn = shell("PATH='" + binary + "':\"$PATH\"; " + command);
        EXPECT_THAT(drawn.err, HasSubstr("steps = -3 at pixel (")) << command;
        return;
    }
    FAIL() << outcome.out;
}

}  // namespace
}  // namespace reliefbench
