#include "command_line.hpp"

#include "scene/image_file.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Render : public CommandLine {
protected:
    /// With a small height map and picture, written to `output` of this test's folder.
    Outcome render(const std::string& output, std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(),
                         {"render", "-a", "resolution=48x32", "-a", "heightmap_size=32", "-o", path(output)});
        return reliefbench(arguments);
    }

    RasterFile rendered(const std::string& output, const std::vector<std::string>& arguments) const {
        const Outcome outcome = render(output, arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return read_raster_file(path(output));
    }
};

/// Whether `part` occurs in `whole`, pixel for pixel.
bool contains(const RasterFile& whole, const RasterFile& part) {
    const auto value = [](const RasterFile& raster, int x, int y, int channel) {
        return raster.values[(static_cast<std::size_t>(y) * raster.size.width + x) * 3 + channel];
    };
    const auto found_at = [&](int left, int top) {
        for (int y = 0; y < part.size.height; ++y) {
            for (int x = 0; x < part.size.width; ++x) {
                for (int channel = 0; channel < 3; ++channel) {
                    if (value(whole, left + x, top + y, channel) != value(part, x, y, channel)) return false;
                }
            }
        }
        return true;
    };
    for (int top = 0; top + part.size.height <= whole.size.height; ++top) {
        for (int left = 0; left + part.size.width <= whole.size.width; ++left) {
            if (found_at(left, top)) return true;
        }
    }
    return false;
}

TEST_F(Render, OneCellComesWithItsTruthAndALegendOfItsErrors) {
    const RasterFile all = rendered("all.png", {"--technique", "steep", "--validate"});
    const RasterFile picture = rendered("picture.png", {"--technique", "steep", "--show", "picture"});
    const RasterFile truth = rendered("truth.png", {"--technique", "steep", "--show", "truth"});
    EXPECT_EQ(picture.size, (Resolution{48, 32})) << "one picture alone comes as it is";
    EXPECT_NE(picture.values, truth.values);
    EXPECT_TRUE(contains(all, picture));
    EXPECT_TRUE(contains(all, truth));
    EXPECT_GT(all.size.height, 2 * 32) << "there is a legend";
    EXPECT_THAT(render("again.png", {"--technique", "steep"}).err,
                AllOf(HasSubstr("UV error"), HasSubstr("Taps per pixel"), HasSubstr("Missed hits"), HasSubstr("FLIP")));
}

TEST_F(Render, EveryMapCanBeShown) {
    const RasterFile maps = rendered(
        "maps.png", {"--technique", "pom", "--show", "uv_error,depth_error,normal_error,flip,ssim,taps,coverage"});
    EXPECT_GT(maps.size.width, 7 * 48);
}

TEST_F(Render, LayersAgreeWithEachOther) {
    const RasterFile layers = rendered("layers.exr", {"--technique", "qdm", "-a", "view_angle=60"});
    EXPECT_EQ(layers.size, (Resolution{48, 32}));
    EXPECT_EQ(layers.bits, 32);
    EXPECT_THAT(layers.channel_names,
                testing::UnorderedElementsAre("hit.u", "hit.v", "hit.h", "hit.t", "truth.u", "truth.v", "truth.h",
                                              "truth.t", "color.R", "color.G", "color.B", "truth_color.R",
                                              "truth_color.G", "truth_color.B", "uv_error", "depth_error",
                                              "normal_error", "flip", "ssim", "taps", "coverage"));
    const auto value = [&](std::size_t pixel, const std::string& channel) {
        const auto position = std::find(layers.channel_names.begin(), layers.channel_names.end(), channel);
        return layers.values[pixel * layers.channel_names.size() +
                             static_cast<std::size_t>(position - layers.channel_names.begin())];
    };
    std::size_t hits = 0;
    for (std::size_t pixel = 0; pixel < layers.size.pixels(); ++pixel) {
        const bool compared = value(pixel, "coverage") == 1;
        EXPECT_EQ(compared, value(pixel, "hit.t") >= 0 && value(pixel, "truth.t") >= 0);
        EXPECT_EQ(std::isnan(value(pixel, "uv_error")), !compared);
        if (value(pixel, "hit.t") == -1) {
            EXPECT_EQ(value(pixel, "hit.u"), 0);
            EXPECT_EQ(value(pixel, "hit.h"), 0);
            continue;
        }
        ++hits;
        EXPECT_GE(value(pixel, "hit.u"), 0);
        EXPECT_LE(value(pixel, "hit.u"), 1);
        EXPECT_GT(value(pixel, "taps"), 0);
        // A pixel's hit and its truth lie on one ray: a wide bound, so that a silhouette may differ.
        EXPECT_NEAR(value(pixel, "hit.t"), value(pixel, "truth.t"), 0.5);
        if (compared) {
            EXPECT_EQ(value(pixel, "depth_error"), value(pixel, "hit.t") - value(pixel, "truth.t"));
        }
    }
    EXPECT_GT(hits, layers.size.pixels() / 20);
}

