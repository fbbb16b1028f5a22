#include "advice/map_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace reliefbench {

namespace {

/// Pixels by which the relief must shift something to be seen.
constexpr double least_shift = 0.5;
constexpr double narrow_range = 0.25;
constexpr std::size_t few_levels = 16;
/// Of neighbouring texels that are equal, and of those that differ by one step among the others.
constexpr double min_equal_share = 0.5;
constexpr double min_single_step_share = 0.8;
/// Differences of neighbours, squared, against those at half the resolution: smooth maps have 0.25, edges of flat
/// tops about 0.7, white noise 4.
constexpr double max_roughness = 1;
/// A seam's mean difference against that of neighbours elsewhere, and against the range of heights.
constexpr double max_seam_ratio = 4;
constexpr double min_seam = 0.02;
constexpr double steps_of_8_bits = 255;

struct HeightStatistics {
    double lowest = 1;
    double highest = 0;
    std::size_t levels = 0;
    bool has_8_bits = true;
    double equal_share = 0;
    double single_step_share = 0;
    double roughness = 0;
    double neighbour_difference = 0;
    double seam_difference = 0;
};

/// Means over pairs of neighbours to the right and above, the border's own left out.
struct Differences {
    double absolute = 0;
    double squared = 0;
    std::size_t equal = 0;
    std::size_t single_steps = 0;
    std::size_t pairs = 0;

    void add(double a, double b) {
        const double difference = std::abs(a - b);
        absolute += difference;
        squared += difference * difference;
        equal += difference == 0 ? 1 : 0;
        single_steps += std::abs(difference * steps_of_8_bits - 1) < 0.01 ? 1 : 0;
        ++pairs;
    }
    double mean() const { return pairs > 0 ? absolute / static_cast<double>(pairs) : 0; }
    double mean_square() const { return pairs > 0 ? squared / static_cast<double>(pairs) : 0; }
};

template <typename Height>
Differences inner_differences(int width, int height, const Height& at) {
    Differences all;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (x + 1 < width) all.add(at(x, y), at(x + 1, y));
            if (y + 1 < height) all.add(at(x, y), at(x, y + 1));
        }
    }
    return all;
}

double seam_difference(const HeightMap& map) {
    Differences columns;
    Differences rows;
    for (int y = 0; y < map.height(); ++y)
        columns.add(map.texel(0, y), map.texel(map.width() - 1, y));
    for (int x = 0; x < map.width(); ++x)
        rows.add(map.texel(x, 0), map.texel(x, map.height() - 1));
    return std::max(columns.mean(), rows.mean());
}

void add_levels(const HeightMap& map, HeightStatistics& statistics) {
    constexpr double finest = 65535;
    std::vector<bool> is_level(static_cast<std::size_t>(finest) + 1);
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const double height = map.texel(x, y);
            statistics.lowest = std::min(statistics.lowest, height);
            statistics.highest = std::max(statistics.highest, height);
            is_level[static_cast<std::size_t>(std::lround(height * finest))] = true;
            const double step = height * steps_of_8_bits;
            statistics.has_8_bits = statistics.has_8_bits && std::abs(step - std::round(step)) < 0.001;
        }
    }
    statistics.levels = static_cast<std::size_t>(std::ranges::count(is_level, true));
}

HeightStatistics statistics_of(const HeightMap& map) {
    HeightStatistics statistics;
    add_levels(map, statistics);
    const Differences fine =
        inner_differences(map.width(), map.height(), [&](int x, int y) { return double{map.texel(x, y)}; });
    const Differences coarse = inner_differences(map.width() / 2, map.height() / 2, [&](int x, int y) {
        return 0.25 * (double{map.texel(2 * x, 2 * y)} + map.texel(2 * x + 1, 2 * y) + map.texel(2 * x, 2 * y + 1) +
                       map.texel(2 * x + 1, 2 * y + 1));
    });
    statistics.neighbour_difference = fine.mean();
    statistics.seam_difference = seam_difference(map);
    if (fine.pairs > 0) statistics.equal_share = static_cast<double>(fine.equal) / static_cast<double>(fine.pairs);
    if (fine.pairs > fine.equal)
        statistics.single_step_share =
            static_cast<double>(fine.single_steps) / static_cast<double>(fine.pairs - fine.equal);
    // Without a coarser level (a map of one texel) nothing is known.
    if (coarse.pairs > 0) {
        const double least = 1e-12;
        statistics.roughness = fine.mean_square() / std::max(coarse.mean_square(), least);
    }
    return statistics;
}

