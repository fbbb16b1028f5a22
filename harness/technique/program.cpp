#include "technique/program.hpp"

#include "core/error.hpp"
#include "gpu/shader_cache.hpp"
#include "manifest/shared_shaders.hpp"
#include "technique/counted_fetches.hpp"
#include "technique/pipeline/draw_pipeline.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <limits>

namespace reliefbench {

namespace {

/// Numbers of what is declared here, above all that harness/shaders declares itself: shaders that use two of one number
/// are an Error (gpu/shader_interface.hpp).
constexpr std::uint32_t first_parameter_constant = 16;
constexpr std::uint32_t target_map_binding = 6;
constexpr std::uint32_t first_derived_map_binding = 8;

constexpr const char* pass_file = "pass.glsl";
constexpr const char* probed_definition = "#define RELIEFBENCH_PROBED 1\n";

/// Values of the constant self_shadow in scene.glsl.
namespace self_shadow_method {
constexpr std::uint32_t off = 0;
constexpr std::uint32_t hard = 1;
constexpr std::uint32_t dykhta = 2;
constexpr std::uint32_t tatarchuk = 3;
}  // namespace self_shadow_method

/// What relief.glsl goes by.
std::string declare_contract(const Manifest& manifest) {
    return manifest.contract == 1 ? "#define RELIEFBENCH_CONTRACT_1 1\n" : "";
}

/// A constant with its value, and a macro for the preprocessor: what layout qualifiers are chosen by.
std::string declare_compile_time(const Parameter& parameter, const ParameterValue& value) {
    if (parameter.type == ParameterType::boolean) {
        const bool set = std::get<bool>(value);
        return fmt::format("const bool {} = {};\n{}", parameter.name, set,
                           set ? fmt::format("#define {} 1\n", compile_time_macro(parameter)) : "");
    }
    const auto& word = std::get<std::string>(value);
    const auto index = std::ranges::find(parameter.choices, word) - parameter.choices.begin();
    return fmt::format("const int {} = {};\n#define {} 1\n", parameter.name, index,
                       compile_time_macro(parameter, word));
}

/// Whether it waits for another value of a parameter of compile time: then it is a macro, so that what is off leaves
/// nothing in the shader, not even an unused constant.
bool is_compiled_away(const Manifest& manifest, const Parameter& parameter, const ParameterValues& values) {
    return std::ranges::any_of(parameter.only_with, [&](const ParameterCondition& condition) {
        return manifest.find_parameter(condition.parameter)->compile_time && !all_hold({condition}, values);
    });
}

/// As the 32 bits of its constant.
std::uint32_t constant_bits(const Parameter& parameter, const ParameterValue& value) {
    switch (parameter.type) {
        case ParameterType::integer:
            return static_cast<std::uint32_t>(std::get<std::int64_t>(value));
        case ParameterType::real:
            return std::bit_cast<std::uint32_t>(static_cast<float>(std::get<double>(value)));
        case ParameterType::boolean:
            return std::get<bool>(value) ? 1 : 0;
        case ParameterType::choice: {
            const auto& word = std::get<std::string>(value);
            return static_cast<std::uint32_t>(std::ranges::find(parameter.choices, word) - parameter.choices.begin());
        }
    }
    return 0;
}

std::string define_default(const Parameter& parameter) {
    const std::uint32_t bits = constant_bits(parameter, parameter.default_value);
    switch (parameter.type) {
        case ParameterType::integer:
        case ParameterType::choice:
            return fmt::format("#define {} {}\n", parameter.name, static_cast<std::int32_t>(bits));
        case ParameterType::real:
            return fmt::format("#define {} {:#.9g}\n", parameter.name, std::bit_cast<float>(bits));
        case ParameterType::boolean:
            return fmt::format("#define {} {}\n", parameter.name, bits != 0);
    }
    return {};
}

/// A constant for each parameter. Its value comes by specialization, so that all values share one compilation, but for
/// those of compile time and what they leave without effect.
std::string declare_parameters(const Manifest& manifest, const ParameterValues& values) {
    std::string text;
    std::uint32_t id = first_parameter_constant - 1;
    for (const Parameter& parameter : manifest.parameters) {
        ++id;
        for (std::size_t i = 0; i < parameter.choices.size(); ++i)
            text += fmt::format("const int {}_{} = {};\n", parameter.name, parameter.choices[i], i);
        if (parameter.compile_time) {
            text += declare_compile_time(parameter, values.at(parameter.name));
            continue;
        }
        if (is_compiled_away(manifest, parameter, values)) {
            text += define_default(parameter);
            continue;
        }
        const char* declaration = nullptr;
        switch (parameter.type) {
            case ParameterType::integer:
            case ParameterType::choice:
                declaration = "layout(constant_id = {}) const int {} = 0;\n";
                break;
            case ParameterType::real:
                declaration = "layout(constant_id = {}) const float {} = 0.0;\n";
                break;
            case ParameterType::boolean:
                declaration = "layout(constant_id = {}) const bool {} = false;\n";
                break;
        }
        text += fmt::format(fmt::runtime(declaration), id, parameter.name);
    }
    return text;
}

/// Values of the parameters of compile time: part of the key of what is compiled.
std::string compile_time_key(const Manifest& manifest, const ParameterValues& values) {
    std::string key;
    for (const Parameter& parameter : manifest.parameters) {
        if (parameter.compile_time) key += fmt::format(" {}={}", parameter.name, to_string(values.at(parameter.name)));
    }
    return key;
}

std::string declare_map(const MapDeclaration& map, std::size_t index) {
    return fmt::format("layout(set = 0, binding = {}) uniform {} {};\n", first_derived_map_binding + index,
                       map.is_volume() ? "sampler3D" : "sampler2D", map.name);
}

const MapDeclaration& find_map(const Manifest& manifest, const std::string& name) {
    const auto found = std::find_if(manifest.maps.begin(), manifest.maps.end(),
                                    [&](const MapDeclaration& map) { return map.name == name; });
    assert(found != manifest.maps.end());
    return *found;
}

gpu::CompiledStage compile_stage(const gpu::Device& device, const Technique& technique, const std::string& key,
                                 gpu::ShaderSource source) {
    source.roots = shared_shader_folders(technique.shaders);
    source.roots.push_back(technique.folder);
    const std::string full_key = fmt::format("{}\n{}\n{}\n{}\n{}", technique.folder.string(), technique.hash,
                                             technique.shaders.string(), source.file, key);
    const gpu::ShaderStage stage = source.stage;
    auto code = device.shader_cache().get(full_key, [&] {
        try {
            return gpu::compile_shader(source);
        } catch (const Error& error) {
            fail("technique '{}' ({}) does not compile:\n{}", technique.manifest.id, technique.folder.string(),
                 error.what());
        }
    });
    return {stage, std::move(code)};
}

struct Stage {
    const char* extension;
    gpu::ShaderStage stage;
    /// Tells patches.glsl which stage includes it.
    const char* definition;
};

const Stage& stage_of(const std::string& file) {
    using gpu::ShaderStage;
    static constexpr std::array<Stage, 4> stages{{
        {".vert", ShaderStage::vertex, ""},
        {".tesc", ShaderStage::tessellation_control, "#define RELIEFBENCH_CONTROL 1\n"},
        {".tese", ShaderStage::tessellation_evaluation, "#define RELIEFBENCH_EVALUATION 1\n"},
        {".frag", ShaderStage::fragment, ""},
    }};
    const auto found =
        std::ranges::find_if(stages, [&](const Stage& stage) { return file.ends_with(stage.extension); });
    assert(found != stages.end());
    return *found;
}

/// Of driver/self_shadow.glsl.
gpu::SpecializationValues self_shadow_constants(const SelfShadow& self_shadow) {
    // What is off leaves its other settings alone: all of them share one pipeline.
    if (self_shadow.mode == SelfShadow::Mode::off) return {{"self_shadow", self_shadow_method::off}};
    const bool hard = self_shadow.mode == SelfShadow::Mode::hard;
    const bool dykhta = self_shadow.soft == SelfShadow::Soft::dykhta;
    const auto bits = [](double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); };
    return {{"self_shadow", hard     ? self_shadow_method::hard
                            : dykhta ? self_shadow_method::dykhta
                                     : self_shadow_method::tatarchuk},
            {"self_shadow_bias", bits(hard ? self_shadow.hard_bias : self_shadow.dykhta_bias)},
            {"self_shadow_min_steps", static_cast<std::uint32_t>(self_shadow.min_steps)},
            {"self_shadow_max_steps", static_cast<std::uint32_t>(self_shadow.max_steps)},
            {"self_shadow_softening", bits(self_shadow.softening)}};
}

/// What surface.glsl and the stages go by where the material has mips; how these are read is the sampler's.
std::string declare_material(const MaterialFilter& filter) {
    if (!filter.has_mips()) return {};
    const auto gradients = [&] {
        switch (filter.gradients) {
            case MaterialFilter::Gradients::before_search:
                return "BEFORE_SEARCH";
            case MaterialFilter::Gradients::from_result:
                return "FROM_RESULT";
            case MaterialFilter::Gradients::analytic:
                return "ANALYTIC";
        }
        return "";
    };
    return fmt::format("#define RELIEFBENCH_MATERIAL_MIPS 1\n#define RELIEFBENCH_GRADIENTS_{} 1\n", gradients());
}

}  // namespace

