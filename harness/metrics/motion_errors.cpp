#include "metrics/motion_errors.hpp"

#include "core/parallel.hpp"
#include "core/statistics.hpp"
#include "metrics/pixel_errors.hpp"
#include "scene/surface/charts.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

constexpr std::size_t rows_per_task = 8;
/// Neighbouring truth hits are one pixel apart, a point and the pixels around its landing up to √2; the rest is for
/// what the camera's motion stretches.
constexpr double same_surface_spacings = 2;

/// The points of the world that a frame's truth shows.
class FramePoints {
public:
    FramePoints(const TruthFrame& frame, const Relief& relief)
        : hits_(frame.hits),
          relief_(relief),
          is_flat_(is_flat(relief.base)),
          rays_(frame.camera, frame.hits.size, parallel_window(relief.base, frame.camera, relief.height_scale)) {}

    /// Of a pixel that has a hit. (u, v) names a point of the plane only.
    glm::dvec3 at(int x, int y) const {
        const Hit& hit = hits_.at(x, y);
        if (is_flat_) return surface_point(relief_, hit.u, hit.v, hit.h);
        const Ray ray = rays_.at(x, y);
        return ray.origin + static_cast<double>(hit.t) * ray.direction;
    }

    const PixelRays& rays() const { return rays_; }

private:
    const HitImage& hits_;
    const Relief& relief_;
    bool is_flat_;
    PixelRays rays_;
};

/// Distance of truth hits around a pixel: along rows and along columns the nearer of both neighbours, then the larger.
class TruthSpacing {
public:
    TruthSpacing(const HitImage& hits, const FramePoints& points) : hits_(hits), points_(points) {}

    double at(int x, int y) const {
        const double along_row = std::min(to_neighbour(x, y, -1, 0), to_neighbour(x, y, 1, 0));
        const double along_column = std::min(to_neighbour(x, y, 0, -1), to_neighbour(x, y, 0, 1));
        if (std::isinf(along_row) || std::isinf(along_column)) return std::min(along_row, along_column);
        return std::max(along_row, along_column);
    }

private:
    double to_neighbour(int x, int y, int dx, int dy) const {
        constexpr double none = std::numeric_limits<double>::infinity();
        const int other_x = x + dx;
        const int other_y = y + dy;
        if (other_x < 0 || other_x >= hits_.size.width || other_y < 0 || other_y >= hits_.size.height) return none;
        if (!hits_.at(other_x, other_y).is_hit()) return none;
        return glm::distance(points_.at(x, y), points_.at(other_x, other_y));
    }

    const HitImage& hits_;
    const FramePoints& points_;
};

/// `position` as PixelRays counts pixels.
Landing land(glm::dvec2 position, glm::dvec3 point, double tolerance, const TruthFrame& frame,
             const FramePoints& points) {
    const glm::dvec2 corner(std::floor(position.x), std::floor(position.y));
    const glm::dvec2 fraction = position - corner;
    Landing landing{.x = static_cast<int>(corner.x), .y = static_cast<int>(corner.y)};
    const std::size_t nearest = (fraction.x >= 0.5 ? 1U : 0U) + (fraction.y >= 0.5 ? 2U : 0U);
    std::array<double, 4> weights{};
    std::array<bool, 4> same{};
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const bool right = i % 2 == 1;
        const bool below = i >= 2;
        const int x = landing.x + (right ? 1 : 0);
        const int y = landing.y + (below ? 1 : 0);
        if (x < 0 || x >= frame.hits.size.width || y < 0 || y >= frame.hits.size.height) continue;
        same[i] = frame.is_compared(frame.hits.index(x, y)) && glm::distance(points.at(x, y), point) <= tolerance;
        if (!same[i]) continue;
        weights[i] = (right ? fraction.x : 1 - fraction.x) * (below ? fraction.y : 1 - fraction.y);
        sum += weights[i];
    }
    if (!same[nearest]) return landing;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        landing.weights[i] = static_cast<float>(weights[i] / sum);
    }
    return landing;
}

/// Technique − truth.
struct HitDifference {
    double u = 0, v = 0, h = 0, t = 0;

    void add(const HitDifference& other, double weight) {
        u += weight * other.u;
        v += weight * other.v;
        h += weight * other.h;
        t += weight * other.t;
    }
};

