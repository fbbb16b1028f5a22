#include "report/page.hpp"

#include "comparison_sample.hpp"
#include "report/page_cells.hpp"
#include "report/page_comparison.hpp"
#include "report/page_pictures.hpp"
#include "report/page_samples.hpp"
#include "run_sample.hpp"
#include "store/figures.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include <cmath>
#include <limits>

namespace reliefbench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* empty_page = R"(<script id="data">"RELIEFBENCH_DATA"</script><p>after</p>)";

Json columns_of_sample() {
    return cells_to_columns(sample_run().cells);
}

TEST(PageCells, AFieldIsAColumnWithOneEntryPerCell) {
    const Json json = columns_of_sample();
    EXPECT_EQ(json.at("count"), 3);
    EXPECT_EQ(json.at("id").at(1), "tessellation | heightmap=bricks");
    EXPECT_EQ(json.at("words").at("technique").at("values"), Json({"pom", "tessellation", "mine"}));
    EXPECT_EQ(json.at("words").at("technique").at("index"), Json({0, 1, 2}));
    EXPECT_EQ(json.at("words").at("reason").at("index"), Json({-1, 0, 1}));
    EXPECT_EQ(json.at("words").at("reason_group"), json.at("words").at("reason"));
    EXPECT_EQ(json.at("axes").at("heightmap").at("values"), Json({"bricks, \"red\""}));
    EXPECT_EQ(json.at("axes").at("heightmap").at("index"), Json({0, -1, -1}));
    EXPECT_EQ(json.at("parameters").at("refine").at("values"), Json({true}));
    EXPECT_EQ(json.at("numbers").at("time.draw.ci95_ms.high"), Json({0.75, nullptr, nullptr}));
    EXPECT_EQ(json.at("numbers").at("error.uv_texels.p99"), Json({0.75, nullptr, nullptr}));
}

TEST(PageCells, ANumberThatNoCellHasIsLeftOutAndOneThatACellLacksIsNull) {
    const Json json = columns_of_sample();
    EXPECT_FALSE(json.at("numbers").contains("image.flip"));
    EXPECT_FALSE(json.at("numbers").contains("error.normal_deg"));
    EXPECT_EQ(json.at("numbers").at("image.psnr"), Json({30, nullptr, nullptr}));
    EXPECT_TRUE(cells_to_columns({}).at("numbers").empty());
}

TEST(PageCells, NumbersAreRoundedToSixDigitsAndPrintAsSuch) {
    EXPECT_EQ(rounded_number(5.073486083333333).dump(), "5.07349");
    EXPECT_EQ(rounded_number(1.355147105641663e-10).dump(), "1.35515e-10");
    EXPECT_EQ(rounded_number(123456789).dump(), "123456789");
    EXPECT_EQ(rounded_number(0).dump(), "0");
    EXPECT_TRUE(rounded_number(std::numeric_limits<double>::quiet_NaN()).is_null());
    EXPECT_TRUE(rounded_number(std::numeric_limits<double>::infinity()).is_null());
}

SamplesByRound rounds_of(int count) {
    SamplesByRound rounds;
    for (int round = 0; round < count; ++round) {
        rounds[round] = {1.0 * round, 1.0 * round + 2};
    }
    return rounds;
}

TEST(SampleGroups, ARoundIsAGroupWhileThereIsRoom) {
    const std::vector<SampleGroup> groups = group_samples(rounds_of(4), 4);
    ASSERT_EQ(groups.size(), 4U);
    EXPECT_EQ(groups[3].first_round, 3);
    EXPECT_EQ(groups[3].samples, 2U);
    EXPECT_THAT(groups[3].quantiles, ElementsAre(3, 3.5, 4, 4.5, 5));
}

TEST(SampleGroups, MoreRoundsThanGroupsGoTogetherInTheirOrder) {
    const std::vector<SampleGroup> groups = group_samples(rounds_of(7), 3);
    ASSERT_EQ(groups.size(), 3U);
    EXPECT_EQ(groups[0].samples, 6U);
    EXPECT_EQ(groups[1].first_round, 3);
    EXPECT_EQ(groups[2].first_round, 6);
    EXPECT_EQ(groups[2].samples, 2U);
    EXPECT_EQ(groups[0].quantiles.front(), 0);
    EXPECT_EQ(groups[0].quantiles.back(), 4);
    EXPECT_TRUE(group_samples({{0, {}}}, 3).empty());
}

