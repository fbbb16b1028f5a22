#include "report/figure_lines.hpp"

#include "support/cell_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace reliefbench {
namespace {

using testing::ElementsAre;

CellResult cell_with_figures() {
    CellResult cell;
    cell.time["draw"].median_ms = 3;
    set_figures(cell, {{"work.taps_mean", 17.5},
                       {"work.taps_p95", 18},
                       {"work.covered_pixels", 65536},
                       {"error.uv_texels.p50", 0.25},
                       {"error.uv_texels.p99", 1.5},
                       {"error.missed", 0.00125},
                       {"image.psnr", std::numeric_limits<double>::infinity()},
                       {"image.rmse", 0},
                       {"image.footprint.flip", 0.026034},
                       {"image.footprint.psnr", 26.1234},
                       {"image.footprint.ssim", 0.94},
                       {"image.footprint.rmse", 0.0495},
                       {"error.outside_quad.pixels", 640},
                       {"error.outside_quad.covered", 0}});
    return cell;
}

TEST(FigureLines, SayEachFigureButTimesByItsLabelWithThoseOfOneGroupTogether) {
    EXPECT_THAT(figure_lines(cell_with_figures()),
                ElementsAre("Taps per pixel: 17.50, p95 18.00", "Covered pixels: 65536 pixels",
                            "UV error: median 0.2500, p99 1.500 texels", "Missed hits: 0.1250 % of footprint",
                            "Relief outside the footprint: 640 pixels, 0 % covered", "Whole picture: PSNR ∞ dB, RMSE 0",
                            "Footprint: FLIP 0.02603, PSNR 26.12 dB, SSIM 0.9400, RMSE 0.04950"));
    EXPECT_THAT(figure_lines(CellResult()), testing::IsEmpty());
}

TEST(FigureLines, AreInTheOrderInWhichTheyAreAskedFor) {
    EXPECT_THAT(figure_lines(cell_with_figures(),
                             {"error.uv_texels.p99", "error.uv_texels.p50", "work.taps_mean", "error.shadow.mean"}),
                ElementsAre("UV error: p99 1.500, median 0.2500 texels", "Taps per pixel: 17.50"));
}

TEST(FigureLines, DoNotJoinWhatIsOfTwoGroups) {
    EXPECT_THAT(figure_lines(cell_with_figures(), {"image.footprint.flip", "work.taps_p95", "error.uv_texels.p50",
                                                   "image.rmse", "image.footprint.rmse"}),
                ElementsAre("FLIP: footprint 0.02603", "Taps per pixel: p95 18.00", "UV error: median 0.2500 texels",
                            "RMSE: whole picture 0", "RMSE: footprint 0.04950"));
}

}  // namespace
}  // namespace reliefbench
