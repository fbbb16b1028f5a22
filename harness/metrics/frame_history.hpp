#pragma once

#include "scene/camera.hpp"
#include "scene/image.hpp"
#include "scene/relief.hpp"

#include <glm/vec2.hpp>

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace reliefbench {

/// What temporal antialiasing makes of a sequence of frames: an exponential history, carried from frame to frame by the
/// depths that the frames show. Pictures are linear RGB.

struct HistorySettings {
    /// The fraction of the history that a frame leaves of it, in [0, 1); 0 shows each frame by itself.
    double weight = 0;
    /// Whether the history is clamped, before a frame is blended in, to what the frame's own 3×3 pixels span.
    bool neighbourhood_clamp = false;
};

/// Of a pixel that shows the background.
inline constexpr double no_distance = std::numeric_limits<double>::quiet_NaN();

/// Where what a pixel of one frame shows lay in the picture of another. Cameras may have a shift: pictures of histories
/// stand on the pixels' centres, so that what moves is what the unshifted cameras see move, and between two frames of a
/// still camera nothing does, exactly.
class Reprojection {
public:
    Reprojection(const Camera& from, const Camera& to, Resolution resolution, const Relief& relief);

    /// As PixelRays counts pixels; may lie outside the picture, and is empty where the other camera does not look.
    /// `distance` is that of the point along the pixel's (shifted) ray, negative before the origins of parallel rays.
    /// With no_distance the pixel shows the background, which lies infinitely far away: it turns with a perspective
    /// camera, and stays where it is under parallel rays.
    std::optional<glm::dvec2> operator()(int x, int y, double distance) const;

private:
    bool is_perspective_;
    PixelRays drawn_;
    PixelRays from_;
    PixelRays to_;
    /// Of perspective cameras.
    glm::dvec3 from_eye_;
    glm::dvec3 to_eye_;
};

/// A frame as it was drawn.
struct HistoryFrame {
    const Image<std::array<float, 3>>& colour;
    /// By pixel, for Reprojection.
    const Image<double>& distances;
    /// From this frame to the one that the history ends with.
    const Reprojection& reprojection;
};

/// The history with one frame more: weight · history + (1 − weight) · frame, the history sampled where each pixel's
/// point was, by Catmull and Rom's cubic. A pixel whose point was outside the picture gets the frame alone.
Image<std::array<float, 3>> next_history(const Image<std::array<float, 3>>& history, const HistoryFrame& frame,
                                         const HistorySettings& settings);

}  // namespace reliefbench
