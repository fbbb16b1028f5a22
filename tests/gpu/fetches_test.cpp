#include "gpu/fetches.hpp"

#include "core/error.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>

#include <fmt/format.h>

namespace reliefbench::gpu {
namespace {

using Kind = Fetch::Kind;
using testing::ElementsAre;
using testing::IsEmpty;

const char* const declarations = R"(
    layout(location = 0) in vec2 uv;
    layout(location = 0) out vec4 colour;
    layout(set = 0, binding = 0) uniform sampler2D map;
    layout(set = 0, binding = 1, r32ui) uniform uimage2D stored;
)";

/// Of a fragment shader whose main() is included from "body.glsl", which stands in "own.glsl".
ShaderSource source_of(const std::string& body) {
    return {.stage = ShaderStage::fragment,
            .file = "main.frag",
            .roots = {},
            .generated = {{"main.frag", fmt::format("{}#include \"own.glsl\"\n", declarations)}, {"own.glsl", body}},
            .preamble = ""};
}

std::string list_of(const SpirV& module) {
    std::string text;
    for (const Fetch& fetch : find_fetches(module))
        text += fmt::format("{} {}:{}\n", static_cast<int>(fetch.kind), fetch.file, fetch.line);
    return text;
}

/// What the compiler's own process tells comes back as an Error.
std::string fetches_in(const std::string& body) {
    ShaderSource source = source_of(body);
    source.inspect = [](const SpirV& module) { fail("{}", list_of(module)); };
    return error_message([&] { compile_shader(source); });
}

TEST(Fetches, OfEveryKindAreFoundWithTheirPlaces) {
    EXPECT_EQ(fetches_in(R"(void main() {
        colour = texture(map, uv);
        colour += textureLod(map, uv, 0.0);
        colour += textureProj(map, vec3(uv, 1.0)) + textureGrad(map, uv, uv, uv);
        colour += texelFetch(map, ivec2(uv), 0);
        colour += textureGather(map, uv);
        colour += vec4(imageLoad(stored, ivec2(uv)));
        colour += vec4(imageAtomicAdd(stored, ivec2(uv), 1u));
    })"),
              "0 own.glsl:2\n0 own.glsl:3\n0 own.glsl:4\n0 own.glsl:4\n1 own.glsl:5\n2 own.glsl:6\n3 own.glsl:7\n"
              "3 own.glsl:8\n");
}

TEST(Fetches, SizesAndLevelsAndWritesAreNone) {
    EXPECT_EQ(fetches_in(R"(void main() {
        colour = vec4(textureSize(map, 0), textureQueryLevels(map), textureQueryLod(map, uv).x);
        imageStore(stored, ivec2(uv), uvec4(imageSize(stored).x));
    })"),
              "");
}

// What a macro makes stands where it is used, and what a function makes stands in the function.
TEST(Fetches, OfMacrosAndSamplerParametersAreFound) {
    EXPECT_EQ(fetches_in(R"(#define MAP map
#define READ(where) textureLod(MAP, where, 0.0)
vec4 read(sampler2D any, vec2 where) {
    return textureLod(any, where, 0.0);
}
void main() {
    colour = READ(uv);
    colour += read(map, uv);
})"),
              "0 own.glsl:7\n0 own.glsl:4\n");
}

TEST(Fetches, AModuleIsTheSameWhetherOrNotItWasInspected) {
    const ShaderSource plain = source_of("void main() { colour = texture(map, uv); }");
    ShaderSource inspected = plain;
    inspected.inspect = [](const SpirV&) {};
    const SpirV module = compile_shader(plain);
    EXPECT_EQ(module, compile_shader(inspected));
    EXPECT_THAT(find_fetches(module), ElementsAre(Fetch{.kind = Kind::sampled, .file = "", .line = 0}));
    EXPECT_THAT(find_fetches(compile_shader(source_of("void main() { colour = vec4(uv, uv); }"))), IsEmpty());
}

}  // namespace
}  // namespace reliefbench::gpu
