#include "measure/chosen_run.hpp"

#include "fake_cells.hpp"
#include "store/crashes.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Script = std::vector<std::vector<std::size_t>>;

/// Wants the rounds that it was given, in their order, of the cells that are not settled.
class ScriptedChooser : public CellChooser {
public:
    explicit ScriptedChooser(Script rounds) : rounds_(std::move(rounds)) {}

    void add_result(std::size_t cell, const CellResult& result) override { results[cell] = result.status; }
    void add_times(std::size_t cell, const PassTiming& draw, bool is_settled) override {
        rounds_seen[cell].push_back(draw.rounds);
        if (is_settled) settled.insert(cell);
    }
    std::vector<std::size_t> next_round() override {
        if (next_ == rounds_.size()) return {};
        return rounds_[next_++];
    }
    std::string reason_left_out(std::size_t cell) const override {
        return worth_measuring.contains(cell) ? "" : "not measured: out of the question";
    }
    std::string standing() const override { return "in question"; }

    std::map<std::size_t, CellStatus> results;
    std::map<std::size_t, std::vector<std::size_t>> rounds_seen;
    std::set<std::size_t> settled;
    std::set<std::size_t> worth_measuring;

private:
    Script rounds_;
    std::size_t next_ = 0;
};

/// Goes on by a second with every look.
class CountingClock : public Clock {
public:
    double seconds() const override { return now_++; }

private:
    mutable double now_ = 0;
};

class ChosenCellsOfARun : public testing::Test {
protected:
    ChosenCellsOfARun() {
        configuration.sampling.rule = SamplingSettings::Rule::fixed;
        configuration.sampling.rounds = 3;
        configuration.sampling.samples_per_visit = 1;
        for (std::size_t index = 0; index < 6; ++index) {
            Cell cell;
            cell.id = "cell " + std::to_string(index);
            cell.technique = "fake";
            cell.view.view.camera.view_angle = static_cast<double>(index / 3);
            cells.push_back(cell);
        }
        options.deadline_s = 1e18;
    }

    ChosenOutcome run(FakeCells& source, CellChooser& chooser, RunWriter& writer, const Clock& clock = steady_clock()) {
        return run_chosen_cells(source, configuration, cells, writer, chooser, {}, clock, options);
    }

    std::map<std::string, CellResult> stored() const {
        std::map<std::string, CellResult> results;
        for (const CellResult& cell : read_run(path).cells)
            results[cell.cell] = cell;
        return results;
    }

    Configuration configuration;
    std::vector<Cell> cells;
    ChosenOptions options;
    TemporaryFolder folder;
    const std::filesystem::path path = folder / "run";
};

TEST_F(ChosenCellsOfARun, OnlyThoseAreDrawnAndTheOthersAreSkippedWithTheReason) {
    FakeCells source(cells);
    ScriptedChooser chooser({{0, 4}, {0}, {0}});
    RunWriter writer(path, Json::object());
    const ChosenOutcome outcome = run(source, chooser, writer);
    EXPECT_FALSE(outcome.ended_early);
    EXPECT_FALSE(outcome.is_time_over);
    EXPECT_THAT(source.made, ElementsAre("cell 0", "cell 4"));
    const auto results = stored();
    ASSERT_EQ(results.size(), 6U);
    EXPECT_EQ(results.at("cell 0").stop, StopReason::rounds);
    EXPECT_EQ(results.at("cell 0").time.at("draw").rounds, 3U);
    EXPECT_EQ(results.at("cell 4").stop, StopReason::narrowed);
    EXPECT_EQ(results.at("cell 4").time.at("draw").rounds, 1U);
    EXPECT_EQ(results.at("cell 1").status, CellStatus::skipped);
    EXPECT_EQ(results.at("cell 1").reason, "not measured: out of the question");
}

