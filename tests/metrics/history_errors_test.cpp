#include "metrics/history_errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace reliefbench {
namespace {

using Colours = Image<std::array<float, 3>>;

constexpr Resolution size{40, 30};

Colours plain(float grey) {
    return Colours(size, {grey, grey, grey});
}

/// Every pixel's point lies so many columns farther right in the next frame.
Image<Landing> landings_by(float columns) {
    Image<Landing> landings(size);
    const int whole = static_cast<int>(columns);
    const float fraction = columns - static_cast<float>(whole);
    for (int y = 0; y + 1 < size.height; ++y) {
        for (int x = 0; x + whole + 1 < size.width; ++x)
            landings.at(x, y) = {.x = x + whole, .y = y, .weights = {1 - fraction, fraction, 0, 0}};
    }
    return landings;
}

double largest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

TEST(Ghosting, IsOverTheFootprintAlone) {
    Image<std::uint8_t> inside(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width / 2; ++x)
            inside.at(x, y) = 1;
    }
    const Footprint footprint{inside, {0, 0, 0}};
    Colours history = plain(0.4F);
    for (int y = 0; y < size.height; ++y)
        history.at(size.width - 1, y) = {1, 0, 0};
    const std::vector<double> outside = ghosting({history, plain(0.4F)}, footprint);
    EXPECT_EQ(outside.size(), size.pixels() / 2);
    EXPECT_EQ(largest(outside), 0);
    history.at(3, 3) = {1, 0, 0};
    EXPECT_GT(largest(ghosting({history, plain(0.4F)}, footprint)), 0.1);
}

TEST(HistoryFlip, IsNoneForAnErrorThatMovesWithTheSurface) {
    // A ramp, so that between pixels nothing is lost.
    const auto with_error = [](double shift) {
        Colours history = plain(0.3F);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x)
                history.at(x, y)[0] += static_cast<float>(0.01 * (x - shift));
        }
        return history;
    };
    const Colours still = plain(0.3F);
    const Colours first = with_error(0);
    const std::vector<double> moves = history_flip(landings_by(2.5F), {first, still}, {with_error(2.5), still});
    EXPECT_FALSE(moves.empty());
    EXPECT_LT(largest(moves), 1e-4);
    EXPECT_GT(largest(history_flip(landings_by(2.5F), {first, still}, {with_error(12.5), still})), 0.02);
}

TEST(HistoryFlip, IsNoneForWhatTheStillPicturesShowToo) {
    const std::vector<double> values =
        history_flip(landings_by(0), {plain(0.3F), plain(0.3F)}, {plain(0.8F), plain(0.8F)});
    EXPECT_EQ(largest(values), 0);
}

TEST(HistoryFlip, IsOverThePixelsWhosePointsAreSeen) {
    EXPECT_EQ(history_flip(landings_by(0), {plain(0), plain(0)}, {plain(0), plain(0)}).size(),
              std::size_t(size.width - 1) * std::size_t(size.height - 1));
    EXPECT_TRUE(history_flip(Image<Landing>(size), {plain(0), plain(0)}, {plain(1), plain(0)}).empty());
}

}  // namespace
}  // namespace reliefbench
