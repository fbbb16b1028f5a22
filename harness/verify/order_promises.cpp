#include "core/counted.hpp"
#include "verify/promise_checks.hpp"

#include "metrics/error_maps.hpp"
#include "technique/map_needs.hpp"
#include "verify/worst_pixel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

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
    /// The largest error as a fraction of its pixel's step, and where it is.
    double largest_in_steps = INFINITY;
    double floor = 0;
    std::optional<PixelPlace> worst = {};
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
    set_sample_count(manifest, parameters, sampling.samples, manifest.defaults());
    if (declaration.halvings) parameters.at(*declaration.halvings) = sampling.halvings;
    return parameters;
}

SampledError measure_error(CheckList& list, const PromiseDeclaration& declaration, const Circumstance& where,
                           const Sampling& sampling) {
    const CoordinateScene& scene = list.scenes().get(where.map, where.map_size);
    const TruthComparison found =
        list.compare(sampled_parameters(list.manifest(), declaration, sampling), scene, where.view);
    SampledError error;
    error.sampling = sampling;
    // The ray meets the surface at an angle, which turns an error of height into up to twice the error of place.
    constexpr double amplification = 2;
    const double deviation = amplification * list.filter_deviation();
    error.floor = deviation * most_texels_through_relief(where.view, scene.map, found.truth.footprint) + float_texels;
    error.missed = found.errors.missed;
    if (error.missed > 0 || !found.errors.uv_texels) {
        error.worst = worst_place(found, scene.map, where.view, true);
        return error;
    }
    error.median = found.errors.uv_texels->p50;

    const Image<float> uv_errors = uv_error_map(compared_hits(found, scene.map, where.view.relief));
    WorstPixel worst;
    for (std::size_t pixel = 0; pixel < uv_errors.texels.size(); ++pixel) {
        if (found.truth.footprint.texels[pixel] != in_footprint) continue;
        const auto [i, j] = place_of(pixel, where.view.resolution);
        const double stride = texels_through_relief(where.view, scene.map, i, j);
        const double step = stride / static_cast<double>(sampling.samples << sampling.halvings);
        worst.offer((uv_errors.texels[pixel] - deviation * stride - float_texels) / step, pixel);
    }
    error.largest_in_steps = worst.value();
    error.worst = worst.place(where.view.resolution);
    if (!error.worst) error.worst = worst_place(found, scene.map, where.view, false);
    return error;
}

/// By what an error may fall from one step of a series to the next, but for the floor.
struct Fall {
    double min_ratio;
    double greatest_ratio;
};

bool falls(const SampledError& coarse, const SampledError& fine, const Fall& fall) {
    return fine.missed == 0 && fine.median <= fall.greatest_ratio * coarse.median + coarse.floor &&
           fine.median >= fall.min_ratio * coarse.median - coarse.floor;
}

/// Whether a series can show that its errors do not fall: its first one is so far above the floor that staying there
/// would be seen.
bool can_tell(const std::vector<SampledError>& series, const Fall& fall) {
    const SampledError& first = series.front();
    return series.size() > 1 && first.median > fall.greatest_ratio * first.median + first.floor;
}

