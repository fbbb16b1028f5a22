#include "store/cell_result.hpp"

#include "support/cell_figures.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

using namespace reliefbench;

namespace {

CellResult full_result() {
    CellResult result;
    result.cell = "pom max_steps=16 | heightmap=bricks view_angle=60";
    result.technique = "pom";
    result.axes["heightmap"] = "bricks";
    result.axes["view_angle"] = 60;
    result.parameters["max_steps"] = 16;
    result.parameters["bias"] = 0.1;
    result.time["draw"] = {1.0 / 3, 0.01, {0.3, 0.4}, 15, 4, 5, 2, 0.3125};
    result.time["quadtree"] = {2, 0, {2, 2}, 3, 1, 3, 0, 2};
    result.ns_per_pixel = 12.5;
    result.stop = StopReason::stalled;
    result.throttled_rounds = 3;
    result.prepare_ms = 0.75;
    result.prepare_bytes = 87381;
    set_figures(result, {{"work.taps_mean", 17.5},
                         {"work.taps_p95", 18},
                         {"work.texels_mean", 70},
                         {"work.steps_mean", 16},
                         {"work.steps_p95", 16},
                         {"work.unconverged", 0.25},
                         {"work.covered_pixels", 65536},
                         {"work.shadow_taps_mean", 21.5},
                         {"work.shadow_taps_p95", 31}});
    result.pipeline["fragment_shader_invocations"] = 65536;
    result.executable["fragment"]["register_count"] = 40;
    set_summary(result, "error.uv_texels", {0.1, 0.2, 0.05, 0.5, 1e-300, 3});
    set_summary(result, "error.depth", {-0.001, 0.002, 0.0005, 0.005, 0.01, 0.03});
    set_summary(result, "error.normal_deg", {1, 2, 3, 4, 5, 6});
    set_figures(result, {{"error.compared", 65000},
                         {"error.missed", 0.0625},
                         {"error.false_hits", 0.125},
                         {"error.ties", 0.0625},
                         {"error.outside_quad.pixels", 12},
                         {"error.outside_quad.covered", 0.5},
                         {"error.coverage_iou", 0.9},
                         {"error.wrong_surface", 0.003},
                         {"error.shadow.mean", 0.02},
                         {"error.shadow.false_shadow", 0.01},
                         {"error.shadow.missed_shadow", 0.015},
                         {"error.shadow.compared", 64000},
                         {"error.shadow.truth_standard_error", 0.001}});
    set_figures(result, {{"image.flip", 0.1},
                         {"image.psnr", 30},
                         {"image.ssim", 0.9},
                         {"image.rmse", 0.03},
                         {"image.footprint.flip", 0.04},
                         {"image.footprint.psnr", 36},
                         {"image.footprint.ssim", 0.95},
                         {"image.footprint.rmse", 0.016}});
    set_figures(result, {{"motion.texels.mean", 0.5},
                         {"motion.texels.p95", 2},
                         {"motion.texels.max", 8},
                         {"motion.compared", 500000},
                         {"motion.hit_once", 12},
                         {"motion.unseen", 700}});
    return result;
}

TEST(CellResultJson, HasEveryFieldWhereTheFormatSays) {
    const Json expected = Json::parse(R"({
        "cell": "pom max_steps=16 | heightmap=bricks view_angle=60",
        "technique": "pom",
        "axes": {"heightmap": "bricks", "view_angle": 60},
        "parameters": {"max_steps": 16, "bias": 0.1},
        "status": "ok",
        "reason": null,
        "time": {
            "draw": {"median_ms": 0.3333333333333333, "mad_ms": 0.01, "ci95_ms": [0.3, 0.4], "n": 15, "repeats": 4,
                     "rounds": 5, "outliers": 2, "lower_quartile_ms": 0.3125},
            "quadtree": {"median_ms": 2.0, "mad_ms": 0.0, "ci95_ms": [2.0, 2.0], "n": 3, "repeats": 1, "rounds": 3,
                         "outliers": 0, "lower_quartile_ms": 2.0},
            "stop": "stalled", "ns_per_pixel": 12.5, "throttled_rounds": 3
        },
        "prepare": {"ms": 0.75, "bytes": 87381},
        "pipeline": {"fragment_shader_invocations": 65536},
        "executable": {"fragment": {"register_count": 40.0}},
        "work": {"taps_mean": 17.5, "taps_p95": 18.0, "texels_mean": 70.0, "steps_mean": 16.0, "steps_p95": 16.0,
                 "unconverged": 0.25, "covered_pixels": 65536, "shadow_taps_mean": 21.5, "shadow_taps_p95": 31.0},
        "error": {
            "uv_texels": {"mean": 0.1, "rms": 0.2, "p50": 0.05, "p95": 0.5, "p99": 1e-300, "max": 3.0},
            "depth": {"mean": -0.001, "rms": 0.002, "p50": 0.0005, "p95": 0.005, "p99": 0.01, "max": 0.03},
            "normal_deg": {"mean": 1.0, "rms": 2.0, "p50": 3.0, "p95": 4.0, "p99": 5.0, "max": 6.0},
            "compared": 65000, "missed": 0.0625, "false_hits": 0.125, "ties": 0.0625,
            "outside_quad": {"pixels": 12, "covered": 0.5},
            "coverage_iou": 0.9, "wrong_surface": 0.003,
            "shadow": {"mean": 0.02, "false_shadow": 0.01, "missed_shadow": 0.015, "compared": 64000,
                       "truth_standard_error": 0.001}
        },
        "image": {"flip": 0.1, "psnr": 30.0, "ssim": 0.9, "rmse": 0.03,
                  "footprint": {"flip": 0.04, "psnr": 36.0, "ssim": 0.95, "rmse": 0.016}},
        "motion": {"texels": {"mean": 0.5, "p95": 2.0, "max": 8.0}, "flip": null, "compared": 500000, "hit_once": 12,
                   "unseen": 700}
    })");
    const Json written = to_json(full_result()).flatten();
    const Json flat = expected.flatten();
    for (const auto& [pointer, value] : flat.items())
        EXPECT_EQ(written.value(pointer, Json("missing")), value) << pointer;
    // What the result has not got.
    for (const auto& [pointer, value] : written.items())
        EXPECT_TRUE(flat.contains(pointer) || value.is_null()) << pointer;
}

