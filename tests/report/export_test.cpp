#include "report/export.hpp"

#include "core/file.hpp"
#include "report/csv.hpp"
#include "report/github_action.hpp"
#include "report/google_benchmark.hpp"
#include "report/quality_cost_markdown.hpp"
#include "run_sample.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace reliefbench;

namespace {

using testing::HasSubstr;

const std::string pom = "pom max_steps=16 | heightmap=bricks";

TEST(GoogleBenchmark, TheContextNamesTheDeviceAndNoHost) {
    EXPECT_EQ(Json::parse(format_google_benchmark(sample_run(), {})).at("context"), Json::parse(R"({
        "date": "2026-11-22T08:56:36Z", "host_name": "", "executable": "reliefbench", "num_cpus": 2, "caches": [],
        "load_avg": [], "library_build_type": "release", "device": "llvmpipe", "driver": "llvmpipe",
        "driver_version": "Mesa 22.3.6", "tool_version": "0.1.0", "git_revision": "abc", "configuration": "quick"
    })"));
}

TEST(GoogleBenchmark, EachRoundIsARepetitionAndAggregatesFollow) {
    const Json benchmarks =
        Json::parse(format_google_benchmark(sample_run(), {{pom, {0.5, 0.25, 0.75}}})).at("benchmarks");
    ASSERT_EQ(benchmarks.size(), 7U);  // what failed or was skipped has no time
    // Six samples of four draws in three rounds.
    EXPECT_EQ(benchmarks[1], Json::parse(R"({
        "name": "pom max_steps=16 | heightmap=bricks", "family_index": 0, "per_family_instance_index": 0,
        "run_name": "pom max_steps=16 | heightmap=bricks", "run_type": "iteration", "repetitions": 3,
        "repetition_index": 1, "threads": 1, "iterations": 8, "real_time": 250000.0, "cpu_time": 250000.0,
        "time_unit": "ns", "taps": 17.5, "uv_error_p99_texels": 0.75, "missed_and_false_hits": 0.003,
        "prepare_bytes": 87381.0
    })"));
    EXPECT_EQ(benchmarks[3], Json::parse(R"({
        "name": "pom max_steps=16 | heightmap=bricks_mean", "family_index": 0, "per_family_instance_index": 0,
        "run_name": "pom max_steps=16 | heightmap=bricks", "run_type": "aggregate", "repetitions": 3, "threads": 1,
        "aggregate_name": "mean", "aggregate_unit": "time", "iterations": 3, "real_time": 500000.0,
        "cpu_time": 500000.0, "time_unit": "ns", "taps": 17.5, "uv_error_p99_texels": 0.75,
        "missed_and_false_hits": 0.003, "prepare_bytes": 87381.0
    })"));
    EXPECT_EQ(benchmarks[4].at("aggregate_name"), "median");
    EXPECT_EQ(benchmarks[4].at("real_time"), 500000);
    EXPECT_EQ(benchmarks[5].at("aggregate_name"), "stddev");
    EXPECT_EQ(benchmarks[5].at("real_time"), 250000);
    EXPECT_EQ(benchmarks[5].at("taps"), 0);
    EXPECT_EQ(benchmarks[6].at("name"), pom + "_cv");
    EXPECT_EQ(benchmarks[6].at("aggregate_unit"), "percentage");
    EXPECT_EQ(benchmarks[6].at("real_time"), 0.5);
}

TEST(GoogleBenchmark, ACellWithoutRoundsIsOneRepetition) {
    const Json benchmarks = Json::parse(format_google_benchmark(sample_run(), {})).at("benchmarks");
    ASSERT_EQ(benchmarks.size(), 1U);
    EXPECT_EQ(benchmarks[0].at("real_time"), 500000);
    EXPECT_EQ(benchmarks[0].at("repetitions"), 1);
}

TEST(GithubAction, IsSmallerIsBetter) {
    EXPECT_EQ(Json::parse(format_github_action(sample_run())), Json::parse(R"([{
        "name": "pom max_steps=16 | heightmap=bricks", "unit": "ms", "value": 0.5, "range": "± 0.0125",
        "extra": "95 % interval of the median: 0.2500 to 0.7500 ms\n6 samples\nTaps per pixel: 17.5\nUV error, p99: 0.750 texels"
    }])"));
}

