#include "cli/advise_map.hpp"

#include "advice/answer.hpp"
#include "advice/candidate_sweep.hpp"
#include "advice/map_faults.hpp"
#include "advice/narrowing.hpp"
#include "cli/configuration_text.hpp"
#include "cli/duration.hpp"
#include "cli/output_file.hpp"
#include "cli/run_worker.hpp"
#include "cli/shell_word.hpp"
#include "cli/supervisor.hpp"
#include "cli/terminal.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/log.hpp"
#include "measure/chosen_run.hpp"
#include "store/chosen_figures.hpp"
#include "sweep/override.hpp"
#include "technique/map_needs.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

namespace reliefbench {

namespace {

/// What its configuration is called in messages.
constexpr const char* advice_configuration = "advice";

/// The narrowing as the runner asks it.
class NarrowingChooser : public CellChooser {
public:
    NarrowingChooser(const CandidateSweep& sweep, const AdviceRequest& request)
        : narrowing_(sweep.settings, sweep.contests, request) {}

    void add_result(std::size_t cell, const CellResult& result) override { narrowing_.set_result(cell, result); }
    void add_times(std::size_t cell, const PassTiming& draw, bool is_settled) override {
        narrowing_.set_times(cell, time_bounds(draw, is_settled));
    }
    std::vector<std::size_t> next_round() override {
        contenders_ = narrowing_.contenders();
        return narrowing_.next_round();
    }
    std::string reason_left_out(std::size_t cell) const override { return narrowing_.reason_left_out(cell); }
    std::string standing() const override { return fmt::format("{} in question", counted(contenders_, "setting")); }

private:
    Narrowing narrowing_;
    std::size_t contenders_ = 0;
};

ConfigurationText configuration_text(const AdviseMapOptions& options, const std::vector<Manifest>& techniques) {
    SweepQuestion question;
    const std::vector<Json> maps = parse_values("heightmap", options.map, "--map " + options.map);
    if (maps.size() != 1) fail("--map {}: advice is for one height map", options.map);
    question.map = maps.front();
    question.albedo = options.albedo;
    for (const Json& angle : parse_values("view_angle", options.view_angles, "--view-angle " + options.view_angles)) {
        if (!angle.is_number()) fail("--view-angle {}: expected degrees such as 60,75", options.view_angles);
        question.view_angles.push_back(angle.get<double>());
    }
    question.resolution = options.resolution;
    question.height_scale = options.height_scale;
    return {advice_configuration, candidate_configuration(question, techniques).dump()};
}

/// Of a patch side that is seen head-on.
double pixels_per_side(const View& view) {
    if (view.camera.projection == Projection::parallel) return view.resolution.width;
    const double half_fov = view.camera.fov * std::numbers::pi / 360;
    return view.resolution.height / (2 * view.camera.distance * std::tan(half_fov));
}

/// As the worst of the views see it.
MapUse use_of_map(const std::vector<Cell>& cells) {
    MapUse use{.height_scale = 0, .steepest_view_angle = 0, .pixels_per_side = 0};
    for (const Cell& cell : cells) {
        const View& view = cell.view.view;
        use.height_scale = std::max(use.height_scale, view.relief.height_scale);
        use.repeats = use.repeats || view.relief.boundary == Boundary::repeat || view.relief.tiling > 1;
        use.steepest_view_angle = std::max(use.steepest_view_angle, view.camera.view_angle);
        use.pixels_per_side = std::max(use.pixels_per_side, pixels_per_side(view));
    }
    return use;
}

/// Each map that the cells have, before anything is measured.
void tell_map_faults(const std::vector<Cell>& cells) {
    std::vector<std::pair<HeightMapSource, HeightFormat>> told;
    for (const Cell& cell : cells) {
        const std::pair map(cell.view.height_map, cell.view.height_format);
        if (std::ranges::find(told, map) != told.end()) continue;
        told.push_back(map);
        for (const MapFault& fault : map_faults(load_height_map(map.first, map.second), use_of_map(cells))) {
            if (fault.kind == MapFault::Kind::constant) fail("{}", fault.text);
            log_warning("{}", fault.text);
        }
    }
}

/// Figures that no cell of such a sweep has are refused before it is measured.
void refuse_missing_figures(const AdviceRequest& request, const std::vector<Cell>& cells) {
    std::vector<const FigureDeclaration*> asked{request.rank_by};
    for (const AdviceLimit& limit : request.limits)
        asked.push_back(limit.figure);
    const bool has_shadows = std::ranges::any_of(
        cells, [](const Cell& cell) { return cell.view.view.self_shadow.mode != SelfShadow::Mode::off; });
    for (const FigureDeclaration* figure : asked) {
        for (const std::string& need : figure->needs) {
            if (need == figure_needs::self_shadow && !has_shadows)
                fail("{} needs self-shadows: add -a self_shadow=hard", figure->path);
            if (need == figure_needs::motion || need == figure_needs::history || need == figure_needs::object)
                fail("{} needs what a configuration alone has (\"{}\"): run one, and ask `reliefbench advise RUN`",
                     figure->path, need);
        }
    }
}

Json question_json(const AdviceRequest& request) {
    Json limits;
    for (const AdviceLimit& limit : request.limits)
        limits[limit.figure->path] = limit.value;
    return {{"limits", limits}, {"rank_by", request.rank_by->path}};
}

/// The same for the same question, so that the same command goes on with it.
std::filesystem::path folder_of(const AdviseMapOptions& options, const RunSources& sources, const Json& question) {
    if (!options.output.empty()) return options.output;
    constexpr std::size_t digits = 8;
    Json identity = {sources.configuration.expanded, sources.filters, sources.technique_directories, question,
                     options.device.options.choice};
    const std::string map = sources.cells.front().view.height_map.name;
    return std::filesystem::path("results") / fmt::format("advice-{}-{}", std::filesystem::path(map).stem().string(),
                                                          content_hash(identity.dump()).substr(0, digits));
}

std::map<std::string, std::string> preset_titles(const TechniqueLibrary& library) {
    std::map<std::string, std::string> titles;
    for (const Technique& technique : library.techniques) {
        for (const Preset& preset : technique.manifest.presets)
            titles[preset.name] = preset.title;
    }
    return titles;
}

/// What is said below the answer: where the run is, how it goes on, and how it is looked at.
std::string next_commands(const std::filesystem::path& folder, bool is_time_over) {
    const std::string run = shell_word(folder.string());
    std::string text = fmt::format(
        "kept in {}\n  look at it: reliefbench report {} -o {}\n  ask it again: reliefbench "
        "advise {} --budget TIME\n",
        folder.string(), run, shell_word((folder / "report.html").string()), run);
    if (is_time_over) {
        text +=
            "  go on: the same command, with -o where it had that; or measure all that was not reached: reliefbench "
            "run " +
            shell_word((folder / "run.json").string()) + " -o " + run + " --resume\n";
    }
    return text;
}

RunJob job_of(const AdviseMapOptions& options, const ConfigurationText& text) {
    RunJob job{.sources = read_run_sources(text, options.cells, options.library),
               .resume = "plain",
               .format = {},
               .exports = {},
               .device = options.device.options,
               .sharing = options.sharing,
               .command_line = {}};
    set_sampling(job.sources.configuration, options.sampling.settings);
    if (options.preparation.limit_s) set_preparation_limit(job.sources.configuration, *options.preparation.limit_s);
    for (Cell& cell : job.sources.cells) {
        const Manifest& manifest = job.sources.library.get(cell.technique).manifest;
        if (!cell.skip_reason.empty() || manifest.map_needs.empty()) continue;
        cell.skip_reason = unmet_map_need(manifest, height_map_size(cell.view.height_map), cell.view.view.relief);
    }
    return job;
}

/// In the worker process: the same run, of the cells that the narrowing chooses.
ExitCode work_on_advice(RunJob job, const AdviseMapOptions& options, AdviceRequest request, bool json, double time_s,
                        WorkerStatus& status) {
    const Json question = question_json(request);
    job.takes_over = !status.folder().empty();
    job.folder = job.takes_over ? status.folder() : folder_of(options, job.sources, question);
    status.set_folder(job.folder);
    request.asks_for_all_views = true;
    const std::size_t cells = job.sources.cells.size();
    job.chosen = ChosenCells{
        .chooser = std::make_shared<NarrowingChooser>(
            candidate_sweep(job.sources.cells, job.sources.library.manifests()), request),
        .time_s = time_s,
        .question = question,
        .answer = [request, json, cells, folder = job.folder, titles = preset_titles(job.sources.library)](
                      const Run& run, bool is_time_over) {
            const bool is_measured =
                std::ranges::any_of(run.cells, [](const CellResult& cell) { return cell.status == CellStatus::ok; });
            Advice advice;
            advice.request = request;
            if (is_measured) advice = advise(run.cells, request, run.run);
            const NarrowedSweep sweep{run.cells, cells, is_time_over, titles};
            constexpr int spaces = 2;
            if (json) return answer_json(advice, sweep).dump(spaces, ' ', false, Json::error_handler_t::replace) + '\n';
            return answer_words(advice, sweep, table_columns()) + next_commands(folder, is_time_over);
        }};
    return work_on_run(job, status);
}

}  // namespace

void AdviseMapOptions::add_to(CLI::App& command) {
    command.add_option("--albedo", albedo, "Colours of the surface: an image file; default: one made from the heights")
        ->type_name("FILE");
    command.add_option("--view-angle", view_angles, "Degrees, 0 is head-on: one or more; default: " + view_angles)
        ->type_name("DEGREES");
    command.add_option("--resolution", resolution, "Of the picture, which relief fills; default: " + resolution)
        ->type_name("WxH");
    command
        .add_option("--height-scale", height_scale,
                    fmt::format("Depth of the relief, in sides of the patch; default: {:g}", height_scale))
        ->type_name("DEPTH");
    command.add_option("--time", time, "What measuring may take: 90s, 3m, 1h; default: " + time)->type_name("DURATION");
    command
        .add_option("-o,--output", output,
                    "Folder in which the run is kept, and gone on with where it ended; default: "
                    "results/advice-<map>-<question>")
        ->type_name("DIR");
    cells.add_to(command);
    sampling.add_to(command);
    library.add_to(command);
    device.add_to(command);
    sharing.add_to(command);
    preparation.add_to(command, "10");
    command
        .add_option("--pass-timeout", pass_timeout,
                    "Give up a cell when one of its passes on the device takes longer: 0.5s, 10s, 2m; default: 10s")
        ->type_name("DURATION");
}

ExitCode advise_from_map(const AdviseMapOptions& options, const AdviseRequestOptions& asked, bool json,
                         const std::vector<std::string>& command_line) {
    const double pass_timeout_s = parse_duration(options.pass_timeout, "--pass-timeout");
    const double time_s = parse_duration(options.time, "--time");
    refuse_standard_output(options.output, "a run is a folder; the answer goes to standard output anyway");
    const AdviceRequest request = asked.request(known_figure(chosen_figures::flip), {});
    const std::unique_ptr<WorkerStatus> status = take_worker_status();
    if (const std::optional<ConfigurationText> handed = take_handed_configuration(advice_configuration)) {
        RunJob job = job_of(options, *handed);
        job.command_line = command_line;
        return work_on_advice(std::move(job), options, request, json, time_s, *status);
    }
    const ConfigurationText text = configuration_text(options, options.library.find().manifests());
    const RunJob job = job_of(options, text);
    refuse_missing_figures(request, job.sources.cells);
    tell_map_faults(job.sources.cells);
    const HandedConfiguration handing(text);
    return supervise({command_line, pass_timeout_s, options.pass_timeout, handing});
}

}  // namespace reliefbench
