// A straight ray segment against the bilinear surface of one cell between four texel centres.

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
