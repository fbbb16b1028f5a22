#include "measure/run.hpp"

#include "fake_cells.hpp"
#include "store/crashes.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class RunCells : public testing::Test {
protected:
    RunCells() {
        configuration.sampling.rule = SamplingSettings::Rule::fixed;
        configuration.sampling.rounds = 2;
        configuration.sampling.samples_per_visit = 1;
    }

    static std::vector<Cell> cells_of(std::size_t count) {
        std::vector<Cell> cells(count);
        for (std::size_t i = 0; i < count; ++i) {
            cells[i].id = "cell " + std::to_string(i);
            cells[i].technique = "fake";
            // A view of its own for every second one.
            cells[i].view.view.camera.view_angle = static_cast<double>(i / 2);
        }
        return cells;
    }

    RunOutcome run(const std::vector<Cell>& cells, FakeCells& source, RunWriter& writer, MeasureOptions options = {}) {
        return run_cells(source, configuration, cells, writer, {}, steady_clock(), options);
    }

    Configuration configuration;
    TemporaryFolder folder;
};

std::vector<std::string> ids(const std::vector<CellResult>& cells, CellStatus status) {
    std::vector<std::string> found;
    for (const CellResult& cell : cells) {
        if (cell.status == status) found.push_back(cell.cell);
    }
    return found;
}

// Draws take 2 ms of each cell that is sampled: two rounds of one sample.
TEST_F(RunCells, OnlyPreparationsOfSampledCellsAreInsideCountedSamples) {
    const std::vector<Cell> cells = cells_of(4);
    FakeCells source(cells);
    source.preparations = {{"cell 0", 100}, {"cell 1", 1000}, {"cell 2", 10000}, {"cell 3", 100000}};
    source.failing = {"cell 1"};
    source.failing_in_motion = {"cell 2"};
    source.kept = {"cell 3"};
    RunWriter writer(folder / "run", Json::object());
    EXPECT_NEAR(run(cells, source, writer).split.samples_s, 0.104, 1e-9);
}

TEST_F(RunCells, ADeviceLostInAVisitFailsThatCellAndLeavesTheOthersForANewOne) {
    const std::vector<Cell> cells = cells_of(4);
    const std::filesystem::path path = folder / "run";
    {
        RunWriter writer(path, Json::object());
        FakeCells source(cells);
        source.losing_when_visited = {"cell 2"};
        const RunOutcome outcome = run(cells, source, writer);
        EXPECT_TRUE(outcome.device_lost);
        EXPECT_TRUE(outcome.ended_early);
        EXPECT_EQ(outcome.tally.failed, 1U);
    }
    RunWriter writer(path, Json::object(), RunWriter::Continue{});
    FakeCells source(cells);
    const RunOutcome outcome = run(cells, source, writer, {.earlier = read_earlier_work(path, "draw")});
    EXPECT_FALSE(outcome.ended_early);
    EXPECT_THAT(source.made, ElementsAre("cell 0", "cell 1", "cell 3"));
    const auto stored = read_run(path);
    EXPECT_EQ(stored.cells.size(), 4U);
    EXPECT_THAT(ids(stored.cells, CellStatus::failed), ElementsAre("cell 2"));
}

TEST_F(RunCells, ADeviceLostInPreparationFailsThatCellAlone) {
    const std::vector<Cell> cells = cells_of(4);
    RunWriter writer(folder / "run", Json::object());
    FakeCells source(cells);
    source.losing_at_once = {"cell 1"};
    const RunOutcome outcome = run(cells, source, writer);
    EXPECT_TRUE(outcome.device_lost);
    EXPECT_THAT(source.made, ElementsAre("cell 0", "cell 1"));
    const auto stored = read_run(folder / "run");
    ASSERT_EQ(stored.cells.size(), 1U);
    EXPECT_EQ(stored.cells.front().cell, "cell 1");
}

TEST_F(RunCells, ACellThatTwoWorkersDiedOnIsNotTriedAThirdTime) {
    const std::vector<Cell> cells = cells_of(3);
    RunWriter writer(folder / "run", Json::object());
    append_crash(folder / "run", {"cell 0", "a signal"});
    append_crash(folder / "run", {"cell 1", "a signal"});
    append_crash(folder / "run", {"cell 1", "a pass ran past 10s"});
    FakeCells source(cells);
    const RunOutcome outcome = run(cells, source, writer, {.earlier = read_earlier_work(folder / "run", "draw")});
    EXPECT_THAT(source.made, ElementsAre("cell 0", "cell 2"));
    EXPECT_EQ(outcome.tally.ok, 2U);
    const auto stored = read_run(folder / "run");
    EXPECT_EQ(stored.cells.front().status, CellStatus::failed);
    EXPECT_THAT(stored.cells.front().reason, AllOf(HasSubstr("2 times"), HasSubstr("a pass ran past 10s")));
}

TEST_F(RunCells, TellsTheCellThatItIsOnAndThatItIsOnNone) {
    const std::vector<Cell> cells = cells_of(2);
    RunWriter writer(folder / "run", Json::object());
    FakeCells source(cells);
    configuration.sampling.rounds = 1;
    std::vector<std::string> told;
    run(cells, source, writer, {.on_cell = [&told](const std::string& cell) { told.push_back(cell); }});
    const std::vector<std::string> made(told.begin(), told.begin() + 2);
    EXPECT_THAT(made, ElementsAre("cell 0", "cell 1"));
    EXPECT_EQ(told.back(), "");
    EXPECT_EQ(std::count(told.begin(), told.end(), "cell 0"), 4);  // made ready, warmed up, submitted, collected
}

TEST_F(RunCells, ProgressTellsWhatIsDoneAndHowMuchOfIt) {
    configuration.sampling.rounds = 1;
    const std::vector<Cell> cells = cells_of(3);
    RunWriter writer(folder / "run", Json::object());
    FakeCells source(cells);
    std::vector<std::string> stages;
    const auto watch = [&stages](const Progress& progress) {
        if (stages.empty() || stages.back() != progress.stage) stages.push_back(progress.stage);
    };
    run_cells(source, configuration, cells, writer, watch);
    EXPECT_EQ(stages, (std::vector<std::string>{"preparing 1 of 3", "preparing 1 of 3, compiling", "preparing 2 of 3",
                                                "preparing 2 of 3, compiling", "preparing 3 of 3",
                                                "preparing 3 of 3, compiling", "warming up 1 of 3", "warming up 2 of 3",
                                                "warming up 3 of 3", "sampling"}));
}

#if !defined(__SANITIZE_ADDRESS__)
/// Bytes of this process that are in memory.
std::size_t resident_bytes() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TEST_F(RunCells, MemoryDoesNotGrowWithTheCellsThatAreFinished) {
    constexpr std::size_t early = 200;
    constexpr std::size_t late = 20000;
    constexpr std::size_t most_growth = std::size_t{50} << 20;
    configuration.sampling.rounds = 1;
    const std::vector<Cell> cells = cells_of(late + 1);
    RunWriter writer(folder / "run", Json::object());
    FakeCells source(cells);
    std::map<std::size_t, std::size_t> bytes;
    const auto watch = [&bytes](const Progress& progress) {
        if (progress.cells_done == early || progress.cells_done == late) bytes[progress.cells_done] = resident_bytes();
    };
    run_cells(source, configuration, cells, writer, watch);
    ASSERT_EQ(bytes.size(), 2U);
    EXPECT_LT(bytes.at(late), bytes.at(early) + most_growth);
    RecordProperty("growth_bytes", std::to_string(bytes.at(late) - bytes.at(early)));
}
#endif

}  // namespace
}  // namespace reliefbench
