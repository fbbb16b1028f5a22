#include "measure/laboratory.hpp"

#include "store/crashes.hpp"
#include "technique/test_scene.hpp"

#include <gmock/gmock.h>

#include <optional>
#include <utility>

namespace reliefbench {
namespace {

using testing::HasSubstr;

/// One that takes so many slices, of one source each, that a limit of nothing is passed after the first.
const char* const sliced_manifest = R"({
    "title": "Test", "kind": "march", "citation": "none", "promises": [], "shape": "quad",
    "parameters": [{"name": "scale", "type": "integer", "default": 1, "range": [1, 9], "help": "h"},
                   {"name": "other", "type": "integer", "default": 1, "range": [1, 9], "help": "h"}],
    "maps": [{"name": "made", "format": "r32f"}],
    "passes": [{"name": "search", "shader": "search.glsl", "writes": "made", "sliced": {"iterations": 32768}}]})";

class FailedPreparation : public test::DeviceTest {
protected:
    FailedPreparation()
        : folder_({{"technique.json", sliced_manifest},
                   {"search.glsl", "void prepare(ivec2 texel) { write_map(folded_map() + float(scale)); }"},
                   {"trace.glsl", "Trace trace(ReliefRay ray) { return hit_on_ray(0.5, other); }"}}),
          library_(find_techniques({folder_.root()})),
          inputs_(device(), configuration_.lighting, configuration_.truth) {
        configuration_.preparation.limit_s = 0;
        laboratory_.emplace(library_, configuration_, inputs_, MapMaking{});
    }

    const Technique& technique() const { return library_.techniques.front(); }

    Cell cell(const std::string& map, double view_angle, const ParameterValues& changed = {}) const {
        Cell cell;
        cell.technique = technique().manifest.id;
        cell.parameters = technique().manifest.defaults();
        for (const auto& [name, value] : changed)
            cell.parameters[name] = value;
        cell.view.height_map.name = map;
        cell.view.height_map.size = {16, 16};
        cell.view.view = test::make_view(view_angle, Projection::parallel, {16, 16});
        cell.id = cell_id(technique().manifest, cell.parameters, cell.view);
        return cell;
    }

    CellResult prepare(const Cell& cell) { return laboratory_->make_ready(cell).result; }

    std::string maps_key(const Cell& cell) {
        const Renderer renderer(device(), technique(), cell.parameters, inputs_.map(cell.view).scene, cell.view.view,
                                configuration_.lighting);
        return renderer.maps_key();
    }

    test::TemporaryTechnique folder_;
    TechniqueLibrary library_;
    Configuration configuration_;
    SharedInputs inputs_;
    std::optional<Laboratory> laboratory_;
};

TEST_F(FailedPreparation, MapsAreTheSameWhateverIsDrawnWithThem) {
    EXPECT_EQ(maps_key(cell("rock", 0)), maps_key(cell("rock", 60)));
    EXPECT_EQ(maps_key(cell("rock", 0)), maps_key(cell("rock", 0, {{"other", std::int64_t{2}}})));
    EXPECT_NE(maps_key(cell("rock", 0)), maps_key(cell("rock", 0, {{"scale", std::int64_t{2}}})));
    EXPECT_NE(maps_key(cell("rock", 0)), maps_key(cell("bricks", 0)));
}

TEST_F(FailedPreparation, OneThatWasGivenUpIsNotTriedAgain) {
    const CellResult given_up = prepare(cell("rock", 0));
    EXPECT_EQ(given_up.status, CellStatus::skipped);
    EXPECT_THAT(given_up.reason, HasSubstr("more than the limit of 0 s"));
    EXPECT_THAT(given_up.reason, testing::Not(HasSubstr("about 0 s")));
    // With a limit that would do, to tell that nothing is tried.
    configuration_.preparation.limit_s = 60;
    const CellResult again = prepare(cell("rock", 30));
    EXPECT_EQ(again.status, CellStatus::skipped);
    EXPECT_EQ(again.reason, given_up.reason);
    EXPECT_EQ(prepare(cell("bricks", 0)).status, CellStatus::ok) << "other maps are tried";
    EXPECT_EQ(prepare(cell("rock", 0, {{"scale", std::int64_t{2}}})).status, CellStatus::ok)
        << "other settings are tried";
}

TEST_F(FailedPreparation, OneThatFailedIsNotTriedAgain) {
    configuration_.preparation.limit_s = 60;
    MapMaking maps;
    maps.failed.add(maps_key(cell("rock", 0)), {false, "the maps burnt down"});
    laboratory_.emplace(library_, configuration_, inputs_, std::move(maps));
    const CellResult result = prepare(cell("rock", 30));
    EXPECT_EQ(result.status, CellStatus::failed);
    EXPECT_EQ(result.reason, "the maps burnt down");
}

TEST_F(FailedPreparation, WhatCrashedTooOftenIsKnownToFail) {
    const FailedPreparations failed =
        crashed_preparations({{"often", std::vector<std::string>(max_crashes, "signal 11")}, {"once", {"signal 11"}}});
    ASSERT_NE(failed.find("often"), nullptr);
    EXPECT_FALSE(failed.find("often")->given_up);
    EXPECT_THAT(failed.find("often")->reason, HasSubstr("signal 11"));
    EXPECT_EQ(failed.find("once"), nullptr);
}

TEST_F(FailedPreparation, ACellThatWasReadyIsMadeReadyAgainWithoutALimit) {
    configuration_.preparation.limit_s = 60;
    EXPECT_EQ(prepare(cell("rock", 0)).status, CellStatus::ok);
    configuration_.preparation.limit_s = 0;
    const PreparedCell again = laboratory_->make_ready_again(cell("rock", 0));
    EXPECT_EQ(again.result.status, CellStatus::ok);
    EXPECT_TRUE(again.renderer);
    EXPECT_FALSE(again.probe) << "nothing is drawn for figures that are known";
}

}  // namespace
}  // namespace reliefbench
