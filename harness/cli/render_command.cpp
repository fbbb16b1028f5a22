#include "cli/cell_drawing.hpp"
#include "cli/command.hpp"
#include "cli/contact_sheet.hpp"
#include "cli/output_file.hpp"
#include "cli/progress_printer.hpp"
#include "cli/render_options.hpp"
#include "cli/results.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/log.hpp"
#include "core/scratch_folder.hpp"
#include "measure/cell_figures.hpp"
#include "measure/cell_preparation.hpp"
#include "measure/clock.hpp"
#include "measure/pictures.hpp"
#include "measure/shared_inputs.hpp"
#include "metrics/wrong_surface.hpp"
#include "scene/image_file.hpp"
#include "technique/map_cache.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace reliefbench {

namespace {

std::string format_summary(const std::string& quantity, const std::optional<Summary>& summary) {
    if (!summary) return fmt::format("{}: undefined, no pixel has both hits\n", quantity);
    return fmt::format("{}: median {:.3g}, p95 {:.3g}, p99 {:.3g}, max {:.3g}\n", quantity, summary->p50, summary->p95,
                       summary->p99, summary->max);
}

void print_image_errors(const char* what, const ImageErrors& errors) {
    const auto text = [](const std::optional<double>& value, const char* unit) {
        return value ? fmt::format("{:.4g}{}", *value, unit) : "undefined";
    };
    fmt::print(stderr, "{}: RMSE {}, PSNR {}, SSIM {}, FLIP {}\n", what, text(errors.rmse, ""),
               text(errors.psnr, " dB"), text(errors.ssim, ""), text(errors.flip, ""));
}

/// Of what only some scenes have.
void print_scene_errors(const DrawnCell& drawn, const std::optional<ShadowErrors>& shadow) {
    if (shadow) {
        fmt::print(stderr,
                   "shadows: visibility wrong by {:.4g} on average; {:.3f} % falsely dark, {:.3f} % falsely lit\n",
                   shadow->mean, 100 * shadow->false_shadow, 100 * shadow->missed_shadow);
    }
    if (drawn.truth.front) {
        fmt::print(stderr, "wrong surface in front: {:.3f} % of the footprint\n",
                   100 * wrong_surface(*drawn.probe.front, *drawn.truth.front, drawn.truth.footprint));
    }
}

void print_summary(const Cell& cell, const DrawnCell& drawn, const std::optional<ShadowErrors>& shadow) {
    const HitErrors errors = hit_errors_of(drawn);
    const ImageComparison image = image_errors_of(drawn);
    fmt::print(stderr, "{}\n", cell.id);
    if (const std::optional<WorkSummary> work = summarize_work(drawn.probe, shadow.has_value())) {
        fmt::print(stderr, "{} covered; per pixel {:.2f} taps (p95 {:.0f}), {:.2f} steps; {:.3f} % unconverged\n",
                   counted(work->covered_pixels, "pixel"), work->taps_mean(), work->taps_p95(), work->steps.mean,
                   100 * work->unconverged);
    } else {
        fmt::print(stderr, "no pixel covered\n");
    }
    fmt::print(stderr, "{}", format_summary("UV error, texels", errors.uv_texels));
    fmt::print(stderr, "{}", format_summary("depth error", errors.depth));
    fmt::print(stderr, "{}", format_summary("normal error, degrees", errors.normal_deg));
    fmt::print(stderr, "missed {:.3f} %, false hits {:.3f} %, ties {:.3f} % of {}; coverage IoU {:.5f}\n",
               100 * errors.missed, 100 * errors.false_hits, 100 * errors.ties, counted(errors.footprint, "pixel"),
               errors.coverage_iou);
    if (errors.outside_quad_covered) {
        fmt::print(stderr, "outside the quad: {} of relief, {:.1f} % of them drawn\n",
                   counted(errors.outside_quad_pixels, "pixel"), 100 * *errors.outside_quad_covered);
    }
    print_image_errors("picture, over the footprint", image.footprint);
    print_image_errors("picture, with what lies beyond the quad", image.whole);
    print_scene_errors(drawn, shadow);
}

/// One cell's pictures from left to right; a single one without a legend comes as it is, pixel for pixel.
Picture draw_pictures(const std::vector<Shown>& shown, const DrawnCell& drawn) {
    std::vector<Picture> pictures = pictures_of(shown, drawn);
    if (pictures.size() == 1 && shown.front().kind != Shown::Kind::map) return pictures.front();
    const Font font;
    Sheet sheet;
    sheet.columns = columns_of(shown, font);
    sheet.rows.push_back({"", {}, std::move(pictures)});
    return draw_sheet(sheet, font);
}

/// To standard output as a PNG.
void write_picture(const std::filesystem::path& path, const RasterFile& raster) {
    if (!is_standard_output(path)) {
        write_raster_file(path, raster);
        return;
    }
    const ScratchFolder scratch;
    const std::filesystem::path file = scratch.path() / "picture.png";
    write_raster_file(file, raster);
    print_results(read_text_file(file));
}

void write_cell(const std::filesystem::path& path, OutputKind kind, const std::vector<Shown>& shown,
                const DrawnCell& drawn) {
    write_picture(path, kind == OutputKind::layers ? layers(drawn) : to_raster(draw_pictures(shown, drawn)));
}

void warn_of_constant_maps(const std::vector<Cell>& cells) {
    for (const HeightMapRecord& map : inspect_height_maps(cells)) {
        if (map.constant) log_warning("height map '{}' is constant: there is no relief in it", map.source.name);
    }
}

ExitCode draw_contact_sheet(const RenderOptions& options, const std::vector<Cell>& cells, CellDrawing& drawing) {
    const Font font;
    std::size_t failures = 0;
    const Sheet sheet = make_contact_sheet(cells, shown_by(options), drawing, font, failures);
    write_picture(options.output, to_raster(draw_sheet(sheet, font)));
    fmt::print(stderr, "{}: {}\n", options.output, counted(cells.size(), "row"));
    return failures == 0 ? ExitCode::done : ExitCode::cells_failed;
}

/// A picture is made of a failed cell, too, to see where it fails.
ExitCode report_failure(const Cell& cell, const Probe& probe) {
    const std::string failure = failure_of(probe);
    if (failure.empty()) return ExitCode::done;
    log_error("failed: {}: {}", cell.id, failure);
    return ExitCode::cells_failed;
}

ExitCode draw_frames(const RenderOptions& options, OutputKind kind, const std::vector<Cell>& cells,
                     CellDrawing& drawing) {
    const std::vector<Shown> shown = shown_by(options);
    ExitCode code = ExitCode::done;
    for (std::size_t frame = 0; frame < cells.size(); ++frame) {
        const std::filesystem::path path = frame_path(options.output, frame, cells.size());
        const Probe probe = drawing.probe(cells[frame]);
        write_cell(path, kind, shown, drawing.beside_truth(cells[frame], probe));
        fmt::print(stderr, "[{}/{}] {}: {}\n", frame + 1, cells.size(), path.string(), cells[frame].id);
        code = graver(code, report_failure(cells[frame], probe));
    }
    return code;
}

ExitCode draw_cell(const RenderOptions& options, OutputKind kind, const Cell& cell, CellDrawing& drawing) {
    const Probe probe = drawing.probe(cell);
    const DrawnCell drawn = drawing.beside_truth(cell, probe);
    write_cell(options.output, kind, shown_by(options), drawn);
    print_summary(cell, drawn, drawing.shadow_errors(cell, drawn));
    if (!is_standard_output(options.output)) fmt::print(stderr, "wrote {}\n", options.output);
    return report_failure(cell, probe);
}

/// Told on a line that the next message takes the place of.
void tell(const PreparationProgress& progress, ProgressPrinter& printer, double start_s) {
    printer({.cells_total = 1,
             .current = describe(progress),
             .elapsed_s = steady_clock().seconds() - start_s,
             .remaining_s = progress.remaining_s,
             .share = progress.fraction});
}

ExitCode render(const RenderOptions& options) {
    const OutputKind kind = check_output(options.output);
    shown_by(options);
    if (options.contact_sheet && kind == OutputKind::layers) {
        fail("cannot render a contact sheet to '{}': it is a picture, so give a file name that ends in .png",
             options.output);
    }
    const TechniqueLibrary library = options.library.find();
    const std::vector<Cell> cells = cells_to_render(options, library);
    const Lighting lighting = lighting_of(options);
    const std::optional<SceneObject> object = object_of(options);
    warn_of_constant_maps(cells);
    const gpu::Device device(options.device.options);
    ProgressPrinter printer;
    const auto on_progress = [&printer, start_s = steady_clock().seconds()](const PreparationProgress& progress) {
        tell(progress, printer, start_s);
    };
    CellDrawing drawing(device, library,
                        {.limit_s = options.preparation.limit_s.value_or(PreparationLimit{}.limit_s),
                         .cache = map_cache_folder(),
                         .on_progress = on_progress},
                        lighting, object);
    ExitCode code = ExitCode::done;
    if (options.contact_sheet) {
        code = draw_contact_sheet(options, cells, drawing);
    } else if (!options.animation.empty()) {
        code = draw_frames(options, kind, cells, drawing);
    } else {
        code = draw_cell(options, kind, cells.front(), drawing);
    }
    return graver(code, check_validation(device));
}

}  // namespace

