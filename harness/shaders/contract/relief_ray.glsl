// A ray that enters the relief (contract 2). Over a plane it is straight and comes down evenly, from h = 1 at s = 0 to
// h = 0 at s = 1. Whoever asks the functions for its points and heights can follow whatever way it takes; whoever needs a
// straight one takes straight_offset.

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
};

// Texture coordinates travelled from h = 1 to h = 0 along the tangent plane: -H * uv_per_length * to_eye.xy / to_eye.z.
vec2 straight_offset(ReliefRay ray) { return ray.straight_offset; }

vec2 point_on_ray(ReliefRay ray, float s) { return ray.uv + s * ray.straight_offset; }

float height_of_ray(ReliefRay ray, float s) { return 1.0 - s; }

// Where the ray comes down to height h.
float s_at_height(ReliefRay ray, float h) { return 1.0 - h; }

float end_of_ray(ReliefRay ray) { return ray.s_end; }

// H in texture coordinates, along the axis of the texture along which a length covers more of them.
float height_in_uv(ReliefRay ray) {
    mat2 rates = ray.height_scale * ray.uv_per_length;
    vec2 along_axes = abs(rates[0]) + abs(rates[1]);
    return max(along_axes.x, along_axes.y);
}
