#include "cli/command.hpp"
#include "cli/comparison_output.hpp"
#include "cli/device_lock.hpp"
#include "cli/duration.hpp"
#include "cli/output_file.hpp"
#include "cli/progress_printer.hpp"
#include "cli/quality_choice.hpp"
#include "cli/read_maps.hpp"
#include "cli/run_sources.hpp"
#include "cli/shared_options.hpp"
#include "cli/threshold.hpp"
#include "cli/variant_comparison.hpp"
#include "core/cache_folder.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/log.hpp"
#include "core/scratch_folder.hpp"
#include "core/suggest.hpp"
#include "measure/run_record.hpp"
#include "measure/shared_inputs.hpp"
#include "measure/variants.hpp"
#include "report/comparison_format.hpp"
#include "store/device_share.hpp"
#include "store/line_file.hpp"
#include "technique/baseline_sources.hpp"
#include "technique/source_identity.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>

namespace reliefbench {

namespace {

struct AbOptions {
    std::string configuration;
    std::string baseline;
    std::string threshold = "1%";
    std::string budget = "5m";
    std::string output_folder;
    CellChoice cells;
    TechniqueOptions library;
    DeviceChoice device;
    DeviceSharing sharing;
    QualityChoice quality;
    ComparisonOutput output;
};

TechniqueSources own_sources(const RunSources& sources) {
    TechniqueSources own{{default_technique_root()}, shader_root(), "the work tree"};
    own.roots.insert(own.roots.end(), sources.technique_directories.begin(), sources.technique_directories.end());
    return own;
}

/// The checkout in which the current folder lies, where it is not that whose shaders are compared.
std::optional<std::filesystem::path> other_checkout() {
    std::error_code ignored;
    std::filesystem::path folder = std::filesystem::current_path(ignored);
    while (folder.has_relative_path() && !std::filesystem::is_directory(folder / "harness" / "shaders", ignored))
        folder = folder.parent_path();
    const std::filesystem::path shaders = folder / "harness" / "shaders";
    if (!std::filesystem::is_directory(shaders, ignored) ||
        std::filesystem::equivalent(shaders, shader_root(), ignored))
        return std::nullopt;
    return folder;
}

/// Whoever edited another copy must not take what is the same on both sides for the verdict on the edit.
std::string nothing_differs(const TechniqueSources& own) {
    std::vector<std::string> roots;
    for (const std::filesystem::path& root : own.roots)
        roots.push_back(root.string());
    std::string text =
        fmt::format("nothing differs between the sides: the new one has the techniques of {}", join(roots, " and "));
    if (const auto other = other_checkout())
        text += fmt::format(", and not those of {}, where you are; RELIEFBENCH_DATA_DIR={} compares them",
                            other->string(), other->string());
    return text;
}

/// What the reader must know of the two sides before any figure.
std::vector<std::string> notices_on(const TechniqueLibrary& base, const TechniqueLibrary& changed,
                                    const VariantOutcome& outcome, const TechniqueSources& baseline,
                                    const TechniqueSources& own) {
    std::vector<std::string> notices{fmt::format("the base is {}", baseline.description)};
    notices.insert(notices.end(), baseline.notices.begin(), baseline.notices.end());
    const bool same_shaders = hash_shared_shaders(baseline.shaders) == hash_shared_shaders(shader_root());
    if (!same_shaders) {
        notices.push_back(
            "the shared shaders (harness/shaders) differ between the sides, and each side is compiled with its own");
    }
    std::set<std::string> measured;
    std::set<std::string> unchanged;
    std::set<std::string> replaced;
    for (const MeasuredPair& pair : outcome.measured) {
        const std::string& id = pair.changed.technique;
        measured.insert(id);
        if (same_shaders && base.get(id).hash == changed.get(id).hash) unchanged.insert(id);
        if (takes_place_of_shipped(changed.get(id))) replaced.insert(changed.get(id).folder.string());
    }
    if (!replaced.empty()) {
        notices.push_back(fmt::format("the new side has these in place of the shipped ones: {}",
                                      join(std::vector<std::string>(replaced.begin(), replaced.end()))));
    }
    if (!unchanged.empty()) {
        notices.push_back(fmt::format("the sources are the same on both sides: {}",
                                      join(std::vector<std::string>(unchanged.begin(), unchanged.end()))));
        if (unchanged == measured) {
            notices.push_back(nothing_differs(own));
            log_warning("{}", notices.back());
        }
    }
    return notices;
}

/// As stored runs have it, with where the sources are from.
Json side_record(const std::string& sources, const TechniqueLibrary& library, const Json& run_record) {
    Json hashes = Json::object();
    for (const Technique& technique : library.techniques) {
        hashes[technique.manifest.id] = technique.hash;
    }
    return {{"sources", sources},
            {"device", run_record.at("device")},
            {"environment", run_record.at("environment")},
            {"techniques", std::move(hashes)}};
}

std::filesystem::path make_output_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) fail("cannot make the folder {}: {}", folder.string(), error.message());
    return folder;
}

