#include "cli/command.hpp"
#include "cli/comparison_choice.hpp"
#include "cli/output_file.hpp"
#include "cli/recorded_noise.hpp"
#include "cli/report_page.hpp"
#include "cli/report_pictures.hpp"
#include "cli/results.hpp"
#include "cli/run_sides.hpp"
#include "cli/stored_runs.hpp"
#include "compare/common_ids.hpp"
#include "compare/compare_runs.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/log.hpp"

#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>
#include <optional>
#include <span>

namespace reliefbench {

namespace {

struct ReportOptions {
    std::vector<std::string> folders;
    std::string output;
    ComparisonChoice comparison;
    double picture_megabytes = 7;
};

/// Where nothing says which runs are the base, only two runs can be meant.
std::optional<RunSides> compared_sides(const std::vector<std::string>& folders) {
    if (folders.size() != 2 && !has_separator(folders)) return std::nullopt;
    return split_sides(folders, "report");
}

std::vector<std::string> all_folders(const ReportOptions& options, const std::optional<RunSides>& sides) {
    if (!sides) return options.folders;
    std::vector<std::string> folders = sides->base;
    folders.insert(folders.end(), sides->changed.begin(), sides->changed.end());
    return folders;
}

/// Runs that cannot be compared (of different devices, say) still make a report, which says so.
PageComparison compare_sides(const std::vector<StoredRun>& runs, std::size_t bases, const CompareOptions& options) {
    PageComparison result;
    for (std::size_t run = 0; run < runs.size(); ++run) {
        (run < bases ? result.base : result.changed).push_back(runs[run].name);
    }
    try {
        const std::span<const StoredRun> all(runs);
        result.comparison = compare_runs(all.first(bases), all.subspan(bases), options, find_recorded_noise);
    } catch (const Error& error) {
        result.failure = error.what();
        log_warning("the report says nothing of what changed: {}", error.what());
    }
    return result;
}

/// What a run's folder has beside its cells, by the ids that the folder has.
struct FolderContent {
    std::vector<std::string> ids;
    std::optional<Json> summary;
    RunSamples samples;
    CellPictures pictures;
};

std::vector<FolderContent> read_contents(const std::vector<StoredRun>& stored, double picture_megabytes,
                                         PagePictures& pictures) {
    constexpr double bytes_per_megabyte = 1e6;
    const auto max_bytes = static_cast<std::size_t>(picture_megabytes * bytes_per_megabyte);
    std::vector<FolderContent> contents;
    for (std::size_t at = 0; at < stored.size(); ++at) {
        // Runs share the room, so that the first does not take it all.
        const std::size_t room = max_bytes * (at + 1) / stored.size();
        const StoredRun& run = stored[at];
        contents.push_back(
            {{}, read_run_summary(run.name), read_run_samples(run.name), collect_pictures(run, room, pictures)});
        for (const CellResult& cell : run.run.cells)
            contents.back().ids.push_back(cell.cell);
        if (const std::size_t left_out = contents.back().pictures.left_out; left_out > 0) {
            log_warning("{}: the pictures of {} do not fit into {:g} MB; --picture-megabytes makes room", run.name,
                        counted(left_out, "cell"), picture_megabytes);
        }
    }
    return contents;
}

/// The samples by the ids that the run's cells have now.
RunSamples with_common_ids(RunSamples samples, const std::vector<std::string>& ids, const StoredRun& run) {
    RunSamples renamed;
    for (auto& [pass, cells] : samples) {
        for (std::size_t at = 0; at < ids.size(); ++at) {
            if (auto found = cells.find(ids[at]); found != cells.end())
                renamed[pass][run.run.cells[at].cell] = std::move(found->second);
        }
    }
    return renamed;
}

ExitCode report(const ReportOptions& options) {
    check_output_file(options.output, "--output");
    const std::string page = read_report_page();

    const std::optional<RunSides> sides = compared_sides(options.folders);
    std::vector<StoredRun> stored = read_stored_runs(all_folders(options, sides));
    const CompareOptions compare_options = options.comparison.options(stored);
    PagePictures pictures;
    std::vector<FolderContent> contents = read_contents(stored, options.picture_megabytes, pictures);
    give_common_ids(stored);
    std::optional<PageComparison> comparison;
    if (sides) comparison = compare_sides(stored, sides->base.size(), compare_options);
    std::vector<PageRun> runs;
    for (std::size_t at = 0; at < stored.size(); ++at) {
        FolderContent& content = contents[at];
        runs.push_back({stored[at], std::move(content.summary),
                        with_common_ids(std::move(content.samples), content.ids, stored[at]),
                        std::move(content.pictures)});
    }
    write_output(options.output, fill_page(page, page_data(runs, pictures.json(), comparison, RELIEFBENCH_VERSION)));
    if (!is_standard_output(options.output)) {
        print_results(fmt::format("report: {} (open it in a browser)\n", options.output));
    }
    return ExitCode::done;
}

}  // namespace

void add_report_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<ReportOptions>();
    CLI::App* command =
        app.add_subcommand("report", "Write one HTML file to look at runs with: charts, pictures, tables");
    command->add_option("runs", options->folders, "Folders of runs; with two the page says what changed")
        ->required()
        ->type_name("RUN... [-- NEW...]");
    command->add_option("-o,--output", options->output, "The file to write or replace; - is standard output")
        ->required()
        ->type_name("FILE");
    options->comparison.add_to(*command);
    command
        ->add_option("--picture-megabytes", options->picture_megabytes,
                     "Room for pictures of runs that kept them (\"images\": true); default: 7")
        ->check(CLI::Range(0.0, 1000.0))
        ->type_name("MB");
    command->footer(
        "The file needs no network and no other file. Keys: press ? in it.\n"
        "Example: reliefbench report results/mine -o report.html\n"
        "Example: reliefbench report results/before results/after -o report.html\n");
    command->callback([&chosen, options] { chosen = [options] { return report(*options); }; });
}

}  // namespace reliefbench
