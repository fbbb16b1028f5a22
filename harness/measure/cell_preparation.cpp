#include "measure/cell_preparation.hpp"

#include "core/error.hpp"
#include "gpu/device.hpp"
#include "measure/cell_figures.hpp"
#include "measure/memory_need.hpp"
#include "measure/search_advice.hpp"
#include "metrics/hit_errors.hpp"
#include "metrics/image_errors.hpp"
#include "metrics/shadow_errors.hpp"
#include "metrics/wrong_surface.hpp"
#include "store/crashes.hpp"
#include "technique/cut_loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace reliefbench {

namespace {

/// A preparation that takes long is timed less often, so that a block's length stays in bounds.
constexpr double preparation_budget_ms = 2000;

/// Fraction of covered pixels: a picture with more is not the technique's.
constexpr double most_unconverged = 0.5;

/// The first run compiles in the driver: it counts only when there is no time for another. What takes little is made
/// again though it was kept, for its times.
Preparation time_preparation(Renderer& renderer, const Configuration& configuration,
                             const LongPreparation& long_preparation) {
    const SamplingSettings& sampling = configuration.sampling;
    PreparationSettings settings{.limit_s = configuration.preparation.limit_s,
                                 .cache = long_preparation.map_cache,
                                 .on_progress = long_preparation.on_progress};
    Preparation first = renderer.prepare(settings);
    const double first_ms = preparation_ms(first);
    if (first.pass_ms.empty() || !first.given_up.empty() || first_ms > preparation_budget_ms) {
        return first;
    }
    const int most = std::max(1, sampling.rounds * sampling.samples_per_visit);
    const double affordable = first_ms > 0 ? preparation_budget_ms / first_ms : most;
    settings.samples = static_cast<int>(std::clamp(affordable, 1.0, static_cast<double>(most)));
    settings.take_kept = false;
    // It has shown that it stays below the limit: what a busy machine makes of its times does not skip the cell.
    settings.limit_s = std::numeric_limits<double>::infinity();
    return renderer.prepare(settings);
}

/// Why a picture that was drawn is not the technique's; empty where it is.
std::string reason_to_fail(const gpu::Device& device, const Manifest& manifest, const ParameterValues& parameters,
                           const Probe& probe, const std::optional<WorkSummary>& work) {
    const std::string cut = describe_cut_loops(device, probe);
    if (!cut.empty()) {
        return fmt::format("{}, so that neither its picture nor its time is the technique's; {}", cut,
                           advise_shorter_search(manifest, parameters));
    }
    if (!work || work->unconverged <= most_unconverged) return {};
    return fmt::format(
        "{:.0f} % of its pixels left their loop at the iteration cap, unconverged, so that its time would say nothing; "
        "{}",
        100 * work->unconverged, advise_longer_search(manifest, parameters));
}

/// time_preparation, unless it is known how it ends.
Preparation prepare_once(const gpu::Device& device, Renderer& renderer, const Configuration& configuration,
                         const LongPreparation& long_preparation) {
    const std::string maps = renderer.maps_key();
    if (const FailedPreparations::Failure* known = long_preparation.failed.find(maps)) {
        if (!known->given_up) fail("{}", known->reason);
        Preparation preparation;
        preparation.given_up = known->reason;
        return preparation;
    }
    const auto tell = [&](const std::string& key) {
        if (long_preparation.on_maps) long_preparation.on_maps(key);
    };
    try {
        tell(maps);
        Preparation preparation = time_preparation(renderer, configuration, long_preparation);
        tell({});
        if (!preparation.given_up.empty()) long_preparation.failed.add(maps, {true, preparation.given_up});
        return preparation;
    } catch (const Error& error) {
        tell({});
        // A lost device says nothing of the maps.
        if (!device.is_lost()) long_preparation.failed.add(maps, {false, error.what()});
        throw;
    }
}

/// Why the cell cannot be made on this machine; empty where it can. Nothing is loaded for it.
std::string refusal(const gpu::Device& device, const Technique& technique, const Cell& cell, const SharedInputs& inputs,
                    const Configuration& configuration) {
    const InputSizes sizes = input_sizes(cell.view.height_map);
    const std::string unsupported =
        unsupported_reason(device, technique, cell.parameters, cell.view.view, sizes.height_map);
    if (!unsupported.empty()) return unsupported;
    MemoryNeed need = cell_need(technique, cell, sizes, configuration);
    if (!inputs.has_map(cell.view)) need = with_inputs(need, sizes, cell.view.height_format);
    return lacking_memory(device, "the cell", need);
}

}  // namespace

