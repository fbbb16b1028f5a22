#include "compare/compare_runs.hpp"

#include "compare/pair_runs.hpp"
#include "compare/run_differences.hpp"
#include "compare/synthetic_runs.hpp"
#include "support/cell_figures.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>

using namespace reliefbench;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

std::optional<NoiseRecord> no_record(const MachineKey&) {
    return std::nullopt;
}

Comparison compare(const std::vector<StoredRun>& base, const std::vector<StoredRun>& changed,
                   const CompareOptions& options = {}) {
    return compare_runs(base, changed, options, no_record);
}

Comparison compare_one(const StoredRun& base, const StoredRun& changed, const CompareOptions& options = {}) {
    return compare(std::vector{base}, std::vector{changed}, options);
}

std::vector<std::string> uncompared_reasons(const Comparison& comparison) {
    std::vector<std::string> reasons;
    for (const UncomparedCell& cell : comparison.uncompared) {
        reasons.push_back(cell.cell + ": " + cell.reason);
    }
    return reasons;
}

CellResult with_status(CellResult result, CellStatus status, const std::string& reason) {
    result.status = status;
    result.reason = reason;
    result.time.clear();
    return result;
}

std::vector<StoredRun> repeated(const std::string& name, const std::vector<double>& ms) {
    std::vector<StoredRun> runs;
    for (const double value : ms) {
        runs.push_back(one_run(fmt::format("{}{}", name, runs.size() + 1), {cell_result("c", value)}));
    }
    return runs;
}

TEST(CompareRuns, PairsCellsByIdInTheBasesOrder) {
    const StoredRun base = one_run("base", {cell_result("b", 1), cell_result("a", 2)});
    const StoredRun changed = one_run("new", {cell_result("a", 2.2), cell_result("b", 1)});
    const Comparison comparison = compare_one(base, changed);
    ASSERT_EQ(comparison.cells.size(), 2U);
    EXPECT_EQ(comparison.cells[0].cell, "b");
    EXPECT_DOUBLE_EQ(comparison.cells[1].time.ratio, 1.1);
    EXPECT_EQ(comparison.unit, "runs");
    EXPECT_TRUE(comparison.uncompared.empty());
}

TEST(CompareRuns, OneRunASideRestsOnTheStatedDefaultNoise) {
    const Comparison comparison =
        compare_one(one_run("base", {cell_result("c", 1)}), one_run("new", {cell_result("c", 1.2)}));
    EXPECT_EQ(comparison.cells[0].verdict, Verdict::undecided);
    EXPECT_THAT(comparison.cells[0].reason,
                AllOf(HasSubstr("undecided: +20 %"), HasSubstr("1 run a side"), HasSubstr("more runs a side")));
    EXPECT_THAT(comparison.notices, Contains(AllOf(HasSubstr("10 %"), HasSubstr("default"))));
    EXPECT_EQ(comparison.environment["noise"]["log_sd"], 0.10);
    const Comparison clear = compare_one(one_run("base", {cell_result("c", 1)}), one_run("new", {cell_result("c", 3)}));
    EXPECT_EQ(clear.cells[0].verdict, Verdict::slower);
}

TEST(CompareRuns, TheMachinesRecordTakesThePlaceOfTheDefault) {
    std::vector<MachineKey> asked;
    const auto lookup = [&](const MachineKey& machine) {
        asked.push_back(machine);
        NoiseRecord record;
        record.between_runs = {0.001, 20, "this machine's record"};
        return std::optional(record);
    };
    const std::vector base = {one_run("base", {cell_result("c", 1)})};
    const std::vector changed = {one_run("new", {cell_result("c", 1.05)})};
    const Comparison comparison = compare_runs(base, changed, {}, lookup);
    EXPECT_EQ(comparison.cells[0].verdict, Verdict::slower);
    EXPECT_THAT(comparison.notices, Contains(HasSubstr("this machine's record")));
    EXPECT_EQ(asked.front(), (MachineKey{"a device", "a driver", "1.2", "a CPU"}));
}

