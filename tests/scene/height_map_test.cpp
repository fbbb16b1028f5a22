#include "scene/height_map.hpp"

#include "core/error.hpp"
#include "image_writer.hpp"
#include "scene/procedural.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <set>
#include <vector>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

Image<float> image(Resolution size, std::vector<float> texels) {
    Image<float> result(size);
    result.texels = std::move(texels);
    return result;
}

/// Four texels across, two up; row 0 (v = 0) first.
const Image<float> four_by_two = image({4, 2}, {0.0f, 0.25f, 0.5f, 1.0f,  //
                                                0.75f, 0.125f, 0.0f, 0.5f});

TEST(HeightMap, IsItsTexelsAtTheirCentres) {
    const HeightMap map = make_height_map(four_by_two, HeightFormat::r32f, "literal");
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 4; ++i)
            EXPECT_EQ(map.sample((i + 0.5) / 4, (j + 0.5) / 2), four_by_two.at(i, j));
    }
    EXPECT_EQ(map.sample(0.5 / 4, 0.5 / 2), 0.0);
    EXPECT_EQ(map.sample(3.5 / 4, 0.5 / 2), 1.0);
    EXPECT_EQ(map.sample(0.5 / 4, 1.5 / 2), 0.75);
}

TEST(HeightMap, IsBilinearBetweenTexels) {
    const HeightMap map = make_height_map(four_by_two, HeightFormat::r32f, "literal");
    EXPECT_DOUBLE_EQ(map.sample(1.0 / 4, 0.5 / 2), (0.0 + 0.25) / 2);
    EXPECT_DOUBLE_EQ(map.sample(2.5 / 4, 1.0 / 2), (0.5 + 0.0) / 2);
    EXPECT_DOUBLE_EQ(map.sample(3.0 / 4, 1.0 / 2), (0.5 + 1.0 + 0.0 + 0.5) / 4);
    // A quarter of the way from texel 0 to 1, three quarters from row 0 to 1.
    EXPECT_DOUBLE_EQ(map.sample(0.75 / 4, 1.25 / 2),
                     0.25 * (0.75 * 0.0 + 0.25 * 0.25) + 0.75 * (0.75 * 0.75 + 0.25 * 0.125));
}

TEST(HeightMap, RepeatsAcrossItsBorders) {
    const HeightMap map = make_height_map(four_by_two, HeightFormat::r32f, "literal");
    EXPECT_DOUBLE_EQ(map.sample(0.0, 0.25), (1.0 + 0.0) / 2);
    EXPECT_DOUBLE_EQ(map.sample(1.0, 0.25), (1.0 + 0.0) / 2);
    EXPECT_DOUBLE_EQ(map.sample(0.125, 0.0), (0.75 + 0.0) / 2);
    EXPECT_DOUBLE_EQ(map.sample(0.0, 1.0), (1.0 + 0.0 + 0.5 + 0.75) / 4);
    for (const double shift : {-3.0, -1.0, 1.0, 7.0}) {
        EXPECT_DOUBLE_EQ(map.sample(0.375 + shift, 0.625), map.sample(0.375, 0.625));
        EXPECT_DOUBLE_EQ(map.sample(0.375, 0.625 + shift), map.sample(0.375, 0.625));
    }
    EXPECT_EQ(map.texel(-1, -1), 0.5f);
    EXPECT_EQ(map.texel(4, 2), 0.0f);
    EXPECT_EQ(map.texel(-401, 1000001), 0.5f);
}

TEST(HeightMap, DerivativesAreCentralDifferences) {
    const HeightMap map = make_height_map(four_by_two, HeightFormat::r32f, "literal");
    const auto derivatives = height_derivatives(map);
    // Per texture coordinate: a difference over two texels, times the texels per side, halved.
    EXPECT_THAT(derivatives.at(1, 0), ElementsAre((0.5f - 0.0f) * 2, 0.0f));
    EXPECT_THAT(derivatives.at(0, 0), ElementsAre((0.25f - 1.0f) * 2, 0.0f));
    EXPECT_THAT(derivatives.at(3, 1), ElementsAre((0.75f - 0.0f) * 2, 0.0f));

    const HeightMap upright = make_height_map(image({1, 4}, {0.0f, 0.25f, 1.0f, 0.5f}), HeightFormat::r32f, "upright");
    const auto up = height_derivatives(upright);
    EXPECT_THAT(up.at(0, 0), ElementsAre(0.0f, (0.25f - 0.5f) * 2));
    EXPECT_THAT(up.at(0, 1), ElementsAre(0.0f, (1.0f - 0.0f) * 2));
}

