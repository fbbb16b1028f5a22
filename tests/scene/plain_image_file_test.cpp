#include "scene/plain_image_file.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "image_writer.hpp"
#include "scene/image_file.hpp"
#include "scene/netpbm.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class PlainImageFile : public testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        write_text_file(folder_ / name, bytes);
        return folder_ / name;
    }
    std::string refusal(const std::string& name, const std::string& bytes) const {
        const std::filesystem::path path = write(name, bytes);
        return error_message([&] { read_plain_image(path); });
    }

    const TemporaryFolder folder_;
};

enum class ByteOrder { little, big };

std::string stored_floats(const std::vector<float>& values, ByteOrder order) {
    std::string bytes;
    for (const float value : values) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (int byte = 0; byte < 4; ++byte) {
            const int shift = 8 * (order == ByteOrder::little ? byte : 3 - byte);
            bytes += static_cast<char>(bits >> shift & 0xff);
        }
    }
    return bytes;
}

std::vector<std::uint16_t> noise(std::size_t count) {
    std::vector<std::uint16_t> values(count);
    for (std::size_t index = 0; index < count; ++index)
        values[index] = static_cast<std::uint16_t>(index * 40503 + index * index * 31);
    return values;
}

/// The reference is what the build with OpenImageIO makes of the same file.
void expect_same_as_full_build(const std::filesystem::path& path) {
    const RasterFile expected = read_raster_file(path);
    const RasterFile read = read_plain_image(path);
    EXPECT_EQ(read.size, expected.size) << path;
    EXPECT_EQ(read.bits, expected.bits) << path;
    EXPECT_EQ(read.channel_names, expected.channel_names) << path;
    EXPECT_EQ(read.notes, expected.notes) << path;
    EXPECT_EQ(read.full_scale, expected.full_scale) << path;
    EXPECT_EQ(read.values, expected.values) << path;
}

TEST_F(PlainImageFile, FloatMapsOfBothByteOrdersRunFromTheBottomUp) {
    const std::vector<float> bottom_row_first = {0.75f, 1.0f, 0.125f, 0.0f, -3.5f, 1e20f};
    const auto top_row_first = ElementsAre(0.0f, -3.5f, 1e20f, 0.75f, 1.0f, 0.125f);
    const auto little = write("little.pfm", "Pf\n3 2\n-1.0\n" + stored_floats(bottom_row_first, ByteOrder::little));
    EXPECT_THAT(read_plain_image(little).values, top_row_first);
    EXPECT_EQ(read_plain_image(little).bits, 32);
    EXPECT_THAT(read_plain_image(little).channel_names, ElementsAre("Y"));
    EXPECT_EQ(read_plain_image(little).values, read_with_openimageio(little));
    const auto big = write("big.pfm", "Pf\n3 2\n1.0\n" + stored_floats(bottom_row_first, ByteOrder::big));
    EXPECT_THAT(read_plain_image(big).values, top_row_first);
    EXPECT_EQ(read_plain_image(big).values, read_with_openimageio(big));
}

TEST_F(PlainImageFile, FloatMapsOfThreeChannelsAreInterleaved) {
    const std::vector<float> values = {0.5f, 0.25f, 0.75f, 1, 2, 3};
    const auto path = write("rgb.pfm", "PF\n1 2\n-1\n" + stored_floats(values, ByteOrder::little));
    EXPECT_THAT(read_plain_image(path).values, ElementsAre(1, 2, 3, 0.5f, 0.25f, 0.75f));
    EXPECT_THAT(read_plain_image(path).channel_names, ElementsAre("R", "G", "B"));
    EXPECT_EQ(read_plain_image(path).values, read_with_openimageio(path));
}

TEST_F(PlainImageFile, GreyAndColourMapsHaveTheirLargestValueAsFullScale) {
    // The comment, the tabs, and pixels that look like white space.
    const auto bytes = write("8.pgm", std::string("P5 # a comment\n2\t2 255\n\x0a\x20\x00\xff", 27));
    EXPECT_THAT(read_plain_image(bytes).values, ElementsAre(10, 32, 0, 255));
    EXPECT_EQ(read_plain_image(bytes).bits, 8);
    const auto words = write("16.pgm", std::string("P5\n2 1\n65535\n\x33\x33\xff\xff", 17));
    EXPECT_THAT(read_plain_image(words).values, ElementsAre(13107, 65535));
    EXPECT_EQ(read_plain_image(words).bits, 16);
    const auto tenths = write("tenths.pgm", std::string("P5\n3 1\n10\n\x00\x03\x0a", 13));
    EXPECT_THAT(read_plain_image(tenths).values, ElementsAre(0, 3, 10));
    const auto colour = write("8.ppm", std::string("P6\n1 1\n255\n\xff\x33\x00", 14));
    EXPECT_THAT(read_plain_image(colour).values, ElementsAre(255, 51, 0));
    EXPECT_EQ(read_plain_image(tenths).full_scale, 10);
    // OpenImageIO multiplies by a rounded reciprocal.
    const std::vector<float> fractions = read_with_openimageio(colour);
    for (std::size_t index = 0; index < fractions.size(); ++index)
        EXPECT_FLOAT_EQ(static_cast<float>(read_plain_image(colour).fraction(index)), fractions[index]);
    // A full build reads these files in the same way, since OpenImageIO 2.4 makes 65534 of 65535.
    for (const std::filesystem::path& path : {bytes, words, tenths, colour})
        expect_same_as_full_build(path);
}