TEST(CompareRuns, TheRunsOwnUncertaintyIsNotHiddenByLowNoise) {
    const auto lookup = [](const MachineKey&) {
        NoiseRecord record;
        record.between_runs = {0.001, 20, ""};
        return std::optional(record);
    };
    CellResult uncertain = cell_result("c", 1.05);
    uncertain.time["draw"].ci95_ms = {0.8, 1.3};
    const std::vector base = {one_run("base", {cell_result("c", 1)})};
    const std::vector changed = {one_run("new", {uncertain})};
    EXPECT_EQ(compare_runs(base, changed, {}, lookup).cells[0].verdict, Verdict::undecided);
}

TEST(CompareRuns, ThreeRunsASideTellTheirOwnNoise) {
    const Comparison comparison =
        compare(repeated("base", {1.000, 1.001, 0.999}), repeated("new", {1.100, 1.101, 1.102}));
    EXPECT_EQ(comparison.cells[0].verdict, Verdict::slower);
    EXPECT_THAT(comparison.cells[0].reason, AllOf(HasSubstr("slower by 10 %"), HasSubstr("3 runs a side")));
    EXPECT_EQ(comparison.environment["noise"]["source"], "the runs compared");
    EXPECT_THAT(comparison.notices, testing::Not(Contains(HasSubstr("noise"))));
}

// Runs made before there was an axis had it at its default, or their ids would differ.
TEST(CompareRuns, AnAxisThatOneSideDoesNotKnowIsNoDifference) {
    CellResult cell = cell_result("c", 1);
    const StoredRun base = one_run("base", {cell});
    cell.axes["self_shadow"] = "off";
    const Comparison comparison = compare_one(base, one_run("new", {cell}));
    EXPECT_EQ(comparison.cells.size(), 1U);
    EXPECT_TRUE(comparison.uncompared.empty());
}

TEST(CompareRuns, AParameterThatOneSideDoesNotKnowIsNoDifference) {
    CellResult cell = cell_result("c", 1);
    const StoredRun base = one_run("base", {cell});
    cell.parameters["self_shadow"] = "off";
    const Comparison comparison = compare_one(base, one_run("new", {cell}));
    EXPECT_EQ(comparison.cells.size(), 1U);
    EXPECT_TRUE(comparison.uncompared.empty());
}

TEST(CompareRuns, OfSidesWithoutACommonCellItIsToldWhatDiffers) {
    const auto cell = [](const std::string& id, int angle, int steps) {
        CellResult result = cell_result(id, 1);
        result.axes["view_angle"] = angle;
        result.axes["tiling"] = 2;
        result.parameters["max_steps"] = steps;
        return result;
    };
    const StoredRun base = one_run("base", {cell("a", 0, 8), cell("b", 60, 8)});
    EXPECT_THAT(compare_one(base, one_run("new", {cell("c", 45, 8), cell("d", 45, 16)})).notices,
                Contains("no cell is in both sides: view_angle is 0, 60 in the base and 45 in the new runs"));
    EXPECT_THAT(compare_one(base, one_run("new", {cell("c", 0, 16), cell("d", 60, 8)})).notices,
                Contains("no cell is in both sides: max_steps is 8 in the base and 16, 8 in the new runs"));
    EXPECT_THAT(compare_one(base, one_run("new", {cell("a", 0, 8), cell("d", 45, 8)})).notices,
                testing::Not(Contains(HasSubstr("no cell is in both"))));
}

TEST(CompareRuns, WhatCannotBeComparedIsToldPlainly) {
    CellResult parameter = cell_result("parameter", 1);
    CellResult axis = cell_result("axis", 1);
    axis.axes["height_scale"] = 0.05;
    const StoredRun base =
        one_run("base", {cell_result("gone", 1), cell_result("broken", 1), cell_result("unsupported", 1), parameter,
                         axis, with_status(cell_result("mended", 1), CellStatus::failed, "no shader"),
                         with_status(cell_result("never", 1), CellStatus::skipped, "no feature")});
    parameter.parameters["max_steps"] = 64;
    axis.axes["height_scale"] = 0.1;
    const StoredRun changed = one_run(
        "new", {with_status(cell_result("broken", 1), CellStatus::failed, "lost device"),
                with_status(cell_result("unsupported", 1), CellStatus::skipped, "no feature"), parameter, axis,
                cell_result("mended", 1), with_status(cell_result("never", 1), CellStatus::skipped, "no feature"),
                cell_result("fresh", 1)});
    const Comparison comparison = compare_one(base, changed);
    EXPECT_TRUE(comparison.cells.empty());
    EXPECT_THAT(uncompared_reasons(comparison),
                ElementsAre("gone: only in the base", "broken: measured in the base, but now failed: lost device",
                            "unsupported: measured in the base, but now skipped: no feature",
                            "parameter: the parameter max_steps changed from 32 to 64",
                            "axis: the axis height_scale changed from 0.05 to 0.1",
                            "mended: measured now, but in the base failed: no shader",
                            "never: not measured on either side (base: skipped: no feature; new: skipped: no feature)",
                            "fresh: only in the new runs"));
    for (const UncomparedCell& cell : comparison.uncompared) {
        EXPECT_EQ(cell.failed_now, cell.cell == "broken") << cell.cell;
    }
}