/// The first of a series that does not fall as it must; empty where all do.
const SampledError* first_that_stays(const std::vector<SampledError>& series, const Fall& fall) {
    for (std::size_t i = 1; i < series.size(); ++i) {
        if (!falls(series[i - 1], series[i], fall)) return &series[i];
    }
    return nullptr;
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

/// Why the promise, as it is declared, cannot be checked; empty where it can.
std::string contradiction(const Manifest& manifest, const PromiseDeclaration& declaration) {
    const auto varied = [&](const std::string& key, const std::string& name) -> std::string {
        if (declaration.with.contains(name)) {
            return fmt::format("\"with\" fixes '{}', which the check varies ({}); leave it out of \"with\"", name, key);
        }
        const ParameterValues values = with_values(manifest, declaration.with);
        if (!all_hold(manifest.find_parameter(name)->only_with, values)) {
            return fmt::format("'{}', which the check varies ({}), has no effect under \"with\"", name, key);
        }
        return {};
    };
    std::string reason = varied("sample_count", *manifest.sample_count);
    if (reason.empty() && manifest.sample_count_minimum) {
        const std::string& name = *manifest.sample_count_minimum;
        if (declaration.with.contains(name)) reason = varied("sample_count_minimum", name);
    }
    if (!reason.empty() || !declaration.halvings) return reason;
    if (*declaration.halvings == *manifest.sample_count) {
        return fmt::format("'{}' is the sample count and cannot be its own halvings", *declaration.halvings);
    }
    const Parameter& halvings = *manifest.find_parameter(*declaration.halvings);
    if (halvings.minimum > 0 || halvings.maximum < 1) {
        return fmt::format("the range of '{}' (halvings) must hold 0 and 1: without halving and with one",
                           halvings.name);
    }
    return varied("halvings", *declaration.halvings);
}

/// A promise that cannot be checked is a failed check.
bool can_be_checked(CheckList& list, const PromiseDeclaration& declaration) {
    const std::string reason = contradiction(list.manifest(), declaration);
    if (reason.empty()) return true;
    const ParameterValues parameters = with_values(list.manifest(), declaration.with);
    return list.check(to_string(declaration.promise), describe(parameters, list.manifest()), [&] {
        return Finding{false, reason};
    });
}

/// One draw for each sampling.
std::vector<SampledError> measure_series(CheckList& list, const PromiseDeclaration& declaration,
                                         const Circumstance& where, const std::vector<Sampling>& samplings) {
    std::vector<SampledError> errors;
    for (const Sampling& sampling : samplings)
        errors.push_back(measure_error(list, declaration, where, sampling));
    return errors;
}

/// What is wrong, with the draw that shows it.
Finding failure(const CheckList& list, const PromiseDeclaration& declaration, const std::string& detail,
                const SampledError& shown) {
    return {false, detail, shown.worst, sampled_parameters(list.manifest(), declaration, shown.sampling)};
}

std::string nothing_to_compare(const std::string& by, const SampledError& first) {
    return fmt::format(
        "nothing to compare by {}: with {} the median UV error is {:.3g} texels already, as good as the floor "
        "({:.2g})",
        by, counted(static_cast<std::size_t>(first.sampling.samples), "sample"), first.median, first.floor);
}

Finding judge_first_order(const CheckList& list, const PromiseDeclaration& declaration,
                          const std::vector<SampledError>& doublings, const std::vector<SampledError>& halvings) {
    constexpr Fall fall{0.4, 0.6};
    std::string text = fmt::format("median UV error in texels by samples: {}", describe(doublings));
    if (!halvings.empty()) text += fmt::format("; by halvings: {}", describe(halvings));
    const auto by_steps = [](const SampledError& a, const SampledError& b) {
        return a.largest_in_steps < b.largest_in_steps;
    };
    std::vector<SampledError> all = doublings;
    all.insert(all.end(), halvings.begin(), halvings.end());
    const SampledError& farthest = *std::ranges::max_element(all, by_steps);
    text += fmt::format("; must halve, floor {:.2g}; largest error {:.3g} steps (bound {:g})", doublings.back().floor,
                        farthest.largest_in_steps, declaration.within);
    if (farthest.largest_in_steps > declaration.within) return failure(list, declaration, text, farthest);
    for (const auto& [by, series] : {std::pair("samples", &doublings), std::pair("halvings", &halvings)}) {
        if (series->empty()) continue;
        if (const SampledError* stays = first_that_stays(*series, fall))
            return failure(list, declaration, text, *stays);
        if (!can_tell(*series, fall))
            return failure(list, declaration, nothing_to_compare(by, series->front()), series->front());
    }
    return {true, text};
}

/// Whether the check is left out, because the technique needs its map to lie otherwise than the check has it.
bool is_left_out(CheckList& list, const PromiseDeclaration& declaration, const ParameterValues& parameters,
                 const Circumstance& where) {
    const std::string reason = unmet_map_need(list.manifest(), where.map_size, where.view.relief);
    if (reason.empty()) return false;
    list.skip(to_string(declaration.promise), describe(parameters, list.manifest()) + "; " + describe(where), reason);
    return true;
}

}  // namespace

void check_order_1(CheckList& list, const PromiseDeclaration& declaration) {
    constexpr std::int64_t max_halvings = 6;
    if (!can_be_checked(list, declaration)) return;
    // Gentle slopes: rays at 60° cross the surface once, so that coarse steps find the same crossing as the truth.
    for (const Circumstance& where : smooth_circumstances({256, 256}, 0.02)) {
        const ParameterValues parameters = with_values(list.manifest(), declaration.with);
        if (is_left_out(list, declaration, parameters, where)) continue;
        list.check("order_1", parameters, where, [&]() -> Finding {
            const auto doublings = measure_series(list, declaration, where, {{8, 0}, {16, 0}, {32, 0}, {64, 0}});
            std::vector<Sampling> halved;
            if (declaration.halvings) {
                const double most = list.manifest().find_parameter(*declaration.halvings)->maximum;
                for (std::int64_t count = 0; count <= max_halvings && static_cast<double>(count) <= most; ++count)
                    halved.push_back({8, count});
            }
            return judge_first_order(list, declaration, doublings, measure_series(list, declaration, where, halved));
        });
    }
}

void check_order_2(CheckList& list, const PromiseDeclaration& declaration) {
    constexpr Fall fall{0.17, 0.33};
    if (!can_be_checked(list, declaration)) return;
    // Texels so fine that steps stay longer than texels: within one cell there is no curvature left to halve.
    for (const Circumstance& where : smooth_circumstances({1024, 1024}, 0.1)) {
        const ParameterValues parameters = with_values(list.manifest(), declaration.with);
        if (is_left_out(list, declaration, parameters, where)) continue;
        list.check("order_2", parameters, where, [&]() -> Finding {
            const auto doublings = measure_series(list, declaration, where, {{8, 0}, {16, 0}, {32, 0}});
            const std::string text =
                fmt::format("median UV error in texels by samples: {}; must fall by four, floor {:.2g}",
                            describe(doublings), doublings.back().floor);
            if (const SampledError* stays = first_that_stays(doublings, fall))
                return failure(list, declaration, text, *stays);
            if (!can_tell(doublings, fall))
                return failure(list, declaration, nothing_to_compare("samples", doublings.front()), doublings.front());
            return {true, text};
        });
    }
}

}  // namespace reliefbench
