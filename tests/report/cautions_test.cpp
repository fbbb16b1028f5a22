#include "report/cautions.hpp"

#include "support/cell_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CellResult cell_of(const std::string& projection, double view_angle, double azimuth, double ties = 0) {
    CellResult cell;
    cell.cell = "pom | view_angle=60";
    cell.axes = {{"projection", projection}, {"view_angle", view_angle}, {"azimuth", azimuth}};
    set_figures(cell, {{"error.missed", 0}, {"error.false_hits", 0}});
    set_figure(cell, "error.ties", ties);
    return cell;
}

TEST(Cautions, RaysThatAllRunAlongTexelsAreNamed) {
    EXPECT_THAT(cautions({cell_of("parallel", 60, -90), cell_of("parallel", 75, 180)}),
                ElementsAre(HasSubstr("rows or columns of texels")));
    // One view off the axes shows what the others hide; head-on no ray goes anywhere.
    EXPECT_THAT(cautions({cell_of("parallel", 60, -90), cell_of("parallel", 60, -67)}), IsEmpty());
    EXPECT_THAT(cautions({cell_of("parallel", 60, -90), cell_of("perspective", 60, -90)}), IsEmpty());
    EXPECT_THAT(cautions({cell_of("parallel", 0, -90)}), IsEmpty());
    EXPECT_THAT(cautions({}), IsEmpty());
}

TEST(Cautions, ManyTiesAreNamedWithTheViewThatHasMost) {
    EXPECT_THAT(cautions({cell_of("perspective", 60, -90, 0.01)}), IsEmpty());
    EXPECT_THAT(cautions({cell_of("perspective", 60, -90, 0.125)}),
                ElementsAre(AllOf(HasSubstr("ties"), HasSubstr("view_angle=60"), HasSubstr("12 %"))));
}

TEST(Cautions, FiltersBesideAnUnfilteredTruthAreNamed) {
    Json record = Json::parse(R"({"configuration": {"truth": {"kind": "exact"}},
        "defaults": {"axes": {"material_filter": "lod0", "frames": 1, "samples_per_pixel": 1},
                     "parameters": {"pom": {"start_offset": "none"}}}})");
    CellResult cell = cell_of("perspective", 60, -90);
    cell.technique = "pom";
    set_figure(cell, "image.footprint.flip", 0.1);
    cell.axes.update({{"material_filter", "lod0"}, {"frames", 1}, {"samples_per_pixel", 1}});
    cell.parameters = {{"start_offset", "none"}};
    EXPECT_THAT(cautions({cell}, record), IsEmpty());
    CellResult filtered = cell;
    filtered.axes["material_filter"] = "mip";
    EXPECT_THAT(cautions({cell, filtered}, record),
                ElementsAre(AllOf(HasSubstr("a truth of one sample a pixel"), HasSubstr("material_filter is for"))));
    filtered.axes["frames"] = 16;
    filtered.parameters["start_offset"] = "blue_noise";
    EXPECT_THAT(cautions({filtered}, record),
                ElementsAre(HasSubstr("what material_filter, frames, start_offset are for")));
    record["configuration"]["truth"]["samples"] = 64;
    EXPECT_THAT(cautions({cell, filtered}, record), IsEmpty());
    record["configuration"]["truth"]["samples"] = 1;
    remove_figures(filtered, "image");
    EXPECT_THAT(cautions({filtered}, record), IsEmpty()) << "without pictures nothing is compared";
}

TEST(Cautions, ARunThatKnewNoTiesHasNone) {
    CellResult cell = cell_of("perspective", 60, -90);
    remove_figures(cell, "error.ties");
    EXPECT_THAT(cautions({cell}), IsEmpty());
}

}  // namespace
}  // namespace reliefbench
