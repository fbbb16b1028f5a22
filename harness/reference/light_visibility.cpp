#include "reference/light_visibility.hpp"

#include "core/parallel.hpp"
#include "reference/exact_tracer.hpp"
#include "reference/light_disc.hpp"
#include "reference/pixel_loop.hpp"
#include "reference/scrambled_points.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace reliefbench {

namespace {

constexpr std::size_t pixels_per_task = 64;

/// How much higher than a point its light's first hit must be to shadow it. Both lie on the surface to about 1e-15; but
/// a ray that enters the relief over a plateau has hit it at h = 1 when the surface lies this far below.
constexpr double height_tolerance = entry_tolerance;

/// The hit of a pixel and one light: how many of its points every scrambling has lit.
struct Samples {
    std::size_t pixel = 0;
    std::size_t light = 0;
    std::vector<int> lit;
    /// In each scrambling.
    int points = 0;

    double fraction() const {
        double sum = 0;
        for (const int each : lit)
            sum += each;
        return sum / points / static_cast<double>(lit.size());
    }

    bool is_in_penumbra() const { return fraction() > 0 && fraction() < 1; }

    /// Of the fraction, from the scatter between scramblings.
    double standard_error() const {
        const double mean = fraction();
        double squares = 0;
        for (const int each : lit)
            squares += std::pow(static_cast<double>(each) / points - mean, 2);
        const auto scrambles = static_cast<double>(lit.size());
        return std::sqrt(squares / (scrambles - 1) / scrambles);
    }
};

class LightPathsOverPlane final : public LightPaths {
public:
    LightPathsOverPlane(const HitImage& hits, const HeightMap& map, const Relief& relief)
        : hits_(hits), map_(map), relief_(relief), tracer_(map, relief_) {}

    LitPoint point(std::size_t pixel) const override {
        const double u = hits_.texels[pixel].u;
        const double v = hits_.texels[pixel].v;
        const double h = map_.sample(relief_.tiling * u, relief_.tiling * v);
        return {.place = surface_point(relief_, u, v, h), .h = h};
    }

    void follow(std::span<const LightWay> ways, std::span<std::uint8_t> open) const override {
        std::vector<Ray> rays;
        std::vector<std::size_t> of_way;
        rays.reserve(ways.size());
        of_way.reserve(ways.size());
        for (std::size_t index = 0; index < ways.size(); ++index) {
            open[index] = 0;
            const LightWay& way = ways[index];
            if (const auto ray = light_ray(flat_base(relief_.base), way.point.place, way.to_light)) {
                rays.push_back(*ray);
                of_way.push_back(index);
            }
        }
        std::vector<std::optional<ExactHit>> hits(rays.size());
        tracer_.trace(rays, hits);
        for (std::size_t index = 0; index < rays.size(); ++index) {
            const std::optional<ExactHit>& hit = hits[index];
            open[of_way[index]] = !hit || hit->h <= ways[of_way[index]].point.h + height_tolerance ? 1 : 0;
        }
    }

private:
    const HitImage& hits_;
    const HeightMap& map_;
    Relief relief_;
    ExactTracer tracer_;
};

class VisibilityTracer {
public:
    VisibilityTracer(const LightPaths& paths, const Lighting& lighting) : paths_(paths) {
        for (const DirectionalLight& light : lighting.lights)
            discs_.emplace_back(light);
    }

    std::size_t lights() const { return discs_.size(); }

    /// Of pixels that have hits, which of them the centre of the light lights, 1 or 0.
    std::vector<std::uint8_t> are_lit(std::span<const std::size_t> pixels, std::size_t light) const {
        std::vector<LightWay> ways;
        ways.reserve(pixels.size());
        for (const std::size_t pixel : pixels)
            ways.push_back({paths_.point(pixel), discs_[light].to_centre()});
        std::vector<std::uint8_t> lit(pixels.size());
        paths_.follow(ways, lit);
        return lit;
    }