TEST_F(Render, AContactSheetHasARowPerCellWithTheCellsOwnPicture) {
    const std::vector<std::string> view{"-a", "projection=parallel", "-a", "view_angle=60", "--show", "picture"};
    const auto of = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), view.begin(), view.end());
        return arguments;
    };
    // Parallel rays fill the picture with relief, so that nothing is cropped.
    const RasterFile flat = rendered("flat.png", of({"--technique", "flat"}));
    const RasterFile few = rendered("few.png", of({"--technique", "steep", "-a", "sample_count=6"}));
    const RasterFile many = rendered("many.png", of({"--technique", "steep", "-a", "sample_count=60"}));
    const RasterFile sheet =
        rendered("sheet.png", of({"--contact-sheet", "--technique", "flat,steep", "-a", "sample_count=6,60"}));
    EXPECT_NE(few.values, many.values);
    EXPECT_TRUE(contains(sheet, flat));
    EXPECT_TRUE(contains(sheet, few));
    EXPECT_TRUE(contains(sheet, many));
}

TEST_F(Render, ACellThatFailsLeavesARowOfTheSheetWithoutPictures) {
    std::ofstream(copy_technique("steep", "mine") / "trace.glsl", std::ios::app) << "\nthis is no GLSL;\n";
    const Outcome outcome =
        render("sheet.png", {"--contact-sheet", "--technique", "flat,mine", "--techniques", path("techniques")});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("mine"), HasSubstr("trace.glsl")));
    EXPECT_GT(read_raster_file(path("sheet.png")).size.width, 5 * 48);
}

TEST_F(Render, AnAnimationIsAFramePerValue) {
    const Outcome outcome =
        render("turn.png", {"--technique", "steep", "--show", "picture", "--animate", "view_angle=[0:60:30]"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const RasterFile last = rendered("last.png", {"--technique", "steep", "--show", "picture", "-a", "view_angle=60"});
    EXPECT_EQ(read_raster_file(path("turn_002.png")).values, last.values);
    EXPECT_NE(read_raster_file(path("turn_000.png")).values, last.values);
    EXPECT_TRUE(std::filesystem::exists(path("turn_001.png")));
    EXPECT_FALSE(std::filesystem::exists(path("turn_003.png")));
    EXPECT_FALSE(std::filesystem::exists(path("turn.png")));
}

TEST_F(Render, ABrokenShaderFailsItsCell) {
    std::ofstream(copy_technique("steep", "mine") / "trace.glsl", std::ios::app) << "\nthis is no GLSL;\n";
    const Outcome outcome = render("picture.png", {"--technique", "mine", "--techniques", path("techniques")});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("mine"), HasSubstr("trace.glsl")));
    EXPECT_FALSE(std::filesystem::exists(path("picture.png")));
}