TEST(CompareRuns, AChangedMeshFileIsNotCompared) {
    const auto run_with = [](const char* name, const char* hash) {
        CellResult cell = cell_result("c", 1);
        cell.axes["base"] = "car.glb";
        cell.axes["base_fit"] = "unit";
        StoredRun run = one_run(name, {cell});
        run.run.run["bases"] = Json::parse(R"([{"name": "car.glb", "base_fit": "none", "hash": "n"},
                                               {"name": "car.glb", "base_fit": "unit"}])");
        run.run.run["bases"][1]["hash"] = hash;
        return run;
    };
    EXPECT_THAT(uncompared_reasons(compare_one(run_with("base", "m"), run_with("new", "other"))),
                ElementsAre("c: the content of its base car.glb changed"));
    EXPECT_EQ(compare_one(run_with("base", "m"), run_with("new", "m")).cells.size(), 1U);
}

TEST(CompareRuns, AChangedHeightMapIsNotCompared) {
    StoredRun changed = one_run("new", {cell_result("c", 1)});
    changed.run.run["height_maps"][0]["hash"] = "other";
    EXPECT_THAT(uncompared_reasons(compare_one(one_run("base", {cell_result("c", 1)}), changed)),
                ElementsAre("c: the content of its height map rock changed"));
    changed.run.run["height_maps"][0]["hash"] = "h";
    changed.run.run["height_maps"][0]["albedo_hash"] = "other";
    EXPECT_THAT(uncompared_reasons(compare_one(one_run("base", {cell_result("c", 1)}), changed)),
                ElementsAre("c: the content of the albedo of its height map rock changed"));
    // Another map of the run, or another size or format of this one.
    changed.run.run["height_maps"][0]["size"] = {512, 512};
    EXPECT_EQ(compare_one(one_run("base", {cell_result("c", 1)}), changed).cells.size(), 1U);
}

TEST(CompareRuns, ACellWithoutATimeIsNotCompared) {
    CellResult timeless = cell_result("c", 1);
    timeless.time.clear();
    EXPECT_THAT(uncompared_reasons(compare_one(one_run("base", {cell_result("c", 1)}), one_run("new", {timeless}))),
                ElementsAre("c: measured in the base, but now without a time of the pass draw"));
}

TEST(CompareRuns, ACellOfSomeRunsOnlyIsUsedWithThoseAndTold) {
    std::vector<StoredRun> base = repeated("base", {1, 1, 1});
    std::vector<StoredRun> changed = repeated("new", {1, 1, 1});
    base[1].run.cells.clear();
    changed[2].run.cells[0] = with_status(changed[2].run.cells[0], CellStatus::failed, "lost device");
    const Comparison comparison = compare(base, changed);
    ASSERT_EQ(comparison.cells.size(), 1U);
    EXPECT_EQ(comparison.cells[0].time.units, 2U);
    EXPECT_THAT(comparison.cells[0].reason,
                AllOf(HasSubstr("measured in 2 of 3 base runs only (in the others missing)"),
                      HasSubstr("measured in 2 of 3 new runs only (in the others failed: lost device)")));
}

TEST(CompareRuns, AnotherDeviceIsAnErrorUnlessAllowed) {
    const StoredRun base = one_run("base", {cell_result("c", 1)});
    StoredRun changed = base;
    changed.name = "new";
    changed.run.run["device"]["name"] = "another device";
    const std::string message = error_message([&] { compare_one(base, changed); });
    EXPECT_THAT(message, AllOf(HasSubstr("'a device'"), HasSubstr("'another device'"), HasSubstr("--across-devices")));
    CompareOptions options;
    options.across_devices = true;
    EXPECT_THAT(compare_one(base, changed, options).notices.front(), HasSubstr("the devices differ"));
}