TEST_F(PlainImageFile, PngGivesWhatAFullBuildGives) {
    for (int channels = 1; channels <= 4; ++channels) {
        const std::vector<std::uint16_t> words = noise(static_cast<std::size_t>(7 * 5 * channels));
        const std::vector<std::uint8_t> bytes(words.begin(), words.end());
        const std::filesystem::path path = folder_ / ("png" + std::to_string(channels) + ".png");
        write_with_openimageio<std::uint8_t>(path, {7, 5}, channels, bytes);
        expect_same_as_full_build(path);
        write_with_openimageio<std::uint16_t>(path, {7, 5}, channels, words);
        expect_same_as_full_build(path);
    }
}

TEST_F(PlainImageFile, WritesPngThatOthersRead) {
    RasterFile raster;
    raster.size = {4, 1};
    raster.channel_names = {"R", "G", "B"};
    raster.values = {-1, 0, 0.5f, 1, 2, 0.2f, 0.2f / 255, 0.6f / 255, 1, 0, 0, std::numeric_limits<float>::quiet_NaN()};
    write_plain_image(folder_ / "plain.png", raster);
    EXPECT_THAT(read_raster_file(folder_ / "plain.png").values,
                ElementsAre(0, 0, 128, 255, 255, 51, 0, 1, 255, 0, 0, 0));
    const std::filesystem::directory_iterator files(folder_.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "something was left beside it";
}

TEST_F(PlainImageFile, WritesFloatMapsThatOthersRead) {
    RasterFile raster;
    raster.size = {2, 3};
    raster.channel_names = {"Y"};
    raster.values = {0.1f, -2, 1e20f, 4, 5, 0.6f};
    write_plain_image(folder_ / "plain.pfm", raster);
    EXPECT_EQ(read_with_openimageio(folder_ / "plain.pfm"), raster.values);
    EXPECT_EQ(read_plain_image(folder_ / "plain.pfm").values, raster.values);
}

TEST_F(PlainImageFile, NamesTheFormatsItTakes) {
    EXPECT_THAT(refusal("heights.exr", "\x76\x2f\x31\x01 and so on"),
                AllOf(HasSubstr("heights.exr"), HasSubstr("PFM"), HasSubstr("OpenImageIO")));
    EXPECT_THAT(refusal("ascii.pgm", "P2\n1 1\n255\n3\n"), HasSubstr("binary PGM"));
    EXPECT_THAT(refusal("empty.pfm", ""), HasSubstr("empty.pfm"));
    EXPECT_THAT(error_message([&] { read_plain_image(folder_ / "missing.png"); }), HasSubstr("missing.png"));
    EXPECT_THAT(error_message([&] { read_plain_image(folder_.path()); }), HasSubstr("not a file"));

    RasterFile raster;
    raster.size = {1, 1};
    raster.channel_names = {"a", "b", "c", "d", "e"};
    raster.values.assign(5, 0);
    const auto message = [&](const std::string& name) {
        return error_message([&] { write_plain_image(folder_ / name, raster); });
    };
    EXPECT_THAT(message("layers.exr"), AllOf(HasSubstr("layers.exr"), HasSubstr(".png and .pfm")));
    EXPECT_THAT(message("layers.png"), HasSubstr("not 5"));
    EXPECT_THAT(message("layers.pfm"), HasSubstr("not 5"));
}

TEST_F(PlainImageFile, RefusesExcessBytes) {
    const auto fixture = [](const std::string& name) {
        return std::filesystem::path(RELIEFBENCH_SOURCE_DIR) / "tests/fixtures/heights" / name;
    };
    const auto message = [&](const std::string& name) {
        return error_message([&] { read_plain_image(fixture(name)); });
    };
    EXPECT_THAT(message("crlf.pgm"), HasSubstr("it has 1 byte more than its header says"));
    EXPECT_THAT(message("comment_last.pgm"), HasSubstr("it has 8 bytes more than its header says"));
    EXPECT_THAT(refusal("two.pgm", "P5 1 1 255\nxP5 1 1 255\ny"), HasSubstr("12 bytes more"));
    EXPECT_THAT(refusal("long.pgm", "P5 1 1 65535\nxyz"), HasSubstr("1 byte more"));
    EXPECT_THAT(refusal("long.ppm", "P6 1 1 255\nrgb\n"), HasSubstr("1 byte more"));
    EXPECT_THAT(refusal("long.pfm", "Pf\n1 1\n-1\n" + stored_floats({1}, ByteOrder::little) + "\n"),
                HasSubstr("1 byte more"));
}

TEST_F(PlainImageFile, ACommentMayStandBetweenHeaderAndPixels) {
    const auto two_pixels = ElementsAre(32, 10);
    // https://netpbm.sourceforge.net/doc/pgm.html: the line's end belongs to the comment. netpbm's programs: it is the
    // character between header and pixels.
    EXPECT_THAT(read_plain_image(write("page.pgm", "P5\n2 1\n255# depth\n\n \n")).values, two_pixels);
    EXPECT_THAT(read_plain_image(write("programs.pgm", "P5\n2 1\n255# depth\n \n")).values, two_pixels);
    EXPECT_THAT(read_plain_image(write("within.pgm", "P5 2# width\r1# height\n#\n255\n \n")).values, two_pixels);
    EXPECT_THAT(refusal("short.pgm", "P5\n2 1\n255# depth\n "), HasSubstr("fewer pixels"));
    EXPECT_THAT(refusal("long.pgm", "P5\n2 1\n255# depth\n   \n"), HasSubstr("more than its header"));
}

TEST_F(PlainImageFile, PngOfFewBitsPalettesAndTransparencyGivesWhatAFullBuildGives) {
    const std::filesystem::path pngs = std::filesystem::path(RELIEFBENCH_SOURCE_DIR) / "tests/fixtures/heights/png";
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(pngs)) {
        expect_same_as_full_build(entry.path());
        ++count;
    }
    EXPECT_EQ(count, 12);
    const RasterFile two_bits = read_plain_image(pngs / "grey2.png");
    EXPECT_EQ(two_bits.full_scale, 3);
    EXPECT_THAT(two_bits.values, ElementsAre(0, 1, 2, 3, 3, 2, 1, 0, 1, 1, 2, 2));
    const RasterFile turned = read_plain_image(pngs / "orientation6.png");
    EXPECT_EQ(turned.size, (Resolution{3, 4}));
    EXPECT_THAT(turned.notes, ElementsAre("orientation 6"));
    EXPECT_EQ(read_plain_header(pngs / "orientation6.png").size, turned.size);
    EXPECT_THAT(error_message([&] { read_plain_image(pngs / "grey2.png", {.part = "1", .channels = {}}); }),
                HasSubstr("no part '1'"));
}

