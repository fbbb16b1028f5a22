#include "command_line.hpp"

#include "scene/image_file.hpp"
#include "scene/surface/generated_base.hpp"
#include "support/mesh_writer.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class EndToEnd : public CommandLine {
protected:
    static std::string shipped(const std::string& configuration) {
        return (std::filesystem::path(RELIEFBENCH_SOURCE_DIR) / "configs" / configuration).string();
    }
};

/// What must repeat exactly: everything of a cell but its times.
std::map<std::string, Json> without_times(const std::vector<Json>& cells) {
    std::map<std::string, Json> kept;
    for (Json cell : cells) {
        cell.erase("time");
        if (cell.contains("prepare") && cell["prepare"].is_object()) {
            cell["prepare"].erase("ms");
        }
        kept[cell.at("cell").get<std::string>()] = cell;
    }
    return kept;
}

std::vector<std::string> cell_ids(const std::vector<Json>& cells) {
    std::vector<std::string> ids;
    for (const Json& cell : cells) {
        ids.push_back(cell.at("cell").get<std::string>());
    }
    return ids;
}

TEST_F(EndToEnd, ALogTellsFromItsFirstLinesWhatIsDone) {
    const std::string configuration = write_configuration("long.json", long_configuration());
    const Outcome outcome = reliefbench({"run", configuration, "--sampling", "rounds=1", "-o", path("run")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("[ 0/12] 0:00 elapsed: reading height maps: bricks\n"),
                                   HasSubstr("[ 0/12] 0:00 elapsed: preparing 1 of 12: steep")));
    EXPECT_EQ(Json::parse(read_file(path("run/run.json"))).at("configuration").at("sampling").at("rounds"), 1);
}

TEST_F(EndToEnd, AxesAreListedForPeopleAndPrograms) {
    const Outcome table = reliefbench({"list", "axes"});
    EXPECT_THAT(table.out,
                AllOf(HasSubstr("view_angle "), HasSubstr("from 0 to below 90"), HasSubstr("sample_count ")));
    const Json axes = Json::parse(reliefbench({"list", "axes", "--format", "json"}).out);
    for (const Json& axis : axes) {
        EXPECT_THAT(table.out, HasSubstr(axis.at("axis").get<std::string>()));
        EXPECT_THAT(table.out, HasSubstr(axis.at("description").get<std::string>()));
    }
    EXPECT_EQ(reliefbench({"list", "axes", "--format", "xml"}).code, 2);
}

TEST_F(EndToEnd, SmokeRunsValidatesAndRepeats) {
    const Outcome first = reliefbench({"run", shipped("smoke.json"), "--validate", "-o", path("first")});
    ASSERT_EQ(first.code, 0) << first.err;
    const std::vector<Json> cells = read_lines(path("first/cells.jsonl"));
    ASSERT_GE(cells.size(), 8U);
    std::set<std::string> techniques;
    for (const Json& cell : cells) {
        SCOPED_TRACE(cell.at("cell").get<std::string>());
        EXPECT_EQ(cell.at("status"), "ok");
        techniques.insert(cell.at("technique").get<std::string>());
        const Json& draw = cell.at("time").at("draw");
        EXPECT_GT(draw.at("median_ms").get<double>(), 0);
        EXPECT_EQ(draw.at("n"), 4);  // two rounds of two samples
        EXPECT_GT(cell.at("time").at("ns_per_pixel").get<double>(), 0);
        EXPECT_GE(cell.at("error").at("uv_texels").at("p99").get<double>(), 0);
        EXPECT_GT(cell.at("error").at("compared").get<int>(), 0);
        EXPECT_GE(cell.at("image").at("rmse").get<double>(), 0);
    }
    EXPECT_EQ(techniques.size(), 7U);
    for (const std::string& technique : techniques) {
        EXPECT_THAT(first.out, HasSubstr(technique));
    }
    EXPECT_THAT(first.out, AllOf(HasSubstr("in all"), HasSubstr("counted GPU samples"), HasSubstr("truths")));

    std::size_t samples = 0;
    for (const Json& line : read_lines(path("first/samples.jsonl"))) {
        samples += line.at("pass") == "draw" ? line.at("ms").size() : 0;
    }
    EXPECT_EQ(samples, cells.size() * 4);

    const Json record = Json::parse(read_file(path("first/run.json")));
    for (const char* key : {"configuration", "environment", "device", "techniques", "height_maps", "filter_deviation",
                            "empty_pass", "command_line"}) {
        EXPECT_TRUE(record.contains(key)) << key;
    }
    EXPECT_EQ(record.at("techniques").size(), 7U);

    const Outcome second = reliefbench({"run", path("first/run.json"), "-o", path("second")});
    ASSERT_EQ(second.code, 0) << second.err;
    EXPECT_EQ(without_times(read_lines(path("second/cells.jsonl"))), without_times(cells));
}