TEST(CompareRuns, ACpuDeviceOnAnotherCpuIsAnotherDevice) {
    const StoredRun base = one_run("base", {cell_result("c", 1)});
    StoredRun changed = base;
    changed.run.run["environment"]["cpu"] = "another CPU";
    EXPECT_THAT(error_message([&] { compare_one(base, changed); }), HasSubstr("'another CPU'"));
    StoredRun base_gpu = base;
    base_gpu.run.run["device"]["type"] = "discrete GPU";
    changed.run.run["device"]["type"] = "discrete GPU";
    EXPECT_THAT(compare_one(base_gpu, changed).notices, Contains("the CPU changed from a CPU to another CPU"));
}

TEST(CompareRuns, RunsOfOneSideMustAgree) {
    std::vector<StoredRun> base = repeated("base", {1, 1});
    base[1].run.run["device"]["name"] = "another device";
    EXPECT_THAT(error_message([&] { compare(base, repeated("new", {1})); }),
                AllOf(HasSubstr("one device"), HasSubstr("leave base2 out")));
    std::vector<StoredRun> changed = repeated("new", {1, 1});
    changed[1].run.run["height_maps"][0]["hash"] = "other";
    EXPECT_THAT(error_message([&] { compare(repeated("base", {1}), changed); }),
                AllOf(HasSubstr("new1 and new2"), HasSubstr("height map rock")));
}

TEST(CompareRuns, DifferencesBetweenTheSidesAreNotices) {
    const StoredRun base = one_run("base", {cell_result("c", 1)});
    StoredRun changed = base;
    changed.name = "new";
    changed.run.run["device"]["driver_version"] = "1.3";
    changed.run.run["environment"]["tool_version"] = "2.0";
    changed.run.run["environment"]["git_revision"] = "def";
    changed.run.run["environment"]["git_dirty"] = true;
    changed.run.run["environment"]["os"] = nullptr;
    changed.run.run["techniques"]["second"] = "other";
    changed.run.run["techniques"]["third"] = "hash3";
    changed.run.run["configuration"]["sampling"]["rounds"] = 7;
    const std::vector<std::string> notices = compare_one(base, changed).notices;
    EXPECT_THAT(notices, testing::IsSupersetOf({
                             "the driver's version changed from 1.2 to 1.3",
                             "the tool's version changed from 1.0 to 2.0",
                             "the git revision changed from abc to def",
                             "new was made from a work tree with changes not committed",
                             "the operating system changed from an OS to unknown",
                             "the sources of these techniques changed: second",
                             "sampling: rounds changed from 5 to 7",
                         }));
    EXPECT_EQ(notices.size(), 8U);  // and the noise
}

/// Version 0.1.0 hashed every file of a folder: what differs may be no source.
TEST(CompareRuns, HashesOfWholeFoldersDoNotTellThatSourcesChanged) {
    StoredRun base = one_run("base", {cell_result("c", 1)});
    base.run.run.erase("source_hashes");
    base.run.run["shaders"] = "one";
    StoredRun changed = one_run("changed", {cell_result("c", 1)});
    changed.run.run["shaders"] = "two";
    changed.run.run["techniques"]["second"] = "other";
    const std::vector<std::string> differences = run_differences(base, changed);
    EXPECT_THAT(differences, Contains(HasSubstr("the shaders that all techniques share, or other files beside them")));
    EXPECT_THAT(differences,
                Contains(AllOf(HasSubstr("or other files in their folders, changed"), HasSubstr(": second"))));
    changed.run.run["shaders"] = "one";
    changed.run.run["techniques"]["second"] = "hash2";
    EXPECT_TRUE(same_source(base, changed, "second")) << "equal ones tell that they did not";
    EXPECT_TRUE(run_differences(base, changed).empty());
}

TEST(CompareRuns, RunsOfASideThatDifferAmongThemselvesAreANotice) {
    std::vector<StoredRun> base = repeated("base", {1, 1});
    base[1].run.run["environment"]["git_revision"] = "def";
    EXPECT_THAT(compare(base, repeated("new", {1})).notices,
                Contains(AllOf(HasSubstr("base runs differ among themselves"), HasSubstr("base2"), HasSubstr("def"))));
}

