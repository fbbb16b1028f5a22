#include "metrics/hit_errors.hpp"

#include "core/parallel.hpp"
#include "metrics/pixel_errors.hpp"

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
    std::size_t off_chart = 0;
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

/// A circumstance of bases that are not flat.
FigureDeclaration of_curved(std::string path, std::string label, std::string unit) {
    FigureDeclaration figure = of_truth(std::move(path), std::move(label), std::move(unit), Better::neither);
    figure.needs.emplace_back(figure_needs::curved_base);
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
        {of_curved("error.off_chart", "Hits on another chart", of_footprint),
         [](const HitErrors& errors) { return errors.off_chart; }},
        {pixel_count("error.outside_quad.pixels", "Relief outside the footprint"),
         member<&HitErrors::outside_quad_pixels>},
        {of_truth("error.outside_quad.covered", "Relief outside the footprint, covered", "fraction of its pixels",
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
        if (errors.off_chart) errors.off_chart = static_cast<double>(counts.off_chart) / footprint;
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

void set_distances(HitErrors& errors, const std::vector<std::size_t>& compared, const ComparedHits& hits) {
    if (compared.empty()) {
        return;
    }
    const ShadingNormals normals(hits);
    HitErrors::ComparedPixels& pixels = errors.pixels;
    for (std::vector<double>* values : {&pixels.uv_texels, &pixels.depth, &pixels.normal_deg})
        values->resize(compared.size());
    std::vector<double> depth(compared.size());
    parallel_for(compared.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const std::size_t pixel = compared[index];
            const Hit& ours = hits.technique.texels[pixel];
            const Hit& theirs = hits.truth.texels[pixel];
            pixels.uv_texels[index] = uv_error(ours, theirs, hits.map, hits.relief, hits.chart_period(pixel));
            pixels.depth[index] = depth_error(ours, theirs);
            depth[index] = std::abs(pixels.depth[index]);
            pixels.normal_deg[index] = angle_between(normals.of_technique(pixel), normals.of_truth(pixel));
        }
    });
    std::size_t on_chart = 0;
    for (std::size_t index = 0; index < compared.size(); ++index) {
        if (!hits.is_off_chart(compared[index])) pixels.uv_texels[on_chart++] = pixels.uv_texels[index];
    }
    pixels.uv_texels.resize(on_chart);
    if (on_chart > 0) errors.uv_texels = summarize(pixels.uv_texels);
    errors.depth = summarize(depth);
    errors.depth->mean = summarize(pixels.depth).mean;
    errors.normal_deg = summarize(pixels.normal_deg);
}

}  // namespace

HitErrors compare_hits(const ComparedHits& hits) {
    assert(hits.technique.size == hits.truth.size && hits.footprint.size == hits.truth.size);
    HitErrors errors;
    PixelCounts counts;
    std::vector<std::size_t> compared;
    for (std::size_t pixel = 0; pixel < hits.truth.texels.size(); ++pixel) {
        const bool inside = hits.footprint.texels[pixel] != 0;
        if (hits.footprint.texels[pixel] == tie_in_footprint) {
            ++errors.footprint;
            ++counts.ties;
            continue;
        }
        const bool ours = is_finite_hit(hits.technique.texels[pixel]);
        const bool theirs = hits.truth.texels[pixel].is_hit();
        if (inside || !hits.ends_with_footprint()) {
            counts.covered_by_both += ours && theirs ? 1 : 0;
            counts.covered_by_either += ours || theirs ? 1 : 0;
        }
        if (inside) {
            ++errors.footprint;
            counts.missed += theirs && !ours ? 1 : 0;
            counts.false_hits += ours && !theirs ? 1 : 0;
            if (ours && theirs) {
                compared.push_back(pixel);
                counts.off_chart += hits.is_off_chart(pixel) ? 1 : 0;
            }
        } else if (theirs) {
            ++errors.outside_quad_pixels;
            counts.covered_outside += ours ? 1 : 0;
        }
    }
    errors.compared = compared.size();
    if (hits.curved) errors.off_chart = 0;
    set_coverage(errors, counts);
    set_distances(errors, compared, hits);
    return errors;
}

std::vector<FigureDeclaration> hit_error_figures() {
    return declarations_in(hit_error_table());
}

FigureValueList figures_of(const HitErrors& errors) {
    return values_in(hit_error_table(), errors);
}

}  // namespace reliefbench
