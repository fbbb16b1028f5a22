#include "measure/followed_history.hpp"

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "gpu/device.hpp"
#include "scene/picture_mean.hpp"
#include "technique/cut_loops.hpp"

#include <cmath>
#include <utility>

namespace reliefbench {

namespace {

constexpr std::size_t distance_rows_per_task = 8;

/// Along each pixel's ray, of what is nearer of the relief, as the technique answers it, and the object.
Image<double> shown_distances(const HitImage& hits, const View& view, const std::optional<SceneObject>& object) {
    Image<double> distances(hits.size, no_distance);
    const PixelRays rays = pixel_rays(view);
    parallel_for(static_cast<std::size_t>(hits.size.height), distance_rows_per_task,
                 [&](std::size_t begin, std::size_t end) {
                     for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
                         for (int x = 0; x < hits.size.width; ++x) {
                             double& distance = distances.at(x, y);
                             const Hit& hit = hits.at(x, y);
                             if (hit.is_hit()) distance = static_cast<double>(hit.t);
                             if (!object) continue;
                             const auto met = intersect(*object, rays.at(x, y), view.camera.projection);
                             if (met && !(distance <= met->t)) distance = met->t;
                         }
                     }
                 });
    return distances;
}

}  // namespace

Probe checked_probe(const gpu::Device& device, Renderer& renderer, const Camera& camera, std::optional<int> frame) {
    Probe probe = renderer.probe_from(camera, frame);
    for (const std::string& reason :
         {reason_of_faults(probe.faults, probe.hits.texels.size()), describe_cut_loops(device, probe)}) {
        if (reason.empty()) continue;
        fail("in motion, from azimuth {:g}° and view angle {:g}°, {}", camera.azimuth, camera.view_angle, reason);
    }
    return probe;
}

void FollowedHistory::start(const gpu::Device& device, Renderer& renderer, const Camera& camera) {
    still_ = still_picture(device, renderer, camera);
    history_ = blend(checked_probe(device, renderer, jittered(camera, 0), 0), camera, camera, still_);
    camera_ = camera;
    frame_ = 0;
}

void FollowedHistory::follow(const gpu::Device& device, Renderer& renderer, const Camera& camera, const Truth& truth,
                             const Image<Landing>& landings) {
    ++frame_;
    Image<std::array<float, 3>> still = still_picture(device, renderer, camera);
    const Probe probe = checked_probe(device, renderer, jittered(camera, frame_), frame_);
    Image<std::array<float, 3>> history = blend(probe, camera, camera_, history_);
    ghosting_.add(ghosting({history, still}, {truth.footprint, truth.background}));
    flip_.add(history_flip(landings, {history_, still_}, {history, still}));
    history_ = std::move(history);
    still_ = std::move(still);
    camera_ = camera;
}

Camera FollowedHistory::jittered(Camera camera, int frame) const {
    camera.shift = frame_shift(frame % still_frames, still_frames, view_.resolution, view_.samples_per_pixel);
    return camera;
}

Image<std::array<float, 3>> FollowedHistory::still_picture(const gpu::Device& device, Renderer& renderer,
                                                           const Camera& camera) const {
    PictureMean mean;
    for (int frame = 0; frame < still_frames; ++frame)
        mean.add(checked_probe(device, renderer, jittered(camera, frame), frame).colour);
    return mean.mean();
}

Image<std::array<float, 3>> FollowedHistory::blend(const Probe& probe, const Camera& camera, const Camera& from,
                                                   const Image<std::array<float, 3>>& history) const {
    View drawn = view_;
    drawn.camera = jittered(camera, frame_);
    const Image<double> distances = shown_distances(probe.hits, drawn, object_);
    const Reprojection reprojection(drawn.camera, from, view_.resolution, view_.relief);
    return next_history(history, {probe.colour, distances, reprojection}, settings_);
}

}  // namespace reliefbench
