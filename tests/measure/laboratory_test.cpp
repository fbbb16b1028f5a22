// Cells that end as failed although they were drawn, on a device with the validation layer on.

#include "measure/laboratory.hpp"

#include "gpu/loop_limit.hpp"
#include "technique/test_scene.hpp"

#include <gmock/gmock.h>

#include <string>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Files = test::TemporaryTechnique::Files;

class CellPreparation : public test::DeviceTest {
protected:
    /// The only cell of a configuration of one technique.
    static CellResult prepare(const TechniqueLibrary& library, const std::string& technique,
                              const std::string& parameters = "{}") {
        const Json json = Json::parse(R"({"name": "test", "techniques": [{"technique": ")" + technique +
                                      R"(", "parameters": )" + parameters + R"(}],
            "axes": {"heightmap": "rock", "heightmap_size": "32x32", "view_angle": 75, "projection": "parallel",
                     "boundary": "repeat", "resolution": "16x16"}})");
        const Configuration configuration = parse_configuration(json, "test", {}, library.manifests());
        const std::vector<Cell> cells = expand(configuration, library.manifests());
        EXPECT_EQ(cells.size(), 1U);
        SharedInputs inputs(device(), configuration.lighting, configuration.truth);
        return Laboratory(library, configuration, inputs, {}).make_ready(cells.front()).result;
    }

    static TechniqueLibrary shipped() { return find_techniques({default_technique_root()}); }
};

TEST_F(CellPreparation, TellsWhatItBegins) {
    const TechniqueLibrary library = shipped();
    const Json json = Json::parse(R"({"techniques": ["qdm"], "axes": {"heightmap": "rock", "heightmap_size": 16,
        "resolution": 8}})");
    const Configuration configuration = parse_configuration(json, "test", {}, library.manifests());
    const Cell cell = expand(configuration, library.manifests()).front();
    SharedInputs inputs(device(), configuration.lighting, configuration.truth);
    Laboratory laboratory(library, configuration, inputs, {});
    std::vector<std::string> stages;
    const auto prepare_again = [&] {
        stages.clear();
        laboratory.make_ready(cell, {.on_stage = [&](const std::string& stage) { stages.push_back(stage); }});
        return stages;
    };
    EXPECT_THAT(prepare_again(),
                testing::ElementsAre("loading the height map", "compiling", "making its maps",
                                     "drawing it once, counted", "tracing the truth", "comparing with the truth"));
    EXPECT_THAT(prepare_again(), testing::ElementsAre("compiling", "making its maps", "drawing it once, counted",
                                                      "comparing with the truth"));
}

TEST_F(CellPreparation, ACellOfUnconvergedPixelsNamesWhatCapsThem) {
    const CellResult capped = prepare(shipped(), "qdm", R"({"max_steps": 1})");
    EXPECT_EQ(capped.status, CellStatus::failed);
    EXPECT_THAT(capped.reason, AllOf(HasSubstr("left their loop at the iteration cap"),
                                     HasSubstr("raise max_steps (now 1, at most 65536)"), Not(HasSubstr("min_steps"))));
    EXPECT_TRUE(value_of("error.uv_texels.p99", capped)) << "its figures are kept";
    EXPECT_EQ(prepare(shipped(), "qdm").status, CellStatus::ok);
}

/// Marks every answer, whatever its parameter is.
Files never_converging(const std::string& parameters, const std::string& more) {
    return {{"technique.json", test::manifest_json(parameters, more)},
            {"trace.glsl", "Trace trace(ReliefRay ray) { return unconverged(hit_on_ray(0.5, 1)); }\n"}};
}

TEST_F(CellPreparation, NothingIsRaisedThatIsAtItsMaximum) {
    const std::string most = R"({"name": "most", "type": "integer", "default": 8, "range": [1, 8], "help": "h"})";
    const test::TemporaryTechnique at_most(never_converging(most, R"(, "search_cap": "most")"));
    const std::string id = at_most.folder().filename();
    EXPECT_THAT(prepare(find_techniques({at_most.root()}), id).reason,
                AllOf(HasSubstr("most = 8, which caps it, is at its maximum"), Not(HasSubstr("raise"))));
    const test::TemporaryTechnique without(never_converging("", ""));
    EXPECT_THAT(prepare(find_techniques({without.root()}), without.folder().filename()).reason,
                HasSubstr("the cap stands in its shaders"));
}

TEST_F(CellPreparation, ACellWhoseLoopsTheDeviceEndedIsFailed) {
    if (!gpu::loop_limit(device())) GTEST_SKIP() << "the device ends no loops";
    const test::TemporaryTechnique endless(Files{{"trace.glsl", R"(
        Trace trace(ReliefRay ray) {
            int n = 0;
            while (tap_height(ray.uv) > -1.0) n += 1;
            return hit_on_ray(1.0 - tap_height(ray.uv), n);
        })"}});
    const CellResult result = prepare(find_techniques({endless.root()}), endless.folder().filename());
    EXPECT_EQ(result.status, CellStatus::failed);
    EXPECT_THAT(result.reason, AllOf(HasSubstr("the device ended the loops of 100 % of the pixels"),
                                     HasSubstr("after 65535 iterations of all of them together"),
                                     HasSubstr("give each loop an end of its own that is sooner")));
    EXPECT_GT(value_of("work.taps_mean", result).value(), 60000) << "its figures are kept";
}

TEST_F(CellPreparation, AnAnswerOutOfRangeFailsTheCellAndLeavesNoFigureButThePicture) {
    const test::TemporaryTechnique wrong(
        Files{{"trace.glsl", "Trace trace(ReliefRay ray) { return hit_on_ray(2.0, 1); }"}});
    const TechniqueLibrary library = find_techniques({wrong.root()});
    SharedInputs inputs(device(), Lighting{}, TruthSettings{});
    const Configuration configuration;
    Laboratory laboratory(library, configuration, inputs, {});
    Cell cell;
    cell.id = cell.technique = wrong.folder().filename();
    cell.parameters = library.techniques.front().manifest.defaults();
    cell.view.height_map.name = "rock";
    cell.view.height_map.size = {16, 16};
    cell.view.view = test::make_view(0, Projection::parallel, {16, 16});
    const PreparedCell prepared = laboratory.make_ready(cell);
    EXPECT_EQ(prepared.result.status, CellStatus::failed);
    EXPECT_THAT(prepared.result.reason, HasSubstr("s = 2 at pixel (0, 0)"));
    EXPECT_FALSE(prepared.is_compared);
    EXPECT_FALSE(value_of("work.taps_mean", prepared.result));
    EXPECT_FALSE(prepared.result.prepare_ms);
    ASSERT_TRUE(prepared.probe) << "it is drawn, to see where it fails";

    cell.skip_reason = "the configuration says so";
    const PreparedCell skipped = laboratory.make_ready(cell);
    EXPECT_EQ(skipped.result.status, CellStatus::skipped);
    EXPECT_EQ(describe_ending(skipped.result), "skipped: the configuration says so");
    EXPECT_FALSE(skipped.probe);
}

}  // namespace
}  // namespace reliefbench
