#include "core/error.hpp"
#include "fake_techniques.hpp"
#include "manifest/reserved_names.hpp"
#include "support/error_message.hpp"
#include "sweep/configuration.hpp"
#include "sweep/view_axes.hpp"

#include <gmock/gmock.h>

#include <set>

namespace reliefbench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<Cell> expand_text(const std::string& text, const std::vector<std::string>& overrides = {}) {
    const std::vector<Manifest> techniques = fake_techniques();
    return expand(parse_configuration(parse_json(text, "test.json"), "test.json", overrides, techniques), techniques);
}

std::vector<std::string> ids(const std::vector<Cell>& cells) {
    std::vector<std::string> found;
    for (const Cell& cell : cells)
        found.push_back(cell.id);
    return found;
}

TEST(Expansion, EqualsALiteralTable) {
    const std::vector<Cell> cells = expand_text(R"({
        "techniques": ["plain", "march", {"technique": "tree", "parameters": {"leaf": ["linear", "exact"]}}],
        "axes": {"heightmap": ["bricks", "rock"], "view_angle": [0, 60], "projection": ["perspective", "parallel"],
                 "sample_count": [8, 64]},
        "zip": [["view_angle", "projection"]]})");
    struct Row {
        const char* id;
        const char* skip_reason;
    };
    const Row table[] = {
        {"plain | heightmap=bricks", ""},
        {"march max_steps=8 min_steps=2 | heightmap=bricks", ""},
        {"march max_steps=64 min_steps=16 | heightmap=bricks", ""},
        {"tree max_steps=8 leaf=linear | heightmap=bricks", "max_steps cannot be 8: it is an integer from 16 to 4096"},
        {"tree max_steps=8 | heightmap=bricks", "max_steps cannot be 8: it is an integer from 16 to 4096"},
        {"tree leaf=linear | heightmap=bricks", ""},
        {"tree | heightmap=bricks", ""},
        {"plain | heightmap=bricks view_angle=60 projection=parallel", ""},
        {"march max_steps=8 min_steps=2 | heightmap=bricks view_angle=60 projection=parallel", ""},
        {"march max_steps=64 min_steps=16 | heightmap=bricks view_angle=60 projection=parallel", ""},
        {"tree max_steps=8 leaf=linear | heightmap=bricks view_angle=60 projection=parallel",
         "max_steps cannot be 8: it is an integer from 16 to 4096"},
        {"tree max_steps=8 | heightmap=bricks view_angle=60 projection=parallel",
         "max_steps cannot be 8: it is an integer from 16 to 4096"},
        {"tree leaf=linear | heightmap=bricks view_angle=60 projection=parallel", ""},
        {"tree | heightmap=bricks view_angle=60 projection=parallel", ""},
        {"plain | heightmap=rock", ""},
        {"march max_steps=8 min_steps=2 | heightmap=rock", ""},
        {"march max_steps=64 min_steps=16 | heightmap=rock", ""},
        {"tree max_steps=8 leaf=linear | heightmap=rock", "max_steps cannot be 8: it is an integer from 16 to 4096"},
        {"tree max_steps=8 | heightmap=rock", "max_steps cannot be 8: it is an integer from 16 to 4096"},
        {"tree leaf=linear | heightmap=rock", ""},
        {"tree | heightmap=rock", ""},
        {"plain | heightmap=rock view_angle=60 projection=parallel", ""},
        {"march max_steps=8 min_steps=2 | heightmap=rock view_angle=60 projection=parallel", ""},
        {"march max_steps=64 min_steps=16 | heightmap=rock view_angle=60 projection=parallel", ""},
        {"tree max_steps=8 leaf=linear | heightmap=rock view_angle=60 projection=parallel",
         "max_steps cannot be 8: it is an integer from 16 to 4096"},
        {"tree max_steps=8 | heightmap=rock view_angle=60 projection=parallel",
         "max_steps cannot be 8: it is an integer from 16 to 4096"},
        {"tree leaf=linear | heightmap=rock view_angle=60 projection=parallel", ""},
        {"tree | heightmap=rock view_angle=60 projection=parallel", ""},
    };
    ASSERT_THAT(cells, SizeIs(std::size(table)));
    for (std::size_t index = 0; index < cells.size(); ++index) {
        EXPECT_EQ(cells[index].id, table[index].id) << index;
        EXPECT_EQ(cells[index].skip_reason, table[index].skip_reason) << index;
    }
    EXPECT_EQ(cells[7].view.height_map.name, "bricks");
    EXPECT_EQ(cells[7].view.view.camera.view_angle, 60);
    EXPECT_EQ(cells[7].view.view.camera.projection, Projection::parallel);
    EXPECT_EQ(cells[1].parameters.at("max_steps"), ParameterValue(std::int64_t{8}));
    EXPECT_EQ(cells[1].parameters.at("adaptive"), ParameterValue(false));
    EXPECT_EQ(cells[3].technique, "tree");
}

