#include "command_line.hpp"

#include "scene/image_file.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class BadInput : public CommandLine {
protected:
    std::string tiny(const std::function<void(Json&)>& change = {}) const {
        Json json = tiny_configuration();
        if (change) change(json);
        return write_configuration("tiny.json", json);
    }

    /// What was said, without the lines of progress.
    static std::string words_of(const std::string& errors) {
        std::string words;
        std::istringstream lines(errors);
        for (std::string line; std::getline(lines, line);) {
            if (!line.starts_with('[')) words += line + '\n';
        }
        return words;
    }

    /// So is a dry run, with the same words.
    void expect_refused_by_both(const std::vector<std::string>& arguments,
                                const std::vector<std::string>& words) const {
        expect_refused(arguments, words);
        std::vector<std::string> run{"run"};
        run.insert(run.end(), arguments.begin(), arguments.end());
        std::vector<std::string> dry = run;
        run.insert(run.end(), {"-o", path("run")});
        dry.emplace_back("--dry-run");
        const Outcome planned = reliefbench(dry);
        EXPECT_EQ(planned.code, 2);
        EXPECT_TRUE(planned.out.empty()) << planned.out;
        EXPECT_EQ(planned.err, words_of(reliefbench(run).err));
    }

    /// One row of two float texels.
    std::string write_image(const std::string& name, float left, float right) const {
        RasterFile raster;
        raster.size = {2, 1};
        raster.channel_names = {"Y"};
        raster.values = {left, right};
        write_raster_file(path(name), raster);
        return path(name);
    }
};

TEST_F(BadInput, AMissingConfiguration) {
    expect_refused({"missing.json"}, {"missing.json", "No such file"});
}

TEST_F(BadInput, ACommandLineIsToldInWordsOfItsOwn) {
    struct Case {
        std::vector<std::string> arguments;
        std::vector<std::string> words;
    };
    const std::string smoke = tiny();
    const std::vector<Case> cases{
        {{"list", "axis"},
         {"there is no `reliefbench list` of 'axis' (did you mean 'axes'?)", "`reliefbench list --help`"}},
        {{"list", "technique"}, {"(did you mean 'techniques'?); there are techniques, devices"}},
        {{"list"}, {"`reliefbench list` of what? There are techniques, devices"}},
        {{}, {"a command is missing; the commands are list, run"}},
        {{"rum"}, {"there is no command 'rum' (did you mean 'run'?)", "see `reliefbench --help`"}},
        {{"run", smoke, "--fliter", "technique=pom"},
         {"`reliefbench run` has no option '--fliter' (did you mean '--filter'?); see `reliefbench run --help`"}},
        {{"run", "--dryrun"}, {"has no option '--dryrun' (did you mean '--dry-run'?)"}},
        {{"run", smoke, "--fromat=csv"}, {"has no option '--fromat' (did you mean '--format'?)"}},
        {{"run", smoke, "again"}, {"`reliefbench run` takes no argument 'again'; see `reliefbench run --help`"}},
        {{"--fliter", "x", "run"}, {"`reliefbench` has no option '--fliter'"}},
        {{"run", smoke, "--preparation-limit", "-1"},
         {"--preparation-limit: expected a number of at least 0, found '-1'"}},
        {{"run", smoke, "--resume=foo"}, {"--resume: expected force or nothing, found 'foo'"}},
        {{"run"}, {"configuration is required; see `reliefbench run --help`"}},
        {{"advise", "run", "--flip", "x"}, {"--flip: expected a number, found 'x'; see `reliefbench advise --help`"}},
        {{"selfcheck", smoke, "--processes", "3.5"}, {"--processes: expected a whole number, found '3.5'"}},
        {{"run", "smok.json"},
         {"cannot read smok.json: No such file or directory (did you mean '", "configs/smoke.json'?)"}},
        {{"run", "quick.json"}, {"(did you mean '", "configs/quick.json'?)"}},
        {{"run", "nothing_like_it.json"}, {"those that come with reliefbench are ", "configs/smoke.json"}},
        {{"render", "--technique", "pom", "--set", "view_angle=60", "-o", path("a.png")},
         {"--set view_angle=60: view_angle is an axis of the view, not a parameter; use -a view_angle=60"}},
        {{"render", "--technique", "pom", "--set", "preset=godot_4", "-o", path("a.png")},
         {"--set preset=godot_4: a preset is not a parameter", "use -a preset=godot_4"}},
        {{"render", "--technique", "pom", "-a", "preset=unity_hdrp", "-o", path("a.png")},
         {"'unity_hdrp' is a preset of the technique secant, not of pom"}},
        {{"render", "--technique", "pom", "--animate", "azimut=[0:10:5]", "-o", path("a.png")},
         {"reliefbench: --animate azimut=[0:10:5]: ", "(did you mean 'azimuth'?)"}},
        {{"render", "--technique", "pom", "--lighting", "[]", "-o", path("a.png")}, {"--lighting: expected an object"}},
        {{"render", "--technique", "pom", "--lighting", R"({"shininess": "x"})", "-o", path("a.png")},
         {"--lighting: shininess: expected a number"}},
        {{"ab", smoke, "--baseline", ""}, {"the baseline is empty; name a commit, branch or tag, or a folder"}},
        {{"advise", path("none"), "--flip", "1"}, {path("none") + " holds no run: there is no such folder"}},
    };
    for (const auto& [arguments, words] : cases) {
        const Outcome refused = reliefbench(arguments);
        EXPECT_EQ(refused.code, 2);
        for (const std::string& word : words)
            EXPECT_THAT(refused.err, HasSubstr(word));
    }
}

