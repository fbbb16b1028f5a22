#include "manifest/reserved_names.hpp"

#include "manifest/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace reliefbench {

namespace {

// GLSL 4.60, section 3.6: what of it has no capital letter, without vector and matrix types, which are recognised by
// their stems; and what glslang takes for keywords beside it (GL_KHR_memory_model).
const std::vector<std::string> keywords = words(
    "const uniform buffer shared attribute varying coherent volatile restrict readonly writeonly layout centroid "
    "flat smooth noperspective patch sample invariant precise break continue do for while switch case default if "
    "else subroutine in out inout int void bool true false float double uint discard return lowp mediump highp "
    "precision struct common partition active asm class union enum typedef template this resource goto inline "
    "noinline public static extern external interface long short half fixed unsigned superp input output filter "
    "sizeof cast namespace using demote terminate main defined sampler atomic_uint "
    "devicecoherent queuefamilycoherent workgroupcoherent subgroupcoherent shadercallcoherent nonprivate");

// As a parameter of compile time it would define the macro that tells GLSL for Vulkan.
constexpr std::string_view vulkan_macro = "vulkan";

// Built-in functions, GLSL 4.60 section 8. Redefining one hides it from every shader of the technique.
const std::vector<std::string> functions = words(
    "radians degrees sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh pow exp log exp2 log2 sqrt "
    "inversesqrt abs sign floor trunc round ceil fract mod modf min max clamp mix step smoothstep isnan isinf "
    "fma frexp ldexp length distance cross dot normalize faceforward reflect refract transpose determinant "
    "inverse equal any all not texture barrier");

// Declared by the generated preamble, whatever the technique.
const std::vector<std::string> preamble_names = words("target_map patch_corners");

// The axes of a configuration (harness/sweep), which share one namespace with parameters on the command line.
const std::vector<std::string> axes = words(
    "technique heightmap albedo heightmap_size height_format view_angle azimuth projection distance fov height_scale "
    "tiling boundary resolution sample_count self_shadow soft_shadow hard_shadow_bias dykhta_bias shadow_min_steps "
    "shadow_max_steps shadow_softening depth_write");
// Those that techniques of contract 1 could not know.
const std::vector<std::string> axes_since_contract_2 = words(
    "base curvature base_segments base_fit material_filter anisotropy mip_bias material_gradients samples_per_pixel "
    "frames preset polygon_height");

const std::vector<std::string> type_stems = words("vec ivec uvec bvec dvec fvec hvec mat dmat");

bool contains(const std::vector<std::string>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

bool is_identifier(std::string_view name) {
    const auto lower_or_digit = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    return !name.empty() && name.front() >= 'a' && name.front() <= 'z' && std::ranges::all_of(name, lower_or_digit) &&
           name.find("__") == std::string_view::npos;
}

/// vec2, dmat3x4, ...: a stem and then dimensions.
bool is_type(std::string_view name) {
    const auto dimension = [](char c) { return (c >= '2' && c <= '4') || c == 'x'; };
    const auto matches = [&](std::string_view stem) {
        return name.size() > stem.size() && name.starts_with(stem) &&
               std::ranges::all_of(name.substr(stem.size()), dimension);
    };
    return std::ranges::any_of(type_stems, matches);
}

}  // namespace

std::string check_glsl_name(const std::string& name, int contract) {
    if (!is_identifier(name)) {
        return fmt::format("'{}' is no usable name: lower case letters, digits and single underscores, a letter first",
                           name);
    }
    if (name.starts_with("gl_") || is_type(name) || contains(keywords, name) || contains(functions, name) ||
        name == vulkan_macro) {
        return fmt::format("'{}' is a name of GLSL; choose another", name);
    }
    if (contains(preamble_names, name) || name.starts_with("reliefbench")) {
        return fmt::format("'{}' is a name that the harness's shaders use; choose another", name);
    }
    if (contains(axes, name) || (contract >= 2 && contains(axes_since_contract_2, name)))
        return fmt::format("'{}' is an axis of a configuration; choose another name", name);
    return {};
}

}  // namespace reliefbench