TEST(Expansion, IdsNameEveryAxisThatIsNotAtItsDefault) {
    const std::vector<Cell> cells = expand_text(R"({
        "techniques": [{"technique": "mesh", "parameters": {"factor": 16, "bias": 0.25}}],
        "axes": {"heightmap": "rock", "heightmap_size": "512x128", "height_format": "r32f", "view_angle": 12.5,
                 "azimuth": 22.5, "projection": "perspective", "distance": 2, "fov": 60, "base": "saddle",
                 "curvature": -0.5, "base_segments": 64, "height_scale": 0.1, "tiling": 4, "boundary": "repeat",
                 "resolution": "640x480"}})");
    EXPECT_THAT(ids(cells),
                ElementsAre("mesh factor=16 bias=0.25 | heightmap=rock heightmap_size=512x128 height_format=r32f "
                            "view_angle=12.5 azimuth=22.5 distance=2 fov=60 base=saddle curvature=-0.5 "
                            "base_segments=64 height_scale=0.1 tiling=4 boundary=repeat resolution=640x480"));
    EXPECT_EQ(
        axes_to_json(cells[0].view).dump(),
        R"({"heightmap":"rock","heightmap_size":"512x128","height_format":"r32f","view_angle":12.5,)"
        R"("azimuth":22.5,"projection":"perspective","distance":2.0,"fov":60.0,"base":"saddle",)"
        R"("curvature":-0.5,"base_segments":64,"base_fit":null,"height_scale":0.1,"tiling":4.0,"boundary":"repeat","polygon_height":1.0,)"
        R"("resolution":"640x480","self_shadow":"off","soft_shadow":null,)"
        R"("hard_shadow_bias":null,"dykhta_bias":null,"shadow_min_steps":null,"shadow_max_steps":null,)"
        R"("shadow_softening":null,"depth_write":"on","material_filter":"lod0","anisotropy":null,)"
        R"("mip_bias":null,"material_gradients":null,"samples_per_pixel":1,"frames":1})");
    EXPECT_EQ(parameters_to_json(cells[0].parameters).dump(), R"({"bias":0.25,"factor":16})");
    EXPECT_EQ(cell_id(fake_techniques()[3], cells[0].parameters, cells[0].view), cells[0].id);
}

TEST(Expansion, DefaultsThatAreSpelledOutMakeTheSameIds) {
    EXPECT_THAT(ids(expand_text(R"({"techniques": ["march"], "axes": {"heightmap": {"name": "rock", "seed": 1},
        "heightmap_size": 256, "height_format": "r16", "view_angle": 0, "azimuth": -90.0, "projection": "perspective",
        "distance": 1.5, "fov": 45, "height_scale": 0.05, "tiling": 1, "boundary": "clip", "resolution": "256x256",
        "max_steps": 32.0, "min_steps": 8, "adaptive": false}})")),
                ElementsAre("march | heightmap=rock"));
}

