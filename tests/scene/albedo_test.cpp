#include "scene/albedo.hpp"

#include "core/error.hpp"
#include "image_writer.hpp"
#include "scene/colour.hpp"
#include "scene/image_file.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"
#include "tiff_writer.hpp"

#include <gmock/gmock.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

using testing::HasSubstr;

class AlbedoFile : public testing::Test {
protected:
    const TemporaryFolder folder_;
};

HeightMap small_map() {
    Image<float> heights({2, 1});
    heights.texels = {0, 1};
    return make_height_map(heights, HeightFormat::r16, "two");
}

HeightMapSource with_albedo(const std::filesystem::path& path) {
    HeightMapSource source;
    source.albedo = path.string();
    return source;
}

/// What 16 bits lose, and no more.
constexpr double half_a_level = 0.5 / 65535 + 1e-7;

TEST_F(AlbedoFile, DecodesSrgbAndPutsTheBottomRowFirst) {
    write_with_openimageio<std::uint8_t>(folder_ / "colour.png", {1, 2}, 3, {255, 0, 0, 51, 102, 204});
    const Albedo albedo = load_albedo(with_albedo(folder_ / "colour.png"), small_map());
    EXPECT_EQ(albedo.format, Albedo::Format::unorm16);
    ASSERT_EQ(albedo.texels.size, (Resolution{1, 2}));
    const auto bottom = albedo.texels.at(0, 0);
    EXPECT_NEAR(bottom[0], srgb_decode(0.2), half_a_level);
    EXPECT_NEAR(bottom[1], srgb_decode(0.4), half_a_level);
    EXPECT_NEAR(bottom[2], srgb_decode(0.8), half_a_level);
    EXPECT_EQ(bottom[3], 1);
    EXPECT_EQ(albedo.texels.at(0, 1), (std::array<float, 4>{1, 0, 0, 1}));
}

TEST_F(AlbedoFile, ATransparentOrGreyImageIsAColourToo) {
    write_with_openimageio<std::uint8_t>(folder_ / "rgba.png", {1, 1}, 4, {255, 51, 0, 0});
    const auto clear = load_albedo(with_albedo(folder_ / "rgba.png"), small_map()).texels.at(0, 0);
    EXPECT_EQ(clear[0], 1);
    EXPECT_NEAR(clear[1], srgb_decode(0.2), half_a_level);
    EXPECT_EQ(clear[3], 1);

    write_with_openimageio<std::uint8_t>(folder_ / "grey.png", {1, 1}, 1, {51});
    const auto grey = load_albedo(with_albedo(folder_ / "grey.png"), small_map()).texels.at(0, 0);
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(grey[channel], srgb_decode(0.2), half_a_level);
}

TEST_F(AlbedoFile, StorageChangesNoColour) {
    constexpr int white_is_zero = 0;
    write_handmade_tiff(folder_ / "white.tif", {.width = 1, .values = {13107}, .photometric = white_is_zero});
    write_handmade_tiff(folder_ / "four.tif", {.width = 1, .values = {3}, .bits = 4});
    const auto red = [&](const char* name) {
        return load_albedo(with_albedo(folder_ / name), small_map()).texels.at(0, 0)[0];
    };
    EXPECT_NEAR(red("white.tif"), srgb_decode(0.8), half_a_level);
    EXPECT_NEAR(red("four.tif"), srgb_decode(0.2), half_a_level);
}

TEST_F(AlbedoFile, OfLayersTheOnlyColourPictureIsTaken) {
    const auto fixtures = std::filesystem::path(RELIEFBENCH_SOURCE_DIR) / "tests/fixtures/heights";
    const RasterFile layers = read_raster_file(fixtures / "layers.exr");
    ASSERT_EQ(layers.channel_names, (std::vector<std::string>{"albedo.R", "albedo.G", "albedo.B", "height.Y"}));
    const Albedo albedo = load_albedo(with_albedo(fixtures / "layers.exr"), small_map());
    for (std::size_t channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(albedo.texels.at(3, 4)[channel], srgb_decode(layers.values[3 * 4 + channel]), half_a_level);
    }
    EXPECT_THAT(error_message([&] { load_albedo(with_albedo(fixtures / "parts.exr"), small_map()); }),
                HasSubstr("2 parts (0 'beauty', 1 'height')"));
    RasterFile two;
    two.size = {1, 1};
    two.channel_names = {"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"};
    two.values.assign(6, 0.5F);
    write_raster_file(folder_ / "two.exr", two);
    EXPECT_THAT(error_message([&] {
                    albedo_size(with_albedo(folder_ / "two.exr"), {1, 1});
                }),
                HasSubstr("not one colour picture"));
}

TEST_F(AlbedoFile, AMissingFileIsNamed) {
    EXPECT_THAT(error_message([&] { load_albedo(with_albedo(folder_ / "none.png"), small_map()); }),
                HasSubstr("none.png"));
}

TEST(Albedo, DefaultGrowsLighterWithHeight) {
    const Albedo albedo = load_albedo({}, small_map());
    ASSERT_EQ(albedo.texels.size, (Resolution{2, 1}));
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_LT(albedo.texels.at(0, 0)[channel] + 0.3, albedo.texels.at(1, 0)[channel]);
    }
}

TEST(Albedo, SamplesBilinearlyAndRepeats) {
    Albedo albedo;
    albedo.texels = Image<std::array<float, 4>>({2, 2});
    albedo.texels.texels = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0.5f, 1}};
    EXPECT_THAT(albedo.sample(0.25, 0.25), testing::ElementsAre(0.0, 0.0, 0.0));
    EXPECT_THAT(albedo.sample(0.75, 0.75), testing::ElementsAre(1.0, 1.0, 0.5));
    EXPECT_THAT(albedo.sample(0.375, 0.75), testing::ElementsAre(0.25, 1.0, 0.125));
    EXPECT_THAT(albedo.sample(0.0, 0.5), testing::ElementsAre(0.5, 0.5, 0.125));
    EXPECT_THAT(albedo.sample(-2.0, 3.5), testing::ElementsAre(0.5, 0.5, 0.125));
}

}  // namespace
}  // namespace reliefbench
