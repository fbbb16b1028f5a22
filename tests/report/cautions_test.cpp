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

TEST(Cautions, ARunThatKnewNoTiesHasNone) {
    CellResult cell = cell_of("perspective", 60, -90);
    remove_figures(cell, "error.ties");
    EXPECT_THAT(cautions({cell}), IsEmpty());
}

}  // namespace
}  // namespace reliefbench