std::vector<std::string> changed_fields(const Comparison& comparison) {
    std::vector<std::string> fields;
    for (const QualityChange& change : comparison.cells.at(0).quality.changes) {
        fields.push_back(change.field);
    }
    return fields;
}

TEST(CompareRuns, ErrorsAreComparedOnlyAgainstTheSameTruthAndPicturesOnlyUnderTheSameLight) {
    CellResult worse = cell_result("c", 1);
    set_figure(worse, "error.missed", 0.5);
    set_figure(worse, "image.rmse", 0.5);
    CellResult before = cell_result("c", 1);
    set_figure(before, "image.rmse", 0.1);
    const StoredRun base = one_run("base", {before});
    StoredRun changed = one_run("new", {worse});
    EXPECT_THAT(changed_fields(compare_one(base, changed)),
                ElementsAre("error.missed+error.false_hits", "error.missed", "image.rmse"));
    changed.run.run["configuration"]["lighting"]["ambient"] = 0.3;
    const Comparison lit = compare_one(base, changed);
    EXPECT_THAT(changed_fields(lit), ElementsAre("error.missed+error.false_hits", "error.missed"));
    EXPECT_THAT(lit.notices, Contains(HasSubstr("the lighting or the object differs")));
    changed.run.run["configuration"]["truth"]["kind"] = "mesh";
    const Comparison other = compare_one(base, changed);
    EXPECT_THAT(changed_fields(other), testing::IsEmpty());
    EXPECT_EQ(other.cells[0].quality.verdict, QualityVerdict::not_comparable);
    EXPECT_THAT(other.notices, Contains("truth: kind changed from exact to mesh"));
}

TEST(CompareRuns, MotionIsComparedOnlyAlongTheSameArc) {
    CellResult before = cell_result("c", 1);
    set_figures(before, {{"motion.texels.mean", 0.5}, {"motion.texels.p95", 1}, {"motion.texels.max", 2}});
    set_figures(before, {{"motion.flip.mean", 0.1}, {"motion.flip.p95", 0.2}, {"motion.flip.max", 0.3}});
    set_figures(before, {{"motion.compared", 1000}, {"motion.hit_once", 0}, {"motion.unseen", 0}});
    CellResult worse = before;
    set_figure(worse, "motion.texels.mean", 0.6);
    set_figure(worse, "motion.flip.mean", 0.15);
    StoredRun base = one_run("base", {before});
    StoredRun changed = one_run("new", {worse});
    base.run.run["configuration"]["motion"] = changed.run.run["configuration"]["motion"] = {{"degrees", 0.25}};
    EXPECT_THAT(changed_fields(compare_one(base, changed)), ElementsAre("motion.flip.mean", "motion.texels.mean"));
    changed.run.run["configuration"]["lighting"]["ambient"] = 0.3;
    EXPECT_THAT(changed_fields(compare_one(base, changed)), ElementsAre("motion.texels.mean"));
    changed.run.run["configuration"]["motion"]["degrees"] = 0.5;
    const Comparison other = compare_one(base, changed);
    EXPECT_THAT(changed_fields(other), testing::IsEmpty());
    EXPECT_THAT(other.notices, Contains("motion: degrees changed from 0.25 to 0.5"));
}

TEST(CompareRuns, HistoriesAreComparedOnlyWhenTheyAreBlendedAlike) {
    CellResult before = cell_result("c", 1);
    set_figures(before, {{"motion.flip.mean", 0.1}, {"motion.ghosting.mean", 0.1}, {"motion.history_flip.mean", 0.1}});
    CellResult worse = before;
    set_figures(worse, {{"motion.flip.mean", 0.2}, {"motion.ghosting.mean", 0.2}, {"motion.history_flip.mean", 0.2}});
    StoredRun base = one_run("base", {before});
    StoredRun changed = one_run("new", {worse});
    base.run.run["configuration"]["motion"] = changed.run.run["configuration"]["motion"] = {{"history_weight", 0.9}};
    EXPECT_THAT(changed_fields(compare_one(base, changed)),
                testing::UnorderedElementsAre("motion.flip.mean", "motion.ghosting.mean", "motion.history_flip.mean"));
    changed.run.run["configuration"]["motion"]["history_weight"] = 0.95;
    const Comparison other = compare_one(base, changed);
    EXPECT_THAT(changed_fields(other), ElementsAre("motion.flip.mean"));
    EXPECT_THAT(other.notices, Contains("motion: history_weight changed from 0.9 to 0.95"));
    EXPECT_THAT(other.notices, Contains(HasSubstr("the histories differ")));
}