/// Rows of fields, read by RFC 4180.
std::vector<std::vector<std::string>> read_csv(const std::string& text) {
    std::vector<std::vector<std::string>> rows(1, {""});
    bool quoted = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char character = text[at];
        std::string& field = rows.back().back();
        if (character == '"' && quoted && at + 1 < text.size() && text[at + 1] == '"') {
            field += '"';
            ++at;
        } else if (character == '"') {
            quoted = !quoted;
        } else if (character == ',' && !quoted) {
            rows.back().emplace_back();
        } else if (character == '\n' && !quoted) {
            rows.push_back({""});
        } else {
            field += character;
        }
    }
    EXPECT_EQ(rows.back(), std::vector<std::string>{""}) << "the last line has no end";
    rows.pop_back();
    return rows;
}

TEST(Csv, HasOneRowPerCellAndEveryFieldAsAColumn) {
    const auto rows = read_csv(format_csv(sample_run()));
    ASSERT_EQ(rows.size(), 4U);
    const std::vector<std::string>& titles = rows[0];
    const auto field = [&](std::size_t row, const std::string& title) {
        const auto column = std::find(titles.begin(), titles.end(), title);
        EXPECT_NE(column, titles.end()) << title;
        EXPECT_EQ(rows[row].size(), titles.size());
        return column == titles.end() ? "" : rows[row][static_cast<std::size_t>(column - titles.begin())];
    };
    EXPECT_EQ(field(1, "cell"), pom);
    EXPECT_EQ(field(1, "status"), "ok");
    EXPECT_EQ(field(1, "time.draw.median_ms"), "0.5");
    EXPECT_EQ(field(1, "time.draw.ci95_ms.low"), "0.25");
    EXPECT_EQ(field(1, "time.draw.ci95_ms.high"), "0.75");
    EXPECT_EQ(field(1, "time.draw.n"), "6");
    EXPECT_EQ(field(1, "time.ns_per_pixel"), "12.5");
    EXPECT_EQ(field(1, "time.quadtree.median_ms"), "2.0");
    EXPECT_EQ(field(1, "prepare.bytes"), "87381");
    EXPECT_EQ(field(1, "work.taps_mean"), "17.5");
    EXPECT_EQ(field(1, "error.uv_texels.p99"), "0.75");
    EXPECT_EQ(field(1, "error.depth.mean"), "-0.001");
    EXPECT_EQ(field(1, "error.normal_deg.p99"), "");
    EXPECT_EQ(field(1, "error.outside_quad.pixels"), "0");
    EXPECT_EQ(field(1, "image.psnr"), "30.0");
    EXPECT_EQ(field(1, "image.flip"), "");
    EXPECT_EQ(field(1, "image.footprint.flip"), "0.0625");
    EXPECT_EQ(field(1, "motion.texels.mean"), "0.25");
    EXPECT_EQ(field(1, "motion.flip.mean"), "");
    EXPECT_EQ(field(1, "motion.unseen"), "700");
    EXPECT_EQ(field(1, "axes.heightmap"), "bricks, \"red\"");
    EXPECT_EQ(field(1, "axes.fov"), "");
    EXPECT_EQ(field(1, "parameters.refine"), "true");
    EXPECT_EQ(field(1, "pipeline.fragment_shader_invocations"), "65536");
    EXPECT_EQ(field(2, "reason"), "the device has no tessellation");
    EXPECT_EQ(field(2, "time.draw.median_ms"), "");
    EXPECT_EQ(field(3, "status"), "failed");
    EXPECT_EQ(field(3, "reason"), "trace.glsl:3: 'a' : undeclared,\nsee above");
}

TEST(Csv, ColumnsDoNotDependOnWhichCellsFailed) {
    reliefbench::Run run = sample_run();  // testing::Test has a Run of its own
    run.cells.erase(run.cells.begin());
    const std::vector<std::string> titles = read_csv(format_csv(run)).front();
    EXPECT_EQ(titles, read_csv(format_csv({})).front());
    EXPECT_THAT(titles, testing::IsSupersetOf({"cell", "reason", "time.draw.median_ms", "prepare.ms", "work.taps_mean",
                                               "error.uv_texels.p99", "error.outside_quad.covered", "image.psnr",
                                               "image.footprint.flip"}));
    EXPECT_THAT(titles, testing::Not(testing::Contains("error")));
}

