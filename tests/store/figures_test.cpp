#include "store/figures.hpp"

#include "core/file.hpp"
#include "store/chosen_figures.hpp"
#include "support/cell_figures.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <regex>
#include <set>

namespace reliefbench {
namespace {

/// With every figure that a cell may have.
CellResult complete_cell(const std::shared_ptr<const FigureList>& list = declared_figures()) {
    CellResult cell(list);
    cell.cell = "pom | heightmap=bricks";
    cell.technique = "pom";
    cell.time["draw"].lower_quartile_ms = 1;
    cell.ns_per_pixel = cell.prepare_ms = 1;
    cell.prepare_bytes = 1;
    for (const FigureDeclaration& figure : list->all())
        set_figure(cell, figure.path, 1);
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
    int next = 1;
    for (const FigureDeclaration& figure : figures()) {
        Json& number = json.at(pointer_to(figure.path));
        number = next++;
    }
    return json;
}

TEST(Figures, AreAllNumbersOfACellAndNothingElse) {
    std::set<std::string> declared;
    for (const FigureDeclaration& figure : figures()) {
        const bool is_new = declared.insert(pointer_to(figure.path).to_string()).second;
        EXPECT_TRUE(is_new) << figure.path << " is declared twice";
        EXPECT_FALSE(figure.label.empty()) << figure.path;
    }
    const std::set<std::string> words = {"/cell",   "/technique", "/axes",     "/parameters", "/status",
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
        const std::optional<double> value = value_of(figure, cell);
        ASSERT_TRUE(value) << figure.path;
        EXPECT_EQ(*value, json.at(pointer_to(figure.path))) << figure.path;
    }
}

TEST(Figures, OfACellWithoutResultsHaveNoValue) {
    for (const FigureDeclaration& figure : figures()) {
        if (figure.path == "time.throttled_rounds") continue;
        EXPECT_FALSE(value_of(figure, CellResult())) << figure.path;
    }
}

TEST(Figures, CountsAreWrittenAsWholeNumbers) {
    const Json json = to_json(complete_cell());
    for (const FigureDeclaration& figure : figures())
        EXPECT_EQ(json.at(pointer_to(figure.path)).is_number_integer(), figure.is_count) << figure.path;
}

TEST(Figures, AnImageWithoutAnErrorHasTheBestPsnr) {
    CellResult cell;
    const FigureDeclaration* psnr = find_figure("image.psnr");
    ASSERT_NE(psnr, nullptr);
    EXPECT_EQ(psnr->better, Better::higher);
    EXPECT_FALSE(value_of(*psnr, cell)) << "nothing is known of the image";
    set_figures(cell, {{"image.psnr", std::numeric_limits<double>::infinity()}, {"image.rmse", 0}});
    EXPECT_TRUE(std::isinf(value_of(*psnr, cell).value()));
    EXPECT_TRUE(to_json(cell).at("image").at("psnr").is_null());
}

TEST(Figures, SignedMeansAndCountsHaveNoDirection) {
    EXPECT_EQ(find_figure("error.depth.mean")->better, Better::neither);
    EXPECT_EQ(find_figure("error.compared")->better, Better::neither);
    EXPECT_EQ(find_figure("error.depth.rms")->better, Better::lower);
    EXPECT_EQ(find_figure("error.coverage_iou")->better, Better::higher);
    EXPECT_EQ(find_figure("error.depth"), nullptr);
}

TEST(Figures, SayWhatTheyNeed) {
    for (const FigureDeclaration& figure : figures()) {
        const bool of_truth = std::regex_match(figure.path, std::regex("(error|image|motion)\\..*"));
        EXPECT_EQ(is_error(figure), of_truth) << figure.path;
        EXPECT_EQ(is_time(figure), std::regex_match(figure.path, std::regex("time\\..*|prepare\\.ms"))) << figure.path;
    }
    EXPECT_EQ(find_figure("error.shadow.mean")->needs, (std::vector<std::string>{"truth", "lighting", "self_shadow"}));
    EXPECT_EQ(find_figure("motion.flip.mean")->needs, (std::vector<std::string>{"truth", "motion", "lighting"}));
    EXPECT_EQ(find_figure("error.wrong_surface")->needs, (std::vector<std::string>{"truth", "object"}));
}

/// "p99.9" and "median" of their labels, where these are percentiles over the pixels of one picture.
TEST(Figures, SayWhichPercentileTheyAre) {
    std::size_t percentiles = 0;
    for (const FigureDeclaration& figure : figures()) {
        const std::size_t comma = figure.label.rfind(", ");
        const std::string statistic = comma == std::string::npos ? "" : figure.label.substr(comma + 2);
        const bool is_percentile = statistic == "median" || std::regex_match(statistic, std::regex("p[0-9.]+"));
        // Those of outlines are over pixels of outlines.
        if (is_percentile && !figure.has_need(figure_needs::motion) && figure.unit != "pixels") {
            EXPECT_EQ(figure.percent_of_pixels, statistic == "median" ? 50 : std::stod(statistic.substr(1)))
                << figure.path;
            ++percentiles;
        } else {
            EXPECT_FALSE(figure.percent_of_pixels) << figure.path;
        }
    }
    EXPECT_GE(percentiles, 10U);
}

TEST(Figures, NameOnlyFiguresThatThereAre) {
    for (const FigureDeclaration& figure : figures()) {
        for (const std::string& other : {figure.over, figure.infinite_at_zero, figure.stand_in})
            EXPECT_TRUE(other.empty() || find_figure(other) != nullptr) << figure.path << " names " << other;
    }
}

/// Quoted paths of figures in a source file, comments left out.
std::set<std::string> quoted_paths(const std::filesystem::path& file) {
    static const std::regex path("\"((time|prepare|work|error|image|motion)\\.[a-z0-9_]+(\\.[a-z0-9_]+)*)\"");
    const std::string text = std::regex_replace(read_text_file(file), std::regex("//[^\n]*"), "");
    std::set<std::string> paths;
    for (std::sregex_iterator at(text.begin(), text.end(), path), end; at != end; ++at)
        paths.insert((*at)[1]);
    paths.erase("prepare.comp");  // a shader
    return paths;
}

TEST(Figures, AreNamedWhereTheyAreDeclaredAndWhereDefaultsAreChosen) {
    const std::filesystem::path harness = RELIEFBENCH_SOURCE_DIR "/harness";
    const std::set<std::string> chosen = quoted_paths(harness / "store/chosen_figures.hpp");
    EXPECT_GE(chosen.size(), 10U);
    for (const std::string& path : chosen)
        EXPECT_NE(find_figure(path), nullptr) << path << " is chosen as a default and is not declared";
    std::map<std::string, std::set<std::string>> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(harness)) {
        const std::string extension = entry.path().extension();
        if (extension != ".cpp" && extension != ".hpp") continue;
        for (const std::string& path : quoted_paths(entry.path())) {
            const std::string file = std::filesystem::relative(entry.path(), harness);
            if (file != "store/chosen_figures.hpp") files[path].insert(file);
        }
    }
    for (const auto& [path, named_in] : files) {
        if (find_figure(path) == nullptr) continue;
        EXPECT_EQ(named_in.size(), 1U) << path << " is named in " << testing::PrintToString(named_in);
        EXPECT_TRUE(named_in.begin()->starts_with("metrics/") || named_in.begin()->starts_with("store/")) << path;
    }
    for (const FigureDeclaration& figure : figures())
        EXPECT_TRUE(files.contains(figure.path)) << figure.path << " stands in no source as it is called";
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

Json record_with(const Json& figure) {
    Json list = figures_to_json();
    list.push_back(figure);
    return {{"figures", list}};
}

const Json torn_sides = {{"path", "error.torn_sides.mean"},    {"label", "Torn sides"},
                         {"unit", "fraction of footprint"},    {"better", "lower"},
                         {"needs", {"truth", "a later need"}}, {"a later key", 1},
                         {"percent_of_pixels", 12.5},          {"short_label", "torn p1"},
                         {"legend", "how far apart"}};

TEST(FiguresOfARun, AreThoseOfThisVersionWhereItDeclaresNoOthers) {
    EXPECT_EQ(figures_of_record(Json::object(), "run.json"), declared_figures());
    EXPECT_EQ(figures_of_record({{"figures", figures_to_json()}}, "run.json"), declared_figures());
}

TEST(FiguresOfARun, ThatALaterVersionDeclaredAreReadAndWritten) {
    const auto list = figures_of_record(record_with(torn_sides), "run.json");
    const FigureDeclaration* figure = list->find("error.torn_sides.mean");
    ASSERT_NE(figure, nullptr);
    EXPECT_EQ(figure->label, "Torn sides");
    EXPECT_EQ(figure->better, Better::lower);
    EXPECT_EQ(figure->percent_of_pixels, 12.5);
    EXPECT_EQ(figure->short_label, "torn p1");
    EXPECT_EQ(figure->legend, "how far apart");
    EXPECT_EQ(figures_of_record({{"figures", figures_to_json(list->all())}}, "run.json")->all().back().legend,
              figure->legend);
    EXPECT_TRUE(is_error(*figure));
    Json json = to_json(complete_cell());
    json["error"]["torn_sides"] = {{"mean", 0.25}};
    EXPECT_THAT(error_message([&] { parse_cell_result(json, "c"); }), testing::HasSubstr("unknown key \"torn_sides\""));
    const CellResult cell = parse_cell_result(json, "c", list);
    EXPECT_EQ(value_of(*figure, cell), 0.25);
    EXPECT_EQ(value_of(*find_figure("error.missed"), cell), 1) << "its own list has the same figures";
    EXPECT_FALSE(value_of(*figure, complete_cell())) << "this version's cells have none";
    EXPECT_EQ(to_json(cell), json);
}

TEST(FiguresOfARun, MayBeOfTimesAndOfNewGroups) {
    Json list = Json::array();
    for (const char* path :
         {"time.draw.p99_ms", "time.watts", "prepare.joules", "outline.mean.low", "outline.mean.high"})
        list.push_back({{"path", path}, {"label", path}, {"better", "lower"}});
    const auto figures = figures_of_record({{"figures", list}}, "run.json");
    Json json = to_json(complete_cell(figures));
    json["time"]["draw"]["p99_ms"] = 2;
    json["time"]["watts"] = 3;
    json["prepare"]["joules"] = 4;
    json["outline"] = {{"mean", {5, 6}}};
    json["time"]["quadtree"] = json["time"]["draw"];
    const CellResult cell = parse_cell_result(json, "c", figures);
    double expected = 2;
    for (const Json& figure : list)
        EXPECT_EQ(value_of(figure.at("path").get<std::string>(), cell), expected++) << figure;
    EXPECT_EQ(to_json(cell).at("outline"), Json::parse(R"({"mean": [5.0, 6.0]})"));
}

TEST(FiguresOfARun, ThatCannotStandInACellAreRefused) {
    const auto message = [](const char* key, const Json& value) {
        Json figure = torn_sides;
        figure[key] = value;
        return error_message([&] { figures_of_record(record_with(figure), "run.json"); });
    };
    const std::string place = fmt::format("run.json: $.figures[{}]", figures().size());
    EXPECT_THAT(message("path", 3), testing::StartsWith(place + ".path: expected a string"));
    for (const char* path :
         {"", "torn_sides", "error..mean", "axes.mean", "parameters.x", "error.", "a.b.c.d.e.f.g.h.i"})
        EXPECT_THAT(message("path", path), testing::StartsWith(place + ".path: expected a path")) << path;
    for (const char* path : {"error.missed.mean", "error.uv_texels", "time.draw"})
        EXPECT_THAT(message("path", path), testing::HasSubstr("cannot stand beside the others")) << path;
    EXPECT_THAT(message("better", "more"), testing::StartsWith(place + ".better: expected one of"));
    EXPECT_THAT(message("needs", "truth"), testing::StartsWith(place + ".needs: expected an array"));
    const Json many = Json::array_t(1001, torn_sides);
    EXPECT_THAT(error_message([&] {
                    figures_of_record({{"figures", many}}, "run.json");
                }),
                testing::HasSubstr("more figures than any version has"));
    EXPECT_THAT(error_message([] {
                    figures_of_record({{"figures", 3}}, "run.json");
                }),
                testing::HasSubstr("$.figures: expected an array"));
}

TEST(Figures, TheListOfTheScriptsIsThisOne) {
    const std::string file = RELIEFBENCH_SOURCE_DIR "/scripts/figures.json";
    EXPECT_EQ(Json::parse(read_text_file(file)), figures_to_json())
        << "write it again: reliefbench list figures --format json > scripts/figures.json";
}

}  // namespace
}  // namespace reliefbench