TEST_F(BadInput, SettingsOfSamplingAreNamedAsTheyAreGiven) {
    expect_refused({tiny(), "--sampling", "rule=fixd"}, {"--sampling rule=fixd: rule: expected one of", "'fixed'"});
    expect_refused({tiny(), "--sampling", "ruel=fixed"}, {"--sampling ruel=fixed: unknown key \"ruel\""});
}

TEST_F(BadInput, AShortNameOfAFigureGetsThoseThatItMayMean) {
    ASSERT_EQ(reliefbench({"run", tiny(), "-o", path("run")}).code, 0);
    const std::string run = path("run");
    std::filesystem::copy(run, path("copy"), std::filesystem::copy_options::recursive);
    EXPECT_THAT(reliefbench({"advise", run, "--limit", "flip=0.02"}).err,
                HasSubstr("--limit: there is no figure 'flip' (did you mean image.footprint.flip, image.flip?)"));
    EXPECT_THAT(reliefbench({"advise", run, "--flip", "1", "--rank-by", "uv p99"}).err,
                HasSubstr("--rank-by: there is no figure 'uv p99' (did you mean error.uv_texels.p99?)"));
    EXPECT_THAT(reliefbench({"advise", run, "--flip", "1", "--rank-by", "shadow"}).err,
                HasSubstr("--rank-by: there is no figure 'shadow' (did you mean error.shadow.mean?)"));
    EXPECT_THAT(reliefbench({"advise", run, "--flip", "1", "--rank-by", "uv"}).err, HasSubstr("error.uv_texels.p99"));
    EXPECT_THAT(
        reliefbench({"compare", "--quality", "--quality-figures", "flip", run, path("copy")}).err,
        HasSubstr("--quality-figures: there is no figure 'flip' (did you mean image.footprint.flip, image.flip?)"));
    const Outcome file = reliefbench({"advise", run + "/run.json", "--flip", "1"});
    EXPECT_EQ(file.code, 2);
    EXPECT_THAT(file.err, HasSubstr("run.json is a file; a run is named by its folder, " + run));
    EXPECT_THAT(reliefbench({"run", run, "--dry-run"}).err,
                HasSubstr("it is a folder; name a configuration, or " + run));
}

TEST_F(BadInput, HelpShowsOptionsAsTheyAreTyped) {
    const Outcome help = reliefbench({"run", "--help"});
    EXPECT_THAT(help.out, HasSubstr("--resume[=force] "));
    EXPECT_THAT(help.out, HasSubstr("--preparation-limit SECONDS "));
    EXPECT_THAT(help.out, testing::Not(testing::HasSubstr("{")));
}

TEST_F(BadInput, AFolderOrAMissingFileForAHeightMap) {
    std::filesystem::create_directory(path("folder"));
    const std::string map = path("folder");
    expect_refused({tiny(), "-a", "heightmap=" + map}, {"'" + map + "' is a folder; name a file in it"});
    expect_refused({tiny(), "-a", "albedo=" + map}, {"'" + map + "' is a folder; name a file in it"});
    expect_refused({tiny(), "-a", "heightmap=/nosuch/x.png"}, {"heightmap: there is no file '/nosuch/x.png'\n"});
    expect_refused({write("empty.json", "")}, {"empty.json: it is empty; expected JSON"});
}

