#include "report/comparison_table.hpp"

#include "comparison_sample.hpp"
#include "report/comparison_words.hpp"
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
  +7.2 %  +5.1 to +9.4 %    3.1 %    mixed  steep | view_angle=60

undecided, 1 cell
  change           95 %  visible  quality  more runs  cell
  +3.0 %  −4.0 to +11 %    3.1 %     same          9  qdm | view_angle=60
                                                      (measured in 4 of 5 base runs only)

faster, 1 cell
  change          95 %  visible  quality  cell
   −20 %  −25 to −15 %    3.1 %     same  relief | view_angle=60

worse quality, 1 cell
  pom | view_angle=60
      worse by 8.0 %: error.uv_texels.p99 0.750 → 0.810 texels
      better by 1.0 % of footprint: error.missed 2.00 → 1.00 % of footprint
      and 1 more

mixed quality (some figures better, others worse; --accept-mixed lets it pass), 1 cell
  steep | view_angle=60
      better by 90 %: error.uv_texels.p99 0.800 → 0.0800 texels
      worse by 0.30 % of footprint: error.missed+error.false_hits 0.200 → 0.500 % of footprint

same quality, other changes, 1 cell
  relief | view_angle=60
      worse by 94 %: work.taps_mean 17.5 → 34.0

same quality, changes within the tolerances, 1 cell (--all lists them)

failed now, 1 cell: ok in the base, failed now: trace.glsl:3: error
    mine | view_angle=60
not compared, 2 cells: only in the base
    flat | view_angle=60
    flat | view_angle=0

threshold 2.0 %; change: of the time, new against base; 95 %: its interval; visible: the smallest change that this evidence would have shown
quality is decided by changes beyond these: error.uv_texels.p99, error.uv_texels.mean: 0.05 texels and 5 %; error.missed+error.false_hits:
0.1 % of footprint; image.footprint.flip: 0.002 and 2 %; error.shadow.mean: 0.005 visibility and 5 %; motion.texels.mean: 0.005 texels and 5
%; motion.flip.mean, motion.ghosting.mean, motion.history_flip.mean: 0.005 and 5 %
5 cells compared: 2 slower, 1 undecided, 1 faster, 1 same; quality: 1 worse, 1 mixed, 0 better, 3 same; 3 not compared, 1 of them failed now
)");
}

TEST(ComparisonTable, OfQualityAloneThereIsNothingOnTimes) {
    Comparison comparison = sample_comparison();
    comparison.quality_only = true;
    comparison.accept_mixed = true;
    const std::string table = format_comparison_table(comparison, {true, widest_table});
    for (const char* word : {"slower", "undecided", "faster", "threshold", "visible", "--accept-mixed"})
        EXPECT_THAT(table, Not(HasSubstr(word)));
    EXPECT_THAT(table, HasSubstr("mixed quality (some figures better, others worse), 1 cell\n"));
    EXPECT_THAT(table, HasSubstr("\n5 cells compared; quality: 1 worse, 1 mixed, 0 better, 3 same; 3 not compared"));
}

TEST(ComparisonTable, WhatASideLacksIsNamed) {
    Comparison comparison;
    comparison.cells = {compared("a | v", Verdict::same, 1, {0.99, 1.01})};
    QualityChange lost = quality_change("error.shadow.mean", 0.1, std::nullopt, true);
    lost.decides = false;
    QualityChange stand_in = quality_change("image.flip", 0.1, 0.2, true);
    stand_in.in_place_of = "image.footprint.flip";
    comparison.cells[0].quality = {
        QualityVerdict::worse,
        {stand_in, lost, quality_change("image.psnr", std::numeric_limits<double>::infinity(), 40)}};
    EXPECT_THAT(format_comparison_table(comparison),
                HasSubstr("      worse by 100 %: image.flip 0.100 → 0.200 (in place of image.footprint.flip)\n"
                          "      not compared: error.shadow.mean 0.100 → - visibility\n"
                          "      worse: image.psnr ∞ → 40.0 dB\n"));
}

TEST(ComparisonTable, AmountsReadAsWhatTheyAre) {
    EXPECT_EQ(quality_change_text(quality_change("error.uv_texels.p99", 0, 0.06)),
              "worse by 0.060 texels: error.uv_texels.p99 0 → 0.0600 texels");
    EXPECT_EQ(quality_change_text(quality_change("error.uv_texels.p99", 0.001, 3)),
              "worse by a factor of 3000: error.uv_texels.p99 0.00100 → 3.00 texels");
    EXPECT_EQ(quality_change_text(quality_change("image.ssim", 0.9, 0.95)),
              "better by 0.050: image.ssim 0.900 → 0.950");
    EXPECT_EQ(quality_change_text(quality_change("error.depth.mean", -0.001, 0.002)),
              "error.depth.mean -0.00100 → 0.00200 patch sides");
    QualityChange small = quality_change("error.uv_texels.mean", 0.00961, 0.00903);
    small.is_deciding = true;
    EXPECT_EQ(quality_change_text(small),
              "better by 6.0 %, within the tolerance: error.uv_texels.mean 0.00961 → 0.00903 texels");
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
    for (const char* statistic : {"p99", "mean", "rms", "p50", "p95", "max"}) {
        comparison.cells[0].quality.changes.push_back(
            quality_change(std::string("error.uv_texels.") + statistic, 1, 2, statistic[0] == 'p'));
    }
    comparison.cells[0].quality.changes.push_back(quality_change("image.rmse", 0.1, 0.101));
    for (int cell = 0; cell < 7; ++cell) {
        comparison.uncompared.push_back({"cell " + std::to_string(cell), "only in the base"});
    }
    const std::string table = format_comparison_table(comparison);
    EXPECT_THAT(table, HasSubstr("      worse by 100 %: error.uv_texels.p99 1.00 → 2.00 texels\n"));
    EXPECT_THAT(table, HasSubstr("      worse by 100 %: error.uv_texels.p95 1.00 → 2.00 texels\n      and 2 more\n"));
    EXPECT_THAT(table, HasSubstr("    cell 0\n    cell 1\n    cell 2\n    and 4 more\n"));
    const std::string all = format_comparison_table(comparison, {true, widest_table});
    EXPECT_THAT(all, HasSubstr("worse by 1.0 %: image.rmse 0.100 → 0.101"));
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
    comparison.cells[0].quality = {QualityVerdict::worse, {quality_change("image.rmse", 0.123456, 0.123489, true)}};
    EXPECT_THAT(format_comparison_table(comparison), HasSubstr("worse by 0.027 %: image.rmse 0.12346 → 0.12349\n"));
}

}  // namespace
