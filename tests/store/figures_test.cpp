#include "store/figures.hpp"

#include "core/file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace reliefbench {
namespace {

/// With every group that a cell may have.
CellResult complete_cell() {
    CellResult cell;
    cell.time["draw"] = {};
    cell.time["draw"].lower_quartile_ms = 1;
    cell.work = CellResult::Work{};
    CellResult::Errors errors;
    errors.uv_texels = errors.depth = errors.normal_deg = Summary{};
    errors.shadow = CellResult::ShadowErrors{};
    cell.error = errors;
    cell.image = CellResult::ImageFields{};
    cell.image->footprint = CellResult::FootprintFields{};
    CellResult::Motion motion;
    motion.texels = motion.flip = CellResult::MotionFigure{};
    cell.motion = motion;
    return cell;
}

/// "error.uv_texels.p99" as "/error/uv_texels/p99".
Json::json_pointer pointer_to(std::string path) {
    for (const auto& [bound, index] : {std::pair(".low", ".0"), std::pair(".high", ".1")}) {
        if (path.ends_with(bound)) path.replace(path.rfind('.'), std::string::npos, index);
    }
    std::replace(path.begin(), path.end(), '.', '/');
    return Json::json_pointer("/" + path);
}

/// A different number in every place that may have one.
Json distinct_numbers() {
    Json json = to_json(complete_cell());
    json["cell"] = "pom | heightmap=bricks";
    json["technique"] = "pom";
    int next = 1;
    for (const FigureDeclaration& figure : figures()) {
        Json& number = json.at(pointer_to(std::string(figure.path)));
        number = next++;
    }
    return json;
}

TEST(Figures, AreAllNumbersOfACellAndNothingElse) {
    std::set<std::string> declared;
    for (const FigureDeclaration& figure : figures()) {
        const bool is_new = declared.insert(pointer_to(std::string(figure.path)).to_string()).second;
        EXPECT_TRUE(is_new) << figure.path << " is declared twice";
        EXPECT_FALSE(figure.label.empty()) << figure.path;
    }
    const std::set<std::string> words = {"/cell",   "/technique", "/axes",     "/parameters",    "/status",
                                         "/reason", "/time/stop", "/pipeline", "/executable"};
    std::set<std::string> there;
    const Json flat = to_json(complete_cell()).flatten();
    for (const auto& [pointer, value] : flat.items()) {
        if (!words.contains(pointer)) there.insert(pointer);
    }
    EXPECT_EQ(declared, there);
}

TEST(Figures, HaveTheValueThatTheFileHasAtTheirPath) {
    const Json json = distinct_numbers();
    const CellResult cell = parse_cell_result(json, "cells.jsonl");
    for (const FigureDeclaration& figure : figures()) {
        const std::optional<double> value = figure.value(cell);
        ASSERT_TRUE(value) << figure.path;
        EXPECT_EQ(*value, json.at(pointer_to(std::string(figure.path)))) << figure.path;
    }
}

TEST(Figures, OfACellWithoutResultsHaveNoValue) {
    for (const FigureDeclaration& figure : figures()) {
        if (figure.path == "time.throttled_rounds") continue;
        EXPECT_FALSE(figure.value(CellResult())) << figure.path;
    }
}

TEST(Figures, AnImageWithoutAnErrorHasTheBestPsnr) {
    CellResult cell = complete_cell();
    const FigureDeclaration* psnr = find_figure("image.psnr");
    ASSERT_NE(psnr, nullptr);
    EXPECT_EQ(psnr->better, Better::higher);
    EXPECT_FALSE(psnr->value(cell)) << "nothing is known of the image";
    cell.image->rmse = 0;
    EXPECT_TRUE(std::isinf(psnr->value(cell).value()));
}

TEST(Figures, SignedMeansAndCountsHaveNoDirection) {
    EXPECT_EQ(find_figure("error.depth.mean")->better, Better::neither);
    EXPECT_EQ(find_figure("error.compared")->better, Better::neither);
    EXPECT_EQ(find_figure("error.depth.rms")->better, Better::lower);
    EXPECT_EQ(find_figure("error.coverage_iou")->better, Better::higher);
    EXPECT_EQ(find_figure("error.depth"), nullptr);
}

TEST(Figures, BetterGoesByTheDirection) {
    EXPECT_TRUE(is_better(1, 2, Better::lower));
    EXPECT_TRUE(is_better(2, 1, Better::higher));
    EXPECT_FALSE(is_better(1, 2, Better::higher));
    for (const Better better : {Better::lower, Better::higher, Better::neither}) {
        EXPECT_FALSE(is_better(1, 1, better));
        EXPECT_FALSE(is_better(1, 2, better) && is_better(2, 1, better));
    }
    EXPECT_FALSE(is_better(1, 2, Better::neither) || is_better(2, 1, Better::neither));
}

TEST(Figures, TheListOfTheScriptsIsThisOne) {
    const std::string file = RELIEFBENCH_SOURCE_DIR "/scripts/figures.json";
    EXPECT_EQ(Json::parse(read_text_file(file)), figures_to_json())
        << "write it again: reliefbench list figures --format json > scripts/figures.json";
}

}  // namespace
}  // namespace reliefbench
