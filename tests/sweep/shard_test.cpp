#include "sweep/shard.hpp"

#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace reliefbench;

namespace {

/// Views of `cells_per_view` cells each; the side of a view's picture grows with its number.
std::vector<Cell> sweep(int views, int cells_per_view) {
    std::vector<Cell> cells;
    for (int view = 0; view < views; ++view) {
        for (int number = 0; number < cells_per_view; ++number) {
            Cell cell;
            cell.id = fmt::format("{} {}", view, number);
            cell.view.view.camera.view_angle = view;
            cell.view.view.resolution = {64 * (view + 1), 64};
            cells.push_back(cell);
        }
    }
    return cells;
}

std::vector<std::string> ids(const std::vector<Cell>& cells) {
    std::vector<std::string> result;
    for (const Cell& cell : cells)
        result.push_back(cell.id);
    return result;
}

TEST(Shard, IsWrittenAsItIsRead) {
    EXPECT_EQ(parse_shard("2/8"), (Shard{2, 8}));
    EXPECT_EQ(to_string(Shard{2, 8}), "2/8");
    for (const char* text : {"", "2", "0/4", "5/4", "2/", "/2", "a/b", "1/2/3", "-1/2", "1/0"}) {
        EXPECT_THAT(error_message([&] { parse_shard(text); }), testing::HasSubstr("2/8")) << text;
    }
}

TEST(Shard, EveryCellIsInExactlyOne) {
    std::vector<Cell> cells = sweep(13, 30);
    cells[5].skip_reason = "out of range";
    for (const std::size_t count : {1, 2, 3, 7, 100}) {
        std::multiset<std::string> all;
        for (std::size_t index = 1; index <= count; ++index) {
            for (const std::string& id : ids(cells_of_shard(cells, {index, count})))
                all.insert(id);
        }
        const std::vector<std::string> expected = ids(cells);
        EXPECT_EQ(all, std::multiset<std::string>(expected.begin(), expected.end()));
    }
    EXPECT_THAT(ids(cells_of_shard(cells, {1, 3})), testing::Contains(cells[5].id)) << "skipped cells are the first's";
}

TEST(Shard, BlocksStayWholeAndInOrder) {
    const std::vector<Cell> cells = sweep(8, 40);  // a block each
    for (std::size_t index = 1; index <= 3; ++index) {
        const std::vector<std::string> kept = ids(cells_of_shard(cells, {index, 3}));
        EXPECT_EQ(kept.size() % 40, 0U);
        for (std::size_t cell = 0; cell < kept.size(); cell += 40)
            EXPECT_EQ(kept[cell].substr(kept[cell].find(' ')), " 0");
        EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end(), [](const std::string& a, const std::string& b) {
            return std::stoi(a) < std::stoi(b);
        }));
    }
}

TEST(Shard, LoadsAreBalanced) {
    const std::vector<Cell> cells = sweep(40, 40);
    std::vector<std::size_t> sizes;
    for (std::size_t index = 1; index <= 4; ++index)
        sizes.push_back(cells_of_shard(cells, {index, 4}).size());
    EXPECT_THAT(sizes, testing::Each(testing::AllOf(testing::Ge(360U), testing::Le(440U))));
}

TEST(Shard, CellsThatCostMoreAreBalancedToo) {
    // One view in four has sixteen times the pixels of the others.
    std::vector<Cell> cells = sweep(64, 40);
    for (Cell& cell : cells) {
        const bool large = static_cast<int>(cell.view.view.camera.view_angle) % 4 == 3;
        cell.view.view.resolution = large ? Resolution{2048, 2048} : Resolution{512, 512};
    }
    for (std::size_t index = 1; index <= 4; ++index) {
        const std::vector<Cell> kept = cells_of_shard(cells, {index, 4});
        EXPECT_EQ(kept.size(), 16U * 40U);
        EXPECT_EQ(std::ranges::count_if(kept, [](const Cell& cell) { return cell.view.view.resolution.width == 2048; }),
                  4 * 40);
    }
}

TEST(Shard, NoneGetsAllViewsOfOneAngle) {
    std::vector<Cell> cells = sweep(64, 40);  // of four angles, say, over and over
    for (Cell& cell : cells)
        cell.view.view.resolution = {512, 512};
    for (std::size_t index = 1; index <= 4; ++index) {
        std::set<int> angles;
        for (const Cell& cell : cells_of_shard(cells, {index, 4}))
            angles.insert(static_cast<int>(cell.view.view.camera.view_angle) % 4);
        EXPECT_GE(angles.size(), 3U);
    }
}

}  // namespace