TEST(PageSamples, GroupsOfACellFollowEachOther) {
    RunSamples samples;
    samples["draw"]["pom max_steps=16 | heightmap=bricks"] = rounds_of(2);
    samples["draw"]["not in this run"] = rounds_of(3);
    samples["quadtree"]["mine | heightmap=bricks"] = rounds_of(1);
    const Json json = samples_to_columns(samples, sample_run().cells);
    EXPECT_EQ(json.at(0).at("pass"), "draw");
    EXPECT_EQ(json.at(0).at("cell"), Json({0}));
    EXPECT_EQ(json.at(0).at("groups"), Json({2}));
    EXPECT_EQ(json.at(0).at("first_round"), Json({0, 1}));
    EXPECT_EQ(json.at(0).at("ms"), Json({0, 0.5, 1, 1.5, 2, 1, 1.5, 2, 2.5, 3}));
    EXPECT_EQ(json.at(1).at("cell"), Json({2}));
}

TEST(PageSamples, RunsOfManyCellsKeepFewGroupsOfEach) {
    std::vector<CellResult> cells(10'000);
    RunSamples samples;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        cells[cell].cell = fmt::format("pom | view_angle={}", cell);
        samples["draw"][cells[cell].cell] = rounds_of(40);
    }
    const Json json = samples_to_columns(samples, cells);
    EXPECT_EQ(json.at(0).at("groups").at(0), 6);
    EXPECT_LT(json.dump().size(), 4'000'000U);
}

PagePicture picture_of(int width, int height, const std::function<std::uint8_t(int at)>& value) {
    PagePicture picture{width, height, {}};
    for (int at = 0; at < 3 * width * height; ++at) {
        picture.rgb.push_back(value(at));
    }
    return picture;
}

std::vector<std::uint8_t> decoded(const std::string& base64_text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::uint8_t> bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char digit : base64_text) {
        if (digit == '=') break;
        bits = bits << 6 | static_cast<unsigned>(digits.find(digit));
        count += 6;
        if (count >= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (count -= 8)));
    }
    return bytes;
}

/// What the page does (report_page/src/pictures.ts).
std::vector<std::uint8_t> unpacked(const Json& pool, std::size_t at) {
    const Json& record = pool.at(at);
    const std::size_t pixels = record.at("width").get<std::size_t>() * record.at("height").get<std::size_t>();
    const std::vector<std::uint8_t> packed = decoded(record.at("data"));
    std::vector<std::uint8_t> bytes(3 * pixels);
    uLongf size = bytes.size();
    EXPECT_EQ(uncompress(bytes.data(), &size, packed.data(), packed.size()), Z_OK);
    if (record.at("packing") == "difference") {
        const std::vector<std::uint8_t> base = unpacked(pool, record.at("base"));
        for (std::size_t byte = 0; byte < bytes.size(); ++byte) {
            bytes[byte] = static_cast<std::uint8_t>(bytes[byte] + base[byte]);
        }
    } else if (record.at("packing") == "palette") {
        const std::vector<std::uint8_t> palette = decoded(record.at("palette"));
        std::vector<std::uint8_t> rgb;
        for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            const std::size_t index = bytes[pixel] + (size > pixels ? 256U * bytes[pixels + pixel] : 0U);
            rgb.insert(rgb.end(), {palette[3 * index], palette[3 * index + 1], palette[3 * index + 2]});
        }
        return rgb;
    }
    return bytes;
}

std::uint8_t noise(int at) {
    return static_cast<std::uint8_t>((static_cast<unsigned>(at) * 2654435761U) >> 13);
}

