#pragma once

#include "scene/camera.hpp"
#include "scene/material_filter.hpp"
#include "scene/self_shadow.hpp"
#include "scene/surface/base_surface.hpp"

#include <glm/vec2.hpp>

#include <optional>
#include <string>

namespace reliefbench {

enum class Boundary {
    /// A hit outside the unit square is a miss.
    clip,
    /// The relief goes on for ever; results are evaluated inside the footprint only.
    repeat,
};

std::string to_string(Boundary boundary);

/// How the height map lies on the patch: the surface S(u,v) = P(u,v) + (h − 1)·height_scale·N(u,v) over the base P with
/// the normal N (scene/surface), h sampled at tiling·(u,v).
struct Relief {
    /// H > 0, in units of the patch side.
    double height_scale = 0.05;
    /// Texture repeats per patch side, > 0.
    double tiling = 1;
    Boundary boundary = Boundary::clip;
    BaseSurface base = {};
    /// Of a flat base: the height of the relief at which the polygon lies that is drawn for it, in [0, 1]. The relief
    /// stays where it is, between z = 0 and z = −height_scale; what is higher stands above the polygon.
    double polygon_height = 1;

    bool operator==(const Relief&) const = default;
};

/// The depth that a per-pixel technique leaves to what is drawn with it.
enum class DepthWrite {
    /// That of the relief's point (gl_FragDepth).
    on,
    /// That of the polygon, which needs no writing and leaves early depth tests alone.
    off,
    /// That of the relief's point, declared never to be nearer than the polygon's (depth_greater), so that what is
    /// hidden behind something nearer than the polygon is still rejected early.
    conservative,
};

/// Everything but the height map that a truth depends on.
struct View {
    Camera camera;
    Relief relief;
    Resolution resolution{256, 256};
    SelfShadow self_shadow = {};
    DepthWrite depth_write = DepthWrite::on;
    MaterialFilter material = {};
    /// Of the picture; a power of two. Each is searched for and shaded by itself; their mean in linear light is the
    /// pixel.
    int samples_per_pixel = 1;
    /// Of which the picture is the mean in linear light: those of a still sequence with a shift each (frame_shift).
    int frames = 1;
    /// Which frame of a sequence it is, from 0: the camera's shift and what techniques vary by frame change with it.
    /// Empty for a picture by itself, whose shaders know no frames; its camera has no shift.
    std::optional<int> frame = {};

    bool operator==(const View&) const = default;
};

/// Whether its picture is another one than that of one sample through each pixel's centre.
inline bool has_picture_of_its_own(const View& view) {
    return view.samples_per_pixel > 1 || view.frames > 1;
}

/// One sample through each pixel's centre, of a picture by itself or of one of its frames.
View through_centres(View view);

/// Of a view with several frames that one; else the view itself.
View frame_of(View view, int frame);

/// A ray that enters the relief over a height of at least 1 − this has hit it there: whether it touches a plateau at
/// h = 1 or passes its edge must not depend on rounding. harness/shaders/contract/relief.glsl has the same.
constexpr double entry_tolerance = 0x1p-20;

/// z of the polygon, at most 0.
double polygon_z(const Relief& relief);

/// Lowers polygon and camera to that height of the relief, whose height scale is known.
void set_polygon_height(View& view, double height);

/// Whether the ray belongs to the footprint F: it crosses the polygon within the unit square, and where the relief ends
/// at its border (clip) enters it within the square, too: what comes in through the side is seen by no search that
/// begins at the top.
bool is_in_footprint(const Ray& ray, const Relief& relief);

/// S over (u, v) at the height h, of a relief on a flat base.
glm::dvec3 surface_point(const Relief& relief, double u, double v, double h);

/// The patch coordinates at which the ray enters through a flat base; empty outside of the unit square.
std::optional<glm::dvec2> footprint_entry(const Ray& ray, const BaseSurface& base = {});

PixelRays pixel_rays(const View& view);

/// One ray of them.
Ray pixel_ray(const View& view, double i, double j);

/// World to Vulkan clip space (perspective_clip and parallel_clip of scene/camera.hpp), with all that is seen of the
/// relief behind the near plane.
glm::dmat4 clip_from_world(const View& view);

}  // namespace reliefbench