TEST(HeightMap, QuantisesToWhatTheFormatStores) {
    EXPECT_EQ(quantise(0.5, HeightFormat::r8), 128 / 255.0f);
    EXPECT_EQ(quantise(0.1, HeightFormat::r8), 26 / 255.0f);
    EXPECT_EQ(quantise(0.5, HeightFormat::r16), 32768 / 65535.0f);
    EXPECT_EQ(quantise(0.1, HeightFormat::r16), 6554 / 65535.0f);
    EXPECT_EQ(quantise(0.1, HeightFormat::r32f), 0.1f);
    for (const HeightFormat format : {HeightFormat::r8, HeightFormat::r16, HeightFormat::r32f}) {
        EXPECT_EQ(quantise(0, format), 0);
        EXPECT_EQ(quantise(1, format), 1);
        EXPECT_EQ(parse_height_format(to_string(format)), format);
    }
    EXPECT_EQ(parse_height_format("r64"), std::nullopt);

    const HeightMap map = make_height_map(image({2, 1}, {0.1f, 0.75f}), HeightFormat::r8, "bytes");
    EXPECT_THAT(map.heights.texels, ElementsAre(26 / 255.0f, 191 / 255.0f));
}

TEST(HeightMap, HashTellsContentSizeAndFormatApart) {
    const auto hash = [](Resolution size, std::vector<float> texels, HeightFormat format, std::string name = "a") {
        return make_height_map(image(size, std::move(texels)), format, std::move(name)).hash;
    };
    const std::string base = hash({4, 1}, {0, 1, 0, 1}, HeightFormat::r16);
    EXPECT_EQ(hash({4, 1}, {0, 1, 0, 1}, HeightFormat::r16, "another name"), base);
    EXPECT_NE(hash({4, 1}, {0, 1, 1, 0}, HeightFormat::r16), base);
    EXPECT_NE(hash({2, 2}, {0, 1, 0, 1}, HeightFormat::r16), base);
    EXPECT_NE(hash({4, 1}, {0, 1, 0, 1}, HeightFormat::r8), base);
    // Equal once quantised.
    EXPECT_EQ(hash({4, 1}, {0, 1, 1e-6f, 1}, HeightFormat::r16), base);
}

TEST(HeightMap, RefusesNumbersThatAreNoHeights) {
    const auto message = [](float value) {
        return error_message([&] { make_height_map(image({2, 1}, {0, value}), HeightFormat::r16, "bad"); });
    };
    EXPECT_THAT(message(std::numeric_limits<float>::quiet_NaN()), AllOf(HasSubstr("bad"), HasSubstr("finite")));
    EXPECT_THAT(message(std::numeric_limits<float>::infinity()), HasSubstr("finite"));
    EXPECT_THAT(message(-0.01f), HasSubstr("[0, 1]"));
    EXPECT_THAT(message(1.01f), HasSubstr("[0, 1]"));
    EXPECT_THAT(error_message([] { make_height_map(Image<float>(), HeightFormat::r16, "none"); }),
                HasSubstr("1 to 16384"));
}

class HeightMapFile : public testing::Test {
protected:
    const TemporaryFolder folder_;
};

HeightMapSource source_of(const std::filesystem::path& path) {
    HeightMapSource source;
    source.name = path.string();
    return source;
}

TEST_F(HeightMapFile, BottomRowOfTheImageIsRowZero) {
    write_with_openimageio<std::uint8_t>(folder_ / "rows.png", {2, 3}, 1, {255, 204, 153, 102, 51, 0});
    const HeightMap map = load_height_map(source_of(folder_ / "rows.png"), HeightFormat::r8);
    EXPECT_THAT(map.heights.texels, ElementsAre(0.2f, 0.0f, 0.6f, 0.4f, 1.0f, 0.8f));
    EXPECT_DOUBLE_EQ(map.sample(0.25, 1.0 / 6), 0.2f);
    EXPECT_EQ(map.name, "rows.png");
    EXPECT_EQ(map.mapping, "as stored");
    EXPECT_FALSE(map.constant);
}