TEST_F(ChosenCellsOfARun, TheChooserIsToldWhatWasSeenAndWhenTheRuleWouldStop) {
    FakeCells source(cells);
    source.failing = {"cell 1"};
    ScriptedChooser chooser({{0, 1}, {0}, {0}, {0}});
    RunWriter writer(path, Json::object());
    run(source, chooser, writer);
    EXPECT_EQ(chooser.results.at(0), CellStatus::ok);
    EXPECT_EQ(chooser.results.at(1), CellStatus::failed);
    EXPECT_THAT(chooser.rounds_seen.at(0), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(chooser.settled, ElementsAre(0));
    EXPECT_EQ(stored().at("cell 1").reason, "unconverged");
}

TEST_F(ChosenCellsOfARun, WhereTheTimeEndsWhatWasSampledIsKeptAndTheOthersStayOpen) {
    FakeCells source(cells);
    ScriptedChooser chooser({{0}, {0, 3}, {3}, {0}, {0}, {0}});
    CountingClock clock;
    options.deadline_s = 20;
    RunWriter writer(path, Json::object());
    const ChosenOutcome outcome = run(source, chooser, writer, clock);
    EXPECT_TRUE(outcome.is_time_over);
    EXPECT_FALSE(outcome.ended_early);
    const auto results = stored();
    EXPECT_EQ(results.at("cell 0").stop, StopReason::time);
    EXPECT_FALSE(results.contains("cell 1"));
    EXPECT_FALSE(results.contains("cell 5"));
}

TEST_F(ChosenCellsOfARun, WhatTheTimeCutOffGoesOnWithItsSamples) {
    {
        FakeCells source(cells);
        ScriptedChooser chooser({{0, 3}, {0}, {0}, {0}});
        CountingClock clock;
        options.deadline_s = 20;
        RunWriter writer(path, Json::object());
        ASSERT_TRUE(run(source, chooser, writer, clock).is_time_over);
    }
    const std::size_t had = stored().at("cell 0").time.at("draw").rounds;
    ASSERT_LT(had, 3U);
    ASSERT_EQ(stored().at("cell 3").stop, StopReason::time);
    RunWriter writer(path, Json::object(), RunWriter::Continue{});
    options.deadline_s = 1e18;
    options.cut_off = writer.take_out_cut_off_cells();
    options.earlier = read_earlier_work(path, "draw");
    options.finished = read_run(path).cells;
    FakeCells source(cells);
    ScriptedChooser chooser({{0}, {0}});
    run(source, chooser, writer);
    EXPECT_THAT(source.made, ElementsAre("cell 0"));
    EXPECT_THAT(chooser.rounds_seen.at(0), ElementsAre(had, had + 1, had + 2));
    EXPECT_EQ(chooser.results.at(3), CellStatus::ok);
    EXPECT_EQ(stored().at("cell 0").time.at("draw").rounds, had + 2);
    EXPECT_EQ(stored().at("cell 3").stop, StopReason::narrowed);
}

TEST_F(ChosenCellsOfARun, InterruptedItRecordsNothingAndGoesOnWithItsSamples) {
    {
        FakeCells source(cells);
        ScriptedChooser chooser({{0, 1}, {0}, {0}, {0}});
        std::size_t asked = 0;
        options.is_interrupted = [&asked] { return ++asked > 40; };
        RunWriter writer(path, Json::object());
        EXPECT_TRUE(run(source, chooser, writer).ended_early);
    }
    EXPECT_THAT(stored(), IsEmpty());
    options.is_interrupted = {};
    options.earlier = read_earlier_work(path, "draw");
    ASSERT_TRUE(options.earlier.visits.contains("cell 0"));
    const std::size_t had = options.earlier.visits.at("cell 0").size();
    FakeCells source(cells);
    ScriptedChooser chooser(Script{{0}});
    RunWriter writer(path, Json::object(), RunWriter::Continue{});
    run(source, chooser, writer);
    EXPECT_THAT(chooser.rounds_seen.at(0), ElementsAre(had + 1));
}

TEST_F(ChosenCellsOfARun, WhatIsFinishedIsToldToTheChooserAndNotMeasuredAgain) {
    {
        FakeCells source(cells);
        ScriptedChooser chooser({{0}, {0}, {0}});
        chooser.worth_measuring = {1, 2, 3, 4, 5};
        RunWriter writer(path, Json::object());
        run(source, chooser, writer);
    }
    options.earlier = read_earlier_work(path, "draw");
    options.finished = read_run(path).cells;
    FakeCells source(cells);
    ScriptedChooser chooser(Script{{0, 1}});
    RunWriter writer(path, Json::object(), RunWriter::Continue{});
    run(source, chooser, writer);
    EXPECT_THAT(source.made, ElementsAre("cell 1"));
    EXPECT_EQ(chooser.results.at(0), CellStatus::ok);
    EXPECT_THAT(chooser.rounds_seen.at(0), ElementsAre(3));
    EXPECT_THAT(chooser.settled, ElementsAre(0));
}

TEST_F(ChosenCellsOfARun, WhatWasVisitedLeastLatelyMakesRoomAndIsMadeReadyAnew) {
    FakeCells source(cells);
    ScriptedChooser chooser({{0}, {1}, {2}, {0}});
    options.max_ready = 2;
    RunWriter writer(path, Json::object());
    run(source, chooser, writer);
    EXPECT_THAT(source.made, ElementsAre("cell 0", "cell 1", "cell 2", "cell 0"));
    EXPECT_EQ(stored().at("cell 0").time.at("draw").rounds, 2U);
}

TEST_F(ChosenCellsOfARun, ALostDeviceFailsItsCellAndLeavesTheOthersOpen) {
    FakeCells source(cells);
    source.losing_when_visited = {"cell 1"};
    ScriptedChooser chooser({{0}, {1}, {2}});
    RunWriter writer(path, Json::object());
    const ChosenOutcome outcome = run(source, chooser, writer);
    EXPECT_TRUE(outcome.device_lost);
    EXPECT_TRUE(outcome.ended_early);
    EXPECT_THAT(stored(), ElementsAre(testing::Key("cell 1")));
}

TEST_F(ChosenCellsOfARun, ACellThatTwoWorkersDiedOnIsNotTriedAThirdTime) {
    RunWriter writer(path, Json::object());
    append_crash(path, {"cell 0", "a signal"});
    append_crash(path, {"cell 0", "a signal"});
    options.earlier = read_earlier_work(path, "draw");
    FakeCells source(cells);
    ScriptedChooser chooser(Script{{0, 1}});
    run(source, chooser, writer);
    EXPECT_THAT(source.made, ElementsAre("cell 1"));
    EXPECT_THAT(stored().at("cell 0").reason, HasSubstr("2 times"));
}

}  // namespace
}  // namespace reliefbench
