// A segment of a ray, straight or bent, against the bilinear surface of one cell between four texel centres.

// Height at `position` in [0, 1]^2 of the cell with corners (h00, h10, h01, h11).
float patch_height(vec4 corners, vec2 position) {
    vec2 along_u = mix(corners.xz, corners.yw, position.x);
    return mix(along_u.x, along_u.y, position.y);
}

// Returned where the segment stays above the surface.
const float no_crossing = -1.0;

// The fraction of the segment, in [0, 1], at which the ray first passes from above the surface to beneath it.
// `from` and `to` are (position in the cell, ray height); cell-local positions keep float precision far from the origin.
// The caller comes from above: a segment that starts at or beneath the surface has lost its crossing to rounding at the
// wall of the cell before, and crosses at 0, so that nothing leaks through walls.
float cross_patch(vec4 corners, vec3 from, vec3 to) {
    float twist = corners.x + corners.w - corners.y - corners.z;
    vec3 way = to - from;
    vec2 slope = vec2(mix(corners.y - corners.x, corners.w - corners.z, from.y),
                      mix(corners.z - corners.x, corners.w - corners.y, from.x));

    // Ray minus surface along the segment: a t^2 + b t + c.
    float a = -twist * way.x * way.y;
    float b = way.z - dot(slope, way.xy);
    float c = from.z - patch_height(corners, from.xy);
    if (c <= 0.0) return 0.0;

    // The falling root is (-b - sqrt(D)) / 2a; either form below adds numbers of one sign only.
    float discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return no_crossing;
    float root = sqrt(discriminant);
    float numerator = b < 0.0 ? 2.0 * c : b + root;
    float denominator = b < 0.0 ? root - b : -2.0 * a;
    return denominator > 0.0 && numerator <= denominator ? numerator / denominator : no_crossing;
}

#ifdef RELIEFBENCH_BENT_RAY
// The same of a bent segment: (position in the cell, ray height) = from + way * t + bend * t^2. Where the position bends,
// the gap between ray and surface has small terms of third and fourth order: the root is that of the parabola through the
// gap at 0, 1/2 and 1, corrected by Newton's method. A segment that ends beneath the surface crosses in any case; one that
// comes out again, where it was deeper than an eighth of these terms' coefficients.
float cross_bent_patch(vec4 corners, vec3 from, vec3 way, vec3 bend) {
    float twist = corners.x + corners.w - corners.y - corners.z;
    vec2 slope = vec2(mix(corners.y - corners.x, corners.w - corners.z, from.y),
                      mix(corners.z - corners.x, corners.w - corners.y, from.x));
    // Ray minus surface: e t^4 + d t^3 + a t^2 + b t + c.
    float e = -twist * bend.x * bend.y;
    float d = -twist * (way.x * bend.y + way.y * bend.x);
    float a = bend.z - dot(slope, bend.xy) - twist * way.x * way.y;
    float b = way.z - dot(slope, way.xy);
    float c = from.z - patch_height(corners, from.xy);
    if (c <= 0.0) return 0.0;

    // As in cross_patch; t^3 is 3/2 t^2 - 1/2 t at all three places, t^4 is 7/4 t^2 - 3/4 t.
    float parabola_a = a + 1.5 * d + 1.75 * e;
    float parabola_b = b - 0.5 * d - 0.75 * e;
    float discriminant = parabola_b * parabola_b - 4.0 * parabola_a * c;
    if (discriminant < 0.0) return no_crossing;
    float root = sqrt(discriminant);
    float numerator = parabola_b < 0.0 ? 2.0 * c : parabola_b + root;
    float denominator = parabola_b < 0.0 ? root - parabola_b : -2.0 * parabola_a;
    if (denominator <= 0.0 || numerator > denominator) return no_crossing;
    float t = numerator / denominator;
    for (int i = 0; i < 2; ++i) {
        float gap = c + t * (b + t * (a + t * (d + t * e)));
        float rate = b + t * (2.0 * a + t * (3.0 * d + t * 4.0 * e));
        if (rate < 0.0) t = clamp(t - gap / rate, 0.0, 1.0);
    }
    return t;
}
#endif
