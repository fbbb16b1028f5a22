#include "verify/general_checks.hpp"

#include "core/counted.hpp"
#include "gpu/device.hpp"
#include "verify/worst_pixel.hpp"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

constexpr int resolution = 96;

Circumstance circumstance(const std::string& map, Resolution size, Projection projection, double angle,
                          double azimuth) {
    View view;
    view.camera.projection = projection;
    view.camera.view_angle = angle;
    view.camera.azimuth = azimuth;
    view.relief.height_scale = 0.1;
    view.resolution = {resolution, resolution};
    return {map, size, view};
}

std::vector<Circumstance> picture_circumstances(const Manifest& manifest) {
    std::vector<Circumstance> all{circumstance("rock", {96, 64}, Projection::perspective, 60, -70),
                                  circumstance("cobbles", {64, 64}, Projection::parallel, 75, 20),
                                  circumstance("spikes", {100, 60}, Projection::parallel, 30, -90)};
    all.back().view.relief.boundary = Boundary::repeat;
    for (Circumstance& where : all)
        where = as_needed(manifest, std::move(where));
    return all;
}

/// The defaults, and each boolean and choice changed alone where that has an effect.
std::vector<ParameterValues> variants(const Manifest& manifest) {
    std::vector<ParameterValues> all{manifest.defaults()};
    for (const Parameter& parameter : manifest.parameters) {
        const auto add = [&](const ParameterValue& value) {
            ParameterValues values = with_values(manifest, {{parameter.name, value}});
            reset_idle(manifest, values, true);
            if (values != manifest.defaults()) all.push_back(std::move(values));
        };
        if (parameter.type == ParameterType::boolean) {
            add(false);
            add(true);
        }
        for (const std::string& choice : parameter.choices)
            add(choice);
    }
    return all;
}

bool same_colour(const std::array<float, 4>& timed, const std::array<float, 3>& probed) {
    return timed[0] == probed[0] && timed[1] == probed[1];
}

/// Texels between the places that two colours of a coordinate albedo encode.
double texels_apart(const std::array<float, 4>& timed, const std::array<float, 3>& probed, const HeightMap& map) {
    return std::hypot((timed[0] - probed[0]) * static_cast<float>(map.width()),
                      (timed[1] - probed[1]) * static_cast<float>(map.height()));
}

/// No texture coordinates are below 0.
bool is_background(float red) {
    return red < 0;
}

Finding compare_pictures(const TimedPicture& timed, const Probe& probe, const HeightMap& map, bool bit_for_bit) {
    constexpr double tolerance_texels = 0.5;
    constexpr double tolerated_fraction = 0.001;
    std::size_t drawn = 0;
    std::size_t different = 0;
    WorstPixel worst;
    for (std::size_t pixel = 0; pixel < timed.colour.texels.size(); ++pixel) {
        const auto& timed_colour = timed.colour.texels[pixel];
        const auto& probed_colour = probe.colour.texels[pixel];
        const double apart = texels_apart(timed_colour, probed_colour, map);
        const bool same = bit_for_bit ? same_colour(timed_colour, probed_colour) : apart <= tolerance_texels;
        if (!is_background(timed_colour[0]) || !is_background(probed_colour[0])) ++drawn;
        if (!same) ++different;
        worst.offer(apart, pixel);
    }
    if (drawn == 0) return {false, "nothing to compare: neither draws a pixel"};
    const double allowed = bit_for_bit ? 0 : tolerated_fraction * static_cast<double>(timed.colour.texels.size());
    return {static_cast<double>(different) <= allowed,
            fmt::format("{} of {} pixels differ ({} are drawn), the worst by {:.3g} texels; {}", different,
                        timed.colour.texels.size(), drawn, worst.value(),
                        bit_for_bit ? "bit for bit on a CPU device" : "half a texel allowed, 0.1 % of pixels excepted"),
            worst.place(timed.colour.size)};
}

double depth_of(const glm::dmat4& clip_from_world, const glm::dvec3& point) {
    const glm::dvec4 clip = clip_from_world * glm::dvec4(point, 1.0);
    return clip.z / clip.w;
}

/// By how much u, v or h of a hit leave [0, 1]; u and v may where the relief repeats.
double excess_of(const Hit& hit, const Relief& relief) {
    const auto beyond = [](double x) { return std::max({0.0, -x, x - 1}); };
    const double sideways = relief.boundary == Boundary::repeat ? 0 : std::max(beyond(hit.u), beyond(hit.v));
    return std::max(sideways, beyond(hit.h));
}

/// Hits in range; t the distance of S(u, v) along the ray; the depth written
/// that of S(u, v).
Finding check_hits(const TimedPicture& timed, const Probe& probe, const View& view, double range_tolerance) {
    constexpr double place_tolerance = 2e-5;  // t and depth go through a matrix in floats
    std::size_t out_of_range = 0;
    WorstPixel range;
    WorstPixel t;
    WorstPixel depth;
    std::size_t hits = 0;
    const glm::dmat4 clip_from_world = reliefbench::clip_from_world(view);
    for (std::size_t pixel = 0; pixel < probe.hits.texels.size(); ++pixel) {
        const Hit& hit = probe.hits.texels[pixel];
        if (!hit.is_hit()) continue;
        ++hits;
        const double excess = excess_of(hit, view.relief);
        if (excess > range_tolerance) ++out_of_range;
        range.offer(excess, pixel);
        const auto [i, j] = place_of(pixel, view.resolution);
        const Ray ray = pixel_ray(view, i, j);
        const glm::dvec3 point = surface_point(view.relief, hit.u, hit.v, hit.h);
        t.offer(std::abs(glm::dot(point - ray.origin, ray.direction) - hit.t), pixel);
        depth.offer(std::abs(depth_of(clip_from_world, point) - timed.depth.at(i, j)), pixel);
    }
    if (hits == 0) return {false, "nothing to check: no pixel is hit"};
    const WorstPixel& worst = out_of_range > 0 ? range : t.value() > place_tolerance ? t : depth;
    return {out_of_range == 0 && t.value() <= place_tolerance && depth.value() <= place_tolerance,
            fmt::format("{} hits, {} out of range, t off by at most {:.2g}, depth by {:.2g} (bound {:g})", hits,
                        out_of_range, t.value(), depth.value(), place_tolerance),
            worst.place(view.resolution)};
}

