// A worker that crashes, hangs, is killed or loses its device costs the cell that it was on, not the run.

#include "command_line.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <thread>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Shell words that put the layer of tests/faulty_layer in front of the driver.
const std::string with_faulty_layer = std::string("VK_ADD_LAYER_PATH=") + RELIEFBENCH_FAULTY_LAYER_FOLDER +
                                      " VK_INSTANCE_LAYERS=VK_LAYER_RELIEFBENCH_faulty ";

class Supervisor : public CommandLine {
protected:
    /// The driver does something at the pipeline with 13 steps.
    std::string three_step_counts() const {
        Json json = tiny_configuration();
        json["techniques"] = {"steep"};
        json["axes"]["sample_count"] = {8, 13, 21};
        return write_configuration("three.json", json);
    }

    std::map<int, Json> cells_by_steps(const std::string& run) const {
        std::map<int, Json> cells;
        for (const Json& cell : read_lines(path(run + "/cells.jsonl")))
            cells[cell.at("parameters").at("max_steps").get<int>()] = cell;
        return cells;
    }
};

/// The only child of a process.
pid_t child_of(pid_t process) {
    const std::string number = std::to_string(process);
    pid_t child = 0;
    std::ifstream("/proc/" + number + "/task/" + number + "/children") >> child;
    return child;
}

int exit_code_of(pid_t process) {
    int status = 0;
    waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(Supervisor, ACellThatCrashesTheDriverIsTriedTwiceAndTheSweepGoesOn) {
    const Outcome outcome =
        reliefbench({"run", three_step_counts(), "-o", path("run")}, with_faulty_layer + "RELIEFBENCH_CRASH_AT=13");
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("max_steps=13"), HasSubstr("Segmentation fault")));
    const std::map<int, Json> cells = cells_by_steps("run");
    ASSERT_EQ(cells.size(), 3U);
    EXPECT_EQ(cells.at(8).at("status"), "ok");
    EXPECT_EQ(cells.at(21).at("status"), "ok");
    EXPECT_EQ(cells.at(13).at("status"), "failed");
    EXPECT_THAT(cells.at(13).at("reason").get<std::string>(), AllOf(HasSubstr("2 times"), HasSubstr("signal 11")));
    EXPECT_EQ(read_lines(path("run/crashes.jsonl")).size(), 2U);
    // Nor is it tried again by who resumes.
    const Outcome resumed = reliefbench({"run", three_step_counts(), "-o", path("run"), "--resume"});
    EXPECT_EQ(resumed.code, 4) << resumed.err;
    EXPECT_EQ(read_lines(path("run/cells.jsonl")).size(), 3U);
}

TEST_F(Supervisor, ALostDeviceIsMadeAnew) {
    const Outcome outcome = reliefbench({"run", three_step_counts(), "-o", path("run")},
                                        with_faulty_layer + "RELIEFBENCH_LOSE_DEVICE_AT=13");
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("was lost; another worker goes on"));
    const std::map<int, Json> cells = cells_by_steps("run");
    ASSERT_EQ(cells.size(), 3U);
    EXPECT_EQ(cells.at(8).at("status"), "ok");
    EXPECT_EQ(cells.at(21).at("status"), "ok");
    EXPECT_THAT(cells.at(13).at("reason").get<std::string>(), HasSubstr("the device was lost"));
    EXPECT_FALSE(std::filesystem::exists(path("run/crashes.jsonl")));
}

TEST_F(Supervisor, APassThatRunsTooLongEndsItsCell) {
    const std::filesystem::path slow = copy_technique("flat", "slow");
    // Ends by itself, below what lavapipe allows the loops of an invocation, but not soon.
    std::ofstream(slow / "trace.glsl") << R"(
Trace trace(ReliefRay ray) {
    float sum = 0.0;
    for (int i = 0; i < 65000; ++i) sum += tap_height(ray.uv + vec2(sum, float(i) * 0.001));
    return hit_on_ray(fract(sum) * 0.001, 1);
}
)";
    Json json = tiny_configuration();
    json["techniques"] = {"steep", "slow"};
    json["axes"]["resolution"] = 256;
    const Outcome outcome = reliefbench({"run", write_configuration("slow.json", json), "-o", path("run"),
                                         "--techniques", path("techniques"), "--pass-timeout", "1.5s"});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    const std::vector<Json> cells = read_lines(path("run/cells.jsonl"));
    ASSERT_EQ(cells.size(), 2U);
    for (const Json& cell : cells) {
        EXPECT_EQ(cell.at("status"), cell.at("technique") == "slow" ? "failed" : "ok") << cell.at("reason");
        if (cell.at("technique") != "slow") continue;
        EXPECT_THAT(cell.at("reason").get<std::string>(), HasSubstr("a pass ran past 1.5s (--pass-timeout)"));
    }
}