TEST_F(Render, AFrameThatCannotBeDrawnIsLeftOutAndTheOthersAreDrawn) {
    // Tiled, which the technique does not do, in the first frame.
    const std::filesystem::path manifest = copy_technique("steep", "mine") / "technique.json";
    Json json = Json::parse(read_file(manifest));
    json["needs"] = {{"map", {"untiled"}}};
    std::ofstream(manifest) << json.dump();
    const Outcome outcome = render("tiled.png", {"--technique", "mine", "--techniques", path("techniques"), "--show",
                                                 "picture", "--animate", "tiling=2,1"});
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("skipped: mine"));
    EXPECT_FALSE(std::filesystem::exists(path("tiled_000.png")));
    EXPECT_TRUE(std::filesystem::exists(path("tiled_001.png")));
}

struct BadRender {
    std::vector<std::string> arguments;
    std::string word;
};

TEST_F(Render, RefusesWhatItCannotDraw) {
    const std::vector<BadRender> cases = {
        {{"--technique", "steeep", "-o", "x.png"}, "did you mean 'steep'?"},
        {{"--technique", "steep", "-o", "x.jpg"}, ".png"},
        {{"--technique", "steep", "-o", "x"}, ".png"},
        {{"--technique", "steep", "-o", "x.PNG"}, ".png"},
        {{"--technique", "steep", "-a", "view_angle=0,45", "-o", "x.png"}, "view_angle"},
        {{"--technique", "steep", "-a", "view_angel=0", "-o", "x.png"}, "did you mean 'view_angle'?"},
        {{"--technique", "steep", "--set", "colour=3", "-o", "x.png"}, "colour"},
        {{"--technique", "steep", "--set", "colour", "-o", "x.png"}, "parameter=value"},
        {{"--technique", "steep", "-a", "sample_count=-3", "-o", "x.png"}, "sample_count"},
        {{"--technique", "steep", "-a", "heightmap=missing.png", "-o", "x.png"}, "missing.png"},
        {{"--technique", "steep", "-a", "resolution=32", "-o", "missing/x.png"}, "missing/x.png"},
        {{"-o", "x.png"}, "--technique is required"},
        {{"--technique", "steep,pom", "-o", "x.png"}, "--contact-sheet"},
        {{"--technique", "steep", "--show", "flp", "-o", "x.png"}, "did you mean 'flip'?"},
        {{"--technique", "steep", "--show", "picture,,truth", "-o", "x.png"}, "there is no ''"},
        {{"--technique", "steep", "--animate", "view_angle=30", "-o", "x.png"}, "at least two values"},
        {{"--technique", "steep", "--animate", "view_angle=[60:30:5]", "-o", "x.png"}, "steps away from its stop"},
        {{"--technique", "steep", "--animate", "view_angle=", "-o", "x.png"}, "expected name=value"},
        {{"--technique", "steep", "--animate", "resolution=32,64", "-o", "x.png"}, "one resolution"},
        {{"--technique", "steep", "-a", "view_angle=3", "--animate", "view_angle=1,2", "-o", "x.png"}, "already"},
        {{"--contact-sheet", "--animate", "view_angle=1,2", "-o", "x.png"}, "exclude each other"},
        {{"--contact-sheet", "--set", "colour=3", "-o", "x.png"}, "none of the techniques has a parameter 'colour'"},
        {{"--contact-sheet", "-o", "x.exr"}, ".png"},
    };
    for (const BadRender& bad : cases) {
        std::vector<std::string> arguments{"render"};
        arguments.insert(arguments.end(), bad.arguments.begin(), bad.arguments.end());
        const Outcome outcome = reliefbench(arguments);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(bad.arguments);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("reliefbench: "), HasSubstr(bad.word)));
        EXPECT_FALSE(std::filesystem::exists(path("x.png")));
    }
}

}  // namespace
}  // namespace reliefbench