TEST_F(HeightMapFile, SixteenBitsKeepAllTheirValues) {
    std::vector<std::uint16_t> every(65536);
    for (std::size_t value = 0; value < every.size(); ++value)
        every[value] = static_cast<std::uint16_t>(value);
    write_with_openimageio(folder_ / "every.png", {256, 256}, 1, every);
    const HeightMap map = load_height_map(source_of(folder_ / "every.png"), HeightFormat::r16);
    for (int value = 0; value < 65536; ++value) {
        ASSERT_EQ(map.texel(value % 256, 255 - value / 256), static_cast<float>(value / 65535.0)) << value;
    }
}

TEST_F(HeightMapFile, ChannelIsChosenAndAlphaIsANumberLikeAnother) {
    write_with_openimageio<std::uint8_t>(folder_ / "rgba.png", {1, 2}, 4, {255, 204, 153, 51, 0, 51, 102, 0});
    HeightMapSource source = source_of(folder_ / "rgba.png");
    const std::vector<std::vector<float>> expected{{0, 1}, {0.2f, 0.8f}, {0.4f, 0.6f}, {0, 0.2f}};
    const std::vector<std::string> names{"R", "G", "B", "A"};
    for (std::size_t channel = 0; channel < 4; ++channel) {
        for (const std::string& choice : {std::to_string(channel), names[channel]}) {
            source.channel = choice;
            const HeightMap map = load_height_map(source, HeightFormat::r8);
            EXPECT_THAT(map.heights.texels, testing::ElementsAreArray(expected[channel]));
            EXPECT_EQ(map.mapping, "channel " + names[channel]);
        }
    }
    for (const char* choice : {"-1", "4", "Y"}) {
        source.channel = choice;
        EXPECT_THAT(error_message([&] { load_height_map(source, HeightFormat::r8); }),
                    AllOf(HasSubstr("rgba.png"), HasSubstr("no channel"), HasSubstr("R, G, B, A")));
    }
}

TEST_F(HeightMapFile, InvertTurnsHeightsOver) {
    write_with_openimageio<std::uint8_t>(folder_ / "map.png", {3, 1}, 1, {0, 51, 255});
    HeightMapSource source = source_of(folder_ / "map.png");
    source.invert = true;
    const HeightMap map = load_height_map(source, HeightFormat::r8);
    EXPECT_THAT(map.heights.texels, ElementsAre(1.0f, 0.8f, 0.0f));
    EXPECT_EQ(map.mapping, "inverted");
}

TEST_F(HeightMapFile, NormalizeStretchesToTheWholeRange) {
    write_with_openimageio<float>(folder_ / "map.exr", {3, 1}, 1, {-2, 0, 6});
    HeightMapSource source = source_of(folder_ / "map.exr");
    source.normalize = true;
    const HeightMap map = load_height_map(source, HeightFormat::r32f);
    EXPECT_THAT(map.heights.texels, ElementsAre(0.0f, 0.25f, 1.0f));
    EXPECT_EQ(map.mapping, "[-2, 6] → [0, 1]");
}

TEST_F(HeightMapFile, HeightRangeMapsAndClamps) {
    write_with_openimageio<float>(folder_ / "map.exr", {4, 1}, 1, {-5, 1, 2, 9});
    HeightMapSource source = source_of(folder_ / "map.exr");
    source.height_range = {0, 4};
    EXPECT_THAT(load_height_map(source, HeightFormat::r32f).heights.texels, ElementsAre(0.0f, 0.25f, 0.5f, 1.0f));
    source.invert = true;
    const HeightMap map = load_height_map(source, HeightFormat::r32f);
    EXPECT_THAT(map.heights.texels, ElementsAre(1.0f, 0.75f, 0.5f, 0.0f));
    EXPECT_EQ(map.mapping, "[0, 4] → [0, 1], inverted");
}

TEST_F(HeightMapFile, RefusesOptionsThatMakeNoSense) {
    write_with_openimageio<float>(folder_ / "map.exr", {2, 1}, 1, {0, 1});
    HeightMapSource source = source_of(folder_ / "map.exr");
    const auto message = [&] { return error_message([&] { load_height_map(source, HeightFormat::r16); }); };
    source.height_range = {1, 1};
    EXPECT_THAT(message(), HasSubstr("height_range"));
    source.height_range = {1, 0};
    EXPECT_THAT(message(), HasSubstr("invert"));
    source.height_range = {0, std::numeric_limits<double>::infinity()};
    EXPECT_THAT(message(), HasSubstr("finite"));
    source.height_range = {0, 1};
    source.normalize = true;
    EXPECT_THAT(message(), HasSubstr("normalize and height_range"));

    HeightMapSource procedural;
    procedural.name = "bricks";
    procedural.invert = true;
    EXPECT_THAT(error_message([&] { load_height_map(procedural, HeightFormat::r16); }), HasSubstr("procedural"));
}

