#include "core/error.hpp"
#include "image_writer.hpp"
#include "scene/height_map.hpp"
#include "scene/image_file.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"
#include "tiff_writer.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::filesystem::path fixture(const std::string& name) {
    return std::filesystem::path(RELIEFBENCH_SOURCE_DIR) / "tests/fixtures/heights" / name;
}

HeightMapSource from(const std::filesystem::path& path) {
    HeightMapSource source;
    source.name = path.string();
    return source;
}

std::vector<float> heights_of(const HeightMapSource& source) {
    return load_height_map(source, HeightFormat::r32f).heights.texels;
}

std::string refusal_of(const HeightMapSource& source) {
    return error_message([&] { load_height_map(source, HeightFormat::r16); });
}

/// The fixtures of 7 × 5 numbers, put into their files by hand, rows from the top.
const std::vector<float> metres{0,    8848, 258,  5705, 2502, 6590, 1540, 5910, 3639, 1973, 984,  4155,
                                6715, 345,  6207, 726,  8614, 7991, 7804, 4119, 413,  2161, 4689, 548,
                                2906, 7854, 2967, 2621, 4788, 6519, 2781, 878,  6840, 3298, 3337};

/// Bottom row first, over 8848.
std::vector<float> shares_of_the_summit() {
    std::vector<float> shares;
    for (int row = 4; row >= 0; --row) {
        for (int column = 0; column < 7; ++column)
            shares.push_back(static_cast<float>(metres[static_cast<std::size_t>(row * 7 + column)] / 8848.0));
    }
    return shares;
}

class StoredNumbers : public testing::Test {
protected:
    HeightMapSource tiff(const HandmadeTiff& content) const {
        write_handmade_tiff(folder_ / "map.tif", content);
        return from(folder_ / "map.tif");
    }
    HeightMapSource bytes(const std::string& name, const std::string& content) const {
        write_text_file(folder_ / name, content);
        return from(folder_ / name);
    }

    const TemporaryFolder folder_;
};

TEST_F(StoredNumbers, ZeroMayBeWhiteInWhateverBits) {
    // TIFF 6.0: WhiteIsZero. Values of the file: 0, 65535, 258, ... in its top row.
    const std::vector<float> wide = heights_of(from(fixture("white_is_zero_16.tif")));
    EXPECT_EQ(wide[28], 1.0F);
    EXPECT_EQ(wide[29], 0.0F);
    EXPECT_EQ(wide[30], static_cast<float>(1.0 - 258 / 65535.0));
    EXPECT_EQ(wide[0], static_cast<float>(1.0 - 31335 / 65535.0));
    const std::vector<float> narrow = heights_of(from(fixture("white_is_zero_8.tif")));
    EXPECT_EQ(narrow[28], 1.0F);
    EXPECT_EQ(narrow[30], static_cast<float>(1.0 - 159 / 255.0));
    EXPECT_THAT(load_height_map(from(fixture("white_is_zero_8.tif")), HeightFormat::r16).mapping,
                HasSubstr("0 is white"));
    for (const int bits : {1, 4, 8, 12, 16, 32}) {
        const std::int64_t largest = (std::int64_t{1} << bits) - 1;
        EXPECT_THAT(heights_of(tiff({.width = 2, .values = {0, largest}, .bits = bits, .photometric = 0})),
                    ElementsAre(1.0F, 0.0F))
            << bits;
    }
    // 1.0 and 0.25 as floats.
    EXPECT_THAT(
        heights_of(tiff({.width = 2, .values = {0x3f800000, 0x3e800000}, .bits = 32, .format = 3, .photometric = 0})),
        ElementsAre(0.0F, 0.75F));
}

TEST_F(StoredNumbers, ZeroThatIsWhiteTurnsRangesOverAndLeavesAlpha) {
    HeightMapSource source = tiff({.width = 3, .values = {10, 20, 30}, .bits = 8, .photometric = 0});
    source.normalize = true;
    EXPECT_THAT(heights_of(source), ElementsAre(1.0F, 0.5F, 0.0F));
    source.normalize = false;
    source.height_range = {0, 40};
    EXPECT_THAT(heights_of(source), ElementsAre(0.75F, 0.5F, 0.25F));
    source.invert = true;
    EXPECT_THAT(heights_of(source), ElementsAre(0.25F, 0.5F, 0.75F));
    constexpr int extra_samples = 338;
    HeightMapSource alpha =
        tiff({.width = 1, .values = {0, 51}, .bits = 8, .photometric = 0, .channels = 2, .more = {{extra_samples, 2}}});
    EXPECT_THAT(heights_of(alpha), ElementsAre(1.0F));
    alpha.channel = "1";
    EXPECT_THAT(heights_of(alpha), ElementsAre(0.2F));
}