TEST(CompareRuns, OneRunASideTellsQualityWhateverTheTimesAndTheDevices) {
    CellResult before = cell_result("c", 1);
    set_figure(before, "image.flip", 0.1);
    CellResult after = before;
    set_figure(after, "image.flip", 0.2);
    after.time.clear();
    StoredRun changed = one_run("new", {after, with_status(cell_result("broken", 1), CellStatus::failed, "lost")});
    changed.run.run["device"]["name"] = "another device";
    const std::vector base = {one_run("base", {before, cell_result("broken", 1)})};
    const Comparison comparison = compare_quality_of_runs(base, std::vector{changed}, default_deciding_figures());
    ASSERT_EQ(comparison.cells.size(), 1U);
    EXPECT_TRUE(comparison.quality_only);
    EXPECT_EQ(comparison.cells[0].quality.verdict, QualityVerdict::worse);
    EXPECT_TRUE(comparison.uncompared.at(0).failed_now);
    EXPECT_THAT(comparison.notices, Contains(HasSubstr("the devices differ")));
    EXPECT_THAT(comparison.notices, testing::Not(Contains(HasSubstr("noise"))));
}

TEST(CompareRuns, AFigureOfAnOlderVersionStandsInAndThatIsSaid) {
    CellResult before = cell_result("c", 1);
    set_figure(before, "image.flip", 0.1);
    CellResult after = before;
    set_figure(after, "image.footprint.flip", 0.01);
    EXPECT_THAT(compare_one(one_run("base", {before}), one_run("new", {after})).notices,
                Contains("of 1 of 1 cell one side has no image.footprint.flip, so image.flip decides in its place"));
    EXPECT_THAT(compare_one(one_run("base", {after}), one_run("new", {after})).notices,
                testing::Not(Contains(HasSubstr("decides in its place"))));
}

TEST(CompareRuns, TiesThatOneSideDidNotKnowAreANotice) {
    const CellResult before = cell_result("c", 1);
    CellResult after = before;
    set_figure(after, "error.ties", 0);
    const auto notices = [&] { return compare_one(one_run("base", {before}), one_run("new", {after})).notices; };
    EXPECT_THAT(notices(), testing::Not(Contains(HasSubstr("error.ties"))));
    set_figure(after, "error.ties", 0.02);
    EXPECT_THAT(notices(), Contains(HasSubstr("of 1 of 1 cell the errors of one side count ties")));
}

TEST(CompareRuns, AChangedPreparationTimeIsANotice) {
    const auto with_preparation = [](const std::string& name, double ms) {
        std::vector<StoredRun> runs = repeated(name, {1, 1, 1});
        for (std::size_t run = 0; run < runs.size(); ++run) {
            runs[run].run.cells[0].prepare_ms = ms * (1 + 0.001 * static_cast<double>(run));
        }
        return runs;
    };
    const std::vector<StoredRun> base = with_preparation("base", 10);
    EXPECT_THAT(compare(base, with_preparation("new", 15)).notices,
                Contains(HasSubstr("preparing the maps of all cells together is slower by 50 %")));
    EXPECT_THAT(compare(base, with_preparation("new", 10)).notices, testing::Not(Contains(HasSubstr("preparing"))));
}

/// Five runs a side of 20 cells, those of the new side `factor` times slower.
std::pair<std::vector<StoredRun>, std::vector<StoredRun>> runs_moved_by(double factor) {
    Random random(1);
    RunsModel model;
    model.cells = 20;
    const std::vector<StoredRun> base = synthetic_runs(model, 5, random);
    std::vector<StoredRun> changed = synthetic_runs(model, 5, random);
    for (StoredRun& run : changed) {
        for (CellResult& cell : run.run.cells) {
            cell.time["draw"].median_ms *= factor;
        }
    }
    return {base, changed};
}

int count(const Comparison& comparison, Verdict verdict) {
    return static_cast<int>(std::count_if(comparison.cells.begin(), comparison.cells.end(),
                                          [verdict](const CellComparison& cell) { return cell.verdict == verdict; }));
}