/// What a spreadsheet would run is text; numbers stay numbers.
TEST(Csv, TextIsNoFormula) {
    reliefbench::Run run = sample_run();
    run.cells.resize(1);
    run.cells[0].axes["heightmap"] = "=HYPERLINK(\"x\",1).png";
    run.cells[0].axes["boundary"] = "@SUM(1)";
    run.cells[0].axes["azimuth"] = -90;
    run.cells[0].axes["projection"] = "-1.5e3";
    run.cells[0].reason = "+1 and more";
    const auto rows = read_csv(format_csv(run));
    const auto value = [&](const std::string& column) {
        return rows[1][static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), column) - rows[0].begin())];
    };
    EXPECT_EQ(value("axes.heightmap"), "'=HYPERLINK(\"x\",1).png");
    EXPECT_EQ(value("axes.boundary"), "'@SUM(1)");
    EXPECT_EQ(value("axes.azimuth"), "-90");
    EXPECT_EQ(value("axes.projection"), "-1.5e3");
    EXPECT_EQ(value("reason"), "'+1 and more");
}

TEST(Csv, ARunWithoutCellsHasItsTitles) {
    const std::string csv = format_csv({});
    EXPECT_THAT(csv, testing::StartsWith("cell,technique,"));
    EXPECT_EQ(csv.find('\n'), csv.size() - 1);
}

TEST(QualityCostMarkdown, IsTheTableOfEachView) {
    EXPECT_EQ(format_quality_cost_markdown(sample_run()),
              R"(### heightmap=bricks

|  | technique | ms | ns/pixel | taps | prep ms | uv p50 | uv p99 | depth p99 | flip | missed % | false % | motion |
| :---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
| \* | `pom max_steps=16` | 0.5000 ± 0.0125 | 12.5 | 17.5 | 2.00 | 0.0500 | 0.750 | 0.0100 | 0.0625 | 0.100 | 0.200 | 0.250 |

\* nothing in the view is both faster and better (uv p99); ! missed + false hits above 0.5 %: its errors do not count. ms: median of the draw ± MAD; ns/pixel: per covered pixel; prep: making its maps; uv: texels; depth: patch sides; flip: 0 to 1, over the footprint; missed, false: % of footprint; shadow: mean error of the lights' visibility; motion: change of the UV error between frames, texels.

<details><summary>1 cell failed</summary>

| cell | why |
| --- | --- |
| `mine \| heightmap=bricks` | trace.glsl:3: 'a' : undeclared, see above |

</details>
<details><summary>1 cell skipped</summary>

| cell | why |
| --- | --- |
| `tessellation \| heightmap=bricks` | the device has no tessellation |

</details>
)");
}

TEST(Export, OfNoCellsIsValid) {
    EXPECT_EQ(Json::parse(format_google_benchmark({}, {})).at("benchmarks"), Json::array());
    EXPECT_EQ(format_github_action({}), "[]\n");
    EXPECT_EQ(format_quality_cost_markdown({}), "");
}

TEST(Export, ReadsTheRoundsOfAStoredRun) {
    const TemporaryFolder folder;
    {
        const reliefbench::Run run = sample_run();
        RunWriter writer(folder / "run", run.run);
        writer.append_cell(run.cells[0]);
        writer.append_samples({pom, "draw", 0, 0, 4, {0.25, 0.5, 0.75}});
        writer.append_samples({pom, "draw", 1, 0, 4, {1, 1, 2}});
    }
    const Json benchmarks = Json::parse(export_run(folder / "run", ExportFormat::google_benchmark)).at("benchmarks");
    EXPECT_EQ(benchmarks.at(0).at("real_time"), 500000);
    EXPECT_EQ(benchmarks.at(1).at("real_time"), 1000000);
    EXPECT_THAT(export_run(folder / "run", ExportFormat::csv), HasSubstr(pom));
    EXPECT_THAT(export_run(folder / "run", ExportFormat::github_action), HasSubstr(pom));
    EXPECT_THAT(export_run(folder / "run", ExportFormat::markdown), HasSubstr("### heightmap=bricks"));
}

TEST(Export, AnUnknownFormatIsNamedWithThoseThereAre) {
    EXPECT_EQ(parse_export_format("csv"), ExportFormat::csv);
    EXPECT_EQ(error_message([] { parse_export_format("cvs"); }),
              "there is no export format 'cvs' (did you mean 'csv'?); the formats are google_benchmark, github_action, "
              "csv, markdown");
}

}  // namespace
