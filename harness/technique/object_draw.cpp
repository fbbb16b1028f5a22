#include "technique/object_draw.hpp"

#include "gpu/device.hpp"
#include "gpu/shader_cache.hpp"
#include "manifest/shared_shaders.hpp"
#include "technique/program.hpp"

#include <utility>

namespace reliefbench {

namespace {

/// The block of harness/shaders/driver/object.frag, std140.
struct ObjectUniforms {
    glm::vec3 centre;
    float radius;
    glm::vec3 half_size;
    float unused_0;
    glm::vec3 colour;
    float unused_1;
};
static_assert(sizeof(ObjectUniforms) == 48);

gpu::Buffer upload(const gpu::Device& device, const SceneObject& object) {
    const ObjectUniforms uniforms{.centre = glm::vec3(object.centre),
                                  .radius = static_cast<float>(object.radius),
                                  .half_size = glm::vec3(object.half_size),
                                  .unused_0 = 0,
                                  .colour = glm::vec3(object.colour),
                                  .unused_1 = 0};
    return gpu::make_filled_buffer(device, vk::BufferUsageFlagBits::eUniformBuffer,
                                   std::as_bytes(std::span(&uniforms, 1)));
}

gpu::CompiledStage compile(const gpu::Device& device, const std::filesystem::path& shaders, const std::string& preamble,
                           gpu::ShaderStage stage, const char* file) {
    const gpu::ShaderSource source{
        .stage = stage, .file = file, .roots = shared_shader_folders(shaders), .generated = {}, .preamble = preamble};
    const std::string key = fmt::format("{}\n{}\n{}", shaders.string(), file, preamble);
    return {stage, device.shader_cache().get(key, [&] { return gpu::compile_shader(source); })};
}

}  // namespace

ObjectOnDevice::ObjectOnDevice(const gpu::Device& device, const SceneObject& object, const View& view,
                               std::filesystem::path shaders, const gpu::Binding& scene)
    : device_(&device),
      shape_(object.shape),
      preamble_((indexes_scene(device) ? "#define RELIEFBENCH_INDEXED_SCENE 1\n" : "") +
                declare_rays(view.relief.base, view)),
      shaders_(std::move(shaders)),
      scene_(scene),
      uniforms_(upload(device, object)) {}

gpu::Pipeline ObjectOnDevice::make_pipeline(const std::vector<vk::Format>& colour_formats, vk::Format depth_format,
                                            vk::Extent2D extent, vk::SampleCountFlagBits samples,
                                            const gpu::SpecializationValues& constants) const {
    gpu::GraphicsPipelineOptions options{
        .stages = {compile(*device_, shaders_, preamble_, gpu::ShaderStage::vertex, "object.vert"),
                   compile(*device_, shaders_, preamble_, gpu::ShaderStage::fragment, "object.frag")},
        .constants = constants,
        .colour_formats = colour_formats,
        .depth_format = depth_format,
        .extent = extent,
        .samples = samples};
    options.constants["object_is_box"] = shape_ == SceneObject::Shape::box ? 1 : 0;
    return gpu::make_graphics_pipeline(*device_, options, {scene_, gpu::uniform_buffer("object", uniforms_.buffer)});
}

}  // namespace reliefbench