TEST_F(Supervisor, MapsThatWorkersDiedOnAreNotMadeAgainForOtherCells) {
    const std::filesystem::path slow = copy_technique("flat", "slow");
    std::ofstream(slow / "technique.json") << R"({
        "title": "Slow", "kind": "texture", "citation": "none", "parameters": [], "shape": "quad", "promises": [],
        "maps": [{"name": "made", "format": "r32f"}],
        "passes": [{"name": "search", "shader": "search.glsl", "writes": "made"}]})";
    std::ofstream(slow / "search.glsl") << R"(
void prepare(ivec2 texel) {
    float sum = 0.0;
    for (int i = 0; i < 65000; ++i) sum += tap_height(vec2(texel) + vec2(sum, float(i) * 0.001));
    write_map(vec4(sum));
}
)";
    std::ofstream(slow / "trace.glsl") << "Trace trace(ReliefRay ray) { return hit_off_ray(ray.uv, 1.0, 0); }";
    Json json = tiny_configuration();
    json["techniques"] = {"steep", "slow"};
    json["axes"]["heightmap_size"] = 128;
    json["axes"]["view_angle"] = {0, 30, 45, 60};
    const Outcome outcome = reliefbench({"run", write_configuration("slow.json", json), "-o", path("run"),
                                         "--techniques", path("techniques"), "--pass-timeout", "1s"});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_EQ(read_lines(path("run/crashes.jsonl")).size(), 2U) << outcome.err;
    std::size_t not_made = 0;
    for (const Json& cell : read_lines(path("run/cells.jsonl"))) {
        EXPECT_EQ(cell.at("status"), cell.at("technique") == "slow" ? "failed" : "ok") << cell.at("reason");
        const bool known =
            cell.at("reason").dump().find("making its maps ended the worker process 2 times") != std::string::npos;
        not_made += known ? 1 : 0;
    }
    EXPECT_EQ(not_made, 3U);
}

TEST_F(Supervisor, AWorkerThatIsKilledIsReplacedAndNothingIsLost) {
    const pid_t process = start({"run", write_configuration("long.json", long_configuration()), "-o", path("run")});
    await_samples("run");
    kill(child_of(process), SIGKILL);
    EXPECT_EQ(exit_code_of(process), 0) << read_file(path("err"));
    EXPECT_THAT(read_file(path("err")), HasSubstr("signal 9"));
    const std::vector<Json> cells = read_lines(path("run/cells.jsonl"));
    EXPECT_EQ(cells.size(), 12U);
    for (const Json& cell : cells)
        EXPECT_EQ(cell.at("time").at("draw").at("rounds"), 40) << cell.at("cell");
}

TEST_F(Supervisor, AWorkerThatTakesOverHasTheConfigurationThatAPipeGaveOnce) {
    ASSERT_EQ(mkfifo(path("fifo").c_str(), 0600), 0);
    const pid_t process = start({"run", path("fifo"), "-o", path("run")});
    write("fifo", long_configuration().dump());
    await_samples("run");
    kill(child_of(process), SIGKILL);
    EXPECT_EQ(exit_code_of(process), 0) << read_file(path("err"));
    EXPECT_THAT(read_file(path("err")), HasSubstr("signal 9"));
    EXPECT_EQ(read_lines(path("run/cells.jsonl")).size(), 12U);
}

TEST_F(Supervisor, WhatIsStoppedAndGoesOnIsNotTakenForHanging) {
    const pid_t process = start(
        {"run", write_configuration("long.json", long_configuration()), "-o", path("run"), "--pass-timeout", "1s"});
    await_samples("run");
    const pid_t worker = child_of(process);
    kill(process, SIGSTOP);
    kill(worker, SIGSTOP);
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    kill(worker, SIGCONT);
    kill(process, SIGCONT);
    EXPECT_EQ(exit_code_of(process), 0) << read_file(path("err"));
    EXPECT_FALSE(std::filesystem::exists(path("run/crashes.jsonl")));
}

TEST_F(Supervisor, AWorkerDoesNotOutliveItsSupervisor) {
    const pid_t process = start({"run", write_configuration("long.json", long_configuration()), "-o", path("run")});
    await_samples("run");
    const pid_t worker = child_of(process);
    ASSERT_GT(worker, 0);
    kill(process, SIGKILL);
    exit_code_of(process);
    bool gone = false;
    for (int tries = 0; tries < 200 && !gone; ++tries) {
        gone = kill(worker, 0) != 0;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    EXPECT_TRUE(gone);
}

TEST_F(Supervisor, ATimeoutThatIsNoneIsRefused) {
    const Outcome outcome = reliefbench({"run", three_step_counts(), "-o", path("run"), "--pass-timeout", "soon"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--pass-timeout: expected a time"));
}

}  // namespace
}  // namespace reliefbench
