#include "gpu/shader_interface.hpp"

#include "core/error.hpp"
#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>

namespace reliefbench::gpu {
namespace {

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

TEST(ShaderInterface, WhatCannotBeBoundIsAnErrorWithItsName) {
    const SpirV array = compile(ShaderStage::compute, R"(
        layout(set = 0, binding = 1) uniform sampler2D maps[4];
        layout(local_size_x = 1) in;
        void main() {})");
    EXPECT_THAT(error_message([&] { read_interface(array, compute); }), HasSubstr("'maps' is an array of resources"));
    const SpirV other_set = compile(ShaderStage::compute, R"(
        layout(set = 1, binding = 1) uniform sampler2D detail;
        layout(local_size_x = 1) in;
        void main() {})");
    EXPECT_THAT(error_message([&] { read_interface(other_set, compute); }),
                HasSubstr("'detail' is in descriptor set 1"));
}

class BoundByName : public testing::Test {
protected:
    Pipeline make(const SpecializationValues& constants, const std::vector<Binding>& bindings) const {
        return make_compute_pipeline(device_, {.shader = shader_, .constants = constants}, {bindings});
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

}  // namespace
}  // namespace reliefbench::gpu
