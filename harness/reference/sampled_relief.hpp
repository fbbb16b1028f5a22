#pragma once

#include "reference/exact_tracer.hpp"
#include "reference/light_visibility.hpp"
#include "reference/surface_shader.hpp"
#include "scene/height_map.hpp"
#include "scene/ray.hpp"
#include "scene/relief.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace reliefbench {

/// What one ray of a picture sees of the relief.
struct SurfaceSample {
    /// What follows is of a hit.
    bool is_hit = false;
    /// Along the ray.
    double t = 0;
    glm::dvec2 uv{};
    /// Of shading, a unit vector in world space.
    glm::dvec3 normal{};
    /// Where its light comes to; unset where the view has no shadows.
    LitPoint point{};
};

/// A relief as very many rays see it, neighbours at once. Any number of threads may ask.
class SampledRelief {
public:
    SampledRelief() = default;
    SampledRelief(const SampledRelief&) = delete;
    SampledRelief& operator=(const SampledRelief&) = delete;
    virtual ~SampledRelief() = default;

    /// What each ray shows of the relief; no hit where that is the background.
    virtual void see(std::span<const Ray> rays, std::span<SurfaceSample> samples) const = 0;

    /// Sets reached[i] to whether light comes to points[i] from the direction to_light[i], a unit vector.
    virtual void light(std::span<const LitPoint> points, std::span<const glm::dvec3> to_light,
                       std::span<std::uint8_t> reached) const = 0;

    /// Whether it is sure that no ray between these four sees the relief.
    virtual bool is_beyond(const std::array<Ray, 4>& /*corners*/) const { return false; }
};

/// Over the plane, as the truth of one ray a pixel has it: past the footprint, Boundary::repeat shows the background.
class SampledReliefOverPlane final : public SampledRelief {
public:
    using Trace = std::function<void(std::span<const Ray>, std::span<std::optional<ExactHit>>)>;

    /// Hits come from `trace`, light by the exact tracer. All that it is given must outlive it.
    SampledReliefOverPlane(const HeightMap& map, const View& view, const SurfaceShader& shader,
                           const ExactTracer& tracer, Trace trace);

    void see(std::span<const Ray> rays, std::span<SurfaceSample> samples) const override;
    void light(std::span<const LitPoint> points, std::span<const glm::dvec3> to_light,
               std::span<std::uint8_t> reached) const override;
    bool is_beyond(const std::array<Ray, 4>& corners) const override;

private:
    const HeightMap& map_;
    const View& view_;
    const SurfaceShader& shader_;
    const ExactTracer& tracer_;
    Trace trace_;
};

}  // namespace reliefbench
