#include "technique/renderer.hpp"

#include "core/error.hpp"
#include "gpu/commands.hpp"
#include "gpu/timers.hpp"
#include "scene/picture_mean.hpp"
#include "technique/base_on_device.hpp"
#include "technique/derived_maps.hpp"
#include "technique/draw.hpp"
#include "technique/object_draw.hpp"
#include "technique/pipeline/draw_pipeline.hpp"
#include "technique/program.hpp"
#include "technique/scene_textures.hpp"
#include "technique/scene_uniforms.hpp"
#include "technique/timed_recording.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <optional>

namespace reliefbench {

namespace {

template <typename Texel>
Image<Texel> to_image(Resolution size, const std::vector<std::byte>& bytes) {
    static_assert(std::is_trivially_copyable_v<Texel>);
    Image<Texel> image(size);
    assert(bytes.size() == image.texels.size() * sizeof(Texel));
    std::memcpy(image.texels.data(), bytes.data(), bytes.size());
    return image;
}

PixelWork to_work(const WorkCounters::Pixel& pixel) {
    return {.taps = pixel.taps,
            .texels = pixel.texels,
            .steps = pixel.steps(),
            .unconverged = pixel.unconverged(),
            .cut = pixel.is_cut()};
}

PixelWork to_work(const WorkCounters::Stages& stages) {
    return {.taps = stages.taps, .texels = stages.texels, .cut = stages.cuts > 0};
}

bool is_finite(const Hit& hit) {
    return std::isfinite(hit.u) && std::isfinite(hit.v) && std::isfinite(hit.h) && std::isfinite(hit.t);
}

gpu::Buffer upload_uniforms(const gpu::Device& device, const SceneUniforms& uniforms) {
    const SceneBlock block{.index = 0, .padding = {}, .values = uniforms};
    return gpu::make_filled_buffer(device, vk::BufferUsageFlagBits::eUniformBuffer,
                                   std::as_bytes(std::span(&block, 1)));
}

/// The picture that is shipped, of one sample for each pixel, in which depths decide what is in front.
void show_object(Probe& probe, const TimedPicture& picture) {
    probe.front = Image<Front>(picture.colour.size, Front::nothing);
    for (std::size_t i = 0; i < picture.colour.texels.size(); ++i) {
        const std::array<float, 4>& colour = picture.colour.texels[i];
        probe.colour.texels[i] = {colour[0], colour[1], colour[2]};
        if (colour[3] > 0) probe.front->texels[i] = colour[3] == object_alpha ? Front::object : Front::relief;
    }
}

}  // namespace

struct Renderer::State {
    State(const gpu::Device& used_device, const Technique& used_technique, const ParameterValues& used_parameters,
          const SceneOnDevice& used_scene, const View& used_view, const Lighting& used_lighting,
          const std::optional<SceneObject>& used_object)
        : device(used_device),
          technique(used_technique),
          parameters(used_parameters),
          scene(used_scene),
          view(used_view),
          lighting(used_lighting),
          maps(device, technique, parameters, scene.textures()),
          base(scene.textures().bases.get(drawn_base(technique.manifest, view.relief.base))),
          material(filtered_material(device, scene, view.material)),
          object(used_object),
          centres(make_frame(through_centres(view))) {
        if (has_picture_of_its_own(view)) timed_frame.emplace(make_frame(frame_of(view, 0)));
        // Both now, so that a shader that does not compile is known before anything is drawn.
        compile_draw(device, technique, parameters, Variant::timed, timed_setup().view);
        compile_draw(device, technique, parameters, Variant::probed, centres.setup.view);
    }

    /// Textures of the material with mips, and how they are read.
    struct FilteredMaterial {
        std::shared_ptr<const MaterialMips> mips;
        vk::raii::Sampler sampler;
    };

    /// What a draw reads: its scene's values and the setup that names them.
    struct Frame {
        gpu::Buffer uniforms;
        DrawSetup setup;
    };