// Shadows, depths and an object, measured, and repeated from run.json; real geometry says why it is left out.
TEST_F(EndToEnd, ShadowsAndDepthsAreMeasured) {
    Json json = tiny_configuration();
    json["techniques"] = {"max_mip", "tessellation"};
    json["axes"]["self_shadow"] = {"off", "hard"};
    json["axes"]["depth_write"] = {"on", "off"};
    json["axes"]["view_angle"] = 60;
    json["axes"]["height_scale"] = 0.2;
    json["object"] = {{"shape", "sphere"}, {"centre", {0, 0, -0.2}}, {"radius", 0.4}};
    const Outcome outcome = reliefbench({"run", write_configuration("own.json", json), "-o", path("first")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::vector<Json> cells = read_lines(path("first/cells.jsonl"));
    std::size_t skipped = 0;
    for (const Json& cell : cells) {
        SCOPED_TRACE(cell.at("cell").get<std::string>());
        const bool shadowed = cell.at("axes").at("self_shadow") == "hard";
        const bool polygon_depth = cell.at("axes").at("depth_write") == "off";
        if (cell.at("technique") == "tessellation" && (shadowed || polygon_depth)) {
            EXPECT_EQ(cell.at("status"), "skipped");
            EXPECT_THAT(cell.at("reason").get<std::string>(), HasSubstr("real geometry"));
            ++skipped;
            continue;
        }
        ASSERT_EQ(cell.at("status"), "ok");
        const Json& error = cell.at("error");
        EXPECT_EQ(error.at("shadow").is_null(), !shadowed);
        EXPECT_EQ(cell.at("work").at("shadow_taps_mean").is_null(), !shadowed);
        if (shadowed) {
            EXPECT_GT(error.at("shadow").at("compared").get<int>(), 0);
            EXPECT_GT(cell.at("work").at("shadow_taps_mean").get<double>(), 1);
        }
        if (polygon_depth) {
            EXPECT_GT(error.at("wrong_surface").get<double>(), 0.02);
        } else {
            EXPECT_LT(error.at("wrong_surface").get<double>(), 0.02);
        }
    }
    EXPECT_EQ(cells.size(), 8U);
    EXPECT_EQ(skipped, 3U);
    const Outcome again = reliefbench({"run", path("first/run.json"), "-o", path("second")});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(without_times(read_lines(path("second/cells.jsonl"))), without_times(cells));
}

TEST_F(EndToEnd, ARunRepeatsWithItsFiltersTechniquesAndHeightMap) {
    copy_technique("steep", "mine");
    RasterFile image;
    image.size = {8, 4};
    image.channel_names = {"Y"};
    for (int texel = 0; texel < 32; ++texel) {
        image.values.push_back(static_cast<float>(texel % 5) / 4.0F);
    }
    write_raster_file(path("heights.exr"), image);
    Json json = tiny_configuration();
    json["techniques"] = {"mine", "flat"};
    json["axes"]["heightmap"] = "heights.exr";
    json["axes"].erase("heightmap_size");
    const std::string configuration = write_configuration("own.json", json);
    const Outcome first = reliefbench({"run", configuration, "--techniques", "techniques", "-a", "view_angle=0,60",
                                       "--filter", "technique=mine", "-o", "first"});
    ASSERT_EQ(first.code, 0) << first.err;
    const std::vector<Json> cells = read_lines(path("first/cells.jsonl"));
    EXPECT_EQ(cells.size(), 2U);
    for (const std::string& id : cell_ids(cells)) {
        EXPECT_THAT(id, AllOf(HasSubstr("mine"), HasSubstr("heights.exr"), testing::Not(HasSubstr("/"))));
    }
    // From another working folder.
    const Outcome second = reliefbench({"run", path("first/run.json"), "-o", path("second")});
    ASSERT_EQ(second.code, 0) << second.err;
    EXPECT_EQ(without_times(read_lines(path("second/cells.jsonl"))), without_times(cells));
}

TEST_F(EndToEnd, ADryRunPrintsTheCellsAndTouchesNothing) {
    const Outcome plan = reliefbench({"run", shipped("smoke.json"), "--dry-run", "--filter", "technique=qdm"});
    EXPECT_EQ(plan.code, 0) << plan.err;
    EXPECT_THAT(plan.out, AllOf(HasSubstr("block 1 of 1"), HasSubstr("qdm"), HasSubstr("4 cells")));
    EXPECT_FALSE(std::filesystem::exists(path("results")));
}

TEST_F(EndToEnd, TheDefaultOutputFolderCarriesTheName) {
    const Outcome outcome = reliefbench({"run", write_configuration("tiny.json", tiny_configuration())});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::vector<std::string> folders;
    for (const auto& entry : std::filesystem::directory_iterator(path("results"))) {
        folders.push_back(entry.path().filename().string());
    }
    EXPECT_THAT(folders, ElementsAre(testing::StartsWith("tiny-")));
}

TEST_F(EndToEnd, ACellOutOfOneTechniquesRangeIsSkippedWithTheReason) {
    Json json = tiny_configuration();
    json["techniques"] = {"steep", "relief"};
    json["axes"]["sample_count"] = {4, 1000000};
    const Outcome outcome = reliefbench({"run", write_configuration("t.json", json), "--dry-run"});
    // No technique takes a million samples: an error, not a row of skipped cells.
    EXPECT_EQ(outcome.code, 2) << outcome.out;
}

TEST_F(EndToEnd, ACellOfUnconvergedPixelsFailsAndKeepsItsFigures) {
    const Outcome outcome = reliefbench({"run", write_configuration("tiny.json", tiny_configuration()), "-a",
                                         "technique=qdm", "-a", "max_steps=1", "-o", path("run")});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    const Json cell = read_lines(path("run/cells.jsonl")).at(0);
    EXPECT_EQ(cell.at("status"), "failed");
    EXPECT_THAT(cell.at("reason").get<std::string>(), HasSubstr("left their loop at the iteration cap"));
    EXPECT_GT(cell.at("work").at("unconverged"), 0.5);
    EXPECT_FALSE(cell.at("error").at("uv_texels").is_null());
    EXPECT_FALSE(cell.at("time").contains("draw"));
}

TEST_F(EndToEnd, ImagesAreKeptWhenAskedFor) {
    Json json = tiny_configuration();
    json["images"] = true;
    const Outcome outcome = reliefbench({"run", write_configuration("tiny.json", json), "-o", path("run")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::set<std::string> endings;
    std::set<std::string> legends;
    for (const auto& entry : std::filesystem::directory_iterator(path("run/images"))) {
        const std::string name = entry.path().filename().string();
        const std::string ending = name.substr(name.find('.'));
        if (name.starts_with("legend.")) {
            legends.insert(ending);
            continue;
        }
        EXPECT_THAT(name, testing::StartsWith("steep"));
        EXPECT_EQ(read_raster_file(entry.path()).size, (Resolution{32, 32})) << name;
        endings.insert(ending);
    }
    const std::vector<std::string> maps{".depth_error.png", ".flip.png", ".taps.png", ".uv_error.png"};
    EXPECT_THAT(legends, testing::ElementsAreArray(maps));
    EXPECT_TRUE(endings.erase(".png") == 1 && endings.erase(".truth.png") == 1) << "picture and truth";
    EXPECT_THAT(endings, testing::ElementsAreArray(maps));
}

TEST_F(EndToEnd, ErrorsInMotionAreMeasuredWhenAskedFor) {
    Json json = tiny_configuration();
    json["techniques"] = {"steep", "qdm"};
    const Outcome still = reliefbench({"run", write_configuration("still.json", json), "-o", path("still")});
    ASSERT_EQ(still.code, 0) << still.err;
    for (const Json& cell : read_lines(path("still/cells.jsonl"))) {
        EXPECT_TRUE(cell.at("motion").is_null());
    }
    json["motion"] = {{"frames", 3}};
    const Outcome moving = reliefbench({"run", write_configuration("moving.json", json), "--validate", "-o", "moving"});
    ASSERT_EQ(moving.code, 0) << moving.err;
    const std::vector<Json> cells = read_lines(path("moving/cells.jsonl"));
    ASSERT_EQ(cells.size(), 2U);
    std::map<std::string, double> texels;
    for (const Json& cell : cells) {
        const Json& motion = cell.at("motion");
        EXPECT_GT(motion.at("compared").get<int>(), 100);
        EXPECT_GT(motion.at("flip").at("max").get<double>(), 0);
        texels[cell.at("technique").get<std::string>()] = motion.at("texels").at("mean").get<double>();
        EXPECT_GT(cell.at("time").at("draw").at("n"), 0);
    }
    EXPECT_GT(texels.at("steep"), 10 * texels.at("qdm"));
}

TEST_F(EndToEnd, AFileOfTheGeneratedCylinderGivesItsFigures) {
    const BaseSource cylinder{.kind = BaseSource::Kind::cylinder, .curvature = 1.5, .segments = 32};
    write("cylinder.glb", as_glb(gltf_of(generate_base(cylinder))));
    Json json = tiny_configuration();
    json["techniques"] = {"steep",
                          {{"technique", "max_mip"}, {"parameters", {{"ray_model", "quadric_uv"}}}},
                          "tessellation",
                          "shell_march"};
    json["axes"]["boundary"] = {"clip", "repeat"};
    json["axes"]["self_shadow"] = {"off", "hard"};
    const auto figures_over = [&](const std::string& name, const Json& axes) {
        Json over = json;
        over["axes"].update(axes);
        const Outcome run = reliefbench({"run", write_configuration(name + ".json", over), "-o", path(name)});
        EXPECT_EQ(run.code, 0) << run.err;
        std::vector<Json> figures;
        for (const Json& cell : read_lines(path(name + "/cells.jsonl"))) {
            // Real geometry and shells have no search for shadows.
            if (cell.at("status") == "skipped") continue;
            EXPECT_EQ(cell.at("status"), "ok") << cell.at("reason");
            EXPECT_GT(cell.at("error").at("compared"), 100);
            figures.push_back({cell.at("technique"), cell.at("axes").at("boundary"), cell.at("work"), cell.at("error"),
                               cell.at("image")});
        }
        return figures;
    };
    const auto generated = figures_over("generated", {{"base", "cylinder"}, {"curvature", 1.5}, {"base_segments", 32}});
    EXPECT_EQ(generated.size(), 12U);
    EXPECT_EQ(figures_over("read", {{"base", "cylinder.glb"}, {"base_fit", "none"}}), generated);
}

TEST_F(EndToEnd, ListsTellWhatThereIs) {
    const Outcome techniques = reliefbench({"list", "techniques"});
    EXPECT_EQ(techniques.code, 0) << techniques.err;
    for (const char* id : {"flat", "parallax", "steep", "relief", "pom", "qdm", "tessellation"}) {
        EXPECT_THAT(techniques.out, HasSubstr(id));
    }
    const Outcome height_maps = reliefbench({"list", "heightmaps"});
    EXPECT_EQ(height_maps.code, 0) << height_maps.err;
    for (const char* name : {"bricks", "cobbles", "rock", "waves", "spikes", "steps"}) {
        EXPECT_THAT(height_maps.out, HasSubstr(name));
    }
    const Outcome devices = reliefbench({"list", "devices"});
    EXPECT_EQ(devices.code, 0) << devices.err;
    EXPECT_THAT(devices.out, HasSubstr("0  "));
}

TEST_F(EndToEnd, VerifyFailsABrokenTechniqueWithCode4) {
    copy_technique("flat", "mine");
    const Outcome good = reliefbench({"verify", "--technique", "mine", "--techniques", path("techniques")});
    EXPECT_EQ(good.code, 0) << good.out << good.err;
    EXPECT_THAT(good.out, AllOf(HasSubstr("ok"), HasSubstr("mine")));
    write("techniques/mine/trace.glsl", "this is no GLSL;\n");
    const Outcome bad = reliefbench({"verify", "--technique", "mine", "--techniques", path("techniques")});
    EXPECT_EQ(bad.code, 4) << bad.out << bad.err;
    EXPECT_THAT(bad.out, AllOf(HasSubstr("FAIL"), HasSubstr("trace.glsl")));
}

}  // namespace
}  // namespace reliefbench