/// Appends every visit to the file, if there is one.
std::function<void(const VariantVisit&)> keep_visits(std::optional<LineFile>& file) {
    if (!file) return {};
    return [&file](const VariantVisit& visited) {
        Json line;
        line["cell"] = visited.cell;
        line["round"] = visited.visit.round;
        line["first"] = visited.visit.base_first ? "base" : "new";
        line["repeats"] = visited.repeats;
        line["base_ms"] = visited.visit.base_ms;
        line["new_ms"] = visited.visit.changed_ms;
        file->append(line.dump());
    };
}

ExitCode compare_live(const AbOptions& options) {
    const double threshold = parse_threshold(options.threshold, "--threshold");
    VariantSettings settings;
    settings.cache = cache_folder();
    settings.budget_s = parse_duration(options.budget, "--budget");
    options.output.check();
    refuse_standard_output(options.output_folder, "it is a folder; the comparison goes to standard output anyway");
    const std::vector<DecidingFigure> deciding = options.quality.deciding_figures();
    const RunSources sources =
        read_run_sources(read_configuration_text(options.configuration), options.cells, options.library);
    settings.seed = sources.configuration.seed;
    const ScratchFolder scratch;
    const TechniqueSources own = own_sources(sources);
    const TechniqueSources baseline = find_baseline(options.baseline, own, scratch.path());
    const TechniqueLibrary base = find_techniques(baseline.roots, baseline.shaders, SameId::last_wins);

    std::optional<LineFile> evidence;
    if (!options.output_folder.empty())
        evidence.emplace(make_output_folder(options.output_folder) / "pairs.jsonl", LineFile::Start::created);

    const std::vector<HeightMapRecord> maps = read_maps(sources.cells);
    const gpu::Device device(options.device.options);
    const std::optional<DeviceLock> lock = options.sharing.lock(device.info());
    const Json record =
        make_run_record({sources.configuration, sources.library, sources.cells, maps, device, options.sharing.share});
    fmt::print(stderr, "{} on {}, base: {}\n", counted(sources.cells.size(), "cell"), device.info().name,
               baseline.description);
    VariantOutcome outcome;
    {
        ProgressPrinter printer;
        outcome = measure_variants(device, {base, sources.library}, sources.configuration, sources.cells, settings,
                                   {.is_decided = decided_at_looks(threshold, sources.cells.size()),
                                    .on_progress = [&printer](const Progress& progress) { printer(progress); },
                                    .on_visit = keep_visits(evidence)});
    }
    Comparison comparison = compare_variants(outcome, threshold, deciding);
    comparison.notices = notices_on(base, sources.library, outcome, baseline, own);
    if (const std::string shared = describe(device_share(record), "the times"); !shared.empty())
        comparison.notices.push_back(shared);
    comparison.environment["base"] = side_record(baseline.description, base, record);
    comparison.environment["new"] = side_record(own.description, sources.library, record);
    comparison.environment["sampling"] = {{"budget_s", settings.budget_s},
                                          {"spent_s", outcome.sampling_s},
                                          {"samples_per_visit", settings.samples_per_visit},
                                          {"minimum_pass_ms", settings.minimum_pass_ms},
                                          {"seed", settings.seed}};
    if (evidence) {
        write_text_file(std::filesystem::path(options.output_folder) / "comparison.json",
                        format_comparison(comparison, ComparisonFormat::json));
    }
    const ExitCode code = options.output.print(comparison);
    return worse_of(code, check_validation(device));
}

}  // namespace

void add_ab_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<AbOptions>();
    CLI::App* command = app.add_subcommand("ab", "Compare two versions of the shaders live, interleaved");
    command
        ->add_option("configuration", options->configuration,
                     "A configuration, or the run.json of an earlier run, - for standard input")
        ->required()
        ->type_name("CONFIG");
    command
        ->add_option(
            "--baseline", options->baseline,
            "What the techniques and shared shaders of the work tree are compared with: a checkout, a folder "
            "of technique folders, or a git revision. With --techniques, those of its techniques that have the "
            "id of a shipped one take its place")
        ->required()
        ->type_name("DIR|REVISION");
    command->add_option("--threshold", options->threshold, "The least change that counts; default: 1%")
        ->type_name("PERCENT");
    command
        ->add_option("--budget", options->budget,
                     "Time for sampling, for all cells together: 90s, 5m, 1h; preparing them comes on top; default: 5m")
        ->type_name("TIME");
    options->cells.add_to(*command);
    command
        ->add_option("-o,--output", options->output_folder,
                     "Folder to keep the comparison (comparison.json) and every raw sample (pairs.jsonl) in")
        ->type_name("DIR");
    options->library.add_to(*command);
    options->device.add_to(*command);
    options->sharing.add_to(*command);
    options->quality.add_to(*command);
    options->output.add_to(*command);
    command->footer(
        "The comparison goes to standard output, progress to standard error. Exit codes: 0 nothing slower or worse;\n"
        "1 a cell slower, or its quality worse or mixed (--accept-mixed lets that pass); 3 some undecided; 4 a cell "
        "failed that the baseline could draw.\n"
        "Example: reliefbench ab configs/quick.json --baseline HEAD~1 --filter technique=pom --budget 2m\n"
        "Example: reliefbench ab configs/quick.json --techniques mine --baseline techniques --filter technique=pom\n");
    command->callback([&chosen, options] { chosen = [options] { return compare_live(*options); }; });
}

}  // namespace reliefbench