const FailedPreparations::Failure* FailedPreparations::find(const std::string& maps) const {
    const auto found = failures_.find(maps);
    return found == failures_.end() ? nullptr : &found->second;
}

void FailedPreparations::add_crashed(const std::map<std::string, std::vector<std::string>>& crashed) {
    for (const auto& [maps, reasons] : crashed) {
        if (reasons.size() >= most_crashes) add(maps, {false, crashed_preparation_reason(reasons)});
    }
}

CellResult blank_result(const Cell& cell) {
    CellResult result;
    result.cell = cell.id;
    result.technique = cell.technique;
    result.axes = axes_to_json(cell.view);
    result.parameters = parameters_to_json(cell.parameters);
    return result;
}

std::string describe(const PreparationProgress& progress) {
    std::string text = fmt::format("preparing ({}) {:.0f} %", progress.pass, 100 * progress.fraction);
    if (progress.remaining_s >= 0) text += fmt::format(", {:.0f} s left", progress.remaining_s);
    return text;
}

PreparedOrSkipped prepare_cell(const gpu::Device& device, const Technique& technique, const Cell& cell,
                               SharedInputs& inputs, const Configuration& configuration,
                               const LongPreparation& long_preparation) {
    const std::string refused = refusal(device, technique, cell, inputs, configuration);
    if (!refused.empty()) return {std::nullopt, refused};
    const auto begin = [&](const char* stage) {
        if (long_preparation.on_stage) long_preparation.on_stage(stage);
    };
    if (!inputs.has_map(cell.view)) begin("loading the height map");
    const LoadedMap& loaded = inputs.map(cell.view);
    const View& view = cell.view.view;
    begin("compiling");
    Renderer renderer(device, technique, cell.parameters, loaded.scene, view, configuration.lighting,
                      configuration.object);
    if (!technique.manifest.passes.empty()) begin("making its maps");
    Preparation preparation = prepare_once(device, renderer, configuration, long_preparation);
    if (!preparation.given_up.empty()) return {std::nullopt, preparation.given_up};
    begin("drawing it once, counted");
    Probe probe = renderer.probe();
    if (!probe.faults.empty()) fail("{}", reason_of_faults(probe.faults, view.resolution.pixels()));

    CellResult result = blank_result(cell);
    for (const auto& [pass, samples] : preparation.pass_ms) {
        // Each run is a submission of its own.
        std::vector<std::vector<double>> runs;
        for (const double sample : samples) {
            runs.push_back({sample});
        }
        result.time[pass] = summarize_timing(runs, 1);
    }
    result.prepare_ms = preparation_ms(preparation);
    result.prepare_bytes = preparation.bytes;
    const bool self_shadow = view.self_shadow.mode != SelfShadow::Mode::off;
    const std::optional<WorkSummary> work = summarize_work(probe, self_shadow);
    if (work) result.figures.add(figures_of(*work));
    result.reason = reason_to_fail(device, technique.manifest, cell.parameters, probe, work);
    if (!result.reason.empty()) result.status = CellStatus::failed;
    result.pipeline = renderer.pipeline_statistics();
    result.executable = renderer.executable_statistics();
    if (!inputs.has_truth(cell.view)) begin("tracing the truth");
    const Truth& truth = inputs.truth(cell.view);
    begin("comparing with the truth");
    result.figures.add(figures_of(compare_hits(probe.hits, truth.hits, truth.footprint, loaded.map, view.relief)));
    if (self_shadow) {
        ShadowErrors shadow =
            compare_shadows(probe.light_visibility, probe.hits, truth.light_visibility.fractions, truth.hits,
                            truth.footprint, loaded.map, view.relief, configuration.lighting);
        shadow.truth_standard_error = truth.light_visibility.standard_error;
        result.figures.add(figures_of(shadow));
    }
    if (truth.front)
        result.figures.add(figures_of_wrong_surface(wrong_surface(*probe.front, *truth.front, truth.footprint)));
    result.figures.add(figures_of(
        compare_images(probe.colour, probe.hits, truth.colour, truth.hits, {truth.footprint, truth.background})));
    return {PreparedCell{std::move(renderer), std::move(result), std::move(preparation), std::move(probe)}, {}};
}

}  // namespace reliefbench
