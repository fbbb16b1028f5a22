#include "metrics/frame_history.hpp"

#include "core/parallel.hpp"
#include "scene/surface/base_surface.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace reliefbench {

namespace {

using HistoryColours = Image<std::array<float, 3>>;

constexpr std::size_t history_rows_per_task = 8;

PixelRays centred_rays(Camera camera, Resolution resolution, const Relief& relief) {
    camera.shift = {0, 0};
    return {camera, resolution, parallel_window(relief.base, camera, relief.height_scale)};
}

glm::dvec3 colour_vector(const std::array<float, 3>& colour) {
    return {colour[0], colour[1], colour[2]};
}

std::array<float, 3> colour_array(glm::dvec3 colour) {
    return {static_cast<float>(colour.x), static_cast<float>(colour.y), static_cast<float>(colour.z)};
}

/// Of the four pixels from one before to two behind, at a fraction of the way between the middle ones (Catmull and Rom
/// 1974, tension ½).
std::array<double, 4> cubic_weights(double t) {
    return {((-0.5 * t + 1) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1, ((-1.5 * t + 2) * t + 0.5) * t,
            (0.5 * t - 0.5) * t * t};
}

/// Beyond the border the picture goes on as it ends.
glm::dvec3 cubic_sample(const HistoryColours& picture, glm::dvec2 position) {
    const glm::dvec2 corner = glm::floor(position);
    const std::array<double, 4> across = cubic_weights(position.x - corner.x);
    const std::array<double, 4> down = cubic_weights(position.y - corner.y);
    glm::dvec3 sum(0);
    for (int row = 0; row < 4; ++row) {
        const int y = std::clamp(static_cast<int>(corner.y) + row - 1, 0, picture.size.height - 1);
        for (int column = 0; column < 4; ++column) {
            const double weight = across[static_cast<std::size_t>(column)] * down[static_cast<std::size_t>(row)];
            if (weight == 0) continue;
            const int x = std::clamp(static_cast<int>(corner.x) + column - 1, 0, picture.size.width - 1);
            sum += weight * colour_vector(picture.at(x, y));
        }
    }
    return sum;
}

glm::dvec3 to_ycocg(glm::dvec3 rgb) {
    return {rgb.x / 4 + rgb.y / 2 + rgb.z / 4, (rgb.x - rgb.z) / 2, rgb.y / 2 - (rgb.x + rgb.z) / 4};
}

glm::dvec3 from_ycocg(glm::dvec3 ycocg) {
    const double without_green = ycocg.x - ycocg.z;
    return {without_green + ycocg.y, ycocg.x + ycocg.z, without_green - ycocg.y};
}

/// Luma and chroma vary apart from each other, so that the box is tighter than one in RGB (Karis 2014). What lies
/// within is not changed.
glm::dvec3 clamped_to_neighbours(glm::dvec3 history, const HistoryColours& frame, int x, int y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    glm::dvec3 low(infinity);
    glm::dvec3 high(-infinity);
    for (int row = std::max(0, y - 1); row <= std::min(frame.size.height - 1, y + 1); ++row) {
        for (int column = std::max(0, x - 1); column <= std::min(frame.size.width - 1, x + 1); ++column) {
            const glm::dvec3 neighbour = to_ycocg(colour_vector(frame.at(column, row)));
            low = glm::min(low, neighbour);
            high = glm::max(high, neighbour);
        }
    }
    const glm::dvec3 found = to_ycocg(history);
    const glm::dvec3 clamped = glm::clamp(found, low, high);
    return clamped == found ? history : from_ycocg(clamped);
}

bool is_in_picture(glm::dvec2 position, Resolution size) {
    return position.x >= -0.5 && position.x <= size.width - 0.5 && position.y >= -0.5 &&
           position.y <= size.height - 0.5;
}

}  // namespace

Reprojection::Reprojection(const Camera& from, const Camera& to, Resolution resolution, const Relief& relief)
    : is_perspective_(from.projection == Projection::perspective),
      drawn_(from, resolution, parallel_window(relief.base, from, relief.height_scale)),
      from_(centred_rays(from, resolution, relief)),
      to_(centred_rays(to, resolution, relief)),
      from_eye_(camera_frame(from).eye),
      to_eye_(camera_frame(to).eye) {
    assert(from.projection == to.projection);
}

std::optional<glm::dvec2> Reprojection::operator()(int x, int y, double distance) const {
    const glm::dvec2 pixel(x, y);
    const bool shows_background = std::isnan(distance);
    if (shows_background && !is_perspective_) return pixel;
    const Ray ray = drawn_.at(x, y);
    const glm::dvec3 way = shows_background ? ray.direction : distance * ray.direction;
    const std::optional<glm::dvec2> now = from_.project(ray.origin + way);
    const std::optional<glm::dvec2> there = to_.project((shows_background ? to_eye_ : ray.origin) + way);
    if (!now || !there) return std::nullopt;
    return pixel + (*there - *now);
}

Image<std::array<float, 3>> next_history(const HistoryColours& history, const HistoryFrame& frame,
                                         const HistorySettings& settings) {
    assert(history.size == frame.colour.size && history.size == frame.distances.size);
    HistoryColours next = frame.colour;
    parallel_for(static_cast<std::size_t>(next.size.height), history_rows_per_task,
                 [&](std::size_t begin, std::size_t end) {
                     for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
                         for (int x = 0; x < next.size.width; ++x) {
                             const auto position = frame.reprojection(x, y, frame.distances.at(x, y));
                             if (!position || !is_in_picture(*position, next.size)) continue;
                             glm::dvec3 before = cubic_sample(history, *position);
                             if (settings.neighbourhood_clamp)
                                 before = clamped_to_neighbours(before, frame.colour, x, y);
                             const glm::dvec3 now = colour_vector(frame.colour.at(x, y));
                             next.at(x, y) = colour_array(now + settings.weight * (before - now));
                         }
                     }
                 });
    return next;
}

}  // namespace reliefbench
