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

#include <limits>
#include <sstream>

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
        "extra": "95 % interval of the median: 0.2500 to 0.7500 ms\n6 samples\n17.5 taps per pixel\nUV error p99: 0.750 texels"
    }])"));
}

/// The fields of a line that has no quoted ones.
std::vector<std::string> split_line(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream stream(line + ",");
    for (std::string field; std::getline(stream, field, ',');) {
        fields.push_back(field);
    }
    return fields;
}

TEST(Csv, HasOneRowPerCellAndEveryFieldAsAColumn) {
    EXPECT_EQ(format_csv(sample_run()),
              "cell,technique,status,reason,time.draw.median_ms,time.draw.mad_ms,time.draw.ci95_ms.low,"
              "time.draw.ci95_ms.high,time.draw.n,time.draw.repeats,time.ns_per_pixel,time.quadtree.median_ms,"
              "time.quadtree.mad_ms,time.quadtree.ci95_ms.low,time.quadtree.ci95_ms.high,time.quadtree.n,"
              "time.quadtree.repeats,prepare.ms,prepare.bytes,work.taps_mean,work.taps_p95,work.texels_mean,"
              "work.steps_mean,work.steps_p95,work.unconverged,work.covered_pixels,error.uv_texels.mean,"
              "error.uv_texels.rms,error.uv_texels.p50,error.uv_texels.p95,error.uv_texels.p99,error.uv_texels.max,"
              "error.depth.mean,error.depth.rms,error.depth.p50,error.depth.p95,error.depth.p99,error.depth.max,"
              "error.normal_deg.mean,error.normal_deg.rms,error.normal_deg.p50,error.normal_deg.p95,"
              "error.normal_deg.p99,error.normal_deg.max,error.compared,error.missed,error.false_hits,"
              "error.outside_quad.pixels,error.outside_quad.covered,error.coverage_iou,image.flip,image.psnr,"
              "image.ssim,image.rmse,axes.heightmap,axes.fov,params.max_steps,params.bias,params.refine,"
              "pipeline.fragment_shader_invocations\n"
              "pom max_steps=16 | heightmap=bricks,pom,ok,,0.5,0.0125,0.25,0.75,6,4,12.5,2.0,0.0,2.0,2.0,3,1,2.0,87381,"
              "17.5,18.0,70.0,16.0,16.0,0.25,65536,0.1,0.2,0.05,0.5,0.75,3.0,-0.001,0.002,0.0005,0.005,0.01,0.03,,,,,"
              ",,65000,0.001,0.002,0,,0.9,,30.0,,0.03,\"bricks, \"\"red\"\"\",,16,0.1,true,65536\n"
              "tessellation | heightmap=bricks,tessellation,skipped,the device has no tessellation" +
                  std::string(52, ',') + "\n" +
                  "mine | heightmap=bricks,mine,failed,\"trace.glsl:3: 'a' : undeclared,\nsee above\"" +
                  std::string(52, ',') + "\n");
}

TEST(Csv, ColumnsDoNotDependOnWhichCellsFailed) {
    Run run = sample_run();
    run.cells.erase(run.cells.begin());
    const std::string csv = format_csv(run);
    const std::vector<std::string> titles = split_line(csv.substr(0, csv.find('\n')));
    EXPECT_THAT(titles, testing::IsSupersetOf(
                            {"time.draw.median_ms", "error.uv_texels.p99", "work.taps_mean", "image.psnr", "reason"}));
    EXPECT_THAT(titles, testing::Not(testing::Contains("error")));
}

TEST(Csv, ARunWithoutCellsHasItsTitles) {
    const std::string csv = format_csv({});
    EXPECT_THAT(csv, testing::StartsWith("cell,technique,"));
    EXPECT_EQ(csv.find('\n'), csv.size() - 1);
}

TEST(QualityCostMarkdown, IsTheTableOfEachView) {
    EXPECT_EQ(format_quality_cost_markdown(sample_run()),
              R"(### heightmap=bricks

|  | technique | ms | ns/pixel | taps | prep ms | uv p50 | uv p99 | depth p99 | missed % | false % |
| :---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
| \* | `pom max_steps=16` | 0.5000 ± 0.0125 | 12.5 | 17.5 | 2.00 | 0.0500 | 0.750 | 0.0100 | 0.100 | 0.200 |

\* nothing in the view is both faster and better (UV p99); ! missed + false hits above 0.5 %: its errors do not count. ms: median ± MAD of the draw; prep: making its maps; uv: texels; depth: patch sides; missed, false: % of the footprint.

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
        const Run run = sample_run();
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