TEST(CellResultJson, ReadsBackTheSameToTheLastBit) {
    const std::string written = to_json(full_result()).dump();
    const CellResult result = parse_cell_result(Json::parse(written), "cells.jsonl");
    EXPECT_EQ(to_json(result).dump(), written);
    EXPECT_EQ(result.time.at("draw").median_ms, 1.0 / 3);
    EXPECT_EQ(result.time.at("draw").n, 15U);
    EXPECT_EQ(result.time.size(), 2U);
    EXPECT_EQ(result.time.at("draw").outliers, 2U);
    EXPECT_EQ(result.stop, StopReason::stalled);
    EXPECT_EQ(result.throttled_rounds, 3U);
    EXPECT_EQ(result.executable.at("fragment").at("register_count"), 40);
    EXPECT_EQ(value_of("error.uv_texels.p99", result), 1e-300);
    EXPECT_EQ(value_of("work.covered_pixels", result), 65536);
    EXPECT_EQ(value_of("image.psnr", result), 30);
    EXPECT_EQ(value_of("image.footprint.flip", result), 0.04);
    EXPECT_EQ(value_of("motion.texels.p95", result), 2);
    EXPECT_FALSE(value_of("motion.flip.mean", result));
    EXPECT_EQ(value_of("motion.unseen", result), 700);
    EXPECT_EQ(result.status, CellStatus::ok);
}

