#include "cli/command.hpp"
#include "cli/contact_sheet.hpp"
#include "cli/output_file.hpp"
#include "cli/progress_printer.hpp"
#include "cli/render_options.hpp"
#include "cli/results.hpp"
#include "core/attempt.hpp"
#include "core/cache_folder.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/log.hpp"
#include "core/scratch_folder.hpp"
#include "measure/base_records.hpp"
#include "measure/clock.hpp"
#include "measure/laboratory.hpp"
#include "measure/pictures.hpp"
#include "measure/shared_inputs.hpp"
#include "report/figure_lines.hpp"
#include "scene/image_file.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace reliefbench {

namespace {

void print_figures(const CellResult& result) {
    fmt::print(stderr, "{}\n", result.cell);
    for (const std::string& line : figure_lines(result))
        fmt::print(stderr, "{}\n", line);
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

/// What cells are drawn with, each once, untimed.
struct Drawing {
    Laboratory& laboratory;
    LaboratoryCallbacks callbacks;
    std::vector<Shown> shown;
    OutputKind kind = OutputKind::picture;
};

ExitCode draw_contact_sheet(const RenderOptions& options, const std::vector<Cell>& cells, const Drawing& drawing) {
    const Font font;
    const ContactSheet made = make_contact_sheet(cells, drawing.shown, drawing.laboratory, drawing.callbacks, font);
    write_picture(options.output, to_raster(draw_sheet(made.sheet, font)));
    fmt::print(stderr, "{}: {}\n", options.output, counted(cells.size(), "row"));
    return made.failures == 0 ? ExitCode::done : ExitCode::cells_failed;
}

/// A cell that was to be drawn into a file of its own. One that is skipped leaves none, as does one that fails before
/// it is drawn.
struct DrawnToFile {
    CellResult result;
    bool is_written = false;
    bool is_compared = false;
};

DrawnToFile draw_to_file(const std::filesystem::path& path, const Cell& cell, PreparedCell prepared,
                         const Drawing& drawing) {
    DrawnToFile made{.result = std::move(prepared.result)};
    if (!prepared.probe) return made;
    std::optional<DrawnCell> drawn;
    std::string failure = failure_of([&] { drawn.emplace(drawing.laboratory.beside_truth(cell, *prepared.probe)); });
    if (failure.empty()) {
        made.is_written = fits_in_memory([&] { write_cell(path, drawing.kind, drawing.shown, *drawn); });
        if (!made.is_written) failure = memory_used_up;
    }
    made.is_compared = made.is_written && prepared.is_compared;
    if (!failure.empty()) made.result = ended_result(cell, CellStatus::failed, failure);
    return made;
}

/// A skipped cell was asked for all the same, and there is no picture of it.
ExitCode report_ending(const CellResult& result) {
    tell_ending(result);
    switch (result.status) {
        case CellStatus::ok:
            return ExitCode::done;
        case CellStatus::skipped:
            return ExitCode::bad_input;
        case CellStatus::failed:
            return ExitCode::cells_failed;
    }
    return ExitCode::internal_error;
}

ExitCode draw_frames(const RenderOptions& options, const std::vector<Cell>& cells, const Drawing& drawing) {
    ExitCode code = ExitCode::done;
    for (std::size_t frame = 0; frame < cells.size(); ++frame) {
        const std::filesystem::path path = frame_path(options.output, frame, cells.size());
        const Cell& cell = cells[frame];
        drawing.laboratory.keep_only({cell.view});
        const DrawnToFile made =
            draw_to_file(path, cell, drawing.laboratory.make_picture(cell, drawing.callbacks), drawing);
        if (made.is_written) fmt::print(stderr, "[{}/{}] {}: {}\n", frame + 1, cells.size(), path.string(), cell.id);
        code = worse_of(code, report_ending(made.result));
    }
    return code;
}

ExitCode draw_cell(const RenderOptions& options, const Cell& cell, const Drawing& drawing) {
    const DrawnToFile made =
        draw_to_file(options.output, cell, drawing.laboratory.make_ready(cell, drawing.callbacks), drawing);
    if (made.is_compared) print_figures(made.result);
    if (made.is_written && !is_standard_output(options.output)) fmt::print(stderr, "wrote {}\n", options.output);
    return report_ending(made.result);
}

/// As a configuration has it: each cell is drawn once, and each pass of its preparation is run once.
Configuration configuration_of(const RenderOptions& options) {
    Configuration configuration;
    configuration.lighting = lighting_of(options);
    configuration.object = object_of(options);
    if (options.preparation.limit_s) configuration.preparation.limit_s = *options.preparation.limit_s;
    return configuration;
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
    const Configuration configuration = configuration_of(options);
    warn_of_constant_maps(cells);
    inspect_bases(cells);
    const gpu::Device device(options.device.options);
    ProgressPrinter printer;
    const auto on_progress = [&printer, start_s = steady_clock().seconds()](const PreparationProgress& progress) {
        tell(progress, printer, start_s);
    };
    SharedInputs inputs(device, configuration.lighting, configuration.truth, configuration.object, cache_folder());
    Laboratory laboratory(library, configuration, inputs, {.cache = cache_folder(), .timed = false});
    const Drawing drawing{laboratory, {.on_progress = on_progress}, shown_by(options), kind};
    ExitCode code = ExitCode::done;
    if (options.contact_sheet) {
        code = draw_contact_sheet(options, cells, drawing);
    } else if (!options.animation.empty()) {
        code = draw_frames(options, cells, drawing);
    } else {
        code = draw_cell(options, cells.front(), drawing);
    }
    return worse_of(code, check_validation(device));
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
                        "An axis of the view, one value, or preset=NAME (may be repeated); default: heightmap=bricks, "
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
        "2 missed, 3 false hit, 4 missed outside the footprint.\n"
        "Exit code 4 when a cell fails, as it would in a run; where it could be drawn it is, to see where it fails. "
        "2\n"
        "when the cell is skipped, so that there is no picture; a contact sheet has a row without one.\n"
        "Example: reliefbench render --technique pom --set max_steps=64 -a view_angle=75 -o picture.png\n"
        "Example: reliefbench render --technique pom --show flip,ssim -a view_angle=75 -o maps.png\n"
        "Example: reliefbench render --contact-sheet --technique steep,pom,qdm -a view_angle=60 -o sheet.png\n"
        "Example: reliefbench render --technique pom -a self_shadow=hard --lighting '{\"lights\": [{\"direction\": "
        "[-1, 0, 0.5]}]}' -o shadows.png\n"
        "Example: reliefbench render --technique pom --show picture --animate view_angle=[0:80:2] -o turn.png\n");
    command->callback([&chosen, options] { chosen = [options] { return render(*options); }; });
}

}  // namespace reliefbench
