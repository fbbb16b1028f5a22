// How steep the bilinear surface is at most: (least, most) rise from texel to texel along u, then along v, as
// (1 + rise) / 2 in 16 bits, rounded outwards.

const float stored_steps = 65535.0;

vec4 encode_slopes(vec4 rises) {
    vec4 scaled = (0.5 + 0.5 * rises) * stored_steps;
    return vec4(floor(scaled.x), ceil(scaled.y), floor(scaled.z), ceil(scaled.w)) / stored_steps;
}

vec4 decode_slopes(vec4 stored) {
    return 2.0 * stored - 1.0;
}

// Bounds of both.
vec4 join_slopes(vec4 a, vec4 b) {
    return vec4(min(a.x, b.x), max(a.y, b.y), min(a.z, b.z), max(a.w, b.w));
}

// Joined with anything they change nothing.
const vec4 no_slopes = vec4(1.0, -1.0, 1.0, -1.0);
