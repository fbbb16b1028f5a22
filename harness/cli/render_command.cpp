#include "cli/command.hpp"
#include "cli/run_sources.hpp"
#include "cli/shared_options.hpp"
#include "core/error.hpp"
#include "core/json.hpp"
#include "core/log.hpp"
#include "core/suggest.hpp"
#include "manifest/parameter_json.hpp"
#include "measure/cell_figures.hpp"
#include "measure/pictures.hpp"
#include "measure/shared_inputs.hpp"
#include "metrics/hit_errors.hpp"
#include "metrics/image_errors.hpp"
#include "scene/image_file.hpp"
#include "sweep/configuration.hpp"
#include "sweep/override.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>

namespace reliefbench {

namespace {

struct RenderOptions {
    std::string technique;
    std::vector<std::string> parameters;
    std::vector<std::string> axes;
    std::string output;
    TechniqueOptions library;
    DeviceChoice device;
};

enum class OutputKind { picture, layers };

OutputKind output_kind(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".png") return OutputKind::picture;
    if (extension == ".exr") return OutputKind::layers;
    fail("cannot render to '{}': give a file name that ends in .png (pictures) or .exr (float layers)", path);
}

/// "--set name=value", checked against the technique's declaration.
std::pair<std::string, ParameterValue> parse_setting(const Manifest& manifest, const std::string& argument) {
    const std::size_t equals = argument.find('=');
    if (equals == std::string::npos) fail("--set {}: expected parameter=value", argument);
    const std::string name = argument.substr(0, equals);
    const Parameter* parameter = manifest.find_parameter(name);
    if (parameter == nullptr) {
        std::vector<std::string> names;
        for (const Parameter& known : manifest.parameters) {
            names.push_back(known.name);
        }
        fail("--set {}: the technique '{}' has no parameter '{}'{}; it has: {}", argument, manifest.id, name,
             did_you_mean(name, names), names.empty() ? "none" : join(names));
    }
    ParameterValue value = parse_parameter_value(*parameter, argument.substr(equals + 1));
    const std::string objection = check_parameter_value(*parameter, value);
    if (!objection.empty()) fail("--set {}: {}", argument, objection);
    return {name, std::move(value)};
}

/// The configuration of one cell, which the axes of the command line then change.
Json one_cell(const Manifest& manifest, const std::vector<std::string>& settings) {
    Json selection{{"technique", manifest.id}};
    for (const std::string& argument : settings) {
        const auto [name, value] = parse_setting(manifest, argument);
        selection["parameters"][name] = to_json(value);
    }
    Json configuration;
    configuration["name"] = "render";
    configuration["techniques"] = Json::array({selection});
    configuration["axes"] = {{"heightmap", "bricks"}, {"resolution", "512x512"}, {"view_angle", 45}};
    return configuration;
}

Cell make_cell(const RenderOptions& options, const TechniqueLibrary& library) {
    for (const std::string& argument : options.axes) {
        const std::size_t values = parse_override(argument).values.size();
        if (values != 1)
            fail("-a {}: render draws one cell, so that an axis takes one value, not {}", argument, values);
    }
    const Json json = one_cell(library.get(options.technique).manifest, options.parameters);
    const std::vector<Manifest> manifests = library.manifests();
    const std::vector<Cell> cells = expand(parse_configuration(json, "render", options.axes, manifests), manifests);
    if (!cells.front().skip_reason.empty()) fail("{}: {}", cells.front().id, cells.front().skip_reason);
    return cells.front();
}

std::string format_summary(const std::string& quantity, const std::optional<Summary>& summary) {
    if (!summary) return fmt::format("{}: undefined, no pixel has both hits\n", quantity);
    return fmt::format("{}: median {:.3g}, p95 {:.3g}, p99 {:.3g}, max {:.3g}\n", quantity, summary->p50, summary->p95,
                       summary->p99, summary->max);
}

void print_summary(const Cell& cell, const Probe& probe, const HitErrors& errors, const ImageErrors& image) {
    fmt::print(stderr, "{}\n", cell.id);
    if (const std::optional<CellResult::Work> work = summarize_work(probe)) {
        fmt::print(stderr,
                   "{} pixels covered; per pixel {:.2f} taps (p95 {:.0f}), {:.2f} steps; {:.3f} % unconverged\n",
                   work->covered_pixels, work->taps_mean, work->taps_p95, work->steps_mean, 100 * work->unconverged);
    } else {
        fmt::print(stderr, "no pixel covered\n");
    }
    fmt::print(stderr, "{}", format_summary("UV error, texels", errors.uv_texels));
    fmt::print(stderr, "{}", format_summary("depth error", errors.depth));
    fmt::print(stderr, "{}", format_summary("normal error, degrees", errors.normal_deg));
    fmt::print(stderr, "missed {:.3f} %, false hits {:.3f} % of {} pixels; coverage IoU {:.5f}\n", 100 * errors.missed,
               100 * errors.false_hits, errors.footprint, errors.coverage_iou);
    if (errors.outside_quad_covered) {
        fmt::print(stderr, "outside the quad: {} pixels of relief, {:.1f} % of them drawn\n",
                   errors.outside_quad_pixels, 100 * *errors.outside_quad_covered);
    }
    fmt::print(stderr, "picture: RMSE {}, PSNR {}\n", image.rmse ? fmt::format("{:.4g}", *image.rmse) : "undefined",
               image.psnr ? fmt::format("{:.2f} dB", *image.psnr) : "undefined");
}

ExitCode render(const RenderOptions& options) {
    const OutputKind kind = output_kind(options.output);
    const TechniqueLibrary library = options.library.find();
    const Cell cell = make_cell(options, library);
    const View& view = cell.view.view;
    for (const HeightMapRecord& map : inspect_height_maps({cell})) {
        if (map.constant) log_warning("height map '{}' is constant: there is no relief in it", map.source.name);
    }
    const gpu::Device device(options.device.options);
    const LoadedMap loaded(device, cell.view.height_map, cell.view.height_format);
    const Technique& technique = library.get(cell.technique);
    const std::string unsupported =
        unsupported_reason(device, technique, cell.parameters, view, loaded.map.heights.size);
    if (!unsupported.empty()) fail("{}: {}", cell.id, unsupported);

    const Lighting lighting;
    Renderer renderer(device, technique, cell.parameters, loaded.scene, view, lighting);
    renderer.prepare();
    const Probe probe = renderer.probe();
    const Truth truth = trace_truth(loaded, view, lighting, TruthSettings{});
    if (kind == OutputKind::layers) {
        write_raster_file(options.output, layers(probe, truth));
    } else {
        write_raster_file(options.output, side_by_side({display_picture(probe.colour), display_picture(truth.colour),
                                                        error_picture(probe.hits, truth, loaded.map, view.relief)}));
    }
    print_summary(cell, probe, compare_hits(probe.hits, truth.hits, truth.footprint, loaded.map, view.relief),
                  compare_images(probe.colour, probe.hits, truth.colour, truth.hits));
    return check_validation(device);
}

}  // namespace