TEST_F(StoredNumbers, EveryDepthOfATiffIsExactOrRefused) {
    for (const bool big_endian : {false, true}) {
        for (int bits = 1; bits <= 64; ++bits) {
            const std::int64_t largest = bits < 63 ? (std::int64_t{1} << bits) - 1 : -1;
            const std::vector<std::int64_t> values{0, largest, largest / 3, largest / 2, bits > 1 ? 2 : 1, largest - 1};
            const HeightMapSource source = tiff({.width = 3, .values = values, .bits = bits, .big_endian = big_endian});
            constexpr std::array read{1, 2, 4, 8, 10, 12, 14, 16, 32};
            if (std::ranges::find(read, bits) == read.end()) {
                EXPECT_THAT(refusal_of(source), AllOf(HasSubstr("map.tif"), HasSubstr("bits"))) << bits;
                continue;
            }
            const RasterFile raster = read_raster_file(source.name);
            EXPECT_EQ(raster.full_scale, double(largest));
            for (std::size_t index = 0; index < values.size(); ++index)
                EXPECT_EQ(raster.values[index], static_cast<float>(values[index])) << bits;
        }
    }
    EXPECT_THAT(refusal_of(from(fixture("bits_24.tif"))), HasSubstr("integers of 24 bits are not read"));
    const std::vector<float> twelve = read_raster_file(fixture("bits_12.tif")).values;
    EXPECT_TRUE(std::ranges::all_of(twelve, [](float value) { return value == std::floor(value) && value <= 4095; }));
}

TEST_F(StoredNumbers, FloatsOf64BitsAndMixedSamplesAreRefused) {
    EXPECT_THAT(refusal_of(tiff({.width = 1, .values = {0}, .bits = 64, .format = 3})),
                HasSubstr("floating-point numbers of 64 bits are not read"));
    EXPECT_THAT(refusal_of(tiff({.width = 1, .values = {0}, .bits = 24, .format = 3})), HasSubstr("24 bits"));
    EXPECT_THAT(refusal_of(tiff({.width = 1, .values = {0}, .bits = 12, .format = 2})),
                HasSubstr("signed integers of 12 bits"));
    EXPECT_THAT(refusal_of(tiff({.width = 1, .values = {0}, .bits = 32, .format = 5})), HasSubstr("complex"));
    for (const int palette_inks_or_lab : {3, 5, 8}) {
        EXPECT_THAT(
            refusal_of(tiff(
                {.width = 1, .values = {1, 2, 3, 4}, .bits = 8, .photometric = palette_inks_or_lab, .channels = 4})),
            HasSubstr("PhotometricInterpretation"));
    }
}

TEST_F(StoredNumbers, HeightRangeIsInTheFilesOwnNumbersWhateverStoresThem) {
    for (const char* name : {"metres_uint16.tif", "metres_int16.tif", "metres_float.tif"}) {
        HeightMapSource source = from(fixture(name));
        source.height_range = {0, 8848};
        EXPECT_EQ(heights_of(source), shares_of_the_summit()) << name;
        source.height_range.reset();
        source.normalize = true;
        EXPECT_EQ(heights_of(source), shares_of_the_summit()) << name;
        EXPECT_THAT(load_height_map(source, HeightFormat::r16).mapping, HasSubstr("[0, 8848]"));
    }
    // 10-bit numbers of a PGM, 4-bit ones of a TIFF.
    HeightMapSource grey = bytes("ten.pgm", std::string("P5 2 1 1023\n\x01\x00\x02\x00", 16));
    grey.height_range = {256, 512};
    EXPECT_THAT(heights_of(grey), ElementsAre(0.0F, 1.0F));
    HeightMapSource four = tiff({.width = 3, .values = {3, 6, 12}, .bits = 4});
    four.height_range = {3, 15};
    EXPECT_THAT(heights_of(four), ElementsAre(0.0F, 0.25F, 0.75F));
}

