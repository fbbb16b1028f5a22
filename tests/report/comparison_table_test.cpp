#include "report/comparison_table.hpp"

#include "comparison_sample.hpp"
#include "report/text_layout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

using namespace reliefbench;

namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

void expect_lines_within(const std::string& text, std::size_t columns) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        EXPECT_LE(text_width(line), columns) << line;
    }
}

TEST(ComparisonTable, TellsTheWorstFirstAndCountsWhatStayedTheSame) {
    EXPECT_EQ(format_comparison_table(sample_comparison()),
              R"(note: the driver changed: Mesa 22.3.6, now Mesa 23.0.0

slower, 2 cells
  change            95 %  visible  quality  cell
  +150 %  +125 to +175 %    3.1 %     same  steep | view_angle=0
  +7.2 %  +5.1 to +9.4 %    3.1 %     same  steep | view_angle=60

undecided, 1 cell
  change           95 %  visible  quality  more runs  cell
  +3.0 %  −4.0 to +11 %    3.1 %     same          9  qdm | view_angle=60
                                                      (measured in 4 of 5 base runs only)

faster, 1 cell
  change          95 %  visible  quality  cell
   −20 %  −25 to −15 %    3.1 %     same  relief | view_angle=60

worse quality, 1 cell
  pom | view_angle=60
      error.uv_texels.p99 0.750 → 0.810
      error.missed 0.0200 → 0.0100
      image.psnr - → 40.0

same quality, other changes, 1 cell
  relief | view_angle=60
      work.taps_mean 17.5 → 34.0

failed now, 1 cell: ok in the base, failed now: trace.glsl:3: error
    mine | view_angle=60
not compared, 2 cells: only in the base
    flat | view_angle=60
    flat | view_angle=0

threshold 2.0 %; change: of the time, new against base; 95 %: its interval; visible: the smallest change that this evidence would have shown
5 cells compared: 2 slower, 1 undecided, 1 faster, 1 same; quality: 1 worse, 0 better; 3 not compared, 1 of them failed now
)");
}

TEST(ComparisonTable, AllListsWhatStayedTheSame) {
    const std::string table = format_comparison_table(sample_comparison(), {true, widest_table});
    EXPECT_THAT(table, HasSubstr("same, 1 cell\n"
                                 "  change            95 %  visible  quality  cell\n"
                                 "  +0.0 %  −1.0 to +1.0 %    3.1 %    worse  pom | view_angle=60\n"));
}

TEST(ComparisonTable, OfManyChangesAndCellsTheFirstAreNamed) {
    Comparison comparison = sample_comparison();
    comparison.cells.resize(1);
    comparison.uncompared.clear();
    comparison.notices.clear();
    comparison.cells[0].quality.changes.clear();
    for (int field = 0; field < 7; ++field) {
        comparison.cells[0].quality.changes.push_back({"error.f" + std::to_string(field), 1.0, 2.0 + field, true});
        comparison.uncompared.push_back({"cell " + std::to_string(field), "only in the base"});
    }
    const std::string table = format_comparison_table(comparison);
    EXPECT_THAT(table, HasSubstr("      error.f6 1.00 → 8.00\n      error.f5 1.00 → 7.00\n      error.f4 1.00 → 6.00\n"
                                 "      error.f3 1.00 → 5.00\n      and 3 more\n"));
    EXPECT_THAT(table, HasSubstr("    cell 0\n    cell 1\n    cell 2\n    and 4 more\n"));
    const std::string all = format_comparison_table(comparison, {true, widest_table});
    EXPECT_THAT(all, HasSubstr("error.f0 1.00 → 2.00"));
    EXPECT_THAT(all, HasSubstr("cell 6"));
    EXPECT_THAT(all, Not(HasSubstr(" more\n")));
}

TEST(ComparisonTable, FitsTheTerminalHoweverLongTheIds) {
    Comparison comparison = sample_comparison();
    std::string id = "technique";
    for (int parameter = 0; parameter < 12; ++parameter) {
        id += " a_parameter_" + std::to_string(parameter) + "=0.125";
    }
    for (CellComparison& cell : comparison.cells) {
        cell.cell = id + " | " + cell.cell;
    }
    for (UncomparedCell& cell : comparison.uncompared) {
        cell.cell = id;
        cell.reason += " " + id;
    }
    for (const std::size_t columns : {widest_table, std::size_t{100}, std::size_t{80}}) {
        const std::string table = format_comparison_table(comparison, {true, columns});
        expect_lines_within(table, columns);
        EXPECT_THAT(table, HasSubstr("a_parameter_11=0.125"));
    }
}

TEST(ComparisonTable, WhatNoEvidenceTellsIsADash) {
    Comparison comparison = sample_comparison();
    comparison.cells = {compared("a | v", Verdict::undecided, 1.5, {0, std::numeric_limits<double>::infinity()})};
    comparison.cells[0].time.visible = std::numeric_limits<double>::infinity();
    comparison.cells[0].time.more.reset();
    EXPECT_THAT(format_comparison_table(comparison), HasSubstr("  change  95 %  visible  quality  more runs  cell\n"
                                                               "   +50 %     -        -     same          -  a | v\n"));
}

TEST(ComparisonTable, NothingComparedIsSaid) {
    EXPECT_EQ(format_comparison_table({}), "0 cells compared\n");
    Comparison comparison;
    comparison.uncompared = {{"a | v", "only in the new runs", false}};
    EXPECT_EQ(format_comparison_table(comparison),
              "not compared, 1 cell: only in the new runs\n    a | v\n\n0 cells compared; 1 not compared\n");
}

TEST(ComparisonTable, ChangesThatRoundToTheSameGetMoreDigits) {
    Comparison comparison;
    comparison.cells = {compared("a | v", Verdict::same, 1, {0.99, 1.01})};
    comparison.cells[0].quality = {QualityVerdict::worse, {{"image.rmse", 0.123456, 0.123489, true, false}}};
    EXPECT_THAT(format_comparison_table(comparison), HasSubstr("image.rmse 0.12346 → 0.12349\n"));
}

}  // namespace