/// Pixels by which so much height shifts what is seen at the steepest angle.
double shift_of(double height, const MapUse& use) {
    return height * use.height_scale * std::tan(use.steepest_view_angle * std::numbers::pi / 180) * use.pixels_per_side;
}

std::string normalised_map(const HeightMap& map) {
    return fmt::format("--map '{{\"file\": \"{}\", \"normalize\": true}}'", map.name);
}

void add_faults_of_range(const HeightMap& map, const HeightStatistics& heights, const MapUse& use,
                         std::vector<MapFault>& faults) {
    const double range = heights.highest - heights.lowest;
    if (const double shift = shift_of(range, use); shift < least_shift) {
        faults.push_back(
            {MapFault::Kind::flat,
             fmt::format("height map '{}' is nearly flat: at {:g} degrees its relief (heights {:.3g} to {:.3g}, height "
                         "scale {:g}) shifts what is seen by {:.2g} pixels at most, so that every technique looks like "
                         "normal mapping; give a greater --height-scale, or stretch its heights with {}",
                         map.name, use.steepest_view_angle, heights.lowest, heights.highest, use.height_scale, shift,
                         normalised_map(map))});
    } else if (range < narrow_range) {
        faults.push_back({MapFault::Kind::narrow_range,
                          fmt::format("height map '{}' uses {:.0f} % of the range of heights ({:.3g} to {:.3g}): the "
                                      "relief is that much shallower than the height scale {:g}, and searches spend "
                                      "their samples on empty layers; stretch it with {} and a height scale of {:.2g}",
                                      map.name, 100 * range, heights.lowest, heights.highest, use.height_scale,
                                      normalised_map(map), use.height_scale * range)});
    }
    if (heights.levels < few_levels) {
        faults.push_back({MapFault::Kind::few_levels,
                          fmt::format("height map '{}' has {} heights only: its slopes are stairs, on which all rays "
                                      "meet walls; if that is not meant, make it with 16 bits",
                                      map.name, heights.levels)});
    }
}

}  // namespace

std::vector<MapFault> map_faults(const HeightMap& map, const MapUse& use) {
    if (map.constant) {
        return {{MapFault::Kind::constant,
                 fmt::format("height map '{}' is constant: there is no relief in it, and nothing to choose; name "
                             "another, or another \"channel\" of it",
                             map.name)}};
    }
    const HeightStatistics heights = statistics_of(map);
    std::vector<MapFault> faults;
    add_faults_of_range(map, heights, use, faults);
    const double step_shift = shift_of(1 / steps_of_8_bits, use);
    if (heights.levels >= few_levels && heights.has_8_bits && heights.equal_share >= min_equal_share &&
        heights.single_step_share >= min_single_step_share && step_shift >= least_shift) {
        faults.push_back(
            {MapFault::Kind::terraces,
             fmt::format(
                 "height map '{}' has 8 bits and rises by less than a step from texel to texel: it is terraces, "
                 "whose edges shift by {:.2g} pixels at {:g} degrees, and errors are those on stairs; make it "
                 "with 16 bits",
                 map.name, step_shift, use.steepest_view_angle)});
    }
    if (heights.roughness >= max_roughness) {
        faults.push_back(
            {MapFault::Kind::noise,
             fmt::format("height map '{}' is noise at the scale of its texels: its slopes are {:.2g} times as great as "
                         "at half the resolution (1 or more is noise, a smooth map has 0.5). Searches in steps pass "
                         "over such spikes whatever their sample count, and pictures alias; blur it or halve its size",
                         map.name, std::sqrt(heights.roughness))});
    }
    const double range = heights.highest - heights.lowest;
    if (use.repeats && heights.seam_difference > min_seam * range &&
        heights.seam_difference > max_seam_ratio * heights.neighbour_difference) {
        faults.push_back(
            {MapFault::Kind::seam,
             fmt::format("height map '{}' does not tile: across its border heights jump by {:.2g} in the mean, {:.2g} "
                         "times as much as between neighbours, which is a wall where it repeats; make it tileable, or "
                         "leave boundary at clip and tiling at 1",
                         map.name, heights.seam_difference, heights.seam_difference / heights.neighbour_difference)});
    }
    return faults;
}

}  // namespace reliefbench