void add_render_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<RenderOptions>();
    CLI::App* command = app.add_subcommand(
        "render", "Draw a cell beside its truth and error maps, a contact sheet of techniques, or an animation");
    add_repeated_option(*command, "--technique", options->techniques,
                        "What draws, see `list techniques`; a contact sheet takes several (a,b) and without has all")
        ->type_name("ID");
    add_repeated_option(*command, "--set", options->parameters, "A parameter of the technique (may be repeated)")
        ->type_name("PARAMETER=VALUE");
    add_repeated_option(*command, "-a,--axis", options->axes,
                        "An axis of the view, one value (may be repeated); default: heightmap=bricks, "
                        "resolution=512x512 (contact sheet: 192x192), view_angle=45")
        ->type_name("NAME=VALUE");
    command
        ->add_option("--show", options->show,
                     "What a PNG shows: picture, truth, uv_error, flip, taps, depth_error, normal_error, ssim, "
                     "coverage; default: picture,truth,uv_error (contact sheet: truth,picture,uv_error,flip,taps)")
        ->type_name("LIST");
    command->add_flag("--contact-sheet", options->contact_sheet,
                      "One row per technique, and per value of axes with several, cropped to the relief");
    command->add_option("--animate", options->animation, "A frame per value: -o turn.png writes turn_000.png, ...")
        ->type_name("AXIS=VALUES");
    command
        ->add_option("--lighting", options->lighting,
                     R"(As in a configuration: '{"lights": [{"direction": [-1, 0, 0.5]}]}')")
        ->type_name("JSON");
    command
        ->add_option(
            "--object", options->object,
            R"(A solid that stands in the relief, as in a configuration: '{"shape": "sphere", "radius": 0.2}')")
        ->type_name("JSON");
    command
        ->add_option("-o,--output", options->output, "The file to write, .png or .exr; - is a PNG on standard output")
        ->required()
        ->type_name("FILE");
    options->library.add_to(*command);
    options->device.add_to(*command);
    options->preparation.add_to(*command);
    command->footer(
        ".png: what --show lists, from left to right. Maps are in the colours of magma, with their legend; blue: "
        "missed\n"
        "(the truth hits, the technique does not); cyan: the same outside the flat quad, where only real geometry can\n"
        "draw; green: false hit; grey: nothing.\n"
        ".exr: float channels hit.u hit.v hit.h hit.t, truth.u truth.v truth.h truth.t, color.R color.G color.B,\n"
        "truth_color.R truth_color.G truth_color.B, and all maps by name; u and v in patch coordinates, t the "
        "distance\n"
        "from the eye (for parallel rays from the plane z = 0), t = -1 and zeros for a miss, colours linear; maps are\n"
        "not a number where they are undefined, depth_error is positive where too deep, coverage is 0 neither, 1 "
        "both,\n"
        "2 missed, 3 false hit, 4 missed outside the quad.\n"
        "Exit code 4 when a cell fails because its technique answered out of range; it is drawn all the same.\n"
        "Example: reliefbench render --technique pom --set max_steps=64 -a view_angle=75 -o picture.png\n"
        "Example: reliefbench render --technique pom --show flip,ssim -a view_angle=75 -o maps.png\n"
        "Example: reliefbench render --contact-sheet --technique steep,pom,qdm -a view_angle=60 -o sheet.png\n"
        "Example: reliefbench render --technique pom -a self_shadow=hard --lighting '{\"lights\": [{\"direction\": "
        "[-1, 0, 0.5]}]}' -o shadows.png\n"
        "Example: reliefbench render --technique pom --show picture --animate view_angle=[0:80:2] -o turn.png\n");
    command->callback([&chosen, options] { chosen = [options] { return render(*options); }; });
}

}  // namespace reliefbench