    const gpu::Device& device;
    Technique technique;
    ParameterValues parameters;
    const SceneOnDevice& scene;
    View view;
    Lighting lighting;
    DerivedMaps maps;
    /// Null for a flat one.
    std::shared_ptr<const BaseOnDevice> base;
    /// Empty where it is read at level 0.
    std::optional<FilteredMaterial> material;
    std::optional<SceneObject> object;
    /// One sample through each pixel's centre.
    Frame centres;
    /// What is timed, where that is another one.
    std::optional<Frame> timed_frame;
    bool prepared = false;
    /// PreparationSettings::cache.
    std::filesystem::path cache;

    const DrawSetup& timed_setup() const { return timed_frame ? timed_frame->setup : centres.setup; }

    /// What is timed; made when first asked for, and kept.
    const Draw& display() {
        if (!display_draw) display_draw.emplace(device, technique, Draw::Kind::timed_display, timed_setup());
        return *display_draw;
    }

    static std::optional<FilteredMaterial> filtered_material(const gpu::Device& device, const SceneOnDevice& scene,
                                                             const MaterialFilter& filter);
    DrawGeometry geometry_of(const View& from) const;
    Frame make_frame(const View& from) const;
    /// One draw, submitted and finished.
    void draw_once(const Draw& draw) const;
    Probe probe(const DrawSetup& from) const;
    TimedPicture draw_float(const DrawSetup& from) const;
    /// Of all samples and frames; each is drawn, added and freed before the next.
    Image<std::array<float, 3>> draw_mean(const View& from) const;

