#include "configuration_text.hpp"
#include "core/file.hpp"
#include "manifest/reserved_names.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string with_base(const std::string& axes) {
    return R"({"techniques": ["plain"], "axes": {"heightmap": "rock", )" + axes + "}}";
}

/// Of contract 1, with a parameter that has the name of a later axis.
Manifest technique_with_parameter(const std::string& name) {
    const std::string text = R"({"title": "Old", "kind": "march", "citation": "Nobody", "shape": "quad",
        "promises": [], "parameters": [{"name": ")" +
                             name + R"(", "type": "real", "default": 0, "range": [-1, 1], "help": "Bend."}]})";
    return parse_manifest(parse_json(text, "old"), "old", "old");
}

TEST(BaseAxes, TechniquesOfTheFirstContractMayHaveTheirNamesAsParameters) {
    for (const char* name : {"base", "curvature", "base_segments", "base_fit"}) {
        EXPECT_EQ(check_glsl_name(name, 1), "") << name;
        EXPECT_THAT(check_glsl_name(name, 2), HasSubstr("is an axis of a configuration")) << name;
        EXPECT_NE(technique_with_parameter(name).find_parameter(name), nullptr) << name;
    }
    const std::vector<Manifest> old{technique_with_parameter("curvature")};
    const auto cells = [&](const std::string& text) {
        std::vector<std::string> found;
        for (const Cell& cell : expand(parse_configuration(parse_json(text, "test.json"), "test.json", {}, old), old))
            found.push_back(cell.id);
        return found;
    };
    EXPECT_THAT(cells(R"({"techniques": [{"technique": "old", "parameters": {"curvature": 0.5}}],
                          "axes": {"heightmap": "rock"}})"),
                ElementsAre("old curvature=0.5 | heightmap=rock"));
    EXPECT_THAT(
        error_message([&] { cells(R"({"techniques": ["old"], "axes": {"heightmap": "rock", "curvature": 0.5}})"); }),
        AllOf(HasSubstr("$.axes.curvature: 'curvature' is an axis of the view, and the technique old has a "
                        "parameter of that name"),
              HasSubstr(R"({"technique": "old", "parameters": {"curvature": ...}})")));
}

