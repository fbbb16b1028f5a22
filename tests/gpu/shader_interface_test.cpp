#include "gpu/shader_interface.hpp"

#include "core/error.hpp"
#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>

namespace reliefbench::gpu {
namespace {

using testing::AnyOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

SpirV compile(ShaderStage stage, const std::string& text) {
    return compile_shader({.stage = stage, .file = "test", .roots = {}, .generated = {{"test", text}}, .preamble = {}});
}

constexpr auto fragment = vk::ShaderStageFlagBits::eFragment;
constexpr auto compute = vk::ShaderStageFlagBits::eCompute;

/// "name binding type" of each.
std::vector<std::string> described(const ShaderInterface& interface) {
    std::vector<std::string> all;
    for (const auto& [name, resource] : interface.resources)
        all.push_back(fmt::format("{} {} {}", name, resource.binding, vk::to_string(resource.type)));
    return all;
}

const char* const all_kinds = R"(
    layout(set = 0, binding = 3, std140) uniform Scene { vec4 colour; } scene_block;
    layout(set = 0, binding = 1) uniform sampler2D height_map;
    layout(set = 0, binding = 4) uniform sampler3D never_read;
    layout(set = 0, binding = 6, r32f) uniform writeonly image2D target_map;
    layout(set = 0, binding = 5, std430) buffer Taps { vec4 taps[]; };
    layout(constant_id = 7) const float scale = 2.0;
    layout(constant_id = 2) const bool flag = false;
    layout(constant_id = 11) const int never_used = 3;
    layout(push_constant) uniform Range { int level; ivec2 rows; float table[3]; } range;
    layout(local_size_x = 8, local_size_y = 4) in;
    void main() {
        if (flag) taps[range.level] = texture(height_map, vec2(scale)) + scene_block.colour * range.table[1];
        imageStore(target_map, range.rows, vec4(scale));
    })";

TEST(ShaderInterface, HasNamesAndNumbersOfWhatIsDeclared) {
    const ShaderInterface found = read_interface(compile(ShaderStage::compute, all_kinds), compute);
    EXPECT_THAT(described(found), ElementsAre("Taps 5 StorageBuffer", "height_map 1 CombinedImageSampler",
                                              "never_read 4 CombinedImageSampler", "scene_block 3 UniformBuffer",
                                              "target_map 6 StorageImage"));
    EXPECT_THAT(found.constants, ElementsAre(Pair("flag", 2), Pair("never_used", 11), Pair("scale", 7)));
    EXPECT_THAT(found.local_size, ElementsAre(8, 4, 1));
    // std430: the vector on 8, the table of floats behind it.
    EXPECT_EQ(found.push_constant_bytes, 28U);
}

TEST(ShaderInterface, OfAPipelineIsThatOfItsStagesTogether) {
    const SpirV first = compile(ShaderStage::vertex, R"(
        layout(set = 0, binding = 0, std140) uniform Scene { vec4 colour; } scene_block;
        layout(constant_id = 1) const float scale = 1.0;
        void main() { gl_Position = scale * scene_block.colour; })");
    const SpirV second = compile(ShaderStage::fragment, R"(
        layout(set = 0, binding = 0, std140) uniform Scene { vec4 colour; } scene_block;
        layout(set = 0, binding = 2) uniform sampler2D albedo_map;
        layout(constant_id = 5) const int samples = 1;
        layout(location = 0) out vec4 target;
        void main() { target = scene_block.colour + float(samples) * texture(albedo_map, vec2(0.0)); })");
    ShaderInterface both = read_interface(first, vk::ShaderStageFlagBits::eVertex);
    add_interface(both, read_interface(second, fragment));
    EXPECT_THAT(described(both), ElementsAre("albedo_map 2 CombinedImageSampler", "scene_block 0 UniformBuffer"));
    EXPECT_EQ(both.resources.at("albedo_map").stages, vk::ShaderStageFlags(fragment));
    EXPECT_EQ(both.resources.at("scene_block").stages, vk::ShaderStageFlagBits::eVertex | fragment);
    EXPECT_THAT(both.constants, ElementsAre(Pair("samples", 5), Pair("scale", 1)));
    EXPECT_THAT(both.local_size, ElementsAre(0, 0, 0)) << "no work groups";
}

ShaderInterface with_sampler(const std::string& name, std::uint32_t binding) {
    ShaderInterface interface;
    interface.resources[name] = {binding, vk::DescriptorType::eCombinedImageSampler, fragment};
    return interface;
}

ShaderInterface with_constant(const std::string& name, std::uint32_t id) {
    ShaderInterface interface;
    interface.constants[name] = id;
    return interface;
}

TEST(ShaderInterface, StagesThatContradictEachOtherAreErrors) {
    ShaderInterface samplers = with_sampler("height_map", 1);
    EXPECT_THAT(error_message([&] { add_interface(samplers, with_sampler("cone_map", 1)); }),
                HasSubstr("both 'height_map' and 'cone_map' at binding 1"));
    EXPECT_THAT(error_message([&] { add_interface(samplers, with_sampler("height_map", 2)); }),
                HasSubstr("'height_map'"));
    ShaderInterface constants = with_constant("max_steps", 16);
    EXPECT_THAT(error_message([&] { add_interface(constants, with_constant("fade", 16)); }),
                HasSubstr("both 'max_steps' and 'fade'"));
    EXPECT_THAT(error_message([&] { add_interface(constants, with_constant("max_steps", 17)); }),
                HasSubstr("'max_steps'"));
}

ShaderInterface unused(ShaderInterface interface) {
    for (auto& [name, resource] : interface.resources)
        resource.is_used = false;
    return interface;
}

TEST(ShaderInterface, WhatIsNotUsedContradictsNothing) {
    ShaderInterface other_name = with_sampler("height_map", 1);
    add_interface(other_name, unused(with_sampler("mine", 1)));
    EXPECT_TRUE(other_name.resources.at("height_map").is_used);
    EXPECT_FALSE(other_name.resources.at("mine").is_used);

    ShaderInterface used_first = with_sampler("height_map", 1);
    add_interface(used_first, unused(with_sampler("height_map", 2)));
    EXPECT_THAT(described(used_first), ElementsAre("height_map 1 CombinedImageSampler"));
    ShaderInterface used_last = unused(with_sampler("height_map", 2));
    add_interface(used_last, with_sampler("height_map", 1));
    EXPECT_THAT(described(used_last), ElementsAre("height_map 1 CombinedImageSampler"));
    EXPECT_TRUE(used_last.resources.at("height_map").is_used);
}

/// A resource that the harness binds nothing to, and a statement that uses it.
struct Foreign {
    std::string declaration;
    std::string use;
    /// What is said of it by name.
    std::string error;
    ShaderStage stage = ShaderStage::compute;
};

/// Of each kind that GLSL has.
std::vector<Foreign> foreign_resources() {
    return {
        {"layout(set = 0, binding = 30) uniform sampler2D mine[4];", "taken = texture(mine[1], vec2(0.0));",
         "'mine' is an array of resources"},
        {"layout(set = 0, binding = 30, std430) buffer Mine { vec4 value; } mine[2];", "taken = mine[1].value;",
         "'mine' is an array of resources"},
        {"layout(set = 1, binding = 30) uniform sampler2D mine;", "taken = texture(mine, vec2(0.0));",
         "'mine' is in descriptor set 1"},
        {"layout(set = 0, binding = 30) uniform sampler2D mine;", "taken = texture(mine, vec2(0.0));",
         "use the CombinedImageSampler 'mine', to which nothing is bound"},
        {"#extension GL_EXT_samplerless_texture_functions : require\nlayout(set = 0, binding = 30) uniform texture2D "
         "mine;",
         "taken = texelFetch(mine, ivec2(0), 0);", "use the SampledImage 'mine', to which nothing is bound"},
        {"layout(set = 0, binding = 30) uniform sampler mine; layout(set = 0, binding = 31) uniform texture2D other;",
         "taken = texture(sampler2D(other, mine), vec2(0.0));", "use the Sampler 'mine', to which nothing is bound"},
        {"layout(set = 0, binding = 30) uniform samplerBuffer mine;", "taken = texelFetch(mine, 0);",
         "use the UniformTexelBuffer 'mine', to which nothing is bound"},
        {"layout(set = 0, binding = 30) uniform textureBuffer mine;", "taken = texelFetch(mine, 0);",
         "use the UniformTexelBuffer 'mine', to which nothing is bound"},
        {"layout(set = 0, binding = 30, r32f) uniform imageBuffer mine;", "taken = imageLoad(mine, 0);",
         "use the StorageTexelBuffer 'mine', to which nothing is bound"},
        {"layout(set = 0, binding = 30, r32ui) uniform uimage2D mine;",
         "taken = vec4(float(imageAtomicAdd(mine, ivec2(0), 1u)));",
         "use the StorageImage 'mine', to which nothing is bound"},
        {"layout(set = 0, binding = 30, std140) uniform Mine { vec4 value; };", "taken = value;",
         "use the UniformBuffer 'Mine', to which nothing is bound"},
        {"layout(set = 0, binding = 30, std430) buffer Mine { vec4 values[]; } mine;",
         "taken = vec4(float(mine.values.length()));", "use the StorageBuffer 'mine', to which nothing is bound"},
        {"#extension GL_EXT_ray_query : require\n"
         "layout(set = 0, binding = 30) uniform accelerationStructureEXT mine;",
         "rayQueryEXT query; rayQueryInitializeEXT(query, mine, 0u, 255u, vec3(0.0), 0.0, vec3(1.0), 1.0);",
         "use the AccelerationStructureKHR 'mine', to which nothing is bound"},
        {"layout(set = 0, binding = 30, input_attachment_index = 0) uniform subpassInput mine;",
         "taken = subpassLoad(mine);", "use the InputAttachment 'mine', to which nothing is bound",
         ShaderStage::fragment},
        {"layout(push_constant) uniform Mine { mat4 matrices[1000]; };", "taken = matrices[5][0];",
         "64000 bytes of push constants"},
        {"layout(constant_id = 3) const int length = 2; layout(push_constant) uniform Mine { vec4 values[length]; };",
         "taken = values[1];", "'Mine' have an array whose length is no plain constant"},
    };
}

SpirV compile(const Foreign& foreign, bool is_used) {
    const bool is_compute = foreign.stage == ShaderStage::compute;
    return compile(foreign.stage,
                   foreign.declaration + "\n" +
                       (is_compute ? "layout(local_size_x = 1) in;\n" : "layout(location = 0) out vec4 target;\n") +
                       "void main() { vec4 taken = vec4(0.0); " + (is_used ? foreign.use : "") +
                       (is_compute ? "}" : " target = taken; }"));
}

/// A block's size as a push constant.
std::uint32_t block_bytes(const std::string& members, const std::string& value, const std::string& before = "") {
    return read_interface(compile(ShaderStage::compute, before + "layout(push_constant) uniform Block { " + members +
                                                            " } block;\n"
                                                            "layout(local_size_x = 1) in;\n"
                                                            "void main() { float taken = float(" +
                                                            value + "); }"),
                          compute)
        .push_constant_bytes;
}

TEST(ShaderInterface, PushConstantsOfEveryTypeHaveTheirSize) {
    EXPECT_EQ(block_bytes("mat4 value;", "block.value[0][0]"), 64U);
    EXPECT_EQ(block_bytes("layout(row_major) mat4x2 value;", "block.value[0][0]"), 32U) << "two rows of four";
    EXPECT_EQ(block_bytes("mat4x2 value;", "block.value[0][0]"), 32U) << "four columns of two";
    EXPECT_EQ(block_bytes("float first; mat3 value;", "block.value[0][0]"), 64U) << "columns of three on sixteen";
    EXPECT_EQ(block_bytes("mat2 values[3]; float last;", "block.last"), 52U);
    EXPECT_EQ(block_bytes("bool flag; bvec3 flags;", "block.flag"), 28U) << "four bytes each";
    EXPECT_EQ(block_bytes("double value; int last;", "block.last"), 12U);
    EXPECT_EQ(block_bytes("Inner inner[2]; int last;", "block.last", "struct Inner { vec3 a; mat2 b; };\n"), 68U);
    EXPECT_EQ(block_bytes("float16_t value;", "block.value", "#extension GL_EXT_shader_16bit_storage : require\n"), 4U)
        << "whole words";
}

TEST(ShaderInterface, NumbersOfInstructionsAreNotTakenForVariables) {
    std::string cases;
    for (int i = 0; i < 100; ++i)
        cases += fmt::format("case {}: taps[1] = {}.0; break;\n", i, i);
    const ShaderInterface found = read_interface(compile(ShaderStage::compute, R"(
        layout(set = 0, binding = 5, std430) buffer Taps { float taps[]; };
        layout(set = 0, binding = 30) uniform sampler mine;
        layout(local_size_x = 1) in;
        void main() { switch (int(taps[0])) {)" + cases + "} }"),
                                                 compute);
    EXPECT_TRUE(found.resources.at("Taps").is_used);
    EXPECT_FALSE(found.resources.at("mine").is_used);
}

class BoundByName : public testing::Test {
protected:
    Pipeline make(const SpecializationValues& constants, const std::vector<Binding>& bindings) const {
        return make_compute_pipeline(device_, {.shader = shader_, .constants = constants}, {bindings});
    }
    /// With nothing bound to it.
    Pipeline make_of(const Foreign& foreign, bool is_used) const {
        const CompiledStage shader{foreign.stage, std::make_shared<const SpirV>(compile(foreign, is_used))};
        if (foreign.stage == ShaderStage::compute)
            return make_compute_pipeline(device_, {.shader = shader, .constants = {}}, {{}});
        const CompiledStage vertex{
            ShaderStage::vertex,
            std::make_shared<const SpirV>(compile(ShaderStage::vertex, "void main() { gl_Position = vec4(0.0); }"))};
        return make_graphics_pipeline(device_,
                                      {.stages = {vertex, shader},
                                       .constants = {},
                                       .colour_formats = {vk::Format::eR32G32B32A32Sfloat},
                                       .extent = {1, 1}},
                                      {});
    }
    Binding values(const std::string& name) const { return storage_buffer(name, buffer_.buffer); }

