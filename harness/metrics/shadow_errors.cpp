#include "metrics/shadow_errors.hpp"

#include <glm/geometric.hpp>

#include <cassert>
#include <cmath>
#include <string>
#include <utility>

namespace reliefbench {

namespace {

/// A difference in visibility that counts as a shadow where there is none, or none where there is one.
constexpr double wrong_by = 0.5;

/// Over the visibilities compared.
FigureDeclaration of_visibility(std::string path, std::string label, std::string unit, Better better) {
    return {.path = std::move(path),
            .label = std::move(label),
            .unit = std::move(unit),
            .better = better,
            .needs = {std::string(figure_needs::truth), std::string(figure_needs::lighting),
                      std::string(figure_needs::self_shadow)},
            .over = "error.shadow.compared"};
}

FigureDeclaration visibility_count() {
    FigureDeclaration figure = of_visibility("error.shadow.compared", "Visibilities compared", "", Better::neither);
    figure.is_count = true;
    figure.over.clear();
    return figure;
}

const std::vector<FigureOf<ShadowErrors>>& shadow_error_table() {
    constexpr const char* visibility = "visibility";
    constexpr const char* of_compared = "fraction of visibilities compared";
    constexpr Better lower = Better::lower;
    using Errors = ShadowErrors;
    static const std::vector<FigureOf<Errors>> table = {
        {in_short(of_visibility("error.shadow.mean", "Shadow error, mean", visibility, lower), "shadow",
                  "mean error of the lights' visibility"),
         [](const Errors& errors) { return std::optional(errors.mean); }},
        {of_visibility("error.shadow.false_shadow", "False shadow", of_compared, lower),
         [](const Errors& errors) { return std::optional(errors.false_shadow); }},
        {of_visibility("error.shadow.missed_shadow", "Missed shadow", of_compared, lower),
         [](const Errors& errors) { return std::optional(errors.missed_shadow); }},
        {visibility_count(), [](const Errors& errors) { return std::optional(static_cast<double>(errors.compared)); }},
        {of_visibility("error.shadow.truth_standard_error", "Standard error of the truth's soft shadows", visibility,
                       Better::neither),
         [](const Errors& errors) { return errors.truth_standard_error; }},
    };
    return table;
}

}  // namespace

ShadowErrors compare_shadows(const VisibilityImage& technique, const VisibilityImage& truth, const ComparedHits& hits,
                             const Lighting& lighting) {
    assert(technique.size == truth.size && hits.technique.size == truth.size && hits.truth.size == truth.size &&
           hits.footprint.size == truth.size && lighting.lights.size() <= technique.texels.front().size());
    const ShadingNormals normals(hits);
    ShadowErrors errors;
    std::size_t darker = 0;
    std::size_t lighter = 0;
    double sum = 0;
    for (std::size_t pixel = 0; pixel < truth.texels.size(); ++pixel) {
        if (hits.footprint.texels[pixel] != in_footprint || !hits.truth.texels[pixel].is_hit() ||
            !hits.technique.texels[pixel].is_hit())
            continue;
        const glm::dvec3 normal = normals.of_truth(pixel);
        for (std::size_t light = 0; light < lighting.lights.size(); ++light) {
            if (glm::dot(normal, lighting.lights[light].direction) <= 0) continue;
            const double difference = static_cast<double>(technique.texels[pixel][light]) - truth.texels[pixel][light];
            sum += std::abs(difference);
            darker += difference <= -wrong_by ? 1 : 0;
            lighter += difference >= wrong_by ? 1 : 0;
            ++errors.compared;
        }
    }
    if (errors.compared == 0) return errors;
    const auto compared = static_cast<double>(errors.compared);
    errors.mean = sum / compared;
    errors.false_shadow = static_cast<double>(darker) / compared;
    errors.missed_shadow = static_cast<double>(lighter) / compared;
    return errors;
}

std::vector<FigureDeclaration> shadow_error_figures() {
    return declarations_in(shadow_error_table());
}

FigureValueList figures_of(const ShadowErrors& errors) {
    return values_in(shadow_error_table(), errors);
}

}  // namespace reliefbench
