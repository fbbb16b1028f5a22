#include "scene/image_file.hpp"

#include "core/error.hpp"
#include "image_writer.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class ImageFile : public testing::Test {
protected:
    const TemporaryFolder folder_;
};

void truncate_file(const std::filesystem::path& path, double share) {
    const auto size = static_cast<double>(std::filesystem::file_size(path));
    std::filesystem::resize_file(path, static_cast<std::uintmax_t>(size * share));
}

RasterFile ramp(Resolution size, std::vector<std::string> names) {
    RasterFile raster;
    raster.size = size;
    raster.channel_names = std::move(names);
    raster.values.resize(size.pixels() * raster.channel_names.size());
    for (std::size_t index = 0; index < raster.values.size(); ++index) {
        raster.values[index] = static_cast<float>(index) / static_cast<float>(raster.values.size() - 1);
    }
    return raster;
}

TEST_F(ImageFile, KeepsIntegersAndTheirFullScale) {
    write_with_openimageio<std::uint8_t>(folder_ / "8.png", {2, 2}, 1, {0, 51, 204, 255});
    const RasterFile bytes = read_raster_file(folder_ / "8.png");
    EXPECT_EQ(bytes.bits, 8);
    EXPECT_EQ(bytes.size, (Resolution{2, 2}));
    EXPECT_THAT(bytes.values, ElementsAre(0, 51, 204, 255));
    EXPECT_EQ(bytes.full_scale, 255);
    EXPECT_EQ(bytes.fraction(1), 0.2);

    write_with_openimageio<std::uint16_t>(folder_ / "16.png", {2, 1}, 1, {13107, 65535});
    const RasterFile words = read_raster_file(folder_ / "16.png");
    EXPECT_EQ(words.bits, 16);
    EXPECT_THAT(words.values, ElementsAre(13107, 65535));
    EXPECT_EQ(words.full_scale, 65535);
}

TEST_F(ImageFile, KeepsFloatsAsTheyAre) {
    write_with_openimageio<float>(folder_ / "float.exr", {2, 2}, 1, {-3.5f, 0.1f, 1.0f, 1e20f});
    const RasterFile raster = read_raster_file(folder_ / "float.exr");
    EXPECT_EQ(raster.bits, 32);
    EXPECT_THAT(raster.values, ElementsAre(-3.5f, 0.1f, 1.0f, 1e20f));
}

TEST_F(ImageFile, DoesNotMultiplyColourByAlpha) {
    write_with_openimageio<std::uint8_t>(folder_ / "rgba.png", {1, 2}, 4, {255, 51, 0, 0, 204, 255, 51, 51});
    const RasterFile raster = read_raster_file(folder_ / "rgba.png");
    EXPECT_THAT(raster.channel_names, ElementsAre("R", "G", "B", "A"));
    EXPECT_THAT(raster.values, ElementsAre(255, 51, 0, 0, 204, 255, 51, 51));
}

TEST_F(ImageFile, ExrKeepsNamedChannels) {
    const RasterFile written =
        ramp({5, 3}, {"hit.u", "hit.v", "hit.h", "hit.t", "taps", "color.R", "color.G", "color.B"});
    write_raster_file(folder_ / "layers.exr", written);
    const RasterFile read = read_raster_file(folder_ / "layers.exr");
    EXPECT_EQ(read.size, written.size);
    ASSERT_EQ(read.channels(), written.channels());
    for (int from = 0; from < written.channels(); ++from) {
        const auto found = std::find(read.channel_names.begin(), read.channel_names.end(), written.channel_names[from]);
        ASSERT_NE(found, read.channel_names.end()) << written.channel_names[from];
        const auto to = found - read.channel_names.begin();
        for (std::size_t pixel = 0; pixel < written.size.pixels(); ++pixel) {
            ASSERT_EQ(read.values[pixel * 8 + to], written.values[pixel * 8 + from]) << written.channel_names[from];
        }
    }
}

