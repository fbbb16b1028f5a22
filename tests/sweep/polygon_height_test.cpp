#include "fake_techniques.hpp"
#include "sweep/configuration.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::HasSubstr;

std::vector<Cell> cells_of(const std::string& axes) {
    const std::string text = R"({"techniques": ["plain"], "axes": {"heightmap": "rock", )" + axes + "}}";
    const std::vector<Manifest> techniques = fake_techniques();
    return expand(parse_configuration(parse_json(text, "test.json"), "test.json", {}, techniques), techniques);
}

TEST(PolygonHeightAxis, LowersTheCameraWithThePolygon) {
    const std::vector<Cell> cells = cells_of(R"("polygon_height": [1, 0.25], "height_scale": 0.2)");
    ASSERT_EQ(cells.size(), 2U);
    EXPECT_EQ(cells[0].id, "plain | heightmap=rock height_scale=0.2");
    EXPECT_EQ(cells[1].id, "plain | heightmap=rock height_scale=0.2 polygon_height=0.25");
    EXPECT_EQ(cells[0].view.view.camera.target_height, 0);
    EXPECT_DOUBLE_EQ(cells[1].view.view.camera.target_height, -0.75 * 0.2);
}

TEST(PolygonHeightAxis, SkipsCellsWhereReliefAboveThePolygonCannotBeDrawn) {
    const auto reason = [](const std::string& more) {
        return cells_of(R"("polygon_height": 0.5, )" + more).front().skip_reason;
    };
    EXPECT_EQ(reason(R"("view_angle": 60)"), "");
    EXPECT_THAT(reason(R"("base": "sphere")"), HasSubstr("known of the plane alone"));
    EXPECT_THAT(reason(R"("depth_write": "conservative")"), HasSubstr("nearer than it"));
    EXPECT_THAT(reason(R"("view_angle": 89, "height_scale": 0.2)"), HasSubstr("the eye would lie beneath"));
}

}  // namespace
}  // namespace reliefbench
