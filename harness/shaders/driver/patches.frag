// A fragment of real geometry: the hit is what the rasteriser interpolated.

#include "scene.glsl"
#include "surface.glsl"
#include "taps.glsl"
#include "work.glsl"

layout(location = 0) in vec3 surface;  // u, v, h

void main() {
    ViewRay view = view_ray(gl_FragCoord.xy);
    // Where the relief goes on for ever it is evaluated in the footprint of the patch only.
    if (relief_repeats && !inside_patch(view.entry)) discard;
    count_pixel(scene.resolution, gl_FragCoord.xy, 0, true);
    // As in quad.frag: never negative.
    float t = max(0.0, dot(surface_point(surface.xy, surface.z) - view.origin, view.direction));
    write_surface(vec4(surface, t), view.direction, false, vec3(1.0));
}