bool indexes_scene(const gpu::Device& device) {
    return device.info().type == gpu::DeviceType::cpu;
}

bool divides_by_own_w(const gpu::Device& device, const View& view) {
    return device.info().type == gpu::DeviceType::cpu && view.samples_per_pixel > 1;
}

std::string declare_rays(const BaseSurface& base, const View& view) {
    std::string text = view.frame ? "#define RELIEFBENCH_FRAMES 1\n" : "";
    if (view.relief.polygon_height != 1) text += "#define RELIEFBENCH_POLYGON_HEIGHT 1\n";
    if (view.samples_per_pixel > 1) text += fmt::format("#define RELIEFBENCH_SAMPLES {}\n", view.samples_per_pixel);
    if (is_flat(base)) return text;
    text += "#define RELIEFBENCH_CURVED 1\n";
    if (!curved_base(base).is_unit_square) text += "#define RELIEFBENCH_CHARTS 1\n";
    return text;
}

std::vector<gpu::CompiledStage> compile_draw(const gpu::Device& device, const Technique& technique,
                                             const ParameterValues& parameters, Variant variant, const View& view) {
    const Manifest& manifest = technique.manifest;
    const bool probed = variant == Variant::probed;
    std::string preamble = declare_contract(manifest) + (probed ? probed_definition : "");
    if (indexes_scene(device)) preamble += "#define RELIEFBENCH_INDEXED_SCENE 1\n";
    if (divides_by_own_w(device, view)) preamble += "#define RELIEFBENCH_OWN_PERSPECTIVE 1\n";
    // By the name that shared shaders of earlier revisions, with which ab compiles a baseline, know it.
    if (manifest.shadow_search == ShadowSearch::own) preamble += "#define RELIEFBENCH_OWN_MARCH 1\n";
    if (view.depth_write != DepthWrite::off) preamble += "#define RELIEFBENCH_WRITE_DEPTH 1\n";
    if (view.depth_write == DepthWrite::conservative) preamble += "#define RELIEFBENCH_CONSERVATIVE_DEPTH 1\n";
    preamble += declare_parameters(manifest, parameters);
    for (std::size_t i = 0; i < manifest.maps.size(); ++i) {
        if (!manifest.maps[i].scratch) preamble += declare_map(manifest.maps[i], i);
    }
    std::string key = fmt::format("{} {}{}", probed ? "probed" : "timed", static_cast<int>(view.depth_write),
                                  compile_time_key(manifest, parameters));
    const BaseSurface base = drawn_base(manifest, view.relief.base);
    const std::string of_pipeline = pipeline_of(manifest).preamble(manifest, parameters, base);
    const std::string of_view = declare_rays(base, view) + declare_material(view.material);
    preamble += of_pipeline + of_view;
    key += of_pipeline + of_view;

    std::vector<gpu::CompiledStage> stages;
    for (const std::string& file : stage_files(manifest.shape.kind)) {
        const Stage& stage = stage_of(file);
        stages.push_back(compile_stage(device, technique, key,
                                       {.stage = stage.stage,
                                        .file = file,
                                        .roots = {},
                                        .generated = {},
                                        .preamble = stage.definition + preamble,
                                        .inspect = refuse_uncounted_fetches}));
    }
    return stages;
}