// What the filter has no use for makes no second view.
TEST(Expansion, SettingsOfMipsBelongToTheirFilter) {
    const auto ids_with = [](const char* filter) {
        std::string text = R"({"techniques": ["plain"], "axes": {"heightmap": "rock", "material_filter": "%s",
            "anisotropy": [2, 16], "mip_bias": [-1, 0], "material_gradients": ["before_search", "analytic"]}})";
        text.replace(text.find("%s"), 2, filter);
        return ids(expand_text(text));
    };
    const std::string plain = "plain | heightmap=rock";
    EXPECT_THAT(ids_with("lod0"), ElementsAre(plain));
    EXPECT_THAT(ids_with("mip"), ElementsAre(plain + " material_filter=mip mip_bias=-1",
                                             plain + " material_filter=mip mip_bias=-1 material_gradients=analytic",
                                             plain + " material_filter=mip",
                                             plain + " material_filter=mip material_gradients=analytic"));
    EXPECT_EQ(ids_with("anisotropic").size(), 8U);
    EXPECT_EQ(ids_with("anisotropic").front(), plain + " material_filter=anisotropic anisotropy=2 mip_bias=-1");
    EXPECT_EQ(ids_with("anisotropic").back(), plain + " material_filter=anisotropic material_gradients=analytic");
}

// What one way of shadowing has no use for makes no second view.
TEST(Expansion, SettingsOfShadowsBelongToTheirMethod) {
    const char* const swept = R"({"techniques": ["plain"], "axes": {"heightmap": "rock", "self_shadow": %s,
        "soft_shadow": %s, "hard_shadow_bias": [0.01, 0.02], "dykhta_bias": [0.05, 0.1], "shadow_min_steps": 15,
        "shadow_max_steps": [30, 60], "shadow_softening": [0.58, 1]}})";
    const auto ids_with = [&](const std::string& mode, const std::string& method) {
        std::string text = swept;
        text.replace(text.find("%s"), 2, mode);
        text.replace(text.find("%s"), 2, method);
        return ids(expand_text(text));
    };
    const std::string plain = "plain | heightmap=rock";
    EXPECT_THAT(ids_with(R"("off")", R"(["dykhta", "tatarchuk"])"), ElementsAre(plain));
    EXPECT_THAT(ids_with(R"("hard")", R"(["dykhta", "tatarchuk"])"),
                ElementsAre(plain + " self_shadow=hard", plain + " self_shadow=hard shadow_max_steps=60",
                            plain + " self_shadow=hard hard_shadow_bias=0.02",
                            plain + " self_shadow=hard hard_shadow_bias=0.02 shadow_max_steps=60"));
    EXPECT_THAT(ids_with(R"("soft")", R"("dykhta")"),
                ElementsAre(plain + " self_shadow=soft", plain + " self_shadow=soft shadow_max_steps=60",
                            plain + " self_shadow=soft dykhta_bias=0.1",
                            plain + " self_shadow=soft dykhta_bias=0.1 shadow_max_steps=60"));
    EXPECT_THAT(ids_with(R"("soft")", R"("tatarchuk")"),
                ElementsAre(plain + " self_shadow=soft soft_shadow=tatarchuk",
                            plain + " self_shadow=soft soft_shadow=tatarchuk shadow_softening=1"));
}

TEST(Expansion, EveryAxisOfAViewIsAReservedName) {
    for (const ViewAxis& axis : view_axes())
        EXPECT_NE(check_glsl_name(axis.name), "") << axis.name;
    EXPECT_NE(check_glsl_name("sample_count"), "");
    EXPECT_NE(check_glsl_name("technique"), "");
}

