#include "metrics/hit_errors.hpp"

#include "core/parallel.hpp"
#include "metrics/pixel_errors.hpp"
#include "scene/shading_normal.hpp"

#include <cassert>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench {

namespace {

/// Pixels per range of the parallel loop.
constexpr std::size_t grain = 4096;

struct PixelCounts {
    std::size_t missed = 0;
    std::size_t false_hits = 0;
    std::size_t ties = 0;
    std::size_t covered_outside = 0;
    std::size_t covered_by_both = 0;
    std::size_t covered_by_either = 0;
};

template <auto Statistics, auto Member>
std::optional<double> statistic(const HitErrors& errors) {
    const std::optional<Summary>& summary = errors.*Statistics;
    return summary ? std::optional((*summary).*Member) : std::nullopt;
}

template <auto Member>
std::optional<double> member(const HitErrors& errors) {
    return static_cast<double>(errors.*Member);
}

/// Over the pixels compared.
FigureDeclaration over_compared(std::string path, std::string label, std::string unit, Better better) {
    return {.path = std::move(path),
            .label = std::move(label),
            .unit = std::move(unit),
            .better = better,
            .needs = {std::string(figure_needs::truth)},
            .over = "error.compared"};
}

FigureDeclaration of_truth(std::string path, std::string label, std::string unit, Better better) {
    FigureDeclaration figure = over_compared(std::move(path), std::move(label), std::move(unit), better);
    figure.over.clear();
    return figure;
}

FigureDeclaration pixel_count(std::string path, std::string label) {
    FigureDeclaration figure = of_truth(std::move(path), std::move(label), "pixels", Better::neither);
    figure.is_count = true;
    return figure;
}

const std::vector<FigureOf<HitErrors>>& hit_error_table() {
    constexpr Better lower = Better::lower;
    constexpr auto uv = &HitErrors::uv_texels;
    constexpr auto depth = &HitErrors::depth;
    constexpr auto normal = &HitErrors::normal_deg;
    constexpr const char* texels = "texels";
    constexpr const char* sides = "patch sides";
    constexpr const char* degrees = "degrees";
    constexpr const char* of_footprint = "fraction of footprint";
    static const std::vector<FigureOf<HitErrors>> table = {
        {over_compared("error.uv_texels.mean", "UV error, mean", texels, lower), statistic<uv, &Summary::mean>},
        {over_compared("error.uv_texels.rms", "UV error, RMS", texels, lower), statistic<uv, &Summary::rms>},
        {in_short(at_percentile(50, over_compared("error.uv_texels.p50", "UV error, median", texels, lower)), "uv p50"),
         statistic<uv, &Summary::p50>},
        {at_percentile(95, over_compared("error.uv_texels.p95", "UV error, p95", texels, lower)),
         statistic<uv, &Summary::p95>},
        {in_short(at_percentile(99, over_compared("error.uv_texels.p99", "UV error, p99", texels, lower)), "uv p99"),
         statistic<uv, &Summary::p99>},
        {at_percentile(99.9, over_compared("error.uv_texels.p999", "UV error, p99.9", texels, lower)),
         [](const HitErrors& errors) {
             const std::vector<double>& pixels = errors.pixels.uv_texels;
             return pixels.empty() ? std::nullopt : std::optional(quantile(pixels, 0.999));
         }},
        {over_compared("error.uv_texels.max", "UV error, maximum", texels, lower), statistic<uv, &Summary::max>},
        {over_compared("error.depth.mean", "Depth error, signed mean", sides, Better::neither),
         statistic<depth, &Summary::mean>},
        {over_compared("error.depth.rms", "Depth error, RMS", sides, lower), statistic<depth, &Summary::rms>},
        {at_percentile(50, over_compared("error.depth.p50", "Depth error, median", sides, lower)),
         statistic<depth, &Summary::p50>},
        {at_percentile(95, over_compared("error.depth.p95", "Depth error, p95", sides, lower)),
         statistic<depth, &Summary::p95>},
        {in_short(at_percentile(99, over_compared("error.depth.p99", "Depth error, p99", sides, lower)), "depth p99"),
         statistic<depth, &Summary::p99>},
        {over_compared("error.depth.max", "Depth error, maximum", sides, lower), statistic<depth, &Summary::max>},
        {over_compared("error.normal_deg.mean", "Normal error, mean", degrees, lower),
         statistic<normal, &Summary::mean>},
        {over_compared("error.normal_deg.rms", "Normal error, RMS", degrees, lower), statistic<normal, &Summary::rms>},
        {at_percentile(50, over_compared("error.normal_deg.p50", "Normal error, median", degrees, lower)),
         statistic<normal, &Summary::p50>},
        {at_percentile(95, over_compared("error.normal_deg.p95", "Normal error, p95", degrees, lower)),
         statistic<normal, &Summary::p95>},
        {at_percentile(99, over_compared("error.normal_deg.p99", "Normal error, p99", degrees, lower)),
         statistic<normal, &Summary::p99>},
        {over_compared("error.normal_deg.max", "Normal error, maximum", degrees, lower),
         statistic<normal, &Summary::max>},
        {pixel_count("error.compared", "Pixels compared"), member<&HitErrors::compared>},
        {in_short(of_truth("error.missed", "Missed hits", of_footprint, lower), "missed"), member<&HitErrors::missed>},
        {in_short(of_truth("error.false_hits", "False hits", of_footprint, lower), "false"),
         member<&HitErrors::false_hits>},
        {of_truth("error.ties", "Ties", of_footprint, Better::neither), member<&HitErrors::ties>},
        {pixel_count("error.outside_quad.pixels", "Relief outside the quad"), member<&HitErrors::outside_quad_pixels>},
        {of_truth("error.outside_quad.covered", "Relief outside the quad, covered", "fraction of its pixels",
                  Better::higher),
         [](const HitErrors& errors) { return errors.outside_quad_covered; }},
        {of_truth("error.coverage_iou", "Intersection over union of the coverage", "", Better::higher),
         member<&HitErrors::coverage_iou>},
    };
    return table;
}

void set_coverage(HitErrors& errors, const PixelCounts& counts) {
    if (errors.footprint > 0) {
        const auto footprint = static_cast<double>(errors.footprint);
        errors.missed = static_cast<double>(counts.missed) / footprint;
        errors.false_hits = static_cast<double>(counts.false_hits) / footprint;
        errors.ties = static_cast<double>(counts.ties) / footprint;
    }
    if (errors.outside_quad_pixels > 0) {
        errors.outside_quad_covered =
            static_cast<double>(counts.covered_outside) / static_cast<double>(errors.outside_quad_pixels);
    }
    if (counts.covered_by_either > 0) {
        errors.coverage_iou =
            static_cast<double>(counts.covered_by_both) / static_cast<double>(counts.covered_by_either);
    }
}

void set_distances(HitErrors& errors, const std::vector<std::size_t>& compared, const HitImage& technique,
                   const HitImage& truth, const HeightMap& map, const Relief& relief) {
    if (compared.empty()) {
        return;
    }
    const Image<std::array<float, 2>> derivatives = height_derivatives(map);
    HitErrors::ComparedPixels& pixels = errors.pixels;
    for (std::vector<double>* values : {&pixels.uv_texels, &pixels.depth, &pixels.normal_deg})
        values->resize(compared.size());
    std::vector<double> depth(compared.size());
    parallel_for(compared.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const Hit& ours = technique.texels[compared[index]];
            const Hit& theirs = truth.texels[compared[index]];
            pixels.uv_texels[index] = uv_error(ours, theirs, map, relief);
            pixels.depth[index] = depth_error(ours, theirs);
            depth[index] = std::abs(pixels.depth[index]);
            pixels.normal_deg[index] = angle_between(shading_normal(derivatives, relief, ours.u, ours.v),
                                                     shading_normal(derivatives, relief, theirs.u, theirs.v));
        }
    });
    errors.uv_texels = summarize(pixels.uv_texels);
    errors.depth = summarize(depth);
    errors.depth->mean = summarize(pixels.depth).mean;
    errors.normal_deg = summarize(pixels.normal_deg);
}

}  // namespace

