#pragma once

#include "core/figure.hpp"
#include "scene/camera.hpp"
#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/relief.hpp"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace reliefbench {

/// Of a base that is not flat, by pixel (CurvedHits).
struct FrameCharts {
    const Image<std::uint32_t>& entry_triangles;
    const Image<std::uint8_t>& off_chart;
};

/// One frame of the truth while the camera moves.
struct TruthFrame {
    const Camera& camera;
    const HitImage& hits;
    const FootprintImage& footprint;
    /// Empty where the base is flat.
    std::optional<FrameCharts> charts = {};

    /// Whether pixels of the frame are compared: in F, hit by the truth, no tie, and on the chart that the ray enters
    /// by, without which coordinates do not tell how far apart hits are.
    bool is_compared(std::size_t pixel) const {
        return footprint.texels[pixel] == in_footprint && hits.texels[pixel].is_hit() &&
               !(charts && charts->off_chart.texels[pixel] != 0);
    }
};

/// Where the surface point that the truth shows in a pixel of one frame lies in the next.
struct Landing {
    /// Upper left of the four pixels around it.
    int x = 0;
    int y = 0;
    /// Bilinear, of the pixels (x, y), (x+1, y), (x, y+1), (x+1, y+1), summing to 1; 0 for pixels in which the truth
    /// shows another surface. All 0 where the point is not seen in the next frame.
    std::array<float, 4> weights{};
    /// After how much of u, and of v, the chart that the point lies on meets itself again; 0 where it does not.
    glm::vec2 chart_period{0, 0};

    bool is_seen() const { return weights[0] + weights[1] + weights[2] + weights[3] > 0; }
};

struct TruthMotion {
    /// By pixel of the first frame.
    Image<Landing> landings;
    /// Truth hits in F of the first frame whose point the second does not show: hidden now, or out of F or the picture,
    /// or a tie or on another chart than its entry there.
    std::size_t unseen = 0;
};

/// Follows each truth hit of the first frame that is compared (TruthFrame::is_compared) into the second, in double. A
/// pixel there shows the same surface if it is compared, too, and its truth hit is within twice the distance of
/// neighbouring truth hits around the pixel that the point comes from (on the nearer side, so that an edge does not
/// count). The point is seen if the pixel nearest to where it lands shows the same surface.
TruthMotion follow_truth(const TruthFrame& first, const TruthFrame& second, const Relief& relief);

/// What a technique does between two frames that the truth does not.
struct MotionChange {
    /// Length of the change of the UV error vector (technique's hit − truth's, in texels) of each pixel in which the
    /// point is seen in both frames and the technique hits in both. The second frame's vector is interpolated
    /// bilinearly among the pixels that show the same surface, so that an error that does not change gives 0. Where the
    /// chart has a period the change goes the shortest way.
    std::vector<double> texels;
    /// Pixels in which the point is seen in both frames and the technique hits in one only.
    std::size_t hit_once = 0;
    /// The technique's hits in the first frame, and the same with the second frame's errors in place of the first's:
    /// shaded from the first camera they are the first frame, and the second one warped onto it by the truth's motion
    /// without a colour being resampled. Where the point is not seen in both frames they are the same.
    HitImage first;
    HitImage second;
};

MotionChange compare_frames(const Image<Landing>& landings, const HitImage& first_truth, const HitImage& second_truth,
                            const HitImage& first, const HitImage& second, const HeightMap& map, const Relief& relief);

/// Over the pairs of neighbouring frames: mean of their means, mean of their 95th percentiles, maximum. So nothing has
/// to be kept of a pair once it is added.
class MotionFigures {
public:
    void add(std::span<const double> values);

    struct Values {
        double mean = 0;
        double p95 = 0;
        double max = 0;
    };
    /// Empty when no pair had a value.
    std::optional<Values> values() const;

private:
    std::size_t pairs_ = 0;
    Values sums_;
};

/// Of all pairs of neighbouring frames.
struct MotionErrors {
    /// Change of the UV error, in texels, and FLIP between the frames; empty when no pair had a value.
    std::optional<MotionFigures::Values> texels, flip;
    /// Pixels: compared; seen in both frames and hit in one only; of F and not seen in the next frame.
    std::size_t compared = 0, hit_once = 0, unseen = 0;
};

std::vector<FigureDeclaration> motion_figures();
FigureValueList figures_of(const MotionErrors& errors);

}  // namespace reliefbench