TEST(CellResultJson, RunsFromBeforeErrorsOverTheFootprintAreRead) {
    Json json = to_json(full_result());
    Json earlier = json;
    earlier["image"].erase("footprint");
    const CellResult result = parse_cell_result(earlier, "cells.jsonl");
    EXPECT_EQ(value_of("image.flip", result), 0.1);
    EXPECT_FALSE(is_given(*find_figure("image.footprint.flip"), result));
    json["image"]["footprint"] = nullptr;
    EXPECT_EQ(to_json(result), json);
    EXPECT_EQ(to_json(parse_cell_result(json, "cells.jsonl")), json);
}

TEST(CellResultJson, RunsFromBeforeStoppingRulesAndMotionAreRead) {
    Json json = to_json(full_result());
    json.erase("executable");
    json.erase("motion");
    json["time"].erase("stop");
    json["time"].erase("throttled_rounds");
    json["time"]["draw"].erase("rounds");
    json["time"]["draw"].erase("outliers");
    const CellResult result = parse_cell_result(json, "cells.jsonl");
    EXPECT_FALSE(result.stop);
    EXPECT_FALSE(value_of("motion.compared", result));
    EXPECT_EQ(result.time.at("draw").n, 15U);
}

TEST(CellResultJson, TheKeyOfParametersInVersion010IsReadInPlaceOfTheNewOne) {
    Json json = to_json(full_result());
    json["params"] = json["parameters"];
    json.erase("parameters");
    EXPECT_EQ(parse_cell_result(json, "c").parameters, full_result().parameters);
    json["parameters"] = json["params"];
    EXPECT_THAT(error_message([&] { parse_cell_result(json, "c"); }), testing::HasSubstr("\"parameters\""));
}

TEST(CellResultJson, RunsFromBeforeShadowsAndObjectsAreRead) {
    Json json = to_json(full_result());
    json["work"].erase("shadow_taps_mean");
    json["work"].erase("shadow_taps_p95");
    json["error"].erase("shadow");
    json["error"].erase("wrong_surface");
    json["error"].erase("ties");
    const CellResult result = parse_cell_result(json, "cells.jsonl");
    for (const char* path : {"work.shadow_taps_mean", "error.shadow.mean", "error.wrong_surface", "error.ties"})
        EXPECT_FALSE(value_of(path, result)) << path;
    EXPECT_EQ(value_of("error.missed", result), 0.0625);
}

TEST(CellResultJson, WhatIsUndefinedIsNullAndReadsBackEmpty) {
    CellResult result;
    result.cell = "tessellation | heightmap=bricks";
    result.technique = "tessellation";
    result.status = CellStatus::skipped;
    result.reason = "the device has no tessellation";
    const Json json = to_json(result);
    EXPECT_EQ(json, Json::parse(R"({
        "cell": "tessellation | heightmap=bricks", "technique": "tessellation", "axes": {}, "parameters": {},
        "status": "skipped", "reason": "the device has no tessellation", "time": {"stop": null, "ns_per_pixel": null, "throttled_rounds": 0},
        "prepare": {"ms": null, "bytes": null}, "pipeline": {}, "executable": {}, "work": null,
        "error": null, "image": null, "motion": null})"));
    const CellResult read = parse_cell_result(json, "cells.jsonl");
    EXPECT_EQ(read.status, CellStatus::skipped);
    EXPECT_EQ(read.reason, result.reason);
    for (const FigureDeclaration& figure : figures())
        EXPECT_EQ(value_of(figure, read).has_value(), figure.path == "time.throttled_rounds") << figure.path;
}

