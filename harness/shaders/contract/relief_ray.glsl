// A ray that enters the relief (contract 2). Over a plane it is straight and comes down evenly, from h = 1 at s = 0 to
// h = 0 at s = 1. Whoever asks the functions for its points and heights can follow whatever way it takes; whoever needs a
// straight one takes straight_offset.

// Over a curved base a straight ray of the scene bends in texture space: techniques with the parameter `ray_model` can
// follow it to second order. Height alone bends (`quadric`: Oliveira and Policarpo 2005), or height and way (`quadric_uv`).
// The curvature may be given by hand, too, over the plane as well.
#if defined(HAND_CURVATURE_CONSTANT) || defined(HAND_CURVATURE_PER_AXIS) || \
    (defined(RELIEFBENCH_CURVED) && (defined(RAY_MODEL_QUADRIC) || defined(RAY_MODEL_QUADRIC_UV)))
#define RELIEFBENCH_BENT_RAY 1
#endif

struct ReliefRay {
    vec2 uv;             // texture coordinates where the ray enters the relief, at s = 0
    vec3 to_eye;         // unit vector in the orthonormal frame of tangent, bitangent and normal at that point
    float s_end;         // where the ray leaves the relief
    float height_scale;  // H, in units of W
    mat2 uv_per_length;  // texture coordinates for each unit of length along tangent and bitangent
    vec2 straight_offset;
    // Of the pixel's footprint on the polygon: derivatives of `uv` in screen space, and the level of the height map's mip
    // chain whose texels are as large, negative where texels are larger than pixels.
    vec2 uv_dx;
    vec2 uv_dy;
    float level;
#ifdef RELIEFBENCH_BENT_RAY
    float bend;    // of the height, for each s^2: positive where the base falls away beneath the ray
    vec2 uv_bend;  // of the way, texture coordinates for each s^2; none with `quadric`
#endif
};

// Texture coordinates travelled from h = 1 to h = 0 along the tangent plane: -H * uv_per_length * to_eye.xy / to_eye.z.
vec2 straight_offset(ReliefRay ray) { return ray.straight_offset; }

#ifdef RELIEFBENCH_BENT_RAY
vec2 point_on_ray(ReliefRay ray, float s) { return ray.uv + s * (ray.straight_offset + s * ray.uv_bend); }

float height_of_ray(ReliefRay ray, float s) { return 1.0 - s * (1.0 - ray.bend * s); }

// Their derivatives by s.
vec2 way_of_ray(ReliefRay ray, float s) { return ray.straight_offset + 2.0 * s * ray.uv_bend; }

float slope_of_ray(ReliefRay ray, float s) { return 2.0 * ray.bend * s - 1.0; }

// Whether the ray rises again before it has come to h = 0, and leaves the relief at h = 1: over a base that falls away
// faster than it, past the outline.
bool leaves_above(ReliefRay ray) { return ray.bend > 0.25; }

// Where a ray with this bend leaves the relief: at h = 0, or else at h = 1 again.
float end_of_bend(float bend) { return bend > 0.25 ? 1.0 / bend : 2.0 / (1.0 + sqrt(1.0 - 4.0 * bend)); }

// Where the ray is lowest: where it turns, or its end where it does not before.
float lowest_of_ray(ReliefRay ray) { return 2.0 * ray.bend * ray.s_end > 1.0 ? 0.5 / ray.bend : ray.s_end; }

// Where the ray first comes down to height h; where it is lowest if it does not.
float s_at_height(ReliefRay ray, float h) {
    float depth = 1.0 - h;
    float discriminant = 1.0 - 4.0 * ray.bend * depth;
    return discriminant < 0.0 ? lowest_of_ray(ray) : 2.0 * depth / (1.0 + sqrt(discriminant));
}
#else
vec2 point_on_ray(ReliefRay ray, float s) { return ray.uv + s * ray.straight_offset; }

float height_of_ray(ReliefRay ray, float s) { return 1.0 - s; }

// Where the ray comes down to height h.
float s_at_height(ReliefRay ray, float h) { return 1.0 - h; }
#endif

float end_of_ray(ReliefRay ray) { return ray.s_end; }

// H in texture coordinates, along the axis of the texture along which a length covers more of them.
float height_in_uv(ReliefRay ray) {
    mat2 rates = ray.height_scale * ray.uv_per_length;
    vec2 along_axes = abs(rates[0]) + abs(rates[1]);
    return max(along_axes.x, along_axes.y);
}