    std::optional<Draw> display_draw;
    /// The one asked for last. Below the draw that it records, so that it is destroyed first.
    std::unique_ptr<TimedRecording> timing;
};

std::optional<Renderer::State::FilteredMaterial> Renderer::State::filtered_material(const gpu::Device& device,
                                                                                    const SceneOnDevice& scene,
                                                                                    const MaterialFilter& filter) {
    if (!filter.has_mips()) return std::nullopt;
    return FilteredMaterial{scene.textures().material_mips(), make_material_sampler(device, filter)};
}

DrawGeometry Renderer::State::geometry_of(const View& from) const {
    return pipeline_of(technique.manifest)
        .geometry(device, {technique.manifest, parameters, from, scene.textures().size});
}

Renderer::State::Frame Renderer::State::make_frame(const View& from) const {
    Frame frame{.uniforms = upload_uniforms(device, make_scene_uniforms(from, lighting, geometry_of(from).grid)),
                .setup = {}};
    const vk::raii::Buffer& values = frame.uniforms.buffer;
    DrawSetup& result = frame.setup;
    result.view = from;
    result.parameters = parameters;
    result.constants = parameter_constants(technique.manifest, parameters);
    result.constants["lighting_enabled"] = lighting.enabled ? 1 : 0;
    result.constants.merge(view_constants(from));
    result.bindings = scene.textures().height_bindings();
    for (const gpu::Binding& texture :
         material ? material->mips->bindings(material->sampler) : scene.textures().material_bindings())
        result.bindings.push_back(texture);
    result.bindings.push_back(gpu::uniform_buffer(scene_block_name, values));
    for (const gpu::Binding& map : maps.draw_bindings())
        result.bindings.push_back(map);
    if (base) {
        for (const gpu::Binding& binding : base->bindings())
            result.bindings.push_back(binding);
    }
    result.on_demand[blue_noise_name] = [this] { return scene.textures().blue_noise.binding(cache); };
    if (object)
        result.object.emplace(device, *object, from, technique.shaders, gpu::uniform_buffer(scene_block_name, values));
    result.geometry = geometry_of(from);
    for (int i = 0; i < 3; ++i)
        result.background[static_cast<std::size_t>(i)] = static_cast<float>(lighting.background[i]);
    return frame;
}

void Renderer::State::draw_once(const Draw& draw) const {
    assert(prepared);
    const std::string what = fmt::format("draw with technique '{}'", technique.manifest.id);
    gpu::submit_and_wait(device, what, [&](const vk::raii::CommandBuffer& commands) {
        draw.begin(commands);
        draw.record(commands);
    });
}

Probe Renderer::State::probe(const DrawSetup& from) const {
    const Draw draw(device, technique, Draw::Kind::probed, from);
    draw_once(draw);

    const Resolution size = view.resolution;
    const auto colours = to_image<std::array<float, 4>>(size, draw.read_target(0));
    const auto shadows = to_image<std::array<float, 4>>(size, draw.read_target(2));
    const WorkCounters::Stages stages = draw.work().stages();
    Probe probe{.hits = to_image<Hit>(size, draw.read_target(1)),
                .colour = Image<std::array<float, 3>>(size),
                .covered = Image<std::uint8_t>(size),
                .work = Image<PixelWork>(size),
                .light_visibility = Image<std::array<float, 3>>(size),
                .shadow_taps = Image<std::uint32_t>(size),
                .normals = std::nullopt,
                .front = std::nullopt,
                .stages = to_work(stages)};
    if (!is_flat(view.relief.base)) {
        probe.normals = Image<std::array<float, 3>>(size);
        const auto normals = to_image<std::array<float, 4>>(size, draw.read_target(3));
        std::ranges::transform(normals.texels, probe.normals->texels.begin(), [](const std::array<float, 4>& normal) {
            return std::array<float, 3>{normal[0], normal[1], normal[2]};
        });
    }
    if (stages.fault != 0) probe.faults.push_back(decode_answer_fault(stages.fault, stages.fault_bits));
    for (std::size_t i = 0; i < size.pixels(); ++i) {
        const std::array<float, 4>& colour = colours.texels[i];
        probe.colour.texels[i] = {colour[0], colour[1], colour[2]};
        const std::array<float, 4>& shadow = shadows.texels[i];
        probe.light_visibility.texels[i] = {shadow[0], shadow[1], shadow[2]};
        probe.shadow_taps.texels[i] = static_cast<std::uint32_t>(shadow[3]);
        const WorkCounters::Pixel work = draw.work().pixel(i);
        probe.work.texels[i] = to_work(work);
        probe.covered.texels[i] = static_cast<std::uint8_t>(work.is_covered());
        if (const std::uint32_t fault = work.fault(); fault != 0) {
            probe.faults.push_back(decode_answer_fault(fault, work.steps_or_fault_bits));
            probe.faults.back().pixel = place_of(i, size);
        } else if (!is_finite(probe.hits.texels[i])) {
            // Finite texture coordinates, so far away that their distance is not.
            probe.faults.push_back({AnswerFault::Quantity::uv, probe.hits.texels[i].t, place_of(i, size)});
        }
    }
    return probe;
}

TimedPicture Renderer::State::draw_float(const DrawSetup& from) const {
    const Resolution size = view.resolution;
    const Draw draw(device, technique, Draw::Kind::timed_float, from);
    draw_once(draw);
    TimedPicture picture;
    picture.colour = to_image<std::array<float, 4>>(size, draw.read_target(0));
    if (from.view.samples_per_pixel == 1) picture.depth = to_image<float>(size, draw.read_depth());
    return picture;
}

Image<std::array<float, 3>> Renderer::State::draw_mean(const View& from) const {
    PictureMean picture;
    for (int i = 0; i < from.frames; ++i) {
        const Frame frame = make_frame(frame_of(from, i));
        picture.add(draw_float(frame.setup).colour);
    }
    return picture.mean();
}

Renderer::Renderer(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
                   const SceneOnDevice& scene, const View& view, const Lighting& lighting,
                   const std::optional<SceneObject>& object)
    : state_(std::make_unique<State>(device, technique, parameters, scene, view, lighting, object)) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;

Preparation Renderer::prepare(const PreparationSettings& settings) {
    state_->cache = settings.cache;
    Preparation preparation = state_->maps.prepare(settings);
    state_->prepared = preparation.given_up.empty();
    if (state_->prepared && state_->material) {
        preparation.pass_ms[material_mips_pass] = state_->material->mips->make(settings.samples);
        preparation.bytes += state_->material->mips->bytes();
    }
    return preparation;
}

std::string Renderer::maps_key() const {
    return state_->material ? state_->maps.key() + " " + material_mips_pass : state_->maps.key();
}

Probe Renderer::probe() {
    const DrawSetup& centres = state_->centres.setup;
    Probe probe = state_->probe(centres);
    if (state_->object) show_object(probe, state_->draw_float(centres));
    if (has_picture_of_its_own(state_->view)) probe.colour = state_->draw_mean(state_->view);
    return probe;
}

Probe Renderer::probe_from(const Camera& camera, std::optional<int> frame) {
    View view = state_->view;
    view.camera = camera;
    view.frame = frame;
    view.frames = 1;
    const State::Frame centres = state_->make_frame(through_centres(view));
    Probe probe = state_->probe(centres.setup);
    if (frame && (state_->object || has_picture_of_its_own(view))) probe.colour = state_->draw_mean(view);
    return probe;
}

TimedPicture Renderer::draw_timed(ColourTarget target) {
    const DrawSetup& setup = state_->timed_setup();
    if (target == ColourTarget::linear_float) return state_->draw_float(setup);
    const Resolution size = state_->view.resolution;
    TimedPicture picture;
    constexpr float largest = 255;
    const Draw& display = state_->display();
    state_->draw_once(display);
    const auto bytes = to_image<std::array<std::uint8_t, 4>>(size, display.read_target(0));
    picture.colour = Image<std::array<float, 4>>(size);
    for (std::size_t i = 0; i < size.pixels(); ++i) {
        for (std::size_t channel = 0; channel < 4; ++channel)
            picture.colour.texels[i][channel] = static_cast<float>(bytes.texels[i][channel]) / largest;
    }
    if (setup.view.samples_per_pixel == 1) picture.depth = to_image<float>(size, display.read_depth());
    return picture;
}

PipelineStatistics Renderer::pipeline_statistics() {
    if (!state_->device.info().has_feature("pipelineStatisticsQuery")) return {};
    assert(state_->prepared);
    const Draw& display = state_->display();
    const gpu::PipelineStatisticsQuery query(state_->device, state_->timed_setup().geometry.patch_vertices > 0);
    gpu::submit_and_wait(state_->device, "count pipeline statistics", [&](const vk::raii::CommandBuffer& commands) {
        display.begin(commands);
        query.start(commands);
        display.record(commands);
        query.end(commands);
    });
    return query.read();
}

ExecutableStatistics Renderer::executable_statistics() {
    return read_executable_statistics(state_->device, state_->technique, state_->timed_setup());
}

std::vector<double> Renderer::time_draw(int samples, int repeats) {
    submit_draw(samples, repeats);
    return collect_draw();
}

void Renderer::submit_draw(int samples, int repeats) {
    assert(state_->prepared);
    const Draw& display = state_->display();
    std::unique_ptr<TimedRecording>& timing = state_->timing;
    if (!timing || timing->samples != samples || timing->repeats != repeats) {
        timing.reset();
        timing = std::make_unique<TimedRecording>(state_->device, display,
                                                  fmt::format("time technique '{}'", state_->technique.manifest.id),
                                                  samples, repeats);
    }
    timing->recording.submit();
}

std::vector<double> Renderer::collect_draw() {
    TimedRecording& timing = *state_->timing;
    timing.recording.wait();
    std::vector<double> milliseconds = timing.timestamps.milliseconds();
    for (double& value : milliseconds)
        value /= timing.repeats;
    return milliseconds;
}

std::vector<double> time_empty_pass(const gpu::Device& device, int samples) {
    const gpu::Timestamps timestamps(device, static_cast<std::uint32_t>(samples));
    gpu::submit_and_wait(device, "time an empty pass", [&](const vk::raii::CommandBuffer& commands) {
        timestamps.reset(commands);
        for (std::uint32_t sample = 0; sample < static_cast<std::uint32_t>(samples); ++sample) {
            timestamps.start(commands, sample);
            timestamps.end(commands, sample);
        }
    });
    return timestamps.milliseconds();
}

}  // namespace reliefbench