TEST_F(StoredNumbers, MessagesSpeakInTheFilesOwnNumbers) {
    EXPECT_THAT(refusal_of(tiff({.width = 2, .values = {-86, 8848}, .format = 2})),
                AllOf(HasSubstr("values from -86 to 8848"), HasSubstr("[0, 32767]"), HasSubstr("height_range")));
    HeightMapSource old = tiff({.width = 3, .values = {9000, 20000, 60000}});
    old.height_range = {0.1, 0.8};
    EXPECT_THAT(refusal_of(old), AllOf(HasSubstr("values from 9000 to 60000"), HasSubstr("none inside height_range"),
                                       HasSubstr("own numbers")));
    old.height_range = {8000, 10000};
    testing::internal::CaptureStderr();
    heights_of(old);
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("2 of 3 texels lie outside height_range"));
}

TEST_F(StoredNumbers, TexelsWithoutDataAreNamedAndTakeNoPart) {
    HeightMapSource source = from(fixture("nodata.tif"));
    for (source.normalize = false;; source.normalize = true) {
        EXPECT_THAT(refusal_of(source), AllOf(HasSubstr("no data (-9999 or NaN) in 1 of 35 texels"),
                                              HasSubstr("column 3, row 2 from the bottom"), HasSubstr("\"fill\"")));
        if (source.normalize) break;
    }
    source.fill = 7991;
    testing::internal::CaptureStderr();
    EXPECT_EQ(heights_of(source), shares_of_the_summit());
    EXPECT_THAT(testing::internal::GetCapturedStderr(), AllOf(HasSubstr("warning"), HasSubstr("they get 7991")));
    // A filling takes no part in the range either.
    source.fill = -400;
    EXPECT_EQ(heights_of(source)[2 * 7 + 3], 0.0F);
    EXPECT_EQ(heights_of(source)[2 * 7 + 2], static_cast<float>(8614 / 8848.0));
}

TEST_F(StoredNumbers, NoDataIsTheFilesTheSourcesAndNaN) {
    const auto filled = [&](HeightMapSource source) {
        source.fill = 51;
        return heights_of(source);
    };
    EXPECT_THAT(filled(tiff({.width = 3, .values = {0, 7, 255}, .bits = 8, .nodata = "7"})),
                ElementsAre(0.0F, 0.2F, 1.0F));
    EXPECT_THAT(filled(tiff({.width = 3, .values = {0, 7, 255}, .bits = 8, .big_endian = true, .nodata = " 7.0 "})),
                ElementsAre(0.0F, 0.2F, 1.0F));
    HeightMapSource unread = tiff({.width = 3, .values = {0, 7, 255}, .bits = 8, .nodata = "-9999,0"});
    EXPECT_THAT(refusal_of(unread), HasSubstr("'-9999,0' (GDAL_NODATA), which is no number"));
    unread.nodata = 7;
    EXPECT_THAT(filled(unread), ElementsAre(0.0F, 0.2F, 1.0F));
    EXPECT_EQ(heights_of(tiff({.width = 1, .values = {0}, .bits = 8, .nodata = "-1.#QNAN"})).size(), 1U);
    HeightMapSource told = tiff({.width = 3, .values = {0, 7, 255}, .bits = 8});
    told.nodata = 0;
    EXPECT_THAT(filled(told), ElementsAre(0.2F, static_cast<float>(7 / 255.0), 1.0F));
    // The lowest float, as GDAL writes it; -inf stays an error.
    const std::int64_t lowest = 0xff7fffff;
    HeightMapSource floats = tiff({.width = 3,
                                   .values = {lowest, 0x7fc00000, 0x3f800000},
                                   .bits = 32,
                                   .format = 3,
                                   .nodata = "-3.4028234663852886e+38"});
    floats.fill = 0.5;
    EXPECT_THAT(heights_of(floats), ElementsAre(0.5F, 0.5F, 1.0F));
    HeightMapSource infinite = tiff({.width = 2, .values = {0xff800000, 0}, .bits = 32, .format = 3});
    infinite.fill = 0.5;
    EXPECT_THAT(refusal_of(infinite), HasSubstr("finite"));
    HeightMapSource nothing = tiff({.width = 1, .values = {7}, .bits = 8, .nodata = "7"});
    nothing.fill = 0;
    EXPECT_THAT(refusal_of(nothing), HasSubstr("in any texel"));
}

