#include "reference/filtered_truth.hpp"

#include "reference/light_disc.hpp"
#include "reference/light_visibility.hpp"
#include "reference/pixel_loop.hpp"
#include "reference/scrambled_points.hpp"
#include "reference/shading.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace reliefbench {

namespace {

/// Rays that are traced at once, of whole pixels: enough for tracers that take neighbours together, and few enough to
/// stay in a core's own cache.
constexpr std::size_t rays_at_once = 512;

/// Of a pixel's samples, which numbers chance depends on.
enum class Drawn : std::uint64_t { place = 0, light = 1, order_of_light = 4 };

/// Pixels side by side, all samples of one behind each other, those of the first scrambling first.
struct SampleBatch {
    explicit SampleBatch(std::size_t size)
        : rays(size),
          samples(size),
          visibility(size, {1, 1, 1}),
          points(size),
          to_light(size),
          owners(size),
          lit(size) {}

    std::vector<Ray> rays;
    std::vector<SurfaceSample> samples;
    std::vector<std::array<double, 3>> visibility;
    // Of the light rays asked for at once.
    std::vector<LitPoint> points;
    std::vector<glm::dvec3> to_light;
    std::vector<std::size_t> owners;
    std::vector<std::uint8_t> lit;
};

class PictureFilter {
public:
    PictureFilter(const SampledRelief& relief, const SurfaceShader& shader, const View& view, const Lighting& lighting,
                  const TruthPicture& picture)
        : relief_(relief),
          shader_(shader),
          view_(view),
          lighting_(lighting),
          object_(picture.object),
          rays_(pixel_rays(view)),
          count_(static_cast<std::size_t>(picture.samples)),
          halves_{count_ - count_ / 2, count_ / 2},
          directions_(directions_each(view, picture.samples)),
          points_(static_cast<std::uint32_t>(std::bit_ceil(halves_[0] * directions_))) {
        for (const DirectionalLight& light : lighting.lights)
            discs_.emplace_back(light);
    }

    std::size_t pixels_at_once() const { return std::max<std::size_t>(1, rays_at_once / count_); }
    std::size_t rays_of_batch() const { return pixels_at_once() * count_; }

    /// Of pixels (first, row) to (end − 1, row), at most pixels_at_once.
    void filter(int row, int first, int end, SampleBatch& batch, Truth& truth) const {
        // Those of which nothing is seen are left out.
        std::vector<int> columns;
        for (int column = first; column < end; ++column) {
            if (shows_nothing(column, row)) {
                set(truth, column, row, {}, 0);
            } else {
                columns.push_back(column);
            }
        }
        for (std::size_t pixel = 0; pixel < columns.size(); ++pixel)
            place(columns[pixel], row, std::span(batch.rays).subspan(pixel * count_, count_));
        const std::size_t rays = columns.size() * count_;
        relief_.see(std::span(batch.rays).first(rays), std::span(batch.samples).first(rays));
        if (view_.self_shadow.mode != SelfShadow::Mode::off && lighting_.enabled) light(columns, row, batch);
        for (std::size_t pixel = 0; pixel < columns.size(); ++pixel)
            average(columns[pixel], row, batch, pixel * count_, truth);
    }

private:
    /// Of soft shadows, for each sample and light; a power of two, so that each sample's are stratified.
    static std::size_t directions_each(const View& view, int samples) {
        if (view.self_shadow.mode != SelfShadow::Mode::soft) return 1;
        const LightSampling usual;
        const int least = usual.scrambles * usual.min_points;
        return std::bit_ceil(static_cast<std::size_t>((least + samples - 1) / samples));
    }

    std::uint64_t seed(int column, int row, std::size_t scrambling, Drawn drawn, std::size_t light = 0) const {
        const std::uint64_t pixel = truth_pixel(column, row);
        return (pixel * 2 + scrambling) * 8 + static_cast<std::uint64_t>(drawn) + light;
    }

    std::uint64_t truth_pixel(int column, int row) const {
        return static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(view_.resolution.width) +
               static_cast<std::uint64_t>(column);
    }

    bool shows_nothing(int column, int row) const {
        if (object_ != nullptr) return false;
        const double left = column - 0.5;
        const double top = row - 0.5;
        return relief_.is_beyond(
            {rays_.at(left, top), rays_.at(left + 1, top), rays_.at(left, top + 1), rays_.at(left + 1, top + 1)});
    }

    void place(int column, int row, std::span<Ray> rays) const {
        std::array<glm::dvec2, max_truth_samples> places;
        points_.fill(seed(column, row, 0, Drawn::place), std::span(places).first(halves_[0]));
        points_.fill(seed(column, row, 1, Drawn::place), std::span(places).subspan(halves_[0], halves_[1]));
        for (std::size_t i = 0; i < count_; ++i)
            rays[i] = rays_.at(column - 0.5 + places[i].x, row - 0.5 + places[i].y);
    }

    /// Sets the visibilities of all lights at the samples of these pixels.
    void light(const std::vector<int>& columns, int row, SampleBatch& batch) const {
        for (std::size_t light = 0; light < discs_.size(); ++light) {
            for (std::size_t direction = 0; direction < directions_; ++direction)
                light_from(columns, row, light, direction, batch);
        }
    }