/// A technique with a parameter that only one of its searches has.
std::vector<Cell> expand_refined(const std::string& parameters, const std::string& axes) {
    std::vector<Manifest> techniques = fake_techniques();
    const Json manifest = parse_json(R"({"title": "Fake", "kind": "march", "citation": "Nobody", "shape": "quad",
        "promises": [], "parameters": [
            {"name": "search", "type": "choice", "choices": ["none", "binary"], "default": "none", "help": "Last."},
            {"name": "halvings", "type": "integer", "default": 6, "range": [0, 24], "help": "Halvings.",
             "only_with": {"search": "binary"}},
            {"name": "ray", "type": "choice", "choices": ["straight", "bent"], "default": "straight", "help": "Way.",
             "only_on": "curved_base"}]})",
                                     "refined");
    techniques.push_back(parse_manifest(manifest, "refined", "refined"));
    const Json json = parse_json(R"({"techniques": [{"technique": "refined", "parameters": )" + parameters +
                                     R"(}], "axes": {"heightmap": "rock")" + axes + "}}",
                                 "test.json");
    return expand(parse_configuration(json, "test.json", {}, techniques), techniques);
}

TEST(Expansion, IdleParametersMakeNoCellsOfTheirOwn) {
    EXPECT_THAT(ids(expand_refined(R"({"search": ["none", "binary"], "halvings": [3, 6]})", "")),
                ElementsAre("refined | heightmap=rock", "refined search=binary halvings=3 | heightmap=rock",
                            "refined search=binary | heightmap=rock"));
    const std::vector<Cell> cells = expand_refined("{}", R"(, "search": ["none", "binary"], "halvings": [3, 5])");
    EXPECT_THAT(ids(cells), ElementsAre("refined | heightmap=rock", "refined search=binary halvings=3 | heightmap=rock",
                                        "refined search=binary halvings=5 | heightmap=rock"));
    EXPECT_EQ(cells[0].parameters.at("halvings"), ParameterValue(std::int64_t{6}));
}

TEST(Expansion, AValueWithoutEffectInAnyCellIsAnError) {
    EXPECT_THAT(error_message([] { expand_refined(R"({"halvings": 3})", ""); }),
                HasSubstr("test.json: $.techniques[0]: 'halvings' has no effect in any cell: it needs search=binary"));
    EXPECT_THAT(error_message([] { expand_refined("{}", R"(, "halvings": [3, 4])"); }),
                HasSubstr("$.axes.halvings: 'halvings' has no effect in any cell: it needs search=binary"));
}

TEST(Expansion, WhatOnlyACurvedBaseHasIsIdleOnThePlane) {
    EXPECT_THAT(ids(expand_refined(R"({"ray": ["straight", "bent"]})", R"(, "base": ["plane", "sphere", "plane"])")),
                ElementsAre("refined | heightmap=rock", "refined | heightmap=rock base=sphere",
                            "refined ray=bent | heightmap=rock base=sphere"));
    EXPECT_THAT(error_message([] { expand_refined("{}", R"(, "ray": ["straight", "bent"])"); }),
                HasSubstr("$.axes.ray: 'ray' has no effect in any cell: it needs a base other than the plane"));
}

TEST(Expansion, MakesNoCellTwice) {
    EXPECT_THAT(ids(expand_text(R"({"techniques": ["plain", "plain", {"technique": "march",
        "parameters": {"max_steps": [16, 16]}}], "axes": {"heightmap": ["rock", "rock"], "view_angle": [0, 0.0]}})")),
                ElementsAre("plain | heightmap=rock", "march max_steps=16 | heightmap=rock"));
}

TEST(Expansion, CellsOfOneViewAreNeighboursWhereAZipMeetsItTwice) {
    EXPECT_THAT(
        ids(expand_text(R"({"techniques": ["plain", "mesh"], "axes": {"heightmap": "rock",
        "view_angle": [0, 60, 0], "factor": [4, 8, 16]}, "zip": [["view_angle", "factor"]]})")),
        ElementsAre("plain | heightmap=rock", "mesh factor=4 | heightmap=rock", "mesh factor=16 | heightmap=rock",
                    "plain | heightmap=rock view_angle=60", "mesh factor=8 | heightmap=rock view_angle=60"));
}

