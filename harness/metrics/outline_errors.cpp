#include "metrics/outline_errors.hpp"

#include "core/statistics.hpp"
#include "metrics/distance_transform.hpp"
#include "metrics/pixel_errors.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <string>
#include <utility>

namespace reliefbench {

namespace {

using PixelSet = Image<std::uint8_t>;

/// Those pixels of a set of which one of the four neighbours is wanted, as is_wanted(index) says, or lies outside the
/// frame where `beyond_frame` is wanted.
template <typename Wanted>
PixelSet with_neighbour(const PixelSet& set, bool beyond_frame, const Wanted& is_wanted) {
    PixelSet found(set.size);
    const auto [columns, rows] = set.size;
    const auto width = static_cast<std::size_t>(columns);
    std::size_t pixel = 0;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x, ++pixel) {
            if (set.texels[pixel] == 0) continue;
            const bool has_one = (x > 0 ? is_wanted(pixel - 1) : beyond_frame) ||
                                 (x + 1 < columns ? is_wanted(pixel + 1) : beyond_frame) ||
                                 (y > 0 ? is_wanted(pixel - width) : beyond_frame) ||
                                 (y + 1 < rows ? is_wanted(pixel + width) : beyond_frame);
            found.texels[pixel] = has_one ? 1 : 0;
        }
    }
    return found;
}

/// What a technique and the truth hit of the region.
struct OutlinedSets {
    PixelSet technique;
    PixelSet truth;
    PixelSet region;
};

OutlinedSets sets_within(const ComparedHits& hits, PixelSet region) {
    OutlinedSets sets{PixelSet(region.size), PixelSet(region.size), std::move(region)};
    for (std::size_t pixel = 0; pixel < sets.region.texels.size(); ++pixel) {
        if (sets.region.texels[pixel] == 0) continue;
        const bool is_tie = hits.footprint.texels[pixel] == tie_in_footprint;
        const bool theirs = hits.truth.texels[pixel].is_hit();
        sets.truth.texels[pixel] = theirs ? 1 : 0;
        sets.technique.texels[pixel] = (is_tie ? theirs : is_finite_hit(hits.technique.texels[pixel])) ? 1 : 0;
    }
    return sets;
}

/// The set's outline within the region.
PixelSet inner_outline(const PixelSet& set, const PixelSet& region) {
    return with_neighbour(
        set, false, [&](std::size_t neighbour) { return region.texels[neighbour] != 0 && set.texels[neighbour] == 0; });
}

/// What the outline of `other` is compared with: the set's, and where the region's or the frame's border ends it, but
/// not the other.
PixelSet compared_outline(const PixelSet& set, const PixelSet& other, const PixelSet& region) {
    PixelSet outline = inner_outline(set, region);
    const PixelSet border =
        with_neighbour(region, true, [&](std::size_t neighbour) { return region.texels[neighbour] == 0; });
    for (std::size_t pixel = 0; pixel < set.texels.size(); ++pixel) {
        if (border.texels[pixel] != 0 && set.texels[pixel] != 0 && other.texels[pixel] == 0) outline.texels[pixel] = 1;
    }
    return outline;
}

/// The part of an outline that distances are taken from.
PixelSet without_ties(PixelSet outline, const FootprintImage& footprint) {
    for (std::size_t pixel = 0; pixel < outline.texels.size(); ++pixel) {
        if (footprint.texels[pixel] == tie_in_footprint) outline.texels[pixel] = 0;
    }
    return outline;
}

bool has_any(const PixelSet& set) {
    return std::ranges::any_of(set.texels, [](std::uint8_t value) { return value != 0; });
}

OutlineErrors::Distances distances_of(const OutlinedSets& sets, const FootprintImage& footprint) {
    OutlineErrors::Distances errors;
    std::vector<double> distances;
    for (const auto& [from, to] : {std::pair(&sets.technique, &sets.truth), std::pair(&sets.truth, &sets.technique)}) {
        const PixelSet measured = without_ties(inner_outline(*from, sets.region), footprint);
        const auto pixels = static_cast<std::size_t>(std::ranges::count(measured.texels, 1));
        errors.pixels += pixels;
        if (pixels == 0) continue;
        const PixelSet outline = compared_outline(*to, *from, sets.region);
        if (!has_any(outline)) continue;
        const std::vector<double> one_way = distances_between(measured, outline);
        distances.insert(distances.end(), one_way.begin(), one_way.end());
    }
    if (distances.empty()) return errors;
    const Summary summary = summarize(distances);
    errors.mean = summary.mean;
    errors.p95 = summary.p95;
    return errors;
}

/// Undefined over no pixel.
FigureDeclaration outline_distance(const std::string& path, std::string label, const std::string& over) {
    return {.path = path,
            .label = std::move(label),
            .unit = "pixels",
            .better = Better::lower,
            .needs = {std::string(figure_needs::truth)},
            .over = over};
}

FigureDeclaration outline_pixels(const std::string& path, std::string label) {
    return {.path = path,
            .label = std::move(label),
            .unit = "pixels",
            .needs = {std::string(figure_needs::truth)},
            .is_count = true};
}

template <auto Member>
std::optional<double> of_whole(const OutlineErrors& errors) {
    return errors.whole ? (*errors.whole).*Member : std::nullopt;
}

const std::vector<FigureOf<OutlineErrors>>& outline_error_table() {
    using Errors = OutlineErrors;
    using Distances = OutlineErrors::Distances;
    constexpr const char* inside = "error.outline.pixels";
    constexpr const char* whole = "error.outline_all.pixels";
    static const std::vector<FigureOf<Errors>> table = {
        {in_short(outline_distance("error.outline.mean", "Outline error, mean", inside), "outline"),
         [](const Errors& errors) { return errors.footprint.mean; }},
        {outline_distance("error.outline.p95", "Outline error, p95", inside),
         [](const Errors& errors) { return errors.footprint.p95; }},
        {outline_pixels(inside, "Outline pixels compared"),
         [](const Errors& errors) { return std::optional(static_cast<double>(errors.footprint.pixels)); }},
        {outline_distance("error.outline_all.mean", "Outline error of the whole frame, mean", whole),
         of_whole<&Distances::mean>},
        {outline_distance("error.outline_all.p95", "Outline error of the whole frame, p95", whole),
         of_whole<&Distances::p95>},
        {outline_pixels(whole, "Outline pixels of the whole frame compared"),
         [](const Errors& errors) {
             return errors.whole ? std::optional(static_cast<double>(errors.whole->pixels)) : std::nullopt;
         }},
    };
    return table;
}

}  // namespace

OutlineErrors compare_outlines(const ComparedHits& hits) {
    assert(hits.technique.size == hits.truth.size && hits.footprint.size == hits.truth.size);
    OutlineErrors errors;
    errors.footprint = distances_of(sets_within(hits, hits.footprint), hits.footprint);
    if (!hits.ends_with_footprint()) {
        const PixelSet everywhere(hits.truth.size, 1);
        errors.whole = distances_of(sets_within(hits, everywhere), hits.footprint);
    }
    return errors;
}

std::vector<FigureDeclaration> outline_error_figures() {
    return declarations_in(outline_error_table());
}

FigureValueList figures_of(const OutlineErrors& errors) {
    return values_in(outline_error_table(), errors);
}

}  // namespace reliefbench
