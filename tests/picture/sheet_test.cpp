#include "picture/sheet.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

constexpr Rgb8 red{255, 0, 0};
constexpr Rgb8 blue{0, 0, 255};
constexpr Rgb8 green{0, 255, 0};

struct Box {
    int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
    int pixels = 0;
};

Box box_of(const Picture& picture, const Rgb8& colour) {
    Box box;
    for (int y = 0; y < picture.size.height; ++y) {
        for (int x = 0; x < picture.size.width; ++x) {
            if (picture.at(x, y) != colour) continue;
            box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y),
                   box.pixels + 1};
        }
    }
    return box;
}

TEST(Sheet, KeepsEveryPixelOfItsPicturesInRowsAndColumns) {
    Sheet sheet;
    sheet.title = "heightmap=bricks";
    sheet.columns = {{"truth", {}}, {"picture", Picture({40, 12}, green)}};
    sheet.rows.push_back({"steep", {"max_steps=15"}, {Picture({30, 20}, red), Picture({30, 20}, blue)}});
    sheet.rows.push_back(
        {"broken", {"a reason that is much longer than any place that there is for it in a label"}, {}});
    const Picture picture = draw_sheet(sheet, Font());
    const Box first = box_of(picture, red);
    const Box second = box_of(picture, blue);
    const Box legend = box_of(picture, green);
    EXPECT_EQ(first.pixels, 30 * 20);
    EXPECT_EQ(second.pixels, 30 * 20);
    EXPECT_EQ(legend.pixels, 40 * 12);
    EXPECT_EQ(first.top, second.top);
    EXPECT_GT(second.left, first.right);
    EXPECT_EQ(legend.left, second.left);
    EXPECT_GT(legend.top, second.bottom);
    EXPECT_GT(first.left, 40) << "labels stand at the left";
}

TEST(Sheet, WithoutLabelsLeavesNoRoomForThem) {
    Sheet sheet;
    sheet.columns = {{"a", {}}};
    sheet.rows.push_back({"", {}, {Picture({30, 20}, red)}});
    EXPECT_LT(box_of(draw_sheet(sheet, Font()), red).left, 20);
}

TEST(Picture, IsEncodedToSrgb) {
    // 0.5 linear is 0.7354 in sRGB (IEC 61966-2-1).
    const Picture picture = display_picture(Image<std::array<float, 3>>({1, 1}, {0.5F, 0.0F, 1.0F}));
    EXPECT_EQ(picture.at(0, 0), (Rgb8{188, 0, 255}));
}

TEST(Picture, PartsOutsideAreLeftOut) {
    Picture picture({4, 4}, red);
    fill(picture, {-2, -2, {4, 4}}, blue);
    EXPECT_EQ(box_of(picture, blue).pixels, 4);
    paste(picture, 3, 3, Picture({4, 4}, green));
    EXPECT_EQ(box_of(picture, green).pixels, 1);
    const Picture part = cropped(picture, {1, 1, {3, 3}});
    EXPECT_EQ(part.size, (Resolution{3, 3}));
    EXPECT_EQ(part.at(0, 0), blue);
    EXPECT_EQ(part.at(2, 2), green);
}

TEST(Picture, IsWrittenAsItIs) {
    Picture picture({2, 1});
    picture.texels = {Rgb8{0, 51, 255}, Rgb8{102, 0, 0}};
    const RasterFile raster = to_raster(picture);
    EXPECT_EQ(raster.values, (std::vector<float>{0, 0.2F, 1, 0.4F, 0, 0}));
}

}  // namespace
}  // namespace reliefbench