TEST(Expansion, AParameterAxisGoesToThoseThatHaveIt) {
    EXPECT_THAT(ids(expand_text(R"({"techniques": ["plain", "tree", "mesh"],
        "axes": {"heightmap": "rock", "leaf": ["linear", "exact"], "factor": [1, 2]}})")),
                ElementsAre("plain | heightmap=rock", "tree leaf=linear | heightmap=rock", "tree | heightmap=rock",
                            "mesh factor=1 | heightmap=rock", "mesh factor=2 | heightmap=rock"));
}

TEST(Expansion, TheMoreSpecificSettingOfAParameterWins) {
    // By name over an axis of its name over sample_count.
    EXPECT_THAT(ids(expand_text(R"({"techniques": ["tree", {"technique": "march", "parameters": {"max_steps": 7}}],
        "axes": {"heightmap": "rock", "sample_count": [16, 128], "max_steps": [20, 30]}})")),
                ElementsAre("tree max_steps=20 | heightmap=rock", "tree max_steps=30 | heightmap=rock",
                            "march max_steps=7 | heightmap=rock"));
    EXPECT_THAT(ids(expand_text(R"({"techniques": [{"technique": "march", "parameters": {"min_steps": 3}}],
        "axes": {"heightmap": "rock", "sample_count": [16]}})")),
                ElementsAre("march max_steps=16 min_steps=3 | heightmap=rock"));
}

TEST(Expansion, WhatAViewHasNoUseForMakesNoCopies) {
    EXPECT_THAT(ids(expand_text(R"({"techniques": ["plain"], "axes": {"heightmap": "rock", "projection": "parallel",
        "distance": [1, 2], "fov": [30, 60]}})")),
                ElementsAre("plain | heightmap=rock projection=parallel"));
    EXPECT_EQ(axes_to_json(expand_text(R"({"techniques": ["plain"], "axes": {"heightmap": "rock",
        "projection": "parallel"}})")[0]
                               .view)["distance"],
              Json());
}

TEST(Expansion, AnOwnSizeOfAHeightMapStays) {
    EXPECT_THAT(ids(expand_text(R"({"techniques": ["plain"], "axes": {"heightmap_size": [64, 128],
        "heightmap": ["rock", {"name": "bricks", "size": 512, "seed": 7}]}})")),
                ElementsAre("plain | heightmap=rock heightmap_size=64x64",
                            "plain | heightmap=bricks+seed=7 heightmap_size=512x512",
                            "plain | heightmap=rock heightmap_size=128x128"));
}

TEST(Expansion, ExclusionsDropCellsThatMeetAllConditions) {
    EXPECT_THAT(ids(expand_text(R"({"techniques": ["plain", "march", "tree"],
        "axes": {"heightmap": ["rock", "bricks"], "view_angle": [0, 80], "sample_count": [32, 64]},
        "exclude": [{"technique": ["march", "tree"], "view_angle": 80, "heightmap": "rock"},
                    {"heightmap": "bricks", "view_angle": 80.0}, {"sample_count": 64}, {"leaf": "exact"}]})")),
                ElementsAre("plain | heightmap=rock", "march | heightmap=rock", "plain | heightmap=rock view_angle=80",
                            "plain | heightmap=bricks", "march | heightmap=bricks"));
}

TEST(Expansion, ASweptRealMayBeWritten) {
    EXPECT_THAT(
        ids(expand_text(R"({"techniques": ["mesh"], "axes": {"heightmap": "rock", "bias": [0, 0.5, -1]}})")),
        ElementsAre("mesh | heightmap=rock", "mesh bias=0.5 | heightmap=rock", "mesh bias=-1 | heightmap=rock"));
}

