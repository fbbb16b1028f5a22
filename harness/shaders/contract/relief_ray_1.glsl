// A ray that enters the relief, as contract 1 has it: straight, over a plane. The structure stays as it was in version
// 0.1.0; the functions are those of relief_ray.glsl, so that the library serves both.

struct ReliefRay {
    vec2 uv;          // texture coordinates where the ray enters the relief, at h = 1
    vec2 max_offset;  // texture coordinates travelled from h = 1 to h = 0
    vec3 to_eye;      // unit vector in tangent space
    float height;     // height scale in units of texture coordinates
    vec2 uv_dx;
    vec2 uv_dy;
    float level;
};

vec2 straight_offset(ReliefRay ray) { return ray.max_offset; }

vec2 point_on_ray(ReliefRay ray, float s) { return ray.uv + s * ray.max_offset; }

float height_of_ray(ReliefRay ray, float s) { return 1.0 - s; }

float s_at_height(ReliefRay ray, float h) { return 1.0 - h; }

float end_of_ray(ReliefRay ray) { return 1.0; }

float height_in_uv(ReliefRay ray) { return ray.height; }