TEST_F(ImageFile, PngClampsAndRoundsToEightBits) {
    RasterFile raster = ramp({4, 1}, {"R", "G", "B"});
    raster.values = {-1, 0, 0.5f, 1, 2, 0.2f, 0.2f / 255, 0.6f / 255, 1, 0, 0, 0};
    write_raster_file(folder_ / "picture.png", raster);
    const RasterFile read = read_raster_file(folder_ / "picture.png");
    EXPECT_EQ(read.bits, 8);
    EXPECT_THAT(read.values, ElementsAre(0, 0, 128, 255, 255, 51, 0, 1, 255, 0, 0, 0));
}

TEST_F(ImageFile, LeavesNothingBesideWhatItWrote) {
    write_raster_file(folder_ / "picture.png", ramp({4, 4}, {"R", "G", "B"}));
    const std::filesystem::directory_iterator files(folder_.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST_F(ImageFile, RefusesToWriteWhatItCannot) {
    const RasterFile raster = ramp({2, 2}, {"R", "G", "B"});
    const auto message = [&](const std::string& name, const RasterFile& what) {
        return error_message([&] { write_raster_file(folder_ / name, what); });
    };
    EXPECT_THAT(message("picture.jpg", raster), AllOf(HasSubstr("picture.jpg"), HasSubstr(".exr")));
    EXPECT_THAT(message("no/such/folder/picture.png", raster), HasSubstr("no/such/folder/picture.png"));
    EXPECT_THAT(message("picture.png", ramp({2, 2}, {"a", "b", "c", "d", "e"})), HasSubstr("not 5"));
}

TEST_F(ImageFile, NamesWhatIsWrongWithAFile) {
    const auto message = [&](const std::string& name) {
        return error_message([&] { read_raster_file(folder_ / name); });
    };
    EXPECT_THAT(message("missing.png"), AllOf(HasSubstr("missing.png"), HasSubstr("no such file")));
    EXPECT_THAT(error_message([&] { read_raster_file(folder_.path()); }), HasSubstr("not a file"));

    std::ofstream(folder_ / "text.png") << "This is no picture at all, whatever its name says.\n";
    EXPECT_THAT(message("text.png"), HasSubstr("text.png"));
    std::ofstream(folder_ / "empty.png");
    EXPECT_THAT(message("empty.png"), HasSubstr("empty.png"));
}

TEST_F(ImageFile, RefusesTruncatedFiles) {
    std::vector<std::uint8_t> noise(128 * 128 * 3);
    for (std::size_t index = 0; index < noise.size(); ++index)
        noise[index] = std::uint8_t(index * index * 31 >> 7);
    for (const std::string name : {"cut.png", "cut.jpg", "cut.tif", "cut.exr"}) {
        write_with_openimageio<std::uint8_t>(folder_ / name, {128, 128}, 3, noise);
        EXPECT_NO_THROW(read_raster_file(folder_ / name)) << name;
        truncate_file(folder_ / name, 0.5);
        EXPECT_THROW(read_raster_file(folder_ / name), Error) << name;
    }
}

TEST_F(ImageFile, FormatsAreToldByContentAndOthersReachNoDecoder) {
    const std::vector<std::uint8_t> grey{0, 85, 170, 255};
    for (const std::string name : {"real.png", "real.tif", "real.exr", "real.jpg"}) {
        write_with_openimageio<std::uint8_t>(folder_ / name, {2, 2}, 1, grey);
        std::filesystem::rename(folder_ / name, folder_ / "named.gif");
        EXPECT_EQ(read_raster_file(folder_ / "named.gif").size, (Resolution{2, 2})) << name;
    }
    for (const std::string name : {"a.tga", "a.bmp", "a.gif", "a.hdr", "a.dpx", "a.sgi", "a.webp"}) {
        write_with_openimageio<std::uint8_t>(folder_ / name, {2, 2}, 3, std::vector<std::uint8_t>(12, 9));
        EXPECT_THAT(error_message([&] { read_raster_file(folder_ / name); }),
                    AllOf(HasSubstr(name), HasSubstr("it is not a PNG, JPEG, TIFF, OpenEXR, PFM,")));
    }
    const auto instead = [&](const char* name) { return error_message([&] { read_raster_file(folder_ / name); }); };
    EXPECT_THAT(instead("a.bmp"), HasSubstr("a BMP, which is not read: save it as PNG"));
    EXPECT_THAT(instead("a.webp"), HasSubstr("a WebP, which is not read: save it as PNG"));
    EXPECT_THAT(instead("a.hdr"), HasSubstr("a Radiance HDR, which is not read: save it as OpenEXR or PFM"));
    EXPECT_THAT(instead("a.tga"), HasSubstr("TGA is not read: save it as PNG"));
}

TEST_F(ImageFile, HeadersAreReadAlone) {
    write_with_openimageio<std::uint16_t>(folder_ / "map.png", {3, 2}, 1, std::vector<std::uint16_t>(6, 7));
    std::ofstream(folder_ / "map.ppm") << "P6\n# no pixels behind it\n300 200\n255\n";
    const RasterFile png = read_raster_header(folder_ / "map.png");
    EXPECT_EQ(png.size, (Resolution{3, 2}));
    EXPECT_EQ(png.bits, 16);
    EXPECT_TRUE(png.values.empty());
    const RasterFile ppm = read_raster_header(folder_ / "map.ppm");
    EXPECT_EQ(ppm.size, (Resolution{300, 200}));
    EXPECT_EQ(ppm.channels(), 3);
}

TEST_F(ImageFile, RefusesWhatMemoryDoesNotHoldBeforeItAllocates) {
    write_with_openimageio<std::uint8_t>(folder_ / "map.png", {1024, 1024}, 1,
                                         std::vector<std::uint8_t>(1024 * 1024, 7));
    setenv("RELIEFBENCH_MEMORY_MB", "5", 1);
    EXPECT_THAT(error_message([&] { read_raster_file(folder_ / "map.png"); }),
                AllOf(HasSubstr("1024x1024"), HasSubstr("takes 6 MB to read, and 5 MB is available")));
    unsetenv("RELIEFBENCH_MEMORY_MB");
    EXPECT_NO_THROW(read_raster_file(folder_ / "map.png"));
}

TEST_F(ImageFile, RefusesAbsurdSizesBeforeItAllocates) {
    // The header of a binary PPM that claims 10^10 pixels, and nothing behind it.
    std::ofstream(folder_ / "huge.ppm") << "P6\n100000 100000\n255\n";
    EXPECT_THAT(error_message([&] { read_raster_file(folder_ / "huge.ppm"); }), HasSubstr("huge.ppm"));
    std::ofstream(folder_ / "nothing.ppm") << "P6\n0 0\n255\n";
    EXPECT_THAT(error_message([&] { read_raster_file(folder_ / "nothing.ppm"); }), HasSubstr("nothing.ppm"));
}

/// Files of this process cannot grow beyond some bytes while it lives: as if the disk were full.
class SmallDisk {
public:
    explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SmallDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int);
};

TEST_F(ImageFile, AFullDiskIsAnErrorAndLeavesNothingBehind) {
    const RasterFile raster = ramp({64, 64}, {"R", "G", "B"});
    for (const char* name : {"picture.png", "picture.exr"}) {
        const std::filesystem::path path = folder_ / name;
        write_raster_file(path, raster);
        const std::uintmax_t whole = std::filesystem::file_size(path);
        std::filesystem::remove(path);
        const SmallDisk disk(whole / 2);
        EXPECT_THAT(error_message([&] { write_raster_file(path, raster); }), HasSubstr(path.string()));
        EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
    }
}

}  // namespace
}  // namespace reliefbench