void set_everywhere(std::vector<StoredRun>& runs, const std::function<void(Json&)>& set) {
    for (StoredRun& run : runs) {
        set(run.run.run);
    }
}

TEST(CompareRuns, TheSameCodeThatMovedWidensAllIntervalsAndIsTheFirstNotice) {
    const auto [base, changed] = runs_moved_by(1.5);
    const Comparison comparison = compare(base, changed);
    EXPECT_EQ(count(comparison, Verdict::undecided), 20);
    EXPECT_GT(comparison.environment["noise"]["inflation"], 5);
    EXPECT_THAT(comparison.notices.front(), AllOf(HasSubstr("run the same code on both sides"),
                                                  HasSubstr("another state"), HasSubstr("`reliefbench ab`")));
}

TEST(CompareRuns, CodeThatMayDifferIsNoControl) {
    const auto slower_when = [](const std::function<void(Json&)>& set) {
        auto [base, changed] = runs_moved_by(1.5);
        set_everywhere(changed, set);
        return count(compare(base, changed), Verdict::slower);
    };
    EXPECT_EQ(slower_when([](Json&) {}), 0);
    EXPECT_EQ(slower_when([](Json& run) { run["environment"]["git_revision"] = "def"; }), 20);
    EXPECT_EQ(slower_when([](Json& run) { run["environment"]["git_revision"] = nullptr; }), 20);
    EXPECT_EQ(slower_when([](Json& run) { run["environment"]["git_dirty"] = true; }), 20);
    EXPECT_EQ(slower_when([](Json& run) { run["environment"]["os"] = "another OS"; }), 20);
    EXPECT_EQ(slower_when([](Json& run) { run["device"]["driver_version"] = "1.3"; }), 20);
    EXPECT_EQ(slower_when([](Json& run) { run["techniques"]["first"] = "other"; }), 20);
}

TEST(CompareRuns, TheSharedShadersDecideWhereTheRecordsHaveThem) {
    auto [base, changed] = runs_moved_by(1.5);
    set_everywhere(base, [](Json& run) { run["shaders"] = "s"; });
    set_everywhere(changed, [](Json& run) {
        run["shaders"] = "s";
        run["environment"]["git_revision"] = "def";
    });
    EXPECT_EQ(count(compare(base, changed), Verdict::slower), 0);
    set_everywhere(changed, [](Json& run) { run["shaders"] = "other"; });
    const Comparison comparison = compare(base, changed);
    EXPECT_EQ(count(comparison, Verdict::slower), 20);
    EXPECT_THAT(comparison.notices, Contains("the shaders that all techniques share changed"));
}

TEST(CompareRuns, CellsOfUnchangedTechniquesThatMoveTogetherAreTheFirstNotice) {
    auto [base, changed] = runs_moved_by(1.5);
    set_everywhere(changed, [](Json& run) { run["environment"]["git_revision"] = "def"; });
    EXPECT_THAT(compare(base, changed).notices.front(),
                AllOf(HasSubstr("20 of 20 cells of techniques whose sources are the same"), HasSubstr("slower")));
    set_everywhere(changed, [](Json& run) { run["techniques"]["first"] = "other"; });
    EXPECT_THAT(compare(base, changed).notices, testing::Not(Contains(HasSubstr("sources are the same"))));
}

TEST(CompareRuns, AFewRunsThatLieFarApartOverruleALowMachineNoise) {
    Random random(1);
    RunsModel busy;
    busy.common_sd = 0.5;
    const std::vector<StoredRun> runs = synthetic_runs(busy, 4, random);
    const std::span<const StoredRun> all(runs);
    const Comparison comparison = compare_runs(all.first(2), all.subspan(2), {}, no_record);
    EXPECT_EQ(count(comparison, Verdict::undecided), 75);
}

TEST(CompareRuns, TheEnvironmentOfBothSidesIsKept) {
    StoredRun changed = one_run("new", {});
    changed.run.run["device"]["driver_version"] = "1.3";
    const Comparison comparison = compare_one(one_run("base", {}), changed);
    EXPECT_EQ(comparison.environment["base"]["runs"], Json({"base"}));
    EXPECT_EQ(comparison.environment["base"]["device"]["driver_version"], "1.2");
    EXPECT_EQ(comparison.environment["new"]["device"]["driver_version"], "1.3");
    EXPECT_TRUE(comparison.cells.empty());
}

}  // namespace