TEST_F(StoredNumbers, AnOrientationTagTurnsThePicture) {
    constexpr int orientation = 274;
    // Stored rows 0 1 2 and 3 4 5. The picture of each orientation, rows from the top, by TIFF 6.0's table.
    const std::vector<std::vector<float>> shown{{0, 1, 2, 3, 4, 5}, {2, 1, 0, 5, 4, 3}, {5, 4, 3, 2, 1, 0},
                                                {3, 4, 5, 0, 1, 2}, {0, 3, 1, 4, 2, 5}, {3, 0, 4, 1, 5, 2},
                                                {5, 2, 4, 1, 3, 0}, {2, 5, 1, 4, 0, 3}};
    for (int number = 1; number <= 8; ++number) {
        const HeightMapSource source =
            tiff({.width = 3, .values = {0, 1, 2, 3, 4, 5}, .bits = 8, .more = {{orientation, number}}});
        const RasterFile raster = read_raster_file(source.name);
        EXPECT_EQ(raster.values, shown[static_cast<std::size_t>(number - 1)]) << number;
        EXPECT_EQ(raster.size, number > 4 ? (Resolution{2, 3}) : (Resolution{3, 2})) << number;
        EXPECT_EQ(height_map_size(source), raster.size) << number;
    }
    OIIO::ImageSpec spec(16, 8, 1, OIIO::TypeDesc::UINT8);
    spec.attribute("Orientation", 6);
    const auto output = OIIO::ImageOutput::create("a.jpg");
    ASSERT_TRUE(output->open((folder_ / "turned.jpg").string(), spec));
    std::vector<std::uint8_t> left_is_white(128);
    for (std::size_t pixel = 0; pixel < 128; ++pixel)
        left_is_white[pixel] = pixel % 16 < 8 ? 255 : 0;
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, left_is_white.data()) && output->close());
    const RasterFile turned = read_raster_file(folder_ / "turned.jpg");
    ASSERT_EQ(turned.size, (Resolution{8, 16}));
    EXPECT_GT(turned.values.front(), 250);  // the left side is the top
    EXPECT_LT(turned.values.back(), 5);
}

TEST_F(StoredNumbers, AnExrIsItsDisplayWindow) {
    HeightMapSource whole = from(fixture("parts.exr"));
    whole.part = "height";
    const Image<float> seven = load_height_map(whole, HeightFormat::r32f).heights;
    ASSERT_EQ(seven.size, (Resolution{7, 5}));
    const HeightMap shown = load_height_map(from(fixture("overscan.exr")), HeightFormat::r32f);
    ASSERT_EQ(shown.heights.size, (Resolution{5, 3}));
    EXPECT_EQ(height_map_size(from(fixture("overscan.exr"))), (Resolution{5, 3}));
    EXPECT_EQ(shown.mapping, "display window");
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x)
            EXPECT_EQ(shown.heights.at(x, y), seven.at(x + 1, y + 1));
    }
}

TEST_F(StoredNumbers, AnExrWithFewerPixelsThanItsDisplayWindowIsPaddedAndTold) {
    OIIO::ImageSpec spec(2, 1, 1, OIIO::TypeDesc::FLOAT);
    spec.x = 1;
    spec.y = 2;
    spec.full_width = 4;
    spec.full_height = 3;
    const auto write = [&] {
        const auto output = OIIO::ImageOutput::create("a.exr");
        const std::vector<float> values{0.25F, 0.75F};
        return output->open((folder_ / "crop.exr").string(), spec) &&
               output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close();
    };
    ASSERT_TRUE(write());
    testing::internal::CaptureStderr();
    EXPECT_THAT(heights_of(from(folder_ / "crop.exr")), ElementsAre(0, 0.25F, 0.75F, 0, 0, 0, 0, 0, 0, 0, 0, 0));
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("has 2 of the 12 pixels of its display window"));
    spec.x = 10;
    ASSERT_TRUE(write());
    EXPECT_THAT(refusal_of(from(folder_ / "crop.exr")), HasSubstr("outside its display window"));
}

