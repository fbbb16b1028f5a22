#include "measure/cell_preparation.hpp"

#include "support/error_message.hpp"
#include "technique/test_scene.hpp"

#include <gmock/gmock.h>

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
          technique_(folder_.load()),
          inputs_(device(), configuration_.lighting, configuration_.truth) {
        configuration_.preparation.limit_s = 0;
    }

    Cell cell(const std::string& map, double view_angle, const ParameterValues& changed = {}) const {
        Cell cell;
        cell.technique = technique_.manifest.id;
        cell.parameters = technique_.manifest.defaults();
        for (const auto& [name, value] : changed)
            cell.parameters[name] = value;
        cell.view.height_map.name = map;
        cell.view.height_map.size = {16, 16};
        cell.view.view = test::make_view(view_angle, Projection::parallel, {16, 16});
        cell.id = cell_id(technique_.manifest, cell.parameters, cell.view);
        return cell;
    }

    PreparedOrSkipped prepare(const Cell& cell) {
        return prepare_cell(device(), technique_, cell, inputs_, configuration_, {.failed = failed_});
    }

    std::string maps_key(const Cell& cell) {
        const Renderer renderer(device(), technique_, cell.parameters, inputs_.map(cell.view).scene, cell.view.view,
                                configuration_.lighting);
        return renderer.maps_key();
    }

    test::TemporaryTechnique folder_;
    Technique technique_;
    Configuration configuration_;
    SharedInputs inputs_;
    FailedPreparations failed_;
};

TEST_F(FailedPreparation, MapsAreTheSameWhateverIsDrawnWithThem) {
    EXPECT_EQ(maps_key(cell("rock", 0)), maps_key(cell("rock", 60)));
    EXPECT_EQ(maps_key(cell("rock", 0)), maps_key(cell("rock", 0, {{"other", std::int64_t{2}}})));
    EXPECT_NE(maps_key(cell("rock", 0)), maps_key(cell("rock", 0, {{"scale", std::int64_t{2}}})));
    EXPECT_NE(maps_key(cell("rock", 0)), maps_key(cell("bricks", 0)));
}

TEST_F(FailedPreparation, OneThatWasGivenUpIsNotTriedAgain) {
    const std::string reason = prepare(cell("rock", 0)).skip_reason;
    EXPECT_THAT(reason, HasSubstr("more than the limit of 0 s"));
    EXPECT_THAT(reason, testing::Not(HasSubstr("about 0 s")));
    const FailedPreparations::Failure* known = failed_.find(maps_key(cell("rock", 30)));
    ASSERT_NE(known, nullptr);
    EXPECT_TRUE(known->given_up);
    EXPECT_EQ(known->reason, reason);
    // With a limit that would do, to tell that nothing is tried.
    configuration_.preparation.limit_s = 60;
    EXPECT_EQ(prepare(cell("rock", 30)).skip_reason, reason);
    EXPECT_TRUE(prepare(cell("bricks", 0)).cell) << "other maps are tried";
    EXPECT_TRUE(prepare(cell("rock", 0, {{"scale", std::int64_t{2}}})).cell) << "other settings are tried";
}

TEST_F(FailedPreparation, OneThatFailedIsNotTriedAgain) {
    configuration_.preparation.limit_s = 60;
    failed_.add(maps_key(cell("rock", 0)), {false, "the maps burnt down"});
    EXPECT_EQ(error_message([&] { prepare(cell("rock", 30)); }), "the maps burnt down");
}

TEST_F(FailedPreparation, AnAnswerOutOfRangeIsAnError) {
    configuration_.preparation.limit_s = 60;
    EXPECT_TRUE(prepare(cell("rock", 0)).cell);
    write_text_file(folder_.folder() / "trace.glsl", "Trace trace(ReliefRay ray) { return hit_on_ray(2.0, other); }");
    technique_ = folder_.load();
    EXPECT_THAT(error_message([&] { prepare(cell("rock", 0)); }), HasSubstr("s = 2 at pixel (0, 0)"));
}

}  // namespace
}  // namespace reliefbench