TEST(CellResultJson, NothingToCompareIsNullInside) {
    CellResult result = full_result();
    remove_figures(result, "error.uv_texels");
    remove_figures(result, "error.outside_quad.covered");
    set_figure(result, "image.psnr", std::numeric_limits<double>::quiet_NaN());
    set_figure(result, "image.rmse", 0);
    // Undefined, each by itself: no pixel had any.
    set_group(result, "image.footprint", std::numeric_limits<double>::quiet_NaN());
    const Json json = to_json(result);
    EXPECT_TRUE(json["error"]["uv_texels"].is_null());
    EXPECT_TRUE(json["error"]["outside_quad"]["covered"].is_null());
    EXPECT_TRUE(json["image"]["psnr"].is_null());
    EXPECT_EQ(json["image"]["rmse"], 0.0);
    EXPECT_EQ(json["image"]["footprint"].size(), 5U);
    EXPECT_TRUE(json["image"]["footprint"]["flip"].is_null());
    const CellResult read = parse_cell_result(json, "cells.jsonl");
    EXPECT_FALSE(value_of("error.uv_texels.mean", read));
    EXPECT_TRUE(value_of("error.depth.mean", read));
    EXPECT_EQ(value_of("image.rmse", read), 0);
    EXPECT_TRUE(is_given(*find_figure("image.footprint.flip"), read));
    EXPECT_EQ(to_json(read), json);
}

TEST(CellResultJson, NumbersThatAreNotFiniteAreNeverWritten) {
    CellResult result = full_result();
    result.ns_per_pixel = std::numeric_limits<double>::infinity();
    set_figure(result, "image.psnr", std::numeric_limits<double>::infinity());
    const std::string text = to_json(result).dump();
    EXPECT_THAT(text, testing::HasSubstr("\"ns_per_pixel\":null"));
    EXPECT_THAT(text, testing::HasSubstr("\"psnr\":null"));
}

TEST(CellResultJson, ReadingIsStrict) {
    const Json good = to_json(full_result());
    const auto message = [&](const std::function<void(Json&)>& spoil) {
        Json bad = good;
        spoil(bad);
        return error_message([&] { parse_cell_result(bad, "c"); });
    };
    EXPECT_NO_THROW(parse_cell_result(good, "c"));
    EXPECT_EQ(message([](Json& json) { json["extra"] = 1; }).substr(0, 25), "c: $: unknown key \"extra\"");
    EXPECT_THAT(message([](Json& json) { json["error"]["uv_texels"]["p98"] = 1; }),
                testing::StartsWith("c: $.error.uv_texels: unknown key \"p98\" (did you mean"));
    EXPECT_THAT(message([](Json& json) { json["parameter"] = 1; }), testing::HasSubstr("did you mean"));
    EXPECT_EQ(message([](Json& json) { json["time"]["draw"].erase("n"); }), "c: $.time.draw: key \"n\" is missing");
    EXPECT_EQ(message([](Json& json) { json["time"]["draw"]["n"] = nullptr; }),
              "c: $.time.draw: Samples of the draw is null, which every pass has");
    EXPECT_EQ(message([](Json& json) { json["error"] = 3; }), "c: $.error: expected an object, found 3");
    EXPECT_EQ(message([](Json& json) { json["time"]["draw"]["n"] = -1; }),
              "c: $.time.draw.n: expected an integer of at least 0, found -1");
    EXPECT_EQ(message([](Json& json) { json["time"]["draw"]["ci95_ms"] = {1}; }),
              "c: $.time.draw.ci95_ms: expected [low, high], found [1]");
    EXPECT_EQ(message([](Json& json) { json["status"] = "fine"; }),
              "c: $.status: expected one of ok, skipped, failed, found \"fine\"");
    EXPECT_EQ(message([](Json& json) { json["axes"] = 3; }), "c: $.axes: expected an object, found 3");
    EXPECT_EQ(message([](Json& json) { json["work"]["taps_mean"] = "many"; }),
              "c: $.work.taps_mean: expected a number, found \"many\"");
    EXPECT_EQ(message([](Json& json) { json["error"]["compared"] = 0.5; }),
              "c: $.error.compared: expected an integer of at least 0, found 0.5");
}

}  // namespace
