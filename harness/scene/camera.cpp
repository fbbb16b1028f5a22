#include "scene/camera.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cassert>
#include <cmath>

namespace reliefbench {

namespace {

/// Tangents of the half angles that the picture spans.
glm::dvec2 half_extent(const Camera& camera, Resolution resolution) {
    const double vertical = std::tan(glm::radians(camera.fov) / 2);
    return {vertical * resolution.width / resolution.height, vertical};
}

/// The digits of `index` mirrored at the point (Halton 1960).
double radical_inverse(int index, int base) {
    double inverse = 0;
    double digit = 1;
    for (; index > 0; index /= base) {
        digit /= base;
        inverse += digit * (index % base);
    }
    return inverse;
}

/// From index 1 on: point 0 would be a corner of the pixel.
glm::dvec2 halton_point(int frame) {
    return {radical_inverse(frame + 1, 2), radical_inverse(frame + 1, 3)};
}

}  // namespace

glm::dvec2 frame_shift(int frame, int frames, Resolution resolution, int samples_per_pixel) {
    assert(frame >= 0 && frame < frames);
    glm::dvec2 sum{0, 0};
    for (int i = 0; i < frames; ++i)
        sum += halton_point(i);
    const glm::dvec2 pixels = (halton_point(frame) - sum / double(frames)) / double(samples_per_pixel);
    return pixels / glm::dvec2(resolution.width, resolution.height);
}

std::string to_string(Projection projection) {
    return projection == Projection::perspective ? "perspective" : "parallel";
}

CameraFrame camera_frame(const Camera& camera) {
    const double theta = glm::radians(camera.view_angle);
    const double phi = glm::radians(camera.azimuth);
    const glm::dvec3 to_eye{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
    CameraFrame frame;
    frame.eye = camera.distance * to_eye;
    frame.eye.z += camera.target_height;
    frame.forward = -to_eye;
    frame.up = {-std::cos(theta) * std::cos(phi), -std::cos(theta) * std::sin(phi), std::sin(theta)};
    frame.right = glm::cross(frame.forward, frame.up);
    return frame;
}

PixelRays::PixelRays(const Camera& camera, Resolution resolution, const ParallelWindow& window)
    : parallel_(camera.projection == Projection::parallel),
      resolution_(resolution),
      window_(window),
      shift_(camera.shift),
      target_height_(camera.target_height),
      frame_(camera_frame(camera)) {
    assert(resolution.width > 0 && resolution.height > 0);
    const glm::dvec2 extent = half_extent(camera, resolution);
    across_ = frame_.right * extent.x;
    upwards_ = frame_.up * extent.y;
}

Ray PixelRays::at(double i, double j) const {
    const double across = (i + 0.5) / resolution_.width + shift_.x;
    const double down = (j + 0.5) / resolution_.height + shift_.y;
    if (parallel_) {
        const glm::dvec2 size = window_.high - window_.low;
        const glm::dvec3 place{window_.low.x + across * size.x, window_.high.y - down * size.y, target_height_};
        if (window_.top == target_height_) return {place, frame_.forward};
        glm::dvec3 origin = place + frame_.forward * ((window_.top - target_height_) / frame_.forward.z);
        // Not beneath it by rounding: whoever starts there has not entered the relief.
        if (target_height_ != 0) origin.z = window_.top;
        return {origin, frame_.forward};
    }
    return {frame_.eye, glm::normalize(frame_.forward + across_ * (2 * across - 1) + upwards_ * (1 - 2 * down))};
}

std::optional<glm::dvec2> PixelRays::project(glm::dvec3 point) const {
    double across = 0;
    double down = 0;
    if (parallel_) {
        const glm::dvec3 entry = point - frame_.forward * ((point.z - target_height_) / frame_.forward.z);
        const glm::dvec2 size = window_.high - window_.low;
        across = (entry.x - window_.low.x) / size.x;
        down = (window_.high.y - entry.y) / size.y;
    } else {
        const glm::dvec3 from_eye = point - frame_.eye;
        const double depth = glm::dot(from_eye, frame_.forward);
        if (depth <= 0) return std::nullopt;
        across = (glm::dot(from_eye, across_) / (depth * glm::dot(across_, across_)) + 1) / 2;
        down = (1 - glm::dot(from_eye, upwards_) / (depth * glm::dot(upwards_, upwards_))) / 2;
    }
    return glm::dvec2((across - shift_.x) * resolution_.width - 0.5, (down - shift_.y) * resolution_.height - 0.5);
}

double cosine_of_picture_corner(const Camera& camera, Resolution resolution) {
    const glm::dvec2 extent = half_extent(camera, resolution);
    return 1 / std::sqrt(1 + glm::dot(extent, extent));
}

namespace {

/// Moves what a projection shows by the camera's shift, against it.
glm::dmat4 shifted(glm::dmat4 clip, const Camera& camera) {
    if (camera.shift == glm::dvec2(0)) return clip;
    for (int column = 0; column < 4; ++column) {
        clip[column].x -= 2 * camera.shift.x * clip[column].w;
        clip[column].y -= 2 * camera.shift.y * clip[column].w;
    }
    return clip;
}

}  // namespace

glm::dmat4 perspective_clip(const Camera& camera, Resolution resolution, double near) {
    assert(resolution.width > 0 && resolution.height > 0);
    const CameraFrame frame = camera_frame(camera);
    const glm::dvec2 extent = half_extent(camera, resolution);
    const glm::dvec3 x = frame.right / extent.x;
    const glm::dvec3 y = -frame.up / extent.y;
    const glm::dvec3 depth = frame.forward;

    glm::dmat4 clip;
    for (int column = 0; column < 3; ++column) {
        clip[column] = {x[column], y[column], depth[column], depth[column]};
    }
    clip[3] = {-glm::dot(x, frame.eye), -glm::dot(y, frame.eye), -glm::dot(depth, frame.eye) - near,
               -glm::dot(depth, frame.eye)};
    return shifted(clip, camera);
}

glm::dmat4 parallel_clip(const Camera& camera, const ParallelWindow& window) {
    const glm::dvec3 direction = camera_frame(camera).forward;
    const double slide_x = direction.x / direction.z;
    const double slide_y = direction.y / direction.z;
    const glm::dvec2 scale = 2.0 / (window.high - window.low);
    const glm::dvec2 centre = (window.low + window.high) / 2.0;
    glm::dmat4 clip(1.0);
    clip[0] = {scale.x, 0, 0, 0};
    clip[1] = {0, -scale.y, 0, 0};
    clip[2] = {-scale.x * slide_x, scale.y * slide_y, -1 / window.depth, 0};
    // From 0, so that a centred window leaves no negative zero.
    clip[3] = {0 - scale.x * centre.x, scale.y * centre.y, window.top / window.depth, 1};
    if (camera.target_height != 0) {
        clip[3].x += scale.x * slide_x * camera.target_height;
        clip[3].y -= scale.y * slide_y * camera.target_height;
    }
    return shifted(clip, camera);
}

}  // namespace reliefbench