HitErrors compare_hits(const HitImage& technique, const HitImage& truth, const FootprintImage& footprint,
                       const HeightMap& map, const Relief& relief) {
    assert(technique.size == truth.size && footprint.size == truth.size);
    HitErrors errors;
    PixelCounts counts;
    std::vector<std::size_t> compared;
    for (std::size_t pixel = 0; pixel < truth.texels.size(); ++pixel) {
        const bool inside = footprint.texels[pixel] != 0;
        if (footprint.texels[pixel] == tie_in_footprint) {
            ++errors.footprint;
            ++counts.ties;
            continue;
        }
        const bool ours = is_finite_hit(technique.texels[pixel]);
        const bool theirs = truth.texels[pixel].is_hit();
        if (inside || relief.boundary == Boundary::clip) {
            counts.covered_by_both += ours && theirs ? 1 : 0;
            counts.covered_by_either += ours || theirs ? 1 : 0;
        }
        if (inside) {
            ++errors.footprint;
            counts.missed += theirs && !ours ? 1 : 0;
            counts.false_hits += ours && !theirs ? 1 : 0;
            if (ours && theirs) compared.push_back(pixel);
        } else if (theirs) {
            ++errors.outside_quad_pixels;
            counts.covered_outside += ours ? 1 : 0;
        }
    }
    errors.compared = compared.size();
    set_coverage(errors, counts);
    set_distances(errors, compared, technique, truth, map, relief);
    return errors;
}

std::vector<FigureDeclaration> hit_error_figures() {
    return declarations_in(hit_error_table());
}

FigureValueList figures_of(const HitErrors& errors) {
    return values_in(hit_error_table(), errors);
}

}  // namespace reliefbench
