#include "verify/promise_checks.hpp"

#include "scene/procedural.hpp"
#include "verify/worst_pixel.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace reliefbench {

namespace {

constexpr double checked_height_scale = 0.1;
constexpr double tolerated_pixels = 0.005;

/// Every procedural map at every angle; sizes, projections, azimuths, tilings and boundaries take turns.
std::vector<Circumstance> intersection_circumstances(const Manifest& manifest) {
    constexpr std::array<double, 4> angles{0, 45, 75, 85};
    constexpr std::array<Resolution, 3> sizes{Resolution{128, 128}, Resolution{96, 160}, Resolution{64, 64}};
    // Along texel rows, where the surface is straight in each cell, one time in five.
    constexpr std::array<double, 5> azimuths{-67, 25, -45, 160, -90};
    std::vector<Circumstance> all;
    for (const ProceduralMap& map : procedural_maps()) {
        for (const double angle : angles) {
            const std::size_t turn = all.size() + all.size() / angles.size();
            View view;
            view.camera.projection = turn % 2 == 0 ? Projection::parallel : Projection::perspective;
            view.camera.view_angle = angle;
            view.camera.azimuth = azimuths[turn % azimuths.size()];
            view.relief.height_scale = checked_height_scale;
            view.relief.tiling = turn % 7 == 3 ? 3 : 1;
            view.relief.boundary = turn % 4 == 2 ? Boundary::repeat : Boundary::clip;
            view.resolution = {96, 96};
            all.push_back(as_needed(manifest, {map.name, sizes[turn % sizes.size()], view}));
        }
    }
    return all;
}

struct UnconvergedPixels {
    std::size_t pixels = 0;
    std::optional<PixelPlace> first = {};
};

UnconvergedPixels unconverged_pixels(const Probe& probe) {
    UnconvergedPixels found;
    for (std::size_t pixel = 0; pixel < probe.work.texels.size(); ++pixel) {
        if (probe.work.texels[pixel].unconverged == 0) continue;
        if (found.pixels++ == 0) found.first = place_of(pixel, probe.work.size);
    }
    return found;
}

/// Footprint pixels whose point lies too far beyond the first hit, and the one that goes farthest.
struct BeyondFirstHit {
    std::size_t pixels = 0;
    std::optional<PixelPlace> farthest = {};
};

BeyondFirstHit beyond_first_hit(const TruthComparison& comparison, const HeightMap& map, const View& view,
                                double deviation) {
    constexpr double tolerance_texels = 0.5;
    BeyondFirstHit beyond;
    WorstPixel worst;
    for (std::size_t pixel = 0; pixel < comparison.truth.hits.texels.size(); ++pixel) {
        const Hit& truth = comparison.truth.hits.texels[pixel];
        if (comparison.truth.footprint.texels[pixel] != in_footprint || !truth.is_hit()) continue;
        const Hit& hit = comparison.probe.hits.texels[pixel];
        const auto [i, j] = place_of(pixel, view.resolution);
        const double stride = texels_through_relief(view, map, i, j);
        const glm::dvec3 direction = tangent_direction(view, i, j);
        const double texels_per_length = stride * std::abs(direction.z) / view.relief.height_scale;
        const double texels = hit.is_hit() ? (hit.t - truth.t) * texels_per_length : INFINITY;
        worst.offer(texels, pixel);
        if (texels > tolerance_texels + deviation * stride) ++beyond.pixels;
    }
    beyond.farthest = worst.place(view.resolution);
    return beyond;
}

}  // namespace

std::size_t pixels_beyond(const TruthComparison& comparison, const HeightMap& map, const View& view, double deviation) {
    return beyond_first_hit(comparison, map, view, deviation).pixels;
}

void check_first_hit(CheckList& list, const PromiseDeclaration& declaration) {
    constexpr double tolerance_texels = 0.1;
    const ParameterValues parameters = with_values(list.manifest(), declaration.with);
    for (const Circumstance& where : intersection_circumstances(list.manifest())) {
        list.check("first_hit", parameters, where, [&]() -> Finding {
            const CoordinateScene& scene = list.scenes().get(where.map, where.map_size);
            const TruthComparison& found = list.comparison(parameters, where);
            const double floor =
                list.filter_deviation() * most_texels_through_relief(where.view, scene.map, found.truth.footprint);
            const double p99 = found.errors.uv_texels ? found.errors.uv_texels->p99 : INFINITY;
            const double wrong = found.errors.missed + found.errors.false_hits;
            const UnconvergedPixels unconverged = unconverged_pixels(found.probe);
            return {p99 < tolerance_texels + floor && wrong <= tolerated_pixels && unconverged.pixels == 0,
                    fmt::format("UV error p99 {:.3g} texels (bound {:.3g}), missed + false hits {:.4f} (bound {:g}), "
                                "{} searches ended by their cap",
                                p99, tolerance_texels + floor, wrong, tolerated_pixels, unconverged.pixels),
                    wrong > tolerated_pixels || p99 >= tolerance_texels + floor
                        ? worst_place(found, scene.map, where.view, wrong > tolerated_pixels)
                        : unconverged.first};
        });
    }
}

void check_conservative(CheckList& list, const PromiseDeclaration& declaration) {
    const ParameterValues parameters = with_values(list.manifest(), declaration.with);
    for (const Circumstance& where : intersection_circumstances(list.manifest())) {
        list.check("conservative", parameters, where, [&]() -> Finding {
            const CoordinateScene& scene = list.scenes().get(where.map, where.map_size);
            const TruthComparison& found = list.comparison(parameters, where);
            const BeyondFirstHit beyond = beyond_first_hit(found, scene.map, where.view, list.filter_deviation());
            if (found.errors.compared == 0) return {false, "nothing to compare: no pixel has both hits"};
            const double fraction = static_cast<double>(beyond.pixels) / static_cast<double>(found.errors.footprint);
            return {fraction <= tolerated_pixels,
                    fmt::format("{} of {} pixels go more than half a texel past the first hit (bound {:g})",
                                beyond.pixels, found.errors.footprint, tolerated_pixels),
                    beyond.farthest};
        });
    }
}

}  // namespace reliefbench