gpu::CompiledStage compile_pass(const gpu::Device& device, const Technique& technique,
                                const ParameterValues& parameters, const PassDeclaration& pass, Variant variant) {
    const Manifest& manifest = technique.manifest;
    const bool probed = variant == Variant::probed;
    std::string preamble =
        declare_contract(manifest) + (probed ? probed_definition : "") + declare_parameters(manifest, parameters);
    for (const std::size_t map : maps_before(manifest, pass))
        preamble += declare_map(manifest.maps[map], map);
    const MapDeclaration& target = find_map(manifest, pass.writes);
    const bool folds = pass.sliced && pass.sliced->over == Slicing::Over::sources;
    // The format names of technique.json are GLSL's.
    preamble += fmt::format("layout(set = 0, binding = {}, {}) uniform {} {} target_map;\n", target_map_binding,
                            target.format, folds ? "" : "writeonly", target.is_volume() ? "image3D" : "image2D");
    if (target.is_volume()) preamble += "#define RELIEFBENCH_VOLUME 1\n";
    if (folds) preamble += "#define RELIEFBENCH_FOLDS 1\n";
    if (pass.levels == PassDeclaration::Levels::above_base) preamble += "#define RELIEFBENCH_ABOVE_BASE 1\n";
    const std::string key =
        fmt::format("{}{}{}", pass.name, probed ? " probed" : "", compile_time_key(manifest, parameters));
    return compile_stage(device, technique, key,
                         {.stage = gpu::ShaderStage::compute,
                          .file = "prepare.comp",
                          .roots = {},
                          .generated = {{pass_file, fmt::format("#include \"{}\"\n", pass.shader)}},
                          .preamble = preamble});
}

