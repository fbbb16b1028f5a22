#include "metrics/work.hpp"

#include <cassert>

namespace reliefbench {

namespace {

const std::vector<FigureOf<WorkSummary>>& work_table() {
    using Work = WorkSummary;
    constexpr Better lower = Better::lower;
    static const std::vector<std::string> shadows = {std::string(figure_needs::self_shadow)};
    static const std::vector<FigureOf<Work>> table = {
        {in_short({"work.taps_mean", "Taps per pixel", "", lower}, "taps"),
         [](const Work& w) { return std::optional(w.taps_mean()); }},
        {at_percentile(95, {"work.taps_p95", "Taps per pixel, p95", "", lower}),
         [](const Work& w) { return std::optional(w.taps_p95()); }},
        {{"work.texels_mean", "Texels read per pixel", "", lower},
         [](const Work& w) { return std::optional(w.texels_mean()); }},
        {{"work.steps_mean", "Steps per pixel", "", lower}, [](const Work& w) { return std::optional(w.steps.mean); }},
        {at_percentile(95, {"work.steps_p95", "Steps per pixel, p95", "", lower}),
         [](const Work& w) { return std::optional(w.steps.p95); }},
        {{"work.unconverged", "Unconverged searches", "fraction of covered pixels", lower},
         [](const Work& w) { return std::optional(w.unconverged); }},
        {{.path = "work.covered_pixels", .label = "Covered pixels", .unit = "pixels", .is_count = true},
         [](const Work& w) { return std::optional(static_cast<double>(w.covered_pixels)); }},
        {in_short({"work.shadow_taps_mean", "Shadow taps per pixel", "", lower, shadows}, "shadow taps"),
         [](const Work& w) { return w.shadow_taps ? std::optional(w.shadow_taps->mean) : std::nullopt; }},
        {at_percentile(95, {"work.shadow_taps_p95", "Shadow taps per pixel, p95", "", lower, shadows}),
         [](const Work& w) { return w.shadow_taps ? std::optional(w.shadow_taps->p95) : std::nullopt; }},
    };
    return table;
}

}  // namespace

std::optional<WorkSummary> summarize_work(const Image<std::uint8_t>& covered, const Image<PixelWork>& work,
                                          const PixelWork& stages, const Image<std::uint32_t>* shadow_taps) {
    assert(covered.size == work.size);
    std::vector<double> taps;
    std::vector<double> texels;
    std::vector<double> steps;
    std::vector<double> of_shadows;
    for (std::size_t pixel = 0; pixel < covered.texels.size(); ++pixel) {
        if (covered.texels[pixel] == 0) continue;
        const PixelWork& of_pixel = work.texels[pixel];
        taps.push_back(of_pixel.taps);
        texels.push_back(of_pixel.texels);
        steps.push_back(of_pixel.steps);
        if (shadow_taps != nullptr) of_shadows.push_back(shadow_taps->texels[pixel]);
    }
    if (taps.empty()) return std::nullopt;
    const auto pixels = static_cast<double>(taps.size());
    WorkSummary summary{.taps = summarize(taps),
                        .texels = summarize(texels),
                        .steps = summarize(steps),
                        .stage_taps = stages.taps / pixels,
                        .stage_texels = stages.texels / pixels,
                        .unconverged = unconverged_fraction(covered, work),
                        .covered_pixels = taps.size()};
    if (shadow_taps != nullptr) summary.shadow_taps = summarize(of_shadows);
    return summary;
}

std::vector<FigureDeclaration> work_figures() {
    return declarations_in(work_table());
}

FigureValueList figures_of(const WorkSummary& work) {
    return values_in(work_table(), work);
}

}  // namespace reliefbench