TEST_F(BadInput, AFolderForAConfiguration) {
    expect_refused({path("")}, {path("")});
}

TEST_F(BadInput, AConfigurationThatIsNoJson) {
    expect_refused({write("broken.json", "{ \"name\": ")}, {"broken.json"});
}

TEST_F(BadInput, AnUnknownKey) {
    expect_refused({tiny([](Json& json) { json["sampeling"] = 1; })},
                   {"tiny.json", "sampeling", "did you mean 'sampling'?"});
}

TEST_F(BadInput, AnUnknownTechnique) {
    expect_refused({tiny([](Json& json) { json["techniques"] = {"steeep"}; })}, {"steeep", "did you mean 'steep'?"});
}

TEST_F(BadInput, AnUnknownAxis) {
    expect_refused({tiny([](Json& json) { json["axes"]["view_angel"] = 3; })},
                   {"view_angel", "did you mean 'view_angle'?"});
}

TEST_F(BadInput, AnUnknownAxisOnTheCommandLine) {
    expect_refused({tiny(), "-a", "view_angel=3"}, {"view_angel", "did you mean 'view_angle'?"});
}

TEST_F(BadInput, AnUnknownParameter) {
    expect_refused({tiny([](Json& json) {
                       json["techniques"] = Json::parse(R"([{"technique": "steep", "parameters": {"colour": 3}}])");
                   })},
                   {"colour", "steep"});
}

TEST_F(BadInput, AParameterOutOfItsRange) {
    const Json manifest =
        Json::parse(read_file(std::filesystem::path(RELIEFBENCH_SOURCE_DIR) / "techniques/steep/technique.json"));
    const std::string name = manifest.at("sample_count").get<std::string>();
    expect_refused({tiny([&](Json& json) {
                       Json selection{{"technique", "steep"}};
                       selection["parameters"][name] = -3;
                       json["techniques"] = Json::array({selection});
                   })},
                   {name, "-3"});
}

TEST_F(BadInput, ASampleCountThatNoTechniqueTakes) {
    expect_refused({tiny(), "-a", "sample_count=-7"}, {"sample_count", "-7"});
}

TEST_F(BadInput, AnAngleOutOfRange) {
    expect_refused({tiny(), "-a", "view_angle=90"}, {"view_angle", "90"});
}

TEST_F(BadInput, AResolutionOfZero) {
    expect_refused({tiny(), "-a", "resolution=0"}, {"resolution", "0"});
}

TEST_F(BadInput, AnAbsurdResolution) {
    expect_refused({tiny(), "-a", "resolution=1000000x1000000"}, {"resolution", "1000000"});
}

TEST_F(BadInput, AnAbsurdHeightMapSize) {
    expect_refused({tiny(), "-a", "heightmap_size=0"}, {"heightmap_size", "0"});
}

TEST_F(BadInput, AFilterThatNoCellPasses) {
    expect_refused({tiny(), "--filter", "view_angle=30"}, {"view_angle=30"});
}

TEST_F(BadInput, AMissingHeightMap) {
    expect_refused_by_both({tiny(), "-a", "heightmap=" + path("missing.png")}, {"missing.png"});
}

TEST_F(BadInput, AnUnknownHeightMap) {
    expect_refused_by_both({tiny(), "-a", "heightmap=brick"}, {"brick"});
}

TEST_F(BadInput, AFileThatIsNoImage) {
    expect_refused_by_both({tiny(), "-a", "heightmap=" + write("text.png", "these are words")}, {"text.png"});
}

TEST_F(BadInput, AnImageWithoutTheChannel) {
    const std::string image = write_image("one_channel.exr", 0, 1);
    expect_refused_by_both({tiny([&](Json& json) {
                               json["axes"]["heightmap"] = {{"file", image}, {"channel", 3}};
                           })},
                           {"one_channel.exr", "channel"});
}

TEST_F(BadInput, HeightsThatAreNoNumbers) {
    const std::string image = write_image("nan.exr", 0.5F, std::numeric_limits<float>::quiet_NaN());
    expect_refused_by_both({tiny(), "-a", "heightmap=" + image}, {"nan.exr"});
}