void add_render_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<RenderOptions>();
    CLI::App* command = app.add_subcommand("render", "Draw one cell beside its truth and its error map");
    command->add_option("--technique", options->technique, "What draws; see `list techniques`")
        ->required()
        ->type_name("ID");
    add_repeated_option(*command, "--set", options->parameters, "A parameter of the technique (may be repeated)")
        ->type_name("PARAMETER=VALUE");
    add_repeated_option(*command, "-a,--axis", options->axes,
                        "An axis of the view, one value (may be repeated); default: heightmap=bricks, "
                        "resolution=512x512, view_angle=45")
        ->type_name("NAME=VALUE");
    command->add_option("-o,--output", options->output, "The file to write, .png or .exr")
        ->required()
        ->type_name("FILE");
    options->library.add_to(*command);
    options->device.add_to(*command);
    command->footer(
        ".png: the technique's picture, the truth's, and the error map, from left to right. The error map shows the\n"
        "UV error in texels on a logarithmic scale in the colours of magma: black up to 0.01, pale yellow from 10.\n"
        "Blue: missed (the truth hits, the technique does not). Cyan: the same outside the flat quad, where only real\n"
        "geometry can draw. Green: false hit. Grey: no relief in either.\n"
        ".exr: float channels hit.u hit.v hit.h hit.t, taps, truth.u truth.v truth.h truth.t, color.R color.G "
        "color.B,\n"
        "truth_color.R truth_color.G truth_color.B; u and v in patch coordinates, t the distance from the eye (for\n"
        "parallel rays from the plane z = 0), t = -1 and zeros for a miss, colours linear.\n"
        "Example: reliefbench render --technique pom --set max_steps=64 -a view_angle=75 -o picture.png\n");
    command->callback([&chosen, options] { chosen = [options] { return render(*options); }; });
}

}  // namespace reliefbench