TEST_F(HeightMapFile, RefusesValuesOutsideTheRangeThatNothingMaps) {
    write_with_openimageio<float>(folder_ / "map.exr", {2, 1}, 1, {0.5f, 1.25f});
    EXPECT_THAT(error_message([&] { load_height_map(source_of(folder_ / "map.exr"), HeightFormat::r16); }),
                AllOf(HasSubstr("map.exr"), HasSubstr("1.25"), HasSubstr("height_range"), HasSubstr("normalize")));
}

TEST_F(HeightMapFile, RefusesNaNAndInfinity) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
        write_with_openimageio<float>(folder_ / "map.exr", {2, 2}, 1, {0, 0.5f, bad, 1});
        HeightMapSource source = source_of(folder_ / "map.exr");
        for (source.normalize = false;; source.normalize = true) {
            EXPECT_THAT(error_message([&] { load_height_map(source, HeightFormat::r16); }),
                        AllOf(HasSubstr("map.exr"), HasSubstr("finite"), HasSubstr("column 0, row 0")));
            if (source.normalize) break;
        }
    }
}

TEST_F(HeightMapFile, RefusesFilesThatCannotBeRead) {
    std::ofstream(folder_ / "text.png") << "not an image\n";
    EXPECT_THAT(error_message([&] { load_height_map(source_of(folder_ / "text.png"), HeightFormat::r16); }),
                HasSubstr("text.png"));
    write_with_openimageio<std::uint8_t>(folder_ / "wide.png", {16385, 1}, 1, std::vector<std::uint8_t>(16385));
    EXPECT_THAT(error_message([&] { load_height_map(source_of(folder_ / "wide.png"), HeightFormat::r16); }),
                AllOf(HasSubstr("wide.png"), HasSubstr("16384")));
}

TEST_F(HeightMapFile, AConstantMapIsAWarning) {
    write_with_openimageio<std::uint8_t>(folder_ / "flat.png", {2, 2}, 1, {51, 51, 51, 51});
    HeightMapSource source = source_of(folder_ / "flat.png");
    testing::internal::CaptureStderr();
    const HeightMap map = load_height_map(source, HeightFormat::r8);
    EXPECT_THAT(testing::internal::GetCapturedStderr(), AllOf(HasSubstr("warning"), HasSubstr("flat.png")));
    EXPECT_TRUE(map.constant);
    EXPECT_EQ(map.texel(0, 0), 0.2f);

    source.normalize = true;
    EXPECT_EQ(load_height_map(source, HeightFormat::r8).texel(0, 0), 0.0f);
}

TEST(HeightMapName, AnUnknownOneIsAnErrorThatHelps) {
    HeightMapSource source;
    const auto message = [&] { return error_message([&] { load_height_map(source, HeightFormat::r16); }); };
    source.name = "cobles";
    EXPECT_THAT(message(), AllOf(HasSubstr("did you mean 'cobbles'?"), HasSubstr("waves")));
    source.name = "no/such/map.png";
    EXPECT_THAT(message(), AllOf(HasSubstr("no/such/map.png"), HasSubstr("no such file")));
}

TEST(HeightMapName, ProceduralSizesAreChecked) {
    HeightMapSource source;
    source.name = "rock";
    for (const Resolution size : {Resolution{0, 8}, Resolution{8, -1}, Resolution{16385, 8}}) {
        source.size = size;
        EXPECT_THAT(error_message([&] { load_height_map(source, HeightFormat::r16); }), HasSubstr("1 to 16384"));
    }
    source.size = {24, 10};
    const HeightMap map = load_height_map(source, HeightFormat::r16);
    EXPECT_EQ(map.heights.size, source.size);
    EXPECT_EQ(map.name, "rock");
    EXPECT_EQ(map.mapping, "as generated");
}

}  // namespace
}  // namespace reliefbench