TEST_F(BadInput, InfiniteHeights) {
    const std::string image = write_image("infinite.exr", 0.5F, std::numeric_limits<float>::infinity());
    expect_refused_by_both({tiny(), "-a", "heightmap=" + image}, {"infinite.exr"});
}

TEST_F(BadInput, HeightsThatNothingMapsIntoRange) {
    const std::string image = write_image("metres.exr", 0.5F, 20);
    expect_refused_by_both({tiny(), "-a", "heightmap=" + image}, {"metres.exr", "normalize"});
}

TEST_F(BadInput, AnAlbedoThatIsNoImage) {
    const std::string words = write("words.png", "these are words");
    const auto with_albedo = [&](Json value) {
        return tiny([&](Json& json) {
            value["albedo"] = words;
            json["axes"]["heightmap"] = value;
        });
    };
    expect_refused_by_both({with_albedo({{"name", "rock"}})}, {"words.png"});
    expect_refused_by_both({with_albedo({{"file", write_image("heights.exr", 0, 1)}})}, {"words.png"});
}

TEST_F(BadInput, AFileWithoutAHeaderOfAnotherSize) {
    const std::string file = write("map.r16", "12345678");
    expect_refused_by_both({tiny([&](Json& json) {
                               json["axes"]["heightmap"] = {{"file", file}, {"size", "3x2"}};
                           })},
                           {"map.r16", "it has 8 bytes", "3x2", "take 12"});
    expect_refused_by_both({tiny(), "-a", "heightmap=" + file}, {"map.r16", "size"});
}

TEST_F(BadInput, AnUnknownDevice) {
    expect_refused({tiny(), "--device", "no such thing"}, {"no such thing"});
    expect_refused({tiny(), "--device", "99"}, {"99"});
}

TEST_F(BadInput, AMissingTechniqueDirectory) {
    expect_refused({tiny(), "--techniques", path("missing")}, {path("missing")});
}

TEST_F(BadInput, ABrokenManifestThatTheConfigurationNames) {
    std::ofstream(copy_technique("steep", "mine") / "technique.json") << R"({ "titel": "Mine" })";
    expect_refused({tiny([](Json& json) { json["techniques"] = {"mine"}; }), "--techniques", path("techniques")},
                   {"mine", "technique.json", "titel"});
}

TEST_F(BadInput, ABrokenManifestThatNothingNamesIsAWarning) {
    std::ofstream(copy_technique("steep", "mine") / "technique.json") << "no json";
    const Outcome outcome = reliefbench({"run", tiny(), "--techniques", path("techniques"), "-o", path("run")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("warning"), HasSubstr("mine")));
}

TEST_F(BadInput, ABrokenShaderFailsItsCellsAndNoOthers) {
    std::ofstream(copy_technique("steep", "mine") / "trace.glsl", std::ios::app) << "\nthis is no GLSL;\n";
    const std::string configuration = tiny([](Json& json) { json["techniques"] = {"mine", "steep"}; });
    const Outcome outcome = reliefbench({"run", configuration, "--techniques", path("techniques"), "-o", path("run")});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("mine"), HasSubstr("trace.glsl")));
    const std::vector<Json> cells = read_lines(path("run/cells.jsonl"));
    ASSERT_EQ(cells.size(), 2U);
    for (const Json& cell : cells) {
        const bool is_broken = cell.at("technique") == "mine";
        EXPECT_EQ(cell.at("status"), is_broken ? "failed" : "ok");
        if (is_broken) {
            const auto reason = cell.at("reason").get<std::string>();
            EXPECT_THAT(reason, AllOf(HasSubstr("trace.glsl"), HasSubstr("mine")));
        }
    }
}

TEST_F(BadInput, AnOutputFolderThatCannotBeMade) {
    // A file where a folder is wanted stops even root, whom permissions do not.
    const std::string file = write("file", "");
    const Outcome outcome = reliefbench({"run", tiny(), "-o", file + "/run"});
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("reliefbench: "), HasSubstr(file)));
    EXPECT_TRUE(outcome.out.empty());
}