gpu::SpecializationValues parameter_constants(const Manifest& manifest, const ParameterValues& values) {
    gpu::SpecializationValues constants;
    for (const Parameter& parameter : manifest.parameters) {
        const auto found = values.find(parameter.name);
        if (found == values.end()) fail("technique '{}': parameter '{}' has no value", manifest.id, parameter.name);
        const std::string problem = check_parameter_value(parameter, found->second);
        if (!problem.empty()) fail("technique '{}': parameter '{}': {}", manifest.id, parameter.name, problem);
        if (parameter.compile_time || is_compiled_away(manifest, parameter, values)) continue;
        constants[parameter.name] = constant_bits(parameter, found->second);
    }
    return constants;
}

gpu::SpecializationValues view_constants(const View& view) {
    gpu::SpecializationValues constants = self_shadow_constants(view.self_shadow);
    constants["relief_repeats"] = view.relief.boundary == Boundary::repeat ? 1 : 0;
    return constants;
}

std::vector<std::size_t> maps_before(const Manifest& manifest, const PassDeclaration& pass) {
    std::vector<std::size_t> result;
    for (std::size_t map = 0; map < manifest.maps.size(); ++map) {
        const std::string& name = manifest.maps[map].name;
        const auto end = std::find_if(manifest.passes.begin(), manifest.passes.end(),
                                      [&](const PassDeclaration& other) { return other.name == pass.name; });
        const bool written = std::any_of(manifest.passes.begin(), end,
                                         [&](const PassDeclaration& other) { return other.writes == name; });
        if (written && name != pass.writes) result.push_back(map);
    }
    return result;
}

}  // namespace reliefbench