TEST_F(StoredNumbers, PartsAreChosenByNameOrNumber) {
    HeightMapSource source = from(fixture("parts.exr"));
    EXPECT_THAT(refusal_of(source), AllOf(HasSubstr("2 parts (0 'beauty', 1 'height')"), HasSubstr("\"part\"")));
    EXPECT_THAT(error_message([&] { height_map_size(source); }), HasSubstr("2 parts"));
    source.part = "height";
    const std::vector<float> named = heights_of(source);
    EXPECT_EQ(named[29], 1.0F);  // the top row begins with 0, 1
    EXPECT_EQ(named[28], 0.0F);
    source.part = "1";
    EXPECT_EQ(heights_of(source), named);
    source.part = "hight";
    EXPECT_THAT(refusal_of(source), HasSubstr("did you mean 'height'?"));
    source.part = "2";
    EXPECT_THAT(refusal_of(source), HasSubstr("no part '2'"));

    HeightMapSource layer = from(fixture("layers.exr"));
    EXPECT_THAT(refusal_of(layer),
                AllOf(HasSubstr("albedo.R, albedo.G, albedo.B, height.Y"), HasSubstr("\"channel\"")));
    layer.channel = "height.Y";
    EXPECT_EQ(heights_of(layer), named);
    layer.channel = "3";
    EXPECT_EQ(heights_of(layer), named);
    EXPECT_EQ(load_height_map(layer, HeightFormat::r16).mapping, "channel height.Y");
    layer.channel = "height.X";
    EXPECT_THAT(refusal_of(layer), HasSubstr("did you mean 'height.Y'?"));
    layer.part = "0";
    layer.channel = "height.Y";
    EXPECT_EQ(heights_of(layer), named);
}

TEST_F(StoredNumbers, PagesAreChosenAndSmallerCopiesAreNone) {
    const auto write = [&](const std::vector<int>& kinds) {
        const auto output = OIIO::ImageOutput::create("a.tif");
        std::uint8_t value = 0;
        for (const int kind : kinds) {
            OIIO::ImageSpec spec(1, 1, 1, OIIO::TypeDesc::UINT8);
            spec.attribute("tiff:subfiletype", kind);
            const auto mode = value == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage;
            value = static_cast<std::uint8_t>(value + 51);
            ASSERT_TRUE(output->open((folder_ / "pages.tif").string(), spec, mode));
            ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, &value));
        }
        ASSERT_TRUE(output->close());
    };
    write({0, 1, 4});
    HeightMapSource source = from(folder_ / "pages.tif");
    EXPECT_THAT(heights_of(source), ElementsAre(0.2F));
    source.part = "1";
    EXPECT_THAT(heights_of(source), ElementsAre(0.4F));
    write({2, 2, 2});
    source.part.clear();
    EXPECT_THAT(refusal_of(source), HasSubstr("has 3 parts (0, 1, 2)"));
    source.part = "2";
    EXPECT_THAT(heights_of(source), ElementsAre(0.6F));
}

TEST_F(StoredNumbers, ChannelsOfOneExrMayHaveSeveralNumberFormats) {
    OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"depth.Z", "id", "light.Y"};
    spec.channelformats = {OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::UINT32, OIIO::TypeDesc::HALF};
    const auto output = OIIO::ImageOutput::create("a.exr");
    ASSERT_TRUE(output->open((folder_ / "mixed.exr").string(), spec));
    struct {
        float depth = 0.5F;
        std::uint32_t id = 12;
        std::uint16_t half = 0x3400;  // 0.25
    } pixel;
    std::vector<std::uint8_t> native(10);
    std::memcpy(native.data(), &pixel, native.size());
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UNKNOWN, native.data()) && output->close());
    HeightMapSource source = from(folder_ / "mixed.exr");
    source.channel = "depth.Z";
    EXPECT_THAT(heights_of(source), ElementsAre(0.5F));
    source.channel = "light.Y";
    EXPECT_THAT(heights_of(source), ElementsAre(0.25F));
    source.channel = "id";
    source.height_range = {10, 14};
    EXPECT_THAT(heights_of(source), ElementsAre(0.5F));
    EXPECT_THAT(error_message([&] { read_raster_file(folder_ / "mixed.exr"); }), HasSubstr("number format"));
}

TEST_F(StoredNumbers, AColourPictureForHeightsIsAWarning) {
    write_with_openimageio<std::uint8_t>(folder_ / "normals.png", {1, 1}, 3, {51, 102, 255});
    HeightMapSource source = from(folder_ / "normals.png");
    testing::internal::CaptureStderr();
    EXPECT_THAT(heights_of(source), ElementsAre(0.2F));
    EXPECT_THAT(testing::internal::GetCapturedStderr(), AllOf(HasSubstr("colour picture"), HasSubstr("\"channel\"")));
    testing::internal::CaptureStderr();
    source.channel = "G";
    EXPECT_THAT(heights_of(source), ElementsAre(0.4F));
    write_with_openimageio<std::uint8_t>(folder_ / "grey.png", {2, 1}, 4, {51, 51, 51, 9, 255, 255, 255, 0});
    EXPECT_THAT(heights_of(from(folder_ / "grey.png")), ElementsAre(0.2F, 1.0F));
    EXPECT_THAT(testing::internal::GetCapturedStderr(), Not(HasSubstr("colour")));
}