TEST(BaseAxes, WhatABaseHasNoUseForMakesNoCells) {
    const std::string cell = "plain | heightmap=rock";
    EXPECT_THAT(
        ids(parse(with_base(R"("base": ["plane", "cylinder"], "curvature": [0.5, 1], "base_segments": [64, 128],
                                       "base_fit": ["unit", "none"])"))),
        ElementsAre(cell, cell + " base=cylinder curvature=0.5 base_segments=64", cell + " base=cylinder curvature=0.5",
                    cell + " base=cylinder base_segments=64", cell + " base=cylinder"));
}

TEST(BaseAxes, FilesAreFoundBesideTheConfigurationAndCalledByTheirBaseNames) {
    const TemporaryFolder folder;
    for (const char* name : {"mesh.glb", "other/mesh.glb", "other/Large.OBJ"}) {
        std::filesystem::create_directories((folder / name).parent_path());
        write_text_file(folder / name, "not read here");
    }
    const auto parse_here = [&](const std::string& axes) {
        return parse_configuration(parse_json(with_base(axes), "test.json"), (folder / "test.json").string(), {},
                                   fake_techniques());
    };
    const std::string cell = "plain | heightmap=rock";
    const Configuration configuration = parse_here(
        R"("base": ["mesh.glb", {"file": "other/Large.OBJ"}, "sphere"], "curvature": 2, "base_fit": ["unit", "none"])");
    EXPECT_THAT(ids(configuration),
                ElementsAre(cell + " base=mesh.glb", cell + " base=mesh.glb base_fit=none", cell + " base=Large.OBJ",
                            cell + " base=Large.OBJ base_fit=none", cell + " base=sphere curvature=2"));
    const std::string absolute = (folder / "mesh.glb").string();
    EXPECT_EQ(configuration.expanded["axes"]["base"][0], absolute);
    EXPECT_EQ(configuration.expanded["axes"]["base"][1]["file"], (folder / "other/Large.OBJ").string());
    const std::vector<Cell> cells = expand(configuration, fake_techniques());
    EXPECT_EQ(cells[1].view.base,
              (BaseSource{.kind = BaseSource::Kind::file, .file = absolute, .fit = BaseSource::Fit::none}));
    EXPECT_EQ(axes_to_json(cells[1].view)["base"], "mesh.glb");
    EXPECT_EQ(axes_to_json(cells[1].view)["base_fit"], "none");
    EXPECT_TRUE(axes_to_json(cells[1].view)["curvature"].is_null());
    // On the command line, from where the user is.
    EXPECT_THAT(ids(parse(with_base(R"("tiling": 1)"), {"base=" + absolute})), ElementsAre(cell + " base=mesh.glb"));

    EXPECT_THAT(error_message([&] { parse_here(R"("base": "none.glb")"); }),
                AllOf(HasSubstr("$.axes.base: no file 'none.glb' in " + folder.path().string())));
    EXPECT_THAT(error_message([&] { ids(parse_here(R"("base": ["mesh.glb", "other/mesh.glb"])")); }),
                AllOf(HasSubstr("$.axes.base: '" + absolute), HasSubstr("tell files by base name; rename one")));
    EXPECT_THAT(message_of(with_base(R"("base": "cyllinder")")),
                AllOf(HasSubstr("$.axes.base: no base 'cyllinder' (did you mean 'cylinder'?)"),
                      HasSubstr("an OBJ or glTF 2.0 file (.obj, .gltf, .glb)")));
    EXPECT_THAT(message_of(with_base(R"("base": {"file": "mesh.fbx"})")),
                HasSubstr("$.axes.base.file: expected an OBJ or glTF 2.0 file"));
    EXPECT_THAT(message_of(with_base(R"("base": {"mesh": "a.glb"})")), HasSubstr("$.axes.base"));
    EXPECT_THAT(message_of(with_base(R"("base": 3)")), HasSubstr("$.axes.base: expected one of plane, cylinder"));
}

TEST(BaseAxes, ACurvatureThatNoBaseCanHaveIsAnErrorAndOneThatSomeCannotEndsTheirCells) {
    EXPECT_THAT(message_of(with_base(R"("base": "cylinder", "curvature": [1, 6.5])")),
                HasSubstr("$.axes.curvature[1]: a cylinder of curvature 6.5 would overlap itself; from -6.2832 to"));
    EXPECT_THAT(message_of(with_base(R"("base": ["plane", "sphere"], "curvature": -5)")),
                HasSubstr("$.axes.curvature: a sphere of curvature -5 would overlap itself"));
    const auto reasons = [](const std::string& axes) {
        std::vector<std::string> found;
        for (const Cell& cell : expand(parse(with_base(axes)), fake_techniques()))
            found.push_back(cell.skip_reason);
        return found;
    };
    EXPECT_THAT(reasons(R"("base": ["plane", "cylinder", "saddle"], "curvature": 6.5)"),
                ElementsAre("", HasSubstr("a cylinder of curvature 6.5 would overlap itself"), ""));
    // Where the relief would fold, of two axes that are right by themselves.
    EXPECT_THAT(reasons(R"("base": "sphere", "curvature": [-4, 2, 4], "height_scale": [0.1, 0.25])"),
                ElementsAre("", "", "", "", "",
                            "a relief of height scale 0.25 folds on a sphere of curvature 4: their product has to stay "
                            "below 1; lower either"));
    EXPECT_THAT(reasons(R"("base": "saddle", "curvature": -4, "height_scale": 0.25)"),
                ElementsAre(HasSubstr("folds on a saddle")));
    EXPECT_THAT(reasons(R"("curvature": 900, "height_scale": 10)"), ElementsAre(IsEmpty()));
}

}  // namespace
}  // namespace reliefbench