TEST(PagePictures, EveryPackingGivesBackEachPixel) {
    PagePictures pictures;
    const PagePicture truth = picture_of(61, 47, noise);
    const PagePicture near_truth =
        picture_of(61, 47, [](int at) { return static_cast<std::uint8_t>(noise(at) + (at % 97 == 0 ? 250 : 0)); });
    const PagePicture few_colours =
        picture_of(40, 31, [](int at) { return static_cast<std::uint8_t>(noise(at / 3) % 7 * 30); });
    const PagePicture many_colours = picture_of(
        64, 64, [](int at) { return static_cast<std::uint8_t>(at % 3 == 0 ? noise(at / 3) : noise(at / 3) % 2); });
    const std::size_t truth_at = pictures.add(truth);
    const std::size_t near_at = pictures.add(near_truth, truth_at);
    const std::size_t few_at = pictures.add(few_colours);
    const std::size_t many_at = pictures.add(many_colours);
    EXPECT_EQ(pictures.json().at(near_at).at("packing"), "difference");
    EXPECT_EQ(pictures.json().at(few_at).at("packing"), "palette");
    EXPECT_EQ(unpacked(pictures.json(), truth_at), truth.rgb);
    EXPECT_EQ(unpacked(pictures.json(), near_at), near_truth.rgb);
    EXPECT_EQ(unpacked(pictures.json(), few_at), few_colours.rgb);
    EXPECT_EQ(unpacked(pictures.json(), many_at), many_colours.rgb);
}

TEST(PagePictures, IndicesAboveAByteAreTwoPlanes) {
    PagePictures pictures;
    const PagePicture ramp = picture_of(64, 64, [](int at) {
        const int pixel = at / 3;
        return static_cast<std::uint8_t>(at % 3 == 0 ? pixel % 4 : at % 3 == 1 ? pixel / 4 % 128 : 0);
    });
    pictures.add(ramp);
    EXPECT_EQ(pictures.json().at(0).at("packing"), "palette");
    EXPECT_EQ(unpacked(pictures.json(), 0), ramp.rgb);
}

TEST(PagePictures, EqualPicturesAreKeptOnce) {
    PagePictures pictures;
    const PagePicture picture = picture_of(8, 8, noise);
    EXPECT_EQ(pictures.add(picture), pictures.add(picture));
    const std::size_t bytes = pictures.bytes();
    EXPECT_NE(pictures.add(picture_of(4, 16, noise)), 0U) << "of another shape";
    EXPECT_GT(pictures.bytes(), bytes);
    EXPECT_LT(pictures.bytes(), 2 * pictures.json().dump().size());
}

TEST(PagePictures, ThinningKeepsPixelsAsTheyAre) {
    const PagePicture thinned =
        every_nth_pixel(picture_of(5, 3, [](int at) { return static_cast<std::uint8_t>(at); }), 2);
    EXPECT_EQ(thinned.width, 3);
    EXPECT_EQ(thinned.height, 2);
    EXPECT_THAT(thinned.rgb, ElementsAre(0, 1, 2, 6, 7, 8, 12, 13, 14, 30, 31, 32, 36, 37, 38, 42, 43, 44));
}

TEST(PagePictures, Base64IsPadded) {
    EXPECT_EQ(base64({}), "");
    EXPECT_EQ(base64({'f'}), "Zg==");
    EXPECT_EQ(base64({'f', 'o'}), "Zm8=");
    EXPECT_EQ(base64({'f', 'o', 'o'}), "Zm9v");
    EXPECT_EQ(base64({0xFF, 0xFE, 0xFD, 0xFC}), "//79/A==");
}

