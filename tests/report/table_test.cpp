#include "report/table.hpp"

#include "report/text_layout.hpp"
#include "support/cell_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

using namespace reliefbench;

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

struct Figures {
    double ms = 1;
    double uv_p99 = 1;
    double missed = 0;
    double false_hits = 0;
};

CellResult measured(const std::string& id, const Figures& figures) {
    CellResult cell;
    cell.cell = id;
    cell.technique = id.substr(0, id.find(' '));
    cell.time["draw"] = {figures.ms, 0.012, {0, 0}, 15, 1};
    cell.ns_per_pixel = 15.25;
    cell.prepare_ms = 0;
    set_figures(cell, {{"work.taps_mean", 17.5}, {"work.taps_p95", 18}, {"work.covered_pixels", 65536}});
    set_summary(cell, "error.uv_texels", {0.5, 0.6, 0.25, 0.9, figures.uv_p99, 5});
    set_summary(cell, "error.depth", {-0.001, 0.002, 0.0005, 0.005, 0.0123, 0.03});
    set_figures(cell, {{"error.missed", figures.missed}, {"error.false_hits", figures.false_hits}});
    set_figures(cell, {{"image.flip", 0.25}, {"image.footprint.flip", 0.125}});
    return cell;
}

CellResult unmeasured(const std::string& id, CellStatus status, const std::string& reason) {
    CellResult cell;
    cell.cell = id;
    cell.status = status;
    cell.reason = reason;
    return cell;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// Marks and names of the rows, in order: "*pom".
std::vector<std::string> marked_rows(const std::vector<CellResult>& cells) {
    std::vector<std::string> rows;
    for (const std::string& line : lines_of(format_table(cells))) {
        if (line.find(" ± 0.012") != std::string::npos) rows.push_back(line[0] + line.substr(2, line.find(' ', 2) - 2));
    }
    return rows;
}

TEST(Table, ShowsTheFiguresOfACell) {
    const auto lines = lines_of(
        format_table({measured("pom max_steps=16 | heightmap=bricks view_angle=60", {1.2345, 0.75, 0.00125, 0.0005})}));
    ASSERT_GE(lines.size(), 3U);
    EXPECT_EQ(lines[0], "heightmap=bricks view_angle=60");
    EXPECT_EQ(lines[1],
              "                               ms  ns/pixel  taps  prep ms  uv p50  uv p99   flip  missed %  false %");
    EXPECT_EQ(lines[2],
              "* pom max_steps=16  1.234 ± 0.012      15.2  17.5        0   0.250   0.750  0.125     0.125   0.0500");
}

TEST(Table, ShowsMoreWhereThereIsRoomAndLessWhereThereIsNot) {
    CellResult cell = measured("pom max_steps=16 | v", {1.2345, 0.75, 0.00125, 0.0005});
    set_figures(cell, {{"motion.texels.mean", 0.0625}, {"motion.compared", 10}});
    EXPECT_EQ(lines_of(format_table({cell}, {.columns = 140}))[1],
              "                               ms  ns/pixel  taps  prep ms  uv p50  uv p99  depth p99   flip  missed %"
              "  false %  motion");
    EXPECT_EQ(lines_of(format_table({cell}, {.columns = 80}))[2],
              "* pom max_steps=16  1.234 ± 0.012   0.750  0.125     0.125   0.0500  0.0625");
}

TEST(Table, ColoursTellRanksWithoutMovingAnything) {
    const std::vector<CellResult> cells = {measured("slow | v", {9.5, 0.1}), measured("fast | v", {1.5, 4}),
                                           measured("middle | v", {3.5, 1}),
                                           measured("cheater | v", {3.75, 0.01, 0.2})};
    const std::string coloured = format_table(cells, {.colour = true});
    EXPECT_THAT(coloured, HasSubstr("\033[36m1.500 ± 0.012\033[0m"));
    EXPECT_THAT(coloured, HasSubstr("\033[33m9.500 ± 0.012\033[0m"));
    EXPECT_THAT(coloured, Not(HasSubstr("m3.500 ± 0.012")));
    EXPECT_THAT(coloured, HasSubstr("\033[36m 0.100\033[0m"));
    EXPECT_THAT(coloured, HasSubstr("\033[33m  4.00\033[0m"));
    EXPECT_THAT(coloured, Not(HasSubstr("m0.0100"))) << "the errors of a cell marked ! do not count";
    EXPECT_THAT(coloured, HasSubstr("\033[1m*\033[0m fast"));
    std::string stripped;
    bool in_escape = false;
    for (const char character : coloured.substr(0, coloured.find("in each view and column"))) {
        if (character == '\033') in_escape = true;
        if (!in_escape) stripped += character;
        if (in_escape && character == 'm') in_escape = false;
    }
    EXPECT_EQ(stripped, format_table(cells));
}

TEST(Table, EqualsHaveNoRank) {
    EXPECT_THAT(format_table({measured("a | v", {}), measured("b | v", {})}, {.colour = true}),
                Not(HasSubstr("m1.000 ± 0.012")));
}

TEST(Table, RowsAreSortedByTimeAndTheParetoFrontIsMarked) {
    EXPECT_EQ(marked_rows({measured("slow | v", {9.5, 0.1}), measured("fast | v", {1.5, 4}),
                           measured("beaten | v", {6.5, 5}), measured("middle | v", {3.5, 1})}),
              (std::vector<std::string>{"*fast", "*middle", " beaten", "*slow"}));
}

TEST(Table, EqualsAreMarkedTogetherButNotTheSlowerOfEqualQuality) {
    EXPECT_EQ(marked_rows({measured("b | v", {1.5, 1}), measured("a | v", {1.5, 1}), measured("c | v", {2.5, 1})}),
              (std::vector<std::string>{"*a", "*b", " c"}));
}

TEST(Table, DiscardingHardPixelsWinsNothing) {
    // The cheater is fastest and best, but misses and invents 0.6 % of the footprint; exactly 0.5 % is allowed.
    EXPECT_EQ(
        marked_rows({measured("cheater | v", {1.5, 0.1, 0.004, 0.002}), measured("honest | v", {2.5, 1, 0.005, 0})}),
        (std::vector<std::string>{"!cheater", "*honest"}));
}

TEST(Table, EachViewHasItsOwnFront) {
    const std::string table =
        format_table({measured("a | view_angle=0", {2.5, 1}), measured("b | view_angle=60", {1.5, 2}),
                      measured("c | view_angle=0", {1.5, 0.5})});
    EXPECT_LT(table.find("view_angle=0\n"), table.find("view_angle=60\n"));
    const auto lines = lines_of(table);
    EXPECT_THAT(lines[2], testing::StartsWith("* c"));
    EXPECT_THAT(lines[3], testing::StartsWith("  a"));
    EXPECT_EQ(lines[4], "");
    EXPECT_EQ(lines[5], "view_angle=60");
    EXPECT_THAT(lines[7], testing::StartsWith("* b"));
}

/// With the axes of shadows.
CellResult shadowed(const std::string& setting, const std::string& mode, double ms) {
    CellResult cell =
        measured(setting + " | heightmap=bricks" + (mode == "off" ? "" : " self_shadow=" + mode), {ms, 1});
    cell.axes = {{"heightmap", "bricks"}, {"self_shadow", mode}, {"depth_write", "on"}};
    if (mode == "off") return cell;
    set_figures(cell, {{"error.shadow.mean", 0.0625}, {"error.shadow.compared", 1000}});
    set_figure(cell, "work.shadow_taps_mean", 21.5);
    return cell;
}

TEST(Table, AnAxisThatMovesNoHitsHasItsValuesBelowEachOtherWithWhatShadowsCost) {
    const auto lines =
        lines_of(format_table({shadowed("slow", "off", 3), shadowed("fast", "off", 1), shadowed("slow", "hard", 5),
                               shadowed("fast", "hard", 4), shadowed("slow", "soft", 4), shadowed("fast", "soft", 2)}));
    EXPECT_EQ(lines[0], "heightmap=bricks");
    EXPECT_EQ(lines[1],
              "                                 ms  taps  uv p99   flip  missed %  false %  shadow taps  shadow");
    EXPECT_EQ(lines[2], "  fast");
    EXPECT_EQ(lines[3],
              "*   self_shadow=off   1.000 ± 0.012  17.5    1.00  0.125         0        0            -       -");
    EXPECT_EQ(lines[4],
              "*   self_shadow=hard  4.000 ± 0.012  17.5    1.00  0.125         0        0         21.5  0.0625");
    EXPECT_THAT(lines[5], testing::StartsWith("*   self_shadow=soft  2.000"));
    EXPECT_EQ(lines[6], "  slow");
    // Ranked among those with the same shadows.
    EXPECT_THAT(lines[7], testing::StartsWith("    self_shadow=off   3.000"));
    EXPECT_THAT(lines[8], testing::StartsWith("    self_shadow=hard  5.000"));
    EXPECT_THAT(lines[9], testing::StartsWith("    self_shadow=soft  4.000"));
}

TEST(Table, OneValueOfAnAxisStaysInTheView) {
    const auto lines = lines_of(format_table({shadowed("a", "hard", 1), shadowed("b", "hard", 2)}));
    EXPECT_EQ(lines[0], "heightmap=bricks self_shadow=hard");
    EXPECT_THAT(lines[2], testing::StartsWith("* a "));
}

TEST(Table, FlipIsOverTheFootprintAndOfTheWholePictureInOldRuns) {
    CellResult cell = measured("a | v", {});
    EXPECT_THAT(format_table({cell}), AllOf(HasSubstr(" 0.125 "), HasSubstr("over the footprint")));
    remove_figures(cell, "image.footprint");
    const std::string old = format_table({cell, measured("b | v", {})});
    EXPECT_THAT(old, AllOf(HasSubstr(" 0.250 "), Not(HasSubstr(" 0.125 ")), HasSubstr("of the whole picture"),
                           HasSubstr("relief outside it")));
}

TEST(Table, WhereTheTruthIsFilteredTheFrontGoesByFlipAndSaysWithHowManySamples) {
    const Json record = Json::parse(R"({"configuration": {"truth": {"kind": "exact", "samples": 64}}})");
    CellResult looks_right = measured("a | v", {1, 3});
    CellResult hits_right = measured("b | v", {2, 1});
    set_figure(looks_right, "image.footprint.flip", 0.01);
    set_figure(hits_right, "image.footprint.flip", 0.2);
    const std::string filtered = format_table({looks_right, hits_right}, {}, record);
    EXPECT_THAT(filtered, AllOf(HasSubstr("\n* a"), Not(HasSubstr("\n* b")), HasSubstr("faster and better (flip)"),
                                HasSubstr("over the footprint, against a truth of 64 samples a pixel;\n")));
    const std::string plain = format_table({looks_right, hits_right});
    EXPECT_THAT(plain, AllOf(HasSubstr("\n* a"), HasSubstr("\n* b"), HasSubstr("(uv p99)"), Not(HasSubstr("samples"))));
    remove_figures(looks_right, "image");
    EXPECT_THAT(format_table({looks_right}, {}, record), HasSubstr("(uv p99)")) << "with the lights off";
}

TEST(Table, TheMarksAreExplained) {
    const std::string table = format_table({measured("a | v", {})});
    EXPECT_THAT(table, HasSubstr("\n* nothing in the view is both faster and better"));
    EXPECT_THAT(table, HasSubstr("! missed + false hits above 0.5 %"));
}

TEST(Table, CautionsStandBelowIt) {
    CellResult cell = measured("pom | v", {1, 1});
    cell.axes = {{"projection", "parallel"}, {"view_angle", 60.0}, {"azimuth", -90.0}};
    EXPECT_THAT(format_table({cell}), HasSubstr("\ncaution: all rays run along rows or columns of texels"));
    cell.axes["azimuth"] = -67.0;
    EXPECT_THAT(format_table({cell}), Not(HasSubstr("caution")));
}

TEST(Table, WhatIsUndefinedIsADash) {
    CellResult cell = measured("a | v", {});
    remove_figures(cell, "error.uv_texels");
    remove_figures(cell, "error.depth");
    remove_figures(cell, "work");
    cell.ns_per_pixel.reset();
    cell.prepare_ms.reset();
    remove_figures(cell, "image");
    const auto lines = lines_of(format_table({cell}, {.columns = 140}));
    EXPECT_EQ(lines[2],
              "  a  1.000 ± 0.012         -     -        -       -       -          -     -         0        0");
    remove_figures(cell, "error");
    cell.time.clear();
    EXPECT_EQ(lines_of(format_table({cell}, {.columns = 140}))[2],
              "  a   -         -     -        -       -       -          -     -         -        -");
}

TEST(Table, FailedAndSkippedCellsFollowWithEqualReasonsTogether) {
    const std::string table = format_table({
        unmeasured("t a=1 | v", CellStatus::skipped, "max_steps=512 is out of range"),
        measured("pom | v", {}),
        unmeasured("broken | v", CellStatus::failed, "trace.glsl:3: error"),
        unmeasured("t a=2 | v", CellStatus::skipped, "max_steps=512 is out of range"),
        unmeasured("t a=3 | v", CellStatus::skipped, "max_steps=512 is out of range"),
        unmeasured("t a=4 | v", CellStatus::skipped, "max_steps=512 is out of range"),
        unmeasured("t a=5 | v", CellStatus::skipped, "max_steps=512 is out of range"),
        unmeasured("u | v", CellStatus::skipped, "no tessellation"),
    });
    EXPECT_THAT(table, testing::EndsWith("failed, 1 cell: trace.glsl:3: error\n"
                                         "    broken | v\n"
                                         "skipped, 5 cells: max_steps=512 is out of range\n"
                                         "    t a=1 | v\n"
                                         "    t a=2 | v\n"
                                         "    t a=3 | v\n"
                                         "    and 2 more\n"
                                         "skipped, 1 cell: no tessellation\n"
                                         "    u | v\n"));
    EXPECT_LT(table.find("* pom"), table.find("failed, "));
}

TEST(Table, ReasonsThatDifferByFiguresAreOne) {
    const auto given_up = [](const std::string& estimate, const std::string& percent) {
        return "would take about " + estimate + " s (the pass 'search_2' had done " + percent +
               " %), more than the limit of 20 s";
    };
    const std::string table = format_table({
        unmeasured("a | v", CellStatus::skipped, given_up("594", "3.2")),
        unmeasured("b | v", CellStatus::skipped, given_up("18308", "0.5")),
        unmeasured("c | v", CellStatus::skipped, given_up("600", "3.2")),
        unmeasured("d | v", CellStatus::skipped, "a map of 512x512 is too large"),
        unmeasured("e | v", CellStatus::skipped, "a map of 513x513 is too large"),
    });
    EXPECT_THAT(table, testing::EndsWith("skipped, 3 cells: would take about 594 to 18308 s (the pass 'search_2' had "
                                         "done 0.5 to 3.2 %), more\nthan the limit of 20 s\n"
                                         "    a | v\n    b | v\n    c | v\n"
                                         "skipped, 1 cell: a map of 512x512 is too large\n    d | v\n"
                                         "skipped, 1 cell: a map of 513x513 is too large\n    e | v\n"));
}

TEST(Table, SaysWhatItsMarksAndTitlesMean) {
    EXPECT_THAT(
        format_table({measured("a | v", {})}),
        HasSubstr(
            "* nothing in the view is both faster and better (uv p99)\n"
            "! missed + false hits above 0.5 %: its errors do not count\n"
            "ms: median of the draw ± MAD; ns/pixel: per covered pixel; prep: making its maps; uv: texels;\n"
            "depth: patch sides; flip: 0 to 1, over the footprint; missed, false: % of footprint;\n"
            "shadow: mean error of the lights' visibility; motion: change of the UV error between frames, texels\n"));
}

TEST(Table, NothingMeasuredIsNoEmptyTable) {
    EXPECT_EQ(format_table({}), "");
    EXPECT_THAT(format_table({unmeasured("a | v", CellStatus::failed, "why")}), Not(HasSubstr("taps")));
}

TEST(Table, FitsATerminalOf100ColumnsHoweverLongTheNames) {
    std::string id = "technique";
    for (int parameter = 0; parameter < 12; ++parameter) {
        id += " a_long_parameter_name_" + std::to_string(parameter) + "=0.123456789";
    }
    const std::string view = " | heightmap=bricks" + id.substr(9);
    const std::string table = format_table({measured(id + view, {12345.6789, 123456}), measured("pom" + view, {}),
                                            unmeasured(id + view, CellStatus::failed, id + id)});
    for (const std::string& line : lines_of(table)) {
        EXPECT_LE(text_width(line), 100U) << line;
    }
    for (int parameter = 0; parameter < 12; ++parameter) {
        EXPECT_THAT(table, HasSubstr("a_long_parameter_name_" + std::to_string(parameter) + "=0.123456789"));
    }
}

}  // namespace