TEST_F(PlainImageFile, RefusesDamagedFiles) {
    EXPECT_THAT(refusal("short.pfm", "Pf\n2 2\n-1\n" + stored_floats({1, 2, 3}, ByteOrder::little)),
                AllOf(HasSubstr("short.pfm"), HasSubstr("fewer pixels")));
    EXPECT_THAT(refusal("short.pgm", "P5\n2 2\n65535\n1234567"), HasSubstr("fewer pixels"));
    EXPECT_THAT(refusal("header.pfm", "Pf\n2 2\n"), HasSubstr("a number is due"));
    EXPECT_THAT(refusal("header.pgm", "P5\n2 2\n255"), HasSubstr("ends with its header"));
    EXPECT_THAT(refusal("words.pgm", "P5\ntwo 2\n255\n1234"), HasSubstr("a number is due"));
    EXPECT_THAT(refusal("scale.pfm", "Pf\n1 1\n0\n1234"), HasSubstr("scale"));
    EXPECT_THAT(refusal("scale.pfm", "Pf\n1 1\nnan\n1234"), HasSubstr("scale"));
    EXPECT_THAT(refusal("largest.pgm", "P5\n1 1\n65536\n1234"), HasSubstr("65535"));
    EXPECT_THAT(refusal("negative.pgm", "P5\n-1 1\n255\n1234"), HasSubstr("no pixels"));
    EXPECT_THAT(refusal("huge.ppm", "P6\n100000 100000\n255\n"), HasSubstr("huge.ppm"));

    const std::filesystem::path whole = folder_ / "whole.png";
    const std::vector<std::uint16_t> words = noise(64 * 64);
    write_with_openimageio<std::uint8_t>(whole, {64, 64}, 1, std::vector<std::uint8_t>(words.begin(), words.end()));
    const std::string bytes = read_text_file(whole);
    for (const double share : {0.1, 0.5, 0.9, 0.98}) {
        EXPECT_THAT(refusal("cut.png", bytes.substr(0, static_cast<std::size_t>(double(bytes.size()) * share))),
                    HasSubstr("cut.png"))
            << share;
    }
}

}  // namespace
}  // namespace reliefbench
