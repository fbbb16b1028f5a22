#include "compare/common_ids.hpp"

#include "compare/pair_runs.hpp"
#include "synthetic_runs.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::ElementsAre;

CellResult cell_of(const std::string& id, const Json& parameters, const Json& axes) {
    CellResult cell = cell_result(id, 1);
    cell.parameters = parameters;
    cell.axes = axes;
    return cell;
}

StoredRun run_of(const std::string& name, const std::string& time, std::vector<CellResult> cells,
                 const std::string& defaults = {}) {
    StoredRun run = one_run(name, std::move(cells));
    run.run.run["environment"]["time"] = time;
    if (!defaults.empty()) run.run.run["defaults"] = Json::parse(defaults);
    return run;
}

std::vector<std::string> ids_of(const StoredRun& run) {
    std::vector<std::string> ids;
    for (const CellResult& cell : run.run.cells)
        ids.push_back(cell.cell);
    return ids;
}

/// Format 1: the parameter `jitter` and the axis `base` did not exist, and `rounding` was "down" by default.
StoredRun older_run() {
    return run_of(
        "older", "2026-01-01T00:00:00Z",
        {cell_of("first steps=8 | heightmap=rock", {{"rounding", "down"}, {"steps", 8}}, {{"heightmap", "rock"}}),
         cell_of("first rounding=up | heightmap=rock view_angle=60.5", {{"rounding", "up"}, {"steps", 32}},
                 {{"heightmap", "rock"}, {"view_angle", 60.5}})});
}

StoredRun newer_run() {
    const auto parameters = [](const char* rounding, int steps, const char* jitter) {
        return Json{{"steps", steps}, {"rounding", rounding}, {"jitter", jitter}};
    };
    const auto axes = [](double angle, const char* base) {
        return Json{{"heightmap", "rock"}, {"view_angle", angle}, {"base", base}, {"fov", nullptr}};
    };
    return run_of(
        "newer", "2026-06-01T00:00:00Z",
        {cell_of("first steps=8 rounding=down | heightmap=rock", parameters("down", 8, "off"), axes(0, "plane")),
         cell_of("first | heightmap=rock view_angle=60.5", parameters("up", 32, "off"), axes(60.5, "plane")),
         cell_of("first jitter=noise | heightmap=rock view_angle=60.5 base=sphere", parameters("up", 32, "noise"),
                 axes(60.5, "sphere"))},
        R"({"parameters": {"first": {"steps": 32, "rounding": "up", "jitter": "off"}},
                      "axes": {"heightmap": null, "view_angle": 0, "base": "plane", "fov": 45}})");
}

TEST(CommonIds, NameWhatIsNoLongerADefaultAndLeaveOutWhatARunDoesNotKnow) {
    std::vector<StoredRun> runs{older_run(), newer_run()};
    const std::vector<std::string> own = ids_of(runs[1]);
    give_common_ids(runs);
    EXPECT_THAT(ids_of(runs[0]),
                ElementsAre("first steps=8 rounding=down | heightmap=rock", "first | heightmap=rock view_angle=60.5"));
    EXPECT_EQ(ids_of(runs[1]), own) << "a run's ids by its own defaults are those it has";
}

TEST(CommonIds, MakeAnOlderRunComparableCellByCell) {
    std::vector<StoredRun> runs{older_run(), newer_run()};
    give_common_ids(runs);
    const Comparison comparison =
        compare_quality_of_runs(std::span(runs).first(1), std::span(runs).subspan(1), default_deciding_figures());
    EXPECT_EQ(comparison.cells.size(), 2U);
    ASSERT_EQ(comparison.uncompared.size(), 1U);
    EXPECT_EQ(comparison.uncompared[0].cell, "first jitter=noise | heightmap=rock view_angle=60.5 base=sphere");
}

TEST(CommonIds, GoByTheNewestRunWhateverTheOrderOfTheRuns) {
    std::vector<StoredRun> runs{newer_run(), older_run()};
    give_common_ids(runs);
    EXPECT_THAT(ids_of(runs[1]),
                ElementsAre("first steps=8 rounding=down | heightmap=rock", "first | heightmap=rock view_angle=60.5"));
}

TEST(CommonIds, LeaveIdsAloneWhereNoRunRecordsDefaultsOrAllRecordTheSame) {
    for (std::vector<StoredRun> runs : {std::vector{older_run(), older_run()}, std::vector{newer_run(), newer_run()}}) {
        const std::vector<std::string> before = ids_of(runs[0]);
        give_common_ids(runs);
        EXPECT_EQ(ids_of(runs[0]), before);
    }
}