    const Device device_{{.choice = "", .validation = true}};
    const Buffer buffer_{device_, 256, vk::BufferUsageFlagBits::eStorageBuffer, true};
    const CompiledStage shader_{ShaderStage::compute, std::make_shared<const SpirV>(compile(ShaderStage::compute, R"(
        layout(set = 0, binding = 9, std430) buffer Values { uint values[]; };
        layout(constant_id = 40) const int factor = 1;
        layout(local_size_x = 64) in;
        void main() { values[gl_GlobalInvocationID.x] = uint(factor); })"))};
};

TEST_F(BoundByName, LayoutsHoldWhatTheShaderDeclares) {
    EXPECT_THAT(described(make({{"factor", 5}}, {values("Values")}).interface()),
                ElementsAre("Values 9 StorageBuffer"));
    EXPECT_THAT(device_.validation_messages(), IsEmpty());
}

TEST_F(BoundByName, NamesThatOnlyOneSideHasAreErrors) {
    EXPECT_THAT(error_message([&] { make({}, {}); }), HasSubstr("'Values', to which nothing is bound"));
    EXPECT_THAT(error_message([&] { make({}, {values("Values"), values("extra")}); }), HasSubstr("declare no 'extra'"));
    EXPECT_THAT(error_message([&] { make({}, {uniform_buffer("Values", buffer_.buffer)}); }),
                HasSubstr("'Values' as StorageBuffer"));
    EXPECT_THAT(error_message([&] { make({{"faktor", 1}}, {values("Values")}); }), HasSubstr("no constant 'faktor'"));
}

TEST_F(BoundByName, WhatCannotBeBoundIsAnErrorWithItsName) {
    for (const Foreign& foreign : foreign_resources()) {
        EXPECT_THAT(error_message([&] { make_of(foreign, true); }), HasSubstr(foreign.error)) << foreign.declaration;
    }
    EXPECT_THAT(device_.validation_messages(), IsEmpty());
}

TEST_F(BoundByName, WhatIsNotUsedIsIgnored) {
    for (const Foreign& foreign : foreign_resources()) {
        const ShaderInterface interface = make_of(foreign, false).interface();
        EXPECT_THAT(described(interface), IsEmpty()) << foreign.declaration;
        EXPECT_EQ(interface.push_constant_bytes, 0U) << foreign.declaration;
    }
    // Said of the shaders themselves: a declaration asks for a capability, which the device has switched off or which
    // takes a render pass.
    EXPECT_THAT(device_.validation_messages(),
                Each(AnyOf(HasSubstr("RayQuery"), HasSubstr("ray_query"), HasSubstr("InputAttachment"))));
}

TEST_F(BoundByName, WhatIsDeclaredAndNotUsedMayBeBound) {
    const CompiledStage shader{ShaderStage::compute, std::make_shared<const SpirV>(compile(ShaderStage::compute, R"(
        layout(set = 0, binding = 9, std430) buffer Values { uint values[]; };
        layout(set = 0, binding = 10, std430) buffer Others { uint others[]; };
        layout(local_size_x = 64) in;
        void main() { values[0] = 1u; })"))};
    const auto layout = [&](const std::vector<Binding>& bindings) {
        return described(make_compute_pipeline(device_, {.shader = shader, .constants = {}}, {bindings}).interface());
    };
    EXPECT_THAT(layout({values("Values"), values("Others")}),
                ElementsAre("Others 10 StorageBuffer", "Values 9 StorageBuffer"));
    EXPECT_THAT(layout({values("Values")}), ElementsAre("Values 9 StorageBuffer"));
    EXPECT_THAT(device_.validation_messages(), IsEmpty());
}

}  // namespace
}  // namespace reliefbench::gpu