HitDifference difference(const Hit& technique, const Hit& truth) {
    return {static_cast<double>(technique.u) - truth.u, static_cast<double>(technique.v) - truth.v,
            static_cast<double>(technique.h) - truth.h, static_cast<double>(technique.t) - truth.t};
}

Hit moved(const Hit& hit, const HitDifference& by) {
    return {static_cast<float>(hit.u + by.u), static_cast<float>(hit.v + by.v), static_cast<float>(hit.h + by.h),
            std::max(0.0F, static_cast<float>(hit.t + by.t))};
}

/// Less `offset`, so that an error that does not change gives exactly 0. Empty when the technique misses in the pixel
/// nearest to the landing.
std::optional<HitDifference> landed_difference(const Landing& landing, const HitImage& technique, const HitImage& truth,
                                               const HitDifference& offset) {
    HitDifference sum;
    double weights = 0;
    float largest_weight = -1;
    bool nearest_hits = false;
    for (std::size_t i = 0; i < landing.weights.size(); ++i) {
        const float weight = landing.weights[i];
        if (weight == 0) continue;
        const int x = landing.x + static_cast<int>(i % 2);
        const int y = landing.y + static_cast<int>(i / 2);
        const Hit& hit = technique.at(x, y);
        const bool hits = is_finite_hit(hit);
        if (weight >= largest_weight) {
            largest_weight = weight;
            nearest_hits = hits;
        }
        if (!hits) continue;
        HitDifference change = difference(hit, truth.at(x, y));
        change.add(offset, -1);
        const glm::dvec2 way = shortest_way({change.u, change.v}, glm::dvec2(landing.chart_period));
        change.u = way.x;
        change.v = way.y;
        sum.add(change, weight);
        weights += weight;
    }
    if (!nearest_hits) return std::nullopt;
    HitDifference mean;
    mean.add(sum, 1 / weights);
    return mean;
}

template <auto Change, auto Member>
std::optional<double> of_change(const MotionErrors& errors) {
    const std::optional<MotionFigures::Values>& values = errors.*Change;
    return values ? std::optional((*values).*Member) : std::nullopt;
}

template <auto Member>
std::optional<double> count_of_pixels(const MotionErrors& errors) {
    return static_cast<double>(errors.*Member);
}

FigureDeclaration between_frames(std::string path, std::string label, std::string unit, Better better) {
    return {.path = std::move(path),
            .label = std::move(label),
            .unit = std::move(unit),
            .better = better,
            .needs = {std::string(figure_needs::truth), std::string(figure_needs::motion)}};
}

FigureDeclaration of_texels(std::string path, std::string label) {
    FigureDeclaration figure = between_frames(std::move(path), std::move(label), "texels", Better::lower);
    figure.over = "motion.compared";
    return figure;
}

FigureDeclaration of_pictures(std::string path, std::string label) {
    FigureDeclaration figure = between_frames(std::move(path), std::move(label), "", Better::lower);
    figure.needs.emplace_back(figure_needs::lighting);
    return figure;
}

FigureDeclaration pixels_of_pairs(std::string path, std::string label, Better better) {
    FigureDeclaration figure = between_frames(std::move(path), std::move(label), "pixels", better);
    figure.is_count = true;
    return figure;
}

const std::vector<FigureOf<MotionErrors>>& motion_table() {
    constexpr auto texels = &MotionErrors::texels;
    constexpr auto flip = &MotionErrors::flip;
    using Values = MotionFigures::Values;
    static const std::vector<FigureOf<MotionErrors>> table = {
        {in_short(of_texels("motion.texels.mean", "Change of the UV error between frames, mean"), "motion",
                  "change of the UV error between frames, texels"),
         of_change<texels, &Values::mean>},
        {of_texels("motion.texels.p95", "Change of the UV error between frames, p95"), of_change<texels, &Values::p95>},
        {of_texels("motion.texels.max", "Change of the UV error between frames, maximum"),
         of_change<texels, &Values::max>},
        {of_pictures("motion.flip.mean", "FLIP between frames, mean"), of_change<flip, &Values::mean>},
        {of_pictures("motion.flip.p95", "FLIP between frames, p95"), of_change<flip, &Values::p95>},
        {of_pictures("motion.flip.max", "FLIP between frames, maximum"), of_change<flip, &Values::max>},
        {pixels_of_pairs("motion.compared", "Pixels of pairs of frames compared", Better::neither),
         count_of_pixels<&MotionErrors::compared>},
        {pixels_of_pairs("motion.hit_once", "Pixels hit in one of two frames only", Better::lower),
         count_of_pixels<&MotionErrors::hit_once>},
        {pixels_of_pairs("motion.unseen", "Pixels seen in one of two frames only", Better::neither),
         count_of_pixels<&MotionErrors::unseen>},
    };
    return table;
}

}  // namespace