TEST(CommonIds, NameAParameterThatIsGoneUnlessItWasAtItsDefault) {
    StoredRun older = older_run();
    older.run.cells[0].parameters["gone"] = 3;
    older.run.cells[1].parameters["gone"] = 4;
    older.run.cells[1].cell = "first rounding=up gone=4 | heightmap=rock view_angle=60.5";
    std::vector<StoredRun> runs{older, newer_run()};
    give_common_ids(runs);
    EXPECT_THAT(ids_of(runs[0]), ElementsAre("first steps=8 rounding=down | heightmap=rock",
                                             "first gone=4 | heightmap=rock view_angle=60.5"));
}

/// Its preset `engine` sets `steps` and `rounding`, `measured` are the cell's steps.
StoredRun run_with_preset(const std::string& name, const std::string& time, int steps_of_preset, int measured,
                          const std::string& id) {
    CellResult cell = cell_of(id, {{"steps", measured}, {"rounding", "up"}}, {{"heightmap", "rock"}});
    cell.technique = "first";
    cell.preset = "engine";
    StoredRun run =
        run_of(name, time, {cell},
               R"({"parameters": {"first": {"steps": 32, "rounding": "down"}}, "axes": {"heightmap": null}})");
    run.run.run["presets"]["first"]["engine"]["parameters"] = {{"rounding", "up"}, {"steps", steps_of_preset}};
    return run;
}

TEST(CommonIds, NameWhatIsNoLongerAPresetsValueSoThatOneNameDoesNotStandForTwoSettings) {
    std::vector<StoredRun> runs{
        run_with_preset("older", "2026-01-01T00:00:00Z", 16, 16, "first preset=engine | heightmap=rock"),
        run_with_preset("newer", "2026-06-01T00:00:00Z", 8, 8, "first preset=engine | heightmap=rock"),
        run_with_preset("newest", "2026-07-01T00:00:00Z", 8, 16, "first preset=engine steps=16 | heightmap=rock")};
    give_common_ids(runs);
    EXPECT_THAT(ids_of(runs[0]), ElementsAre("first preset=engine steps=16 | heightmap=rock"));
    EXPECT_THAT(ids_of(runs[1]), ElementsAre("first preset=engine | heightmap=rock"));
    EXPECT_THAT(ids_of(runs[2]), ElementsAre("first preset=engine steps=16 | heightmap=rock"));
}

TEST(CommonIds, NameAParameterOfAPresetThatARunDoesNotKnowForItWasAtItsDefaultThen) {
    std::vector<StoredRun> runs{
        run_with_preset("older", "2026-01-01T00:00:00Z", 16, 16, "first preset=engine | heightmap=rock"),
        run_with_preset("newer", "2026-06-01T00:00:00Z", 16, 16, "first preset=engine | heightmap=rock")};
    Json& newer = runs[1].run.run;
    newer["defaults"]["parameters"]["first"]["tolerance"] = 0;
    newer["presets"]["first"]["engine"]["parameters"]["tolerance"] = 0.01;
    runs[1].run.cells[0].parameters["tolerance"] = 0.01;
    give_common_ids(runs);
    EXPECT_THAT(ids_of(runs[0]), ElementsAre("first preset=engine tolerance=0 | heightmap=rock"));
    EXPECT_THAT(ids_of(runs[1]), ElementsAre("first preset=engine | heightmap=rock"));
}

TEST(CommonIds, LeaveThoseOfPresetsAloneWhereOnlyOtherDefaultsChanged) {
    std::vector<StoredRun> runs{
        run_with_preset("older", "2026-01-01T00:00:00Z", 16, 16, "first preset=engine | heightmap=rock"),
        run_with_preset("newer", "2026-06-01T00:00:00Z", 16, 8, "first preset=engine steps=8 | heightmap=rock")};
    runs[0].run.run["defaults"]["parameters"]["first"]["steps"] = 64;
    give_common_ids(runs);
    EXPECT_THAT(ids_of(runs[0]), ElementsAre("first preset=engine | heightmap=rock"));
    EXPECT_THAT(ids_of(runs[1]), ElementsAre("first preset=engine steps=8 | heightmap=rock"));
}

}  // namespace
}  // namespace reliefbench