    /// Goes on to `points` in each scrambling.
    void sample(Samples& samples, int points) const {
        const LitPoint point = paths_.point(samples.pixel);
        const std::size_t scrambles = samples.lit.size();
        const std::uint64_t seed = (samples.pixel * lights() + samples.light) * scrambles;
        const auto added = static_cast<std::size_t>(points - samples.points);
        std::vector<LightWay> ways;
        ways.reserve(scrambles * added);
        for (std::size_t scramble = 0; scramble < scrambles; ++scramble) {
            for (int index = samples.points; index < points; ++index) {
                const glm::dvec2 place = scrambled_sobol_point(static_cast<std::uint32_t>(index), seed + scramble);
                ways.push_back({point, discs_[samples.light].direction(place)});
            }
        }
        std::vector<std::uint8_t> open(ways.size());
        paths_.follow(ways, open);
        for (std::size_t index = 0; index < open.size(); ++index)
            samples.lit[index / added] += open[index];
        samples.points = points;
    }

private:
    const LightPaths& paths_;
    std::vector<LightDisc> discs_;
};

void trace_hard(const VisibilityTracer& tracer, const HitImage& hits, LightVisibility& visibility) {
    for_each_pixel_tile(hits.size, [&](std::span<const PixelPlace> places) {
        std::vector<std::size_t> pixels;
        for (const PixelPlace& place : places) {
            const std::size_t pixel = static_cast<std::size_t>(place.row) * static_cast<std::size_t>(hits.size.width) +
                                      static_cast<std::size_t>(place.column);
            if (hits.texels[pixel].is_hit()) pixels.push_back(pixel);
        }
        for (std::size_t light = 0; light < tracer.lights(); ++light) {
            const std::vector<std::uint8_t> lit = tracer.are_lit(pixels, light);
            for (std::size_t index = 0; index < pixels.size(); ++index)
                visibility.fractions.texels[pixels[index]][light] = lit[index];
        }
    });
}

/// Every hit with the least number of points; returns those of the penumbra.
std::vector<Samples> find_penumbra(const VisibilityTracer& tracer, const HitImage& hits, const LightSampling& sampling,
                                   LightVisibility& visibility) {
    const std::size_t tasks = (hits.texels.size() + pixels_per_task - 1) / pixels_per_task;
    std::vector<std::vector<Samples>> found(tasks);
    parallel_for(hits.texels.size(), pixels_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
            if (!hits.texels[pixel].is_hit()) continue;
            for (std::size_t light = 0; light < tracer.lights(); ++light) {
                Samples samples{pixel, light, std::vector<int>(static_cast<std::size_t>(sampling.scrambles)), 0};
                tracer.sample(samples, sampling.min_points);
                visibility.fractions.texels[pixel][light] = static_cast<float>(samples.fraction());
                if (samples.is_in_penumbra()) found[begin / pixels_per_task].push_back(std::move(samples));
            }
        }
    });
    std::vector<Samples> penumbra;
    for (std::vector<Samples>& task : found)
        std::move(task.begin(), task.end(), std::back_inserter(penumbra));
    return penumbra;
}

double mean_standard_error(const std::vector<Samples>& penumbra) {
    double sum = 0;
    for (const Samples& samples : penumbra)
        sum += samples.standard_error();
    return sum / static_cast<double>(penumbra.size());
}

void trace_soft(const VisibilityTracer& tracer, const HitImage& hits, const LightSampling& sampling,
                LightVisibility& visibility) {
    std::vector<Samples> penumbra = find_penumbra(tracer, hits, sampling, visibility);
    if (penumbra.empty()) return;
    // All of them, whatever their own error: to stop where chance has made it small would hide what is left.
    for (int points = sampling.min_points;
         points < sampling.max_points && mean_standard_error(penumbra) > sampling.standard_error;) {
        points = std::min(2 * points, sampling.max_points);
        parallel_for(penumbra.size(), pixels_per_task, [&](std::size_t begin, std::size_t end) {
            for (std::size_t index = begin; index < end; ++index)
                tracer.sample(penumbra[index], points);
        });
    }
    for (const Samples& samples : penumbra)
        visibility.fractions.texels[samples.pixel][samples.light] = static_cast<float>(samples.fraction());
    visibility.standard_error = mean_standard_error(penumbra);
}

}  // namespace

LightVisibility trace_light_visibility(const HitImage& hits, const LightPaths& paths, const View& view,
                                       const Lighting& lighting, const LightSampling& sampling) {
    assert(lighting.lights.size() <= 3 && sampling.scrambles > 1 && sampling.min_points <= sampling.max_points);
    LightVisibility visibility;
    visibility.fractions = Image<std::array<float, 3>>(hits.size, {1, 1, 1});
    if (view.self_shadow.mode == SelfShadow::Mode::off || !lighting.enabled) return visibility;
    const VisibilityTracer tracer(paths, lighting);
    if (view.self_shadow.mode == SelfShadow::Mode::hard) {
        trace_hard(tracer, hits, visibility);
    } else {
        trace_soft(tracer, hits, sampling, visibility);
    }
    return visibility;
}

LightVisibility trace_light_visibility(const HitImage& hits, const HeightMap& map, const View& view,
                                       const Lighting& lighting, const LightSampling& sampling) {
    return trace_light_visibility(hits, LightPathsOverPlane(hits, map, view.relief), view, lighting, sampling);
}

}  // namespace reliefbench