TEST_F(StoredNumbers, PackedBytesAreOneNumber) {
    write_with_openimageio<std::uint8_t>(folder_ / "packed.png", {2, 1}, 3, {34, 144, 9, 0, 1, 255});
    HeightMapSource source = from(folder_ / "packed.png");
    source.packing = Packing::rg16;
    EXPECT_THAT(heights_of(source),
                ElementsAre(static_cast<float>((34 * 256 + 144) / 65535.0), static_cast<float>(1 / 65535.0)));
    source.height_range = {1, 34 * 256 + 144};
    EXPECT_THAT(heights_of(source), ElementsAre(1.0F, 0.0F));
    EXPECT_THAT(load_height_map(source, HeightFormat::r16).mapping, HasSubstr("packed rg16"));
    source.packing = Packing::rgb24;
    source.height_range = {0, (34 * 256 + 144) * 256 + 9};
    EXPECT_THAT(heights_of(source), ElementsAre(1.0F, static_cast<float>(511.0 / 2265097)));
    write_with_openimageio<std::uint8_t>(folder_ / "grey.png", {1, 1}, 1, {51});
    HeightMapSource grey = from(folder_ / "grey.png");
    grey.packing = Packing::rg16;
    EXPECT_THAT(refusal_of(grey), AllOf(HasSubstr("packing"), HasSubstr("R, G")));
    write_with_openimageio<std::uint16_t>(folder_ / "wide.png", {1, 1}, 3, {1, 2, 3});
    grey.name = (folder_ / "wide.png").string();
    EXPECT_THAT(refusal_of(grey), HasSubstr("8 bits"));
}

TEST_F(StoredNumbers, FilesWithoutAHeaderHaveTheSizeThatTheyAreGiven) {
    const std::string two_words("\x01\x00\x00\x80", 4);
    HeightMapSource source = bytes("map.r16", two_words);
    EXPECT_THAT(refusal_of(source), HasSubstr("\"size\""));
    source.raw = RawLayout{.size = {1, 2}};
    // The first row is the top one.
    EXPECT_THAT(heights_of(source), ElementsAre(static_cast<float>(32768 / 65535.0), static_cast<float>(1 / 65535.0)));
    EXPECT_EQ(height_map_size(source), (Resolution{1, 2}));
    source.raw->big_endian = true;
    EXPECT_THAT(heights_of(source), ElementsAre(static_cast<float>(128 / 65535.0), static_cast<float>(256 / 65535.0)));
    source.raw = RawLayout{.size = {4, 1}, .sample_type = RawLayout::SampleType::uint8};
    EXPECT_THAT(heights_of(source), ElementsAre(static_cast<float>(1 / 255.0), 0, 0, static_cast<float>(128 / 255.0)));
    source.raw = RawLayout{.size = {2, 1}, .sample_type = RawLayout::SampleType::int16};
    source.height_range = {-32768, 32768};
    EXPECT_THAT(heights_of(source), ElementsAre(static_cast<float>(32769 / 65536.0), 0));
    // A void of SRTM, as its .hgt files have it.
    source.height_range = {0, 4};
    source.nodata = -32768;
    source.fill = 2;
    EXPECT_THAT(heights_of(source), ElementsAre(0.25F, 0.5F));
    HeightMapSource floats = bytes("map.r32", std::string("\x00\x00\x80\x3e", 4));
    floats.raw = RawLayout{.size = {1, 1}, .sample_type = RawLayout::SampleType::float32};
    EXPECT_THAT(heights_of(floats), ElementsAre(0.25F));

    HeightMapSource wrong = from(folder_ / "map.r16");
    for (const Resolution size : {Resolution{1, 1}, Resolution{3, 1}, Resolution{16384, 16384}}) {
        wrong.raw = RawLayout{.size = size};
        EXPECT_THAT(refusal_of(wrong), AllOf(HasSubstr("it has 4 bytes"), HasSubstr("sample_type")));
        EXPECT_THAT(error_message([&] { height_map_size(wrong); }), HasSubstr("it has 4 bytes"));
    }
}

}  // namespace
}  // namespace reliefbench
