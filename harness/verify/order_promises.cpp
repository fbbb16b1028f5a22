#include "verify/promise_checks.hpp"

#include "metrics/error_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

/// How finely a technique is asked to look: its sample count, and its halvings where it has them.
struct Sampling {
    std::int64_t samples = 0;
    std::int64_t halvings = 0;
};

struct SampledError {
    Sampling sampling;
    /// Pixels of the footprint without a hit, as a fraction.
    double missed = 1;
    double median = INFINITY;
    /// The largest error as a fraction of its pixel's step.
    double largest_in_steps = INFINITY;
    double floor = 0;
};

/// Errors of single floats in u, v and the ray parameter, in texels of the maps used here.
constexpr double float_texels = 1e-3;

std::vector<Circumstance> smooth_circumstances(Resolution size, double height_scale) {
    std::vector<Circumstance> all;
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
        View view;
        view.camera.projection = projection;
        view.camera.view_angle = projection == Projection::parallel ? 60 : 45;
        view.camera.azimuth = -65;
        view.relief.height_scale = height_scale;
        // Without a border every ray hits, whatever the step.
        view.relief.boundary = Boundary::repeat;
        view.resolution = {96, 96};
        all.push_back({"waves", size, view});
    }
    return all;
}

ParameterValues sampled_parameters(const Manifest& manifest, const PromiseDeclaration& declaration,
                                   const Sampling& sampling) {
    ParameterValues parameters = with_values(manifest, declaration.with);
    set_sample_count(manifest, parameters, sampling.samples);
    if (declaration.halvings) parameters.at(*declaration.halvings) = sampling.halvings;
    return parameters;
}

SampledError measure_error(CheckList& list, const PromiseDeclaration& declaration, const Circumstance& where,
                           const Sampling& sampling) {
    const CoordinateScene& scene = list.scenes().get(where.map, where.map_size);
    const Comparison found = compare_with_truth(
        list.device(), list.technique(), sampled_parameters(list.manifest(), declaration, sampling), scene, where.view);
    SampledError error;
    error.sampling = sampling;
    // The ray meets the surface at an angle, which turns an error of height into up to twice the error of place.
    constexpr double amplification = 2;
    const double deviation = amplification * list.filter_deviation();
    error.floor = deviation * most_texels_through_relief(where.view, scene.map, found.truth.footprint) + float_texels;
    error.missed = found.errors.missed;
    if (!found.errors.uv_texels) return error;
    error.median = found.errors.uv_texels->p50;

    const Image<float> uv_errors = uv_error_map(found.probe.hits, found.truth.hits, scene.map, where.view.relief);
    error.largest_in_steps = 0;
    for (int j = 0; j < where.view.resolution.height; ++j) {
        for (int i = 0; i < where.view.resolution.width; ++i) {
            const double stride = texels_through_relief(where.view, scene.map, i, j);
            const double step = stride / static_cast<double>(sampling.samples << sampling.halvings);
            const double excess = uv_errors.at(i, j) - deviation * stride - float_texels;
            error.largest_in_steps = std::max(error.largest_in_steps, excess / step);
        }
    }
    return error;
}

bool falls(const SampledError& coarse, const SampledError& fine, double least_ratio, double greatest_ratio) {
    return fine.missed == 0 && fine.median <= greatest_ratio * coarse.median + coarse.floor &&
           fine.median >= least_ratio * coarse.median - coarse.floor;
}

std::string describe(const std::vector<SampledError>& errors) {
    std::string text;
    for (const SampledError& error : errors) {
        text += fmt::format("{}{}", text.empty() ? "" : ", ", error.sampling.samples);
        if (error.sampling.halvings > 0) text += fmt::format("·2^{}", error.sampling.halvings);
        text += fmt::format(": {:.3g}", error.median);
    }
    return text;
}

Finding judge_first_order(const std::vector<SampledError>& doublings, const std::vector<SampledError>& halvings) {
    constexpr double least_ratio = 0.4;
    constexpr double greatest_ratio = 0.6;
    bool passed = true;
    double largest = 0;
    for (const auto* series : {&doublings, &halvings}) {
        for (std::size_t i = 0; i < series->size(); ++i) {
            if (i > 0) passed = passed && falls((*series)[i - 1], (*series)[i], least_ratio, greatest_ratio);
            largest = std::max(largest, (*series)[i].largest_in_steps);
        }
    }
    passed = passed && largest <= 1;
    std::string text = fmt::format("median UV error in texels by samples: {}", describe(doublings));
    if (!halvings.empty()) text += fmt::format("; by halvings: {}", describe(halvings));
    return {passed, text + fmt::format("; must halve, floor {:.2g}; largest error {:.3g} steps (bound 1)",
                                       doublings.back().floor, largest)};
}

}  // namespace

void check_order_1(CheckList& list, const PromiseDeclaration& declaration) {
    // Gentle slopes: rays at 60° cross the surface once, so that coarse steps find the same crossing as the truth.
    for (const Circumstance& where : smooth_circumstances({256, 256}, 0.02)) {
        const ParameterValues parameters = with_values(list.manifest(), declaration.with);
        list.check("order_1", describe(parameters, list.manifest()) + "; " + describe(where), [&]() -> Finding {
            std::vector<SampledError> doublings;
            for (const std::int64_t samples : {8, 16, 32, 64})
                doublings.push_back(measure_error(list, declaration, where, {samples, 0}));
            std::vector<SampledError> halvings;
            if (declaration.halvings) {
                const auto most = std::get<std::int64_t>(parameters.at(*declaration.halvings));
                for (std::int64_t count = 0; count <= most; ++count)
                    halvings.push_back(measure_error(list, declaration, where, {8, count}));
            }
            return judge_first_order(doublings, halvings);
        });
    }
}

void check_order_2(CheckList& list, const PromiseDeclaration& declaration) {
    constexpr double least_ratio = 0.17;
    constexpr double greatest_ratio = 0.33;
    // Texels so fine that steps stay longer than texels: within one cell there is no curvature left to halve.
    for (const Circumstance& where : smooth_circumstances({1024, 1024}, 0.1)) {
        const ParameterValues parameters = with_values(list.manifest(), declaration.with);
        list.check("order_2", describe(parameters, list.manifest()) + "; " + describe(where), [&]() -> Finding {
            std::vector<SampledError> doublings;
            bool passed = true;
            for (const std::int64_t samples : {8, 16, 32}) {
                doublings.push_back(measure_error(list, declaration, where, {samples, 0}));
                const std::size_t last = doublings.size() - 1;
                if (last > 0) {
                    passed = passed && falls(doublings[last - 1], doublings[last], least_ratio, greatest_ratio);
                }
            }
            return {passed, fmt::format("median UV error in texels by samples: {}; must fall by four, floor {:.2g}",
                                        describe(doublings), doublings.back().floor)};
        });
    }
}

}  // namespace reliefbench