/// Work counted over the draw, or over its pixels.
double total_taps(const Probe& probe) {
    double taps = probe.stages.taps;
    for (const PixelWork& work : probe.work.texels)
        taps += work.taps;
    return taps;
}

/// Steps, but no texel read.
bool is_uncounted(const PixelWork& work) {
    return work.steps > 0 && work.texels < 1;
}

void check_picture(CheckList& list, const ParameterValues& parameters, const Circumstance& where) {
    const bool bit_for_bit = list.device().info().type == gpu::DeviceType::cpu;
    TimedPicture timed;
    Probe probe;
    const bool agree = list.check("timed and probed agree", parameters, where, [&] {
        const CoordinateScene& scene = list.scenes().get(where.map, where.map_size);
        Renderer renderer = list.make_renderer(parameters, scene, where.view);
        probe = renderer.probe();
        require_picture(list.device(), list.technique(), parameters, probe);
        timed = renderer.draw_timed(ColourTarget::linear_float);
        return compare_pictures(timed, probe, scene.map, bit_for_bit);
    });
    if (agree)
        list.check("hits are in range", parameters, where,
                   [&] { return check_hits(timed, probe, where.view, range_tolerance(list.manifest())); });
}

}  // namespace

bool check_supported(CheckList& list) {
    const Circumstance first = picture_circumstances(list.manifest()).front();
    const std::string reason =
        unsupported_reason(list.device(), list.technique(), list.manifest().defaults(), first.view, first.map_size);
    if (reason.empty()) return true;
    list.skip("runs on this device", list.device().info().name, reason);
    return false;
}

bool check_compiles(CheckList& list) {
    const Circumstance first = picture_circumstances(list.manifest()).front();
    return list.check("compiles", describe(list.manifest().defaults(), list.manifest()), [&]() -> Finding {
        Renderer renderer =
            list.make_renderer(list.manifest().defaults(), list.scenes().get(first.map, first.map_size), first.view);
        renderer.draw_timed(ColourTarget::display);
        renderer.probe();
        return {true, "timed and probed, every stage"};
    });
}

void check_pictures(CheckList& list) {
    const std::vector<Circumstance> circumstances = picture_circumstances(list.manifest());
    const std::vector<ParameterValues> all = variants(list.manifest());
    for (const Circumstance& where : circumstances)
        check_picture(list, all.front(), where);
    // The others in one each, in turn: there are many, and what they share with the defaults has been seen.
    for (std::size_t i = 1; i < all.size(); ++i)
        check_picture(list, all[i], circumstances[i % circumstances.size()]);
}

void check_polygon(CheckList& list) {
    constexpr double tolerance_texels = 1e-3;
    constexpr double tolerated_pixels = 0.005;  // the rasteriser decides pixel centres on the outline
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        const Circumstance where = circumstance(map_of_ones, {32, 32}, projection, 60, -70);
        const ParameterValues parameters = list.manifest().defaults();
        list.check("a map of ones is the polygon", parameters, where, [&]() -> Finding {
            const CoordinateScene& ones = list.scenes().get(where.map, where.map_size);
            const TruthComparison found = list.compare(parameters, ones, where.view);
            const HitErrors& errors = found.errors;
            const double worst = errors.uv_texels ? errors.uv_texels->max : INFINITY;
            const double wrong = errors.missed + errors.false_hits;
            return {worst <= tolerance_texels && wrong <= tolerated_pixels,
                    fmt::format("UV error at most {:.2g} texels (bound {:g}), missed + false hits {:.2g}", worst,
                                tolerance_texels, wrong),
                    worst_place(found, ones.map, where.view, wrong > tolerated_pixels)};
        });
    }
}

void check_work(CheckList& list) {
    const Circumstance where = picture_circumstances(list.manifest()).front();
    list.check("work is counted", list.manifest().defaults(), where, [&]() -> Finding {
        const auto probe_map = [&](const CoordinateScene& scene) {
            return list.compare(list.manifest().defaults(), scene, where.view).probe;
        };
        const Probe relief = probe_map(list.scenes().get(where.map, where.map_size));
        const CoordinateScene& ones = list.scenes().get(map_of_ones, where.map_size);
        const bool reads_the_relief = relief.hits.texels != probe_map(ones).hits.texels;
        const double taps = total_taps(relief);
        WorstPixel worst;
        std::size_t uncounted = 0;
        for (std::size_t pixel = 0; pixel < relief.work.texels.size(); ++pixel) {
            if (!is_uncounted(relief.work.texels[pixel])) continue;
            ++uncounted;
            worst.offer(relief.work.texels[pixel].steps, pixel);
        }
        if (std::ranges::none_of(relief.hits.texels, &Hit::is_hit)) return {false, "nothing to check: no pixel is hit"};
        return {(taps > 0) == reads_the_relief && uncounted == 0,
                fmt::format("{:.3g} taps in all; hits {} on the relief; {} with steps but no texel read", taps,
                            reads_the_relief ? "depend" : "do not depend", counted(uncounted, "pixel")),
                worst.place(where.view.resolution)};
    });
}

}  // namespace reliefbench