TEST(Expansion, OfAHundredThousandCellsIsComplete) {
    // 250 views × 400 parameter sets.
    Json json = parse_json(R"({"techniques": ["mesh"], "axes": {"heightmap": ["rock", "bricks"]}})", "test");
    for (int index = 0; index < 125; ++index)
        json["axes"]["view_angle"].push_back(index * 0.5);
    for (int index = 1; index <= 40; ++index)
        json["axes"]["factor"].push_back(index);
    for (int index = 0; index < 10; ++index)
        json["axes"]["bias"].push_back(index * 0.1);
    const std::vector<Cell> cells = expand_text(json.dump());
    EXPECT_EQ(cells.size(), 100000U);
    std::set<std::string> distinct;
    for (const Cell& cell : cells)
        distinct.insert(cell.id);
    EXPECT_EQ(distinct.size(), cells.size());
}

TEST(Blocks, HoldWholeViewsUpToTheirSize) {
    // Views of 3, 3, 3 and 3 cells in blocks of 7: two views each.
    const std::vector<Cell> cells = expand_text(R"({"techniques": ["plain", {"technique": "mesh",
        "parameters": {"factor": [1, 2]}}], "axes": {"heightmap": "rock", "view_angle": [0, 20, 40, 60]}})");
    const std::vector<Block> blocks = make_blocks(cells, 7);
    ASSERT_THAT(blocks, SizeIs(2));
    EXPECT_THAT(blocks[0].cells, ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_THAT(blocks[1].cells, ElementsAre(6, 7, 8, 9, 10, 11));
}

TEST(Blocks, SplitAViewThatIsTooLargeAndStartItAfresh) {
    const std::vector<Cell> cells = expand_text(R"({"techniques": ["mesh"],
        "axes": {"heightmap": "rock", "view_angle": [0], "factor": [1, 2, 3, 4, 5]}})");
    const std::vector<Block> blocks = make_blocks(cells, 2);
    ASSERT_THAT(blocks, SizeIs(3));
    EXPECT_THAT(blocks[0].cells, ElementsAre(0, 1));
    EXPECT_THAT(blocks[2].cells, ElementsAre(4));
}

TEST(Blocks, LeaveSkippedCellsOut) {
    const std::vector<Cell> cells = expand_text(R"({"techniques": ["march", "tree"],
        "axes": {"heightmap": "rock", "sample_count": [8, 16]}})");
    ASSERT_THAT(cells, SizeIs(4));
    ASSERT_NE(cells[2].skip_reason, "");
    const std::vector<Block> blocks = make_blocks(cells);
    ASSERT_THAT(blocks, SizeIs(1));
    EXPECT_THAT(blocks[0].cells, ElementsAre(0, 1, 3));
    EXPECT_THAT(make_blocks({}), IsEmpty());
}

std::vector<std::string> filtered(const std::vector<std::string>& filters) {
    const std::string text = R"({"techniques": ["plain", "march", "tree"], "axes": {"heightmap": ["rock", "bricks"],
        "view_angle": [0, 60], "sample_count": [16, 64]}})";
    return ids(filter_cells(expand_text(text), filters, fake_techniques()));
}

std::string filter_message(const std::string& filter) {
    return error_message([&] { filtered({filter}); });
}

TEST(Filter, TakesValuesOfAxesThatOnlySomeViewsHave) {
    const std::vector<Cell> cells = expand_text(R"({"techniques": ["plain"], "axes": {"heightmap": "rock",
        "base": ["plane", "cylinder"], "curvature": [1, 2], "self_shadow": ["off", "soft"],
        "soft_shadow": ["dykhta", "tatarchuk"]}})");
    const auto left = [&](const std::string& filter) {
        return filter_cells(cells, {filter}, fake_techniques()).size();
    };
    ASSERT_THAT(cells, SizeIs(9)) << "a plane and two cylinders, with three ways of shadows";
    EXPECT_EQ(left("curvature=2"), 3U);
    EXPECT_EQ(left("curvature>=1"), 6U);
    EXPECT_EQ(left("soft_shadow=tatarchuk"), 3U);
}

