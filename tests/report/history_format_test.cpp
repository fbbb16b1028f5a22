#include "report/history_format.hpp"

#include "report/sparkline.hpp"
#include "report/text_layout.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

using namespace reliefbench;

namespace {

using testing::HasSubstr;
using Values = std::vector<std::optional<double>>;

TEST(Sparkline, SpansFromTheLeastToTheGreatestOnALogarithmicScale) {
    const Values powers = {1, 2, 4, 8, 16, 32, 64, 128};
    EXPECT_EQ(sparkline(powers, {}), "▁▂▃▄▅▆▇█");
}

TEST(Sparkline, NoiseDoesNotLookLikeChange) {
    const Values values = {1, 1.01, 1.1};  // 1.2 would fill the scale
    EXPECT_EQ(sparkline(values, {}), "▁▁▅");
}

TEST(Sparkline, GapsAndChangesAreMarked) {
    const Values values = {1, std::nullopt, 4, 4};
    EXPECT_EQ(sparkline(values, std::vector<std::size_t>{2}), "▁·│██");
    EXPECT_EQ(sparkline({}, {}), "");
    const Values nothing = {std::nullopt, std::nullopt};
    EXPECT_EQ(sparkline(nothing, {}), "··");
}

History sample_history() {
    History history;
    history.runs = {"r1", "r2", "r3", "r4", "r5", "r6"};
    history.cells = {{"pom | view_angle=60", {1, 1, 1, 1.25, 1.25, 1.25}, {{3, 2, 1.25, 0.0001}}},
                     {"steep a_long=1 | view_angle=60", {2, 2, 2, 2, std::nullopt, std::nullopt}, {}}};
    history.groups = {{3, true, {0}, 1.25, 1.25, "between run 3 and 4: 1 cell slower, 1.25 times"}};
    history.record_changes = {{3, {"the driver changed", "the sampling changed"}}};
    return history;
}

TEST(HistoryTable, ShowsSeriesChangesAndWhatMovedTogether) {
    EXPECT_EQ(format_history(sample_history(), HistoryFormat::table),
              R"(  newest ms  series   changes     cell
      1.250  ▁▁▁│███  +25 % at 4  pom | view_angle=60
      2.000  ▁▁▁▁··               steep a_long=1 | view_angle=60

between run 3 and 4: 1 cell slower, 1.25 times
    pom | view_angle=60
run 4 (r4), against the one before it: the driver changed; the sampling changed

2 cells over 6 runs: 1 changed
)");
}

TEST(HistoryTable, LongSeriesAreCutToTheNewestRuns) {
    History history;
    CellHistory cell{"a | v", {}, {{1, 0, 2, 0.001}, {70, 69, 2, 0.001}}};
    for (int run = 0; run < 80; ++run) {
        history.runs.push_back("r" + std::to_string(run));
        cell.median_ms.push_back(run < 70 ? 1 : 2);
    }
    history.cells = {cell};
    std::string drawn = "…";
    for (int run = 20; run < 80; ++run) {
        drawn += run < 70 ? "▁" : run == 70 ? "│█" : "█";
    }
    EXPECT_THAT(format_history(history, HistoryFormat::table), HasSubstr("  " + drawn + "  "));
}

TEST(HistoryTable, FitsTheTerminal) {
    History history = sample_history();
    for (CellHistory& cell : history.cells) {
        for (int parameter = 0; parameter < 12; ++parameter) {
            cell.cell += " a_parameter_" + std::to_string(parameter) + "=0.125";
        }
    }
    std::istringstream stream(format_history(history, HistoryFormat::table, 80));
    for (std::string line; std::getline(stream, line);) {
        EXPECT_LE(text_width(line), 80U) << line;
    }
}

TEST(HistoryTable, NoCellsAreSaid) {
    EXPECT_EQ(format_history({}, HistoryFormat::table), "0 cells over 0 runs: 0 changed\n");
}

TEST(HistoryMarkdown, IsATable) {
    EXPECT_EQ(format_history(sample_history(), HistoryFormat::markdown),
              R"(**reliefbench: 2 cells over 6 runs: 1 changed**

- between run 3 and 4: 1 cell slower, 1.25 times
- run 4 (r4), against the one before it: the driver changed; the sampling changed

| cell | newest ms | series | changes |
| --- | ---: | --- | --- |
| `pom \| view_angle=60` | 1.250 | ▁▁▁│███ | +25 % at 4 |
| `steep a_long=1 \| view_angle=60` | 2.000 | ▁▁▁▁·· |  |
)");
}

TEST(HistoryJson, CountsRunsFromZeroAndWritesGapsAsNull) {
    EXPECT_EQ(Json::parse(format_history(sample_history(), HistoryFormat::json)), Json::parse(R"({
        "runs": ["r1", "r2", "r3", "r4", "r5", "r6"],
        "cells": [
            {"cell": "pom | view_angle=60", "median_ms": [1.0, 1.0, 1.0, 1.25, 1.25, 1.25],
             "changes": [{"run": 3, "previous": 2, "ratio": 1.25, "p": 0.0001}]},
            {"cell": "steep a_long=1 | view_angle=60", "median_ms": [2.0, 2.0, 2.0, 2.0, null, null], "changes": []}
        ],
        "groups": [{"run": 3, "slower": true, "cells": ["pom | view_angle=60"], "smallest_ratio": 1.25,
                    "largest_ratio": 1.25, "text": "between run 3 and 4: 1 cell slower, 1.25 times"}],
        "record_changes": [{"run": 3, "differences": ["the driver changed", "the sampling changed"]}]
    })"));
}

TEST(HistoryFormats, AnUnknownOneIsAnError) {
    EXPECT_EQ(error_message([] { parse_history_format("tabel"); }),
              "there is no format 'tabel' (did you mean 'table'?); the formats are table, markdown, json");
}

}  // namespace
