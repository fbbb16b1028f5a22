#include "store/view_variants.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

CellResult cell_of(const std::string& view, Json axes) {
    CellResult cell;
    cell.cell = "pom | " + view;
    cell.axes = std::move(axes);
    return cell;
}

std::vector<std::pair<std::string, std::string>> split(const std::vector<CellResult>& cells) {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto& [view, variant] : view_variants(cells)) {
        pairs.emplace_back(view, variant);
    }
    return pairs;
}

using Pairs = std::vector<std::pair<std::string, std::string>>;

TEST(ViewVariants, WhatMovesNoHitIsTakenOutWhereItVaries) {
    EXPECT_EQ(split({cell_of("heightmap=a", {{"self_shadow", "off"}, {"soft_shadow", nullptr}, {"depth_write", "on"}}),
                     cell_of("heightmap=a self_shadow=soft soft_shadow=tatarchuk",
                             {{"self_shadow", "soft"}, {"soft_shadow", "tatarchuk"}, {"depth_write", "on"}}),
                     cell_of("heightmap=a tiling=2 self_shadow=hard",
                             {{"self_shadow", "hard"}, {"soft_shadow", nullptr}, {"depth_write", "on"}})}),
              (Pairs{{"heightmap=a", "self_shadow=off"},
                     {"heightmap=a", "self_shadow=soft soft_shadow=tatarchuk"},
                     {"heightmap=a tiling=2", "self_shadow=hard"}}));
}

TEST(ViewVariants, WhatIsTheSameEverywhereStaysInTheView) {
    EXPECT_EQ(split({cell_of("heightmap=a depth_write=off", {{"depth_write", "off"}}),
                     cell_of("heightmap=b depth_write=off", {{"depth_write", "off"}})}),
              (Pairs{{"heightmap=a depth_write=off", ""}, {"heightmap=b depth_write=off", ""}}));
}

TEST(ViewVariants, ARunThatDidNotKnowAnAxisHasItAtItsDefault) {
    EXPECT_EQ(split({cell_of("heightmap=a", {}), cell_of("heightmap=a depth_write=off", {{"depth_write", "off"}})}),
              (Pairs{{"heightmap=a", "depth_write=on"}, {"heightmap=a", "depth_write=off"}}));
    EXPECT_EQ(split({cell_of("heightmap=a", {}), cell_of("heightmap=a", {{"depth_write", "on"}})}),
              (Pairs{{"heightmap=a", ""}, {"heightmap=a", ""}}));
}

}  // namespace
}  // namespace reliefbench