TEST(Page, HoldsRunsWithAllThatIsKnownOfThem) {
    PageRun run;
    run.stored = {"results/mine", sample_run()};
    run.pictures.technique = {0, -1, -1};
    run.pictures.truth = {1, -1, -1};
    run.pictures.maps["error"] = {2, -1, -1};
    run.pictures.legends["error"] = {
        "UV error", "texels", 0.01, 10, true, {0, 0, 0, 255, 255, 255}, {0.01, 1}, {{{26, 89, 255}, "missed"}}};
    PageComparison failed;
    failed.base = {"results/mine"};
    failed.changed = {"results/other"};
    failed.failure = "another device";
    const Json json = page_data({run}, Json::array(), failed, "1.2.3");
    EXPECT_EQ(json.at("tool_version"), "1.2.3");
    ASSERT_EQ(json.at("figures").size(), figures().size());
    for (Json figure : json.at("figures")) {
        EXPECT_TRUE(figure.at("tolerance").at("relative").is_number());
        if (figure.at("path") == "image.footprint.flip") {
            EXPECT_EQ(figure.at("tolerance").at("absolute"), 0.002);
        }
        figure.erase("tolerance");
        EXPECT_THAT(figures_to_json(), testing::Contains(figure));
    }
    EXPECT_EQ(json.at("runs").at(0).at("record").at("device").at("name"), "llvmpipe");
    EXPECT_TRUE(json.at("runs").at(0).at("summary").is_null());
    EXPECT_EQ(json.at("runs").at(0).at("cautions"), Json::array());
    EXPECT_EQ(json.at("runs").at(0).at("pictures").at("maps").at("error"), Json({2, -1, -1}));
    EXPECT_EQ(json.at("runs").at(0).at("pictures").at("legends").at("error"),
              Json({{"title", "UV error"},
                    {"unit", "texels"},
                    {"dark", 0.01},
                    {"light", 10.0},
                    {"logarithmic", true},
                    {"colours", "AAAA////"},
                    {"marks", {0.01, 1}},
                    {"others", Json::array({{{"colour", {26, 89, 255}}, {"text", "missed"}}})}}));
    EXPECT_EQ(json.at("comparison").at("failure"), "another device");
    EXPECT_TRUE(json.at("comparison").at("result").is_null());
}

TEST(Page, ComparedCellsAreColumnsOfWhatIsShown) {
    const Comparison comparison = sample_comparison();
    std::vector<std::string> ids = {"of another run"};
    for (const CellComparison& cell : comparison.cells)
        ids.push_back(cell.cell);
    const Json json = comparison_to_columns(comparison, ids);
    const Json& cells = json.at("cells");
    EXPECT_EQ(cells.at("cell"), Json({1, 2, 3, 4, 5}));
    EXPECT_EQ(cells.at("verdict"), Json({"same", "slower", "undecided", "faster", "slower"}));
    EXPECT_EQ(cells.at("ratio"), Json({1.0004, 1.072, 1.03, 0.8, 2.5}));
    EXPECT_EQ(cells.at("low").at(1), 1.051);
    EXPECT_EQ(cells.at("high").at(1), 1.094);
    EXPECT_EQ(cells.at("reason").at(1), comparison.cells[1].reason);
    EXPECT_EQ(cells.at("quality").at(0), "worse");
    EXPECT_EQ(cells.at("quality").at(1), "mixed");
    ASSERT_EQ(cells.at("changes").size(), 4U);
    EXPECT_EQ(cells.at("changes").at(0).at(0), 0);
    const Json& changes = cells.at("changes").at(0).at(1);
    ASSERT_EQ(changes.size(), 2U) << "only changes for better or worse";
    EXPECT_EQ(changes.at(0).at("decides"), true);
    EXPECT_EQ(changes.at(0).at("text"), "worse by 8.0 %: error.uv_texels.p99 0.750 → 0.810 texels");
    EXPECT_EQ(changes.at(1).at("decides"), false);
    EXPECT_EQ(json.at("uncompared").size(), 3U);
}

TEST(Page, NoStringEndsTheElementThatHoldsTheData) {
    const Json data = {{"</script><script>alert(1)</script>", "<!-- <script> \xFF"}};
    const std::string page = fill_page(empty_page, data);
    const std::size_t begin = page.find('>') + 1;
    const std::string json = page.substr(begin, page.find("</script>") - begin);
    EXPECT_THAT(json, Not(HasSubstr("<")));
    EXPECT_EQ(Json::parse(json).begin().key(), data.begin().key());
    EXPECT_THAT(page, testing::EndsWith("</script><p>after</p>"));
}

TEST(Page, APageWithoutAPlaceForDataIsRefused) {
    EXPECT_THAT(error_message([] { fill_page("<html></html>", Json::object()); }), HasSubstr("report_page"));
}

}  // namespace
}  // namespace reliefbench