    /// One direction to one light for each sample that this light falls on.
    void light_from(const std::vector<int>& columns, int row, std::size_t light, std::size_t direction,
                    SampleBatch& batch) const {
        const bool is_soft = view_.self_shadow.mode == SelfShadow::Mode::soft;
        const LightDisc& disc = discs_[light];
        std::size_t asked = 0;
        for (std::size_t pixel = 0; pixel < columns.size(); ++pixel) {
            for (std::size_t i = 0; i < count_; ++i) {
                const std::size_t at = pixel * count_ + i;
                const SurfaceSample& sample = batch.samples[at];
                if (direction == 0) batch.visibility[at][light] = 0;
                if (!sample.is_hit || glm::dot(sample.normal, disc.to_centre()) <= 0) continue;
                batch.points[asked] = sample.point;
                batch.to_light[asked] =
                    is_soft ? direction_of(columns[pixel], row, light, i, direction) : disc.to_centre();
                batch.owners[asked++] = at;
            }
        }
        const auto reached = std::span(batch.lit).first(asked);
        relief_.light(std::span(batch.points).first(asked), std::span(batch.to_light).first(asked), reached);
        const double share = 1.0 / static_cast<double>(directions_);
        for (std::size_t i = 0; i < asked; ++i) {
            if (reached[i] != 0) batch.visibility[batch.owners[i]][light] += share;
        }
    }

    glm::dvec3 direction_of(int column, int row, std::size_t light, std::size_t sample, std::size_t direction) const {
        const std::size_t scrambling = sample < halves_[0] ? 0 : 1;
        const auto index = static_cast<std::uint32_t>((sample - scrambling * halves_[0]) * directions_ + direction);
        const auto all = static_cast<std::uint32_t>(std::bit_ceil(halves_[0] * directions_));
        const std::uint32_t shuffled =
            scrambled_index(index, all, seed(column, row, scrambling, Drawn::order_of_light, light));
        return discs_[light].direction(points_.at(shuffled, seed(column, row, scrambling, Drawn::light, light)));
    }

    void average(int column, int row, const SampleBatch& batch, std::size_t begin, Truth& truth) const {
        std::array<glm::dvec3, 2> sums{glm::dvec3(0), glm::dvec3(0)};
        std::size_t shown = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const std::optional<glm::dvec3> colour = colour_of(batch, begin + i);
            shown += colour ? 1 : 0;
            sums[i < halves_[0] ? 0 : 1] += colour.value_or(lighting_.background);
        }
        set(truth, column, row, sums, shown);
    }

    /// Empty for the background.
    std::optional<glm::dvec3> colour_of(const SampleBatch& batch, std::size_t at) const {
        const SurfaceSample& sample = batch.samples[at];
        const Ray& ray = batch.rays[at];
        if (object_ != nullptr) {
            const std::optional<ObjectHit> met = intersect(*object_, ray, view_.camera.projection);
            if (met && (!sample.is_hit || met->t < sample.t))
                return reliefbench::shade(lighting_, object_->colour, met->normal, -ray.direction, met->t);
        }
        if (!sample.is_hit) return std::nullopt;
        return shader_.shade(sample.uv, sample.normal, -ray.direction, sample.t, batch.visibility[at]);
    }

    void set(Truth& truth, int column, int row, const std::array<glm::dvec3, 2>& sums, std::size_t shown) const {
        const std::size_t pixel = truth.colour.index(column, row);
        if (shown == 0) {
            // Exactly the background, which rounded sums might not be.
            truth.colour.texels[pixel] = truth.half_picture->texels[pixel] = truth.background;
            return;
        }
        const auto all = static_cast<double>(count_);
        const auto first = static_cast<double>(halves_[0]);
        const glm::dvec3 mean = (sums[0] + sums[1]) / all;
        const glm::dvec3 half = sums[0] / first;
        // The halves differ by √(1/n₁ + 1/n₂) times what one sample's colour is spread by, the mean by √(1/n).
        const glm::dvec3 error = (half - sums[1] / (all - first)) * std::sqrt(first * (all - first)) / all;
        for (glm::length_t channel = 0; channel < 3; ++channel) {
            truth.colour.texels[pixel][static_cast<std::size_t>(channel)] = static_cast<float>(mean[channel]);
            truth.half_picture->texels[pixel][static_cast<std::size_t>(channel)] = static_cast<float>(half[channel]);
        }
        truth.standard_error->texels[pixel] = static_cast<float>(std::sqrt(glm::dot(error, error) / 3));
    }

    const SampledRelief& relief_;
    const SurfaceShader& shader_;
    const View& view_;
    const Lighting& lighting_;
    const SceneObject* object_;
    PixelRays rays_;
    std::size_t count_;
    /// Samples of each scrambling.
    std::array<std::size_t, 2> halves_;
    std::size_t directions_;
    ScrambledPoints points_;
    std::vector<LightDisc> discs_;
};

}  // namespace

void filter_picture(Truth& truth, const SampledRelief& relief, const SurfaceShader& shader, const View& view,
                    const Lighting& lighting, const TruthPicture& picture) {
    assert(picture.samples > 1 && picture.samples <= max_truth_samples);
    truth.samples = picture.samples;
    truth.colour = Image<std::array<float, 3>>(view.resolution);
    truth.half_picture = Image<std::array<float, 3>>(view.resolution);
    truth.standard_error = Image<float>(view.resolution);
    const PictureFilter filter(relief, shader, view, lighting, picture);
    parallel_for(static_cast<std::size_t>(view.resolution.height), 1, [&](std::size_t begin, std::size_t end) {
        SampleBatch batch(filter.rays_of_batch());
        const int width = view.resolution.width;
        const int step = static_cast<int>(filter.pixels_at_once());
        for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
            for (int column = 0; column < width; column += step)
                filter.filter(row, column, std::min(column + step, width), batch, truth);
        }
    });
}

}  // namespace reliefbench