TEST(Filter, KeepsCellsForWhichAllHold) {
    EXPECT_THAT(filtered({}), SizeIs(20));
    EXPECT_THAT(filtered({"technique=march,tree"}), SizeIs(16));
    EXPECT_THAT(filtered({"technique!=march"}), SizeIs(12));
    EXPECT_THAT(filtered({"max_steps>=16", "max_steps<64"}), SizeIs(8));
    EXPECT_THAT(filtered({"max_steps>16"}), SizeIs(8));
    EXPECT_THAT(filtered({"sample_count<=16"}), SizeIs(8));
    EXPECT_THAT(filtered({"leaf!=exact"}), SizeIs(12)) << "cells without a leaf have none that is exact";
    EXPECT_THAT(filtered({"technique=plain", "heightmap=rock", "view_angle=60"}),
                ElementsAre("plain | heightmap=rock view_angle=60"));
    EXPECT_THAT(filtered({"resolution=256", "view_angle<1"}), SizeIs(10));
    EXPECT_THAT(filtered({"technique=[\"march\",\"tree\"]"}), SizeIs(16));
    EXPECT_THAT(filtered({"view_angle=[0:60:60]"}), SizeIs(20));
}

TEST(Filter, ThatCannotBeReadIsAnError) {
    EXPECT_THAT(filter_message("technique"), HasSubstr("--filter technique: expected name=value"));
    EXPECT_THAT(filter_message("=3"), HasSubstr("expected name=value"));
    EXPECT_THAT(filter_message("view_angle="), HasSubstr("expected name=value"));
    EXPECT_THAT(filter_message("view_angel=3"), HasSubstr("(did you mean 'view_angle'?)"));
    EXPECT_THAT(filter_message("technique=marsh"), HasSubstr("unknown technique 'marsh' (did you mean 'march'?)"));
    EXPECT_THAT(filter_message("view_angle=95"), HasSubstr("from 0 to below 90"));
    EXPECT_THAT(filter_message("view_angle<steep"), HasSubstr("expected a number"));
    EXPECT_THAT(filter_message("leaf=exat"), HasSubstr("(did you mean 'exact'?)"));
}

TEST(Filter, ThatLeavesNoCellSaysWhatThereIs) {
    EXPECT_EQ(filter_message("view_angle=45"),
              "--filter view_angle=45: no cell of the configuration passes: view_angle is 0 or 60 there; "
              "to measure it, use -a view_angle=45");
    EXPECT_EQ(filter_message("view_angle>60"),
              "--filter view_angle>60: no cell of the configuration passes: view_angle is 0 or 60 there");
    EXPECT_THAT(filter_message("max_steps=200"),
                HasSubstr("max_steps is 16 or 64 there; to measure it, use -a max_steps=200"));
    EXPECT_THAT(filter_message("heightmap=rok"), HasSubstr("heightmap is rock or bricks there (did you mean 'rock'?)"));
    EXPECT_THAT(filter_message("technique=mesh"),
                HasSubstr("technique is plain, march or tree there; to measure it, use -a technique=mesh"));
    EXPECT_THAT(filter_message("factor=4"), HasSubstr("no cell there has a 'factor'"));
    EXPECT_EQ(
        error_message([] {
            filtered({"technique=march", "max_steps=64", "leaf=exact"});
        }),
        "--filter leaf=exact: no cell of those that pass --filter technique=march --filter max_steps=64 passes: no "
        "cell there has a 'leaf'");
    EXPECT_THAT(error_message([] {
                    filtered({"technique=march", "view_angle=45"});
                }),
                HasSubstr("--filter view_angle=45: no cell of the configuration passes: view_angle is 0 or 60"));
}

}  // namespace
}  // namespace reliefbench