TruthMotion follow_truth(const TruthFrame& first, const TruthFrame& second, const Relief& relief) {
    assert(first.hits.size == second.hits.size && first.footprint.size == first.hits.size &&
           second.footprint.size == second.hits.size);
    const Resolution size = first.hits.size;
    const FramePoints first_points(first, relief);
    const FramePoints second_points(second, relief);
    const TruthSpacing spacing(first.hits, first_points);
    TruthMotion motion{.landings = Image<Landing>(size)};
    parallel_for(static_cast<std::size_t>(size.height), rows_per_task, [&](std::size_t begin, std::size_t end) {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            for (int x = 0; x < size.width; ++x) {
                const std::size_t pixel = first.hits.index(x, y);
                if (!first.is_compared(pixel)) continue;
                const glm::dvec3 point = first_points.at(x, y);
                const auto position = second_points.rays().project(point);
                const double tolerance = same_surface_spacings * spacing.at(x, y);
                if (!position || std::isinf(tolerance)) continue;
                const bool in_picture =
                    position->x > -1 && position->x < size.width && position->y > -1 && position->y < size.height;
                if (!in_picture) continue;
                Landing& landing = motion.landings.texels[pixel];
                landing = land(*position, point, tolerance, second, second_points);
                if (first.charts)
                    landing.chart_period =
                        chart_period(curved_base(relief.base), first.charts->entry_triangles.texels[pixel]);
            }
        }
    });
    for (std::size_t pixel = 0; pixel < size.pixels(); ++pixel) {
        motion.unseen += first.is_compared(pixel) && !motion.landings.texels[pixel].is_seen() ? 1 : 0;
    }
    return motion;
}

MotionChange compare_frames(const Image<Landing>& landings, const HitImage& first_truth, const HitImage& second_truth,
                            const HitImage& first, const HitImage& second, const HeightMap& map, const Relief& relief) {
    assert(landings.size == first.size && first.size == first_truth.size && first.size == second.size &&
           first.size == second_truth.size);
    MotionChange change{.texels = {}, .hit_once = 0, .first = HitImage(first.size), .second = HitImage(first.size)};
    for (std::size_t pixel = 0; pixel < landings.texels.size(); ++pixel) {
        const Landing& landing = landings.texels[pixel];
        const Hit& before = first.texels[pixel];
        const bool hits_before = is_finite_hit(before);
        if (hits_before) change.first.texels[pixel] = change.second.texels[pixel] = before;
        if (!landing.is_seen()) continue;
        const HitDifference error_before =
            hits_before ? difference(before, first_truth.texels[pixel]) : HitDifference{};
        const auto by = landed_difference(landing, second, second_truth, error_before);
        change.hit_once += by.has_value() != hits_before ? 1 : 0;
        change.second.texels[pixel] = by ? moved(hits_before ? before : first_truth.texels[pixel], *by) : Hit{};
        if (!by || !hits_before) continue;
        change.texels.push_back(std::hypot(by->u * relief.tiling * map.width(), by->v * relief.tiling * map.height()));
    }
    return change;
}

void MotionFigures::add(std::span<const double> values) {
    if (values.empty()) return;
    const Summary summary = summarize(values);
    ++pairs_;
    sums_.mean += summary.mean;
    sums_.p95 += summary.p95;
    sums_.max = std::max(sums_.max, summary.max);
}

std::optional<MotionFigures::Values> MotionFigures::values() const {
    if (pairs_ == 0) return std::nullopt;
    const auto pairs = static_cast<double>(pairs_);
    return Values{sums_.mean / pairs, sums_.p95 / pairs, sums_.max};
}

std::vector<FigureDeclaration> motion_figures() {
    return declarations_in(motion_table());
}

FigureValueList figures_of(const MotionErrors& errors) {
    return values_in(motion_table(), errors);
}

}  // namespace reliefbench