TEST_F(BadInput, AnOutputFolderThatHoldsARun) {
    ASSERT_EQ(reliefbench({"run", tiny(), "-o", path("run")}).code, 0);
    const std::string cells = read_file(path("run/cells.jsonl"));
    const Outcome again = reliefbench({"run", tiny(), "-o", path("run")});
    EXPECT_EQ(again.code, 2) << again.err;
    EXPECT_THAT(again.err, AllOf(HasSubstr("reliefbench: "), HasSubstr(path("run"))));
    EXPECT_EQ(read_file(path("run/cells.jsonl")), cells) << "the earlier run was touched";
    const Outcome planned = reliefbench({"run", tiny(), "-o", path("run"), "--dry-run"});
    EXPECT_EQ(planned.code, 2);
    EXPECT_EQ(planned.err, again.err);
}

TEST_F(BadInput, AConstantHeightMapIsAWarning) {
    const std::string image = write_image("constant.exr", 0.5F, 0.5F);
    const Outcome outcome = reliefbench({"run", tiny(), "-a", "heightmap=" + image, "-o", path("run")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("warning"), HasSubstr("constant.exr"), HasSubstr("constant")));
}

TEST_F(BadInput, UsageErrorsSayWhereToLook) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{}, {"rum"}, {"run"}, {"render"}, {"run", tiny(), "--no-such-option"}}) {
        const Outcome outcome = reliefbench(arguments);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments);
        EXPECT_THAT(outcome.err, HasSubstr("--help"));
        EXPECT_TRUE(outcome.out.empty()) << outcome.out;
    }
}

TEST_F(BadInput, AnUnknownCommandIsNamedWithThoseThereAre) {
    const std::string commands = "the commands are list, run, render, verify";
    const Outcome far = reliefbench({"frobnicate", "-o", "x"});
    EXPECT_EQ(far.code, 2);
    EXPECT_THAT(far.err, AllOf(HasSubstr("there is no command 'frobnicate'; " + commands), HasSubstr("--help")));
    EXPECT_TRUE(far.out.empty()) << far.out;
    const Outcome near = reliefbench({"rum", "x.json"});
    EXPECT_EQ(near.code, 2);
    EXPECT_THAT(near.err, HasSubstr("there is no command 'rum' (did you mean 'run'?); " + commands));
    EXPECT_THAT(reliefbench({}).err, testing::Not(HasSubstr("there is no command")));
}

TEST_F(BadInput, MeshFilesAreReadBeforeAnythingIsWritten) {
    const auto on = [&](const std::string& file) { return tiny([&](Json& json) { json["axes"]["base"] = file; }); };
    expect_refused_by_both({on("none.glb")}, {"tiny.json: $.axes.base: no file 'none.glb' in"});
    expect_refused_by_both({on("cone")}, {"tiny.json: $.axes.base: no base 'cone'", ".obj, .gltf, .glb"});
    write("cut.glb", std::string("glTF\2\0\0\0", 8));
    expect_refused_by_both({on("cut.glb")}, {"mesh '" + path("cut.glb") + "' is cut short"});
    write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_refused_by_both({on("bare.obj")}, {"bare.obj' has no texture coordinates", "unwrap and export it again"});
    expect_refused_by_both({tiny(), "-a", "base=cylinder", "-a", "curvature=7"},
                           {"-a curvature=7: curvature: a cylinder of curvature 7 would overlap itself"});

    // What can be drawn is, with warnings.
    write("poor.obj",
          "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n"
          "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 2/2/1 2/3/1\n");
    const Outcome planned = reliefbench({"run", on("poor.obj"), "--dry-run"});
    EXPECT_EQ(planned.code, 0) << planned.err;
    EXPECT_THAT(planned.out, HasSubstr(" base=poor.obj"));
    EXPECT_EQ(planned.err, "warning: mesh '" + path("poor.obj") + "': 1 triangle of no area, left out\n");
}

TEST_F(CommandLine, BasesAreListedWithTheirLimits) {
    const Outcome table = reliefbench({"list", "bases"});
    EXPECT_EQ(table.code, 0);
    EXPECT_THAT(table.out, AllOf(HasSubstr("plane "), HasSubstr("curvature from -6.2832 to 6.2832"),
                                 HasSubstr("|curvature|*height_scale below 1"), HasSubstr("(.obj, .gltf, .glb)")));
    std::vector<std::string> names;
    for (const Json& base : Json::parse(reliefbench({"list", "bases", "--format", "json"}).out))
        names.push_back(base.at("base"));
    EXPECT_THAT(names, testing::ElementsAre("plane", "cylinder", "sphere", "saddle", "FILE"));
}

}  // namespace
}  // namespace reliefbench
