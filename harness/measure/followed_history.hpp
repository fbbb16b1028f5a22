#pragma once

#include "metrics/frame_history.hpp"
#include "metrics/history_errors.hpp"
#include "reference/truth.hpp"
#include "scene/scene_object.hpp"
#include "technique/renderer.hpp"

#include <optional>

namespace reliefbench {

/// The probe of a cell from another camera, of a sequence's frame where one is given. An Error where it is not the
/// technique's picture.
Probe checked_probe(const gpu::Device& device, Renderer& renderer, const Camera& camera,
                    std::optional<int> frame = std::nullopt);

/// The history of one cell's frames while its camera moves: each is drawn with the jitter of its place in the sequence
/// and blended in, reprojected by its own depths, and compared with the mean of still_frames jittered ones from the
/// same camera.
class FollowedHistory {
public:
    /// The jitter's period, as in engines, and frames of which the picture of a still camera is the mean.
    static constexpr int still_frames = 16;
    /// Of a pixel, between two frames.
    static constexpr std::size_t bytes_per_pixel = 2 * sizeof(std::array<float, 3>);

    /// `view` with its base surface.
    FollowedHistory(const View& view, const HistorySettings& settings, const std::optional<SceneObject>& object)
        : view_(view), settings_(settings), object_(object) {}

    /// The first frame, before which the camera has stood still for long.
    void start(const gpu::Device& device, Renderer& renderer, const Camera& camera);
    /// The next one, from which the camera sees F as the truth has it. `landings`: TruthMotion's, from the frame
    /// before.
    void follow(const gpu::Device& device, Renderer& renderer, const Camera& camera, const Truth& truth,
                const Image<Landing>& landings);

    HistoryErrors errors() const { return {ghosting_.values(), flip_.values()}; }

private:
    Camera jittered(Camera camera, int frame) const;
    Image<std::array<float, 3>> still_picture(const gpu::Device& device, Renderer& renderer,
                                              const Camera& camera) const;
    /// `from`: the camera of the history.
    Image<std::array<float, 3>> blend(const Probe& probe, const Camera& camera, const Camera& from,
                                      const Image<std::array<float, 3>>& history) const;

    View view_;
    HistorySettings settings_;
    std::optional<SceneObject> object_;
    int frame_ = 0;
    /// Of the newest frame, as all below.
    Camera camera_;
    Image<std::array<float, 3>> history_;
    Image<std::array<float, 3>> still_;
    MotionFigures ghosting_;
    MotionFigures flip_;
};

}  // namespace reliefbench
