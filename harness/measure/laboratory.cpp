#include "measure/laboratory.hpp"

#include "core/attempt.hpp"
#include "gpu/device.hpp"
#include "measure/cell_figures.hpp"
#include "measure/memory_need.hpp"
#include "store/crashes.hpp"
#include "technique/draw_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace reliefbench {

namespace {

/// A preparation that takes long is timed less often, so that a block's length stays in bounds.
constexpr double preparation_budget_ms = 2000;

constexpr double no_limit_s = std::numeric_limits<double>::infinity();

}  // namespace

/// How derived maps are made.
struct Laboratory::MapTiming {
    /// Of each pass, at most.
    int max_samples = 1;
    double limit_s = no_limit_s;
    bool timed = false;
};

Laboratory::Laboratory(const TechniqueLibrary& library, const Configuration& configuration, SharedInputs& inputs,
                       MapMaking maps)
    : library_(library), configuration_(configuration), inputs_(inputs), maps_(std::move(maps)) {}

PreparedCell Laboratory::make_ready(const Cell& cell, const LaboratoryCallbacks& callbacks) {
    return make(cell, callbacks, Wanted::figures);
}

PreparedCell Laboratory::make_picture(const Cell& cell, const LaboratoryCallbacks& callbacks) {
    return make(cell, callbacks, Wanted::picture);
}

PreparedCell Laboratory::make(const Cell& cell, const LaboratoryCallbacks& callbacks, Wanted wanted) {
    const SamplingSettings& sampling = configuration_.sampling;
    const MapTiming timing{.max_samples = std::max(1, sampling.rounds * sampling.samples_per_visit),
                           .limit_s = configuration_.preparation.limit_s,
                           .timed = maps_.timed};
    PreparedCell prepared;
    const std::string failure = failure_of([&] {
        prepare(cell, callbacks, timing, prepared);
        if (prepared.renderer) measure(cell, callbacks, wanted, prepared);
    });
    if (failure.empty()) return prepared;
    return {.result = ended_result(cell, CellStatus::failed, failure)};
}

PreparedCell Laboratory::make_ready_again(const Cell& cell) {
    PreparedCell prepared;
    const std::string failure = failure_of([&] { prepare(cell, {}, {}, prepared); });
    if (failure.empty()) return prepared;
    return {.result = ended_result(cell, CellStatus::failed, failure)};
}

DrawnCell Laboratory::beside_truth(const Cell& cell, const Probe& probe) {
    return {probe,
            inputs_.truth(cell.view),
            inputs_.map(cell.view).map,
            inputs_.view(cell.view).relief,
            shape_kind(manifest_of(cell).shape.kind).draws_base,
            inputs_.noise(cell.view)};
}

/// Compiles and prepares, or skips.
void Laboratory::prepare(const Cell& cell, const LaboratoryCallbacks& callbacks, const MapTiming& timing,
                         PreparedCell& prepared) {
    const auto skip = [&](const std::string& reason) {
        prepared.result = ended_result(cell, CellStatus::skipped, reason);
    };
    if (!cell.skip_reason.empty()) return skip(cell.skip_reason);
    const Technique& technique = library_.get(cell.technique);
    const std::string refused = refusal(technique, cell);
    if (!refused.empty()) return skip(refused);
    const auto begin = [&](const char* stage) {
        if (callbacks.on_stage) callbacks.on_stage(stage);
    };
    if (!inputs_.has_map(cell.view)) begin("loading the height map");
    const LoadedMap& loaded = inputs_.map(cell.view);
    begin("compiling");
    Renderer renderer(inputs_.device(), technique, cell.parameters, loaded.scene, inputs_.view(cell.view),
                      configuration_.lighting, configuration_.object);
    if (!technique.manifest.passes.empty() || cell.view.view.material.has_mips()) begin("making its maps");
    Preparation preparation = maps_.failed.prepare(
        inputs_.device(), renderer, [&](Renderer& with_maps) { return prepare_maps(with_maps, callbacks, timing); },
        maps_.on_maps);
    if (!preparation.given_up.empty()) return skip(preparation.given_up);
    prepared.result = blank_result(cell);
    prepared.renderer.emplace(std::move(renderer));
    prepared.preparation = std::move(preparation);
}

/// The first run compiles in the driver: it counts only when there is no time for another. What takes little is made
/// again though it was kept, for its times.
Preparation Laboratory::prepare_maps(Renderer& renderer, const LaboratoryCallbacks& callbacks,
                                     const MapTiming& timing) {
    PreparationSettings settings{.limit_s = timing.limit_s, .cache = maps_.cache, .on_progress = callbacks.on_progress};
    Preparation first = renderer.prepare(settings);
    const double first_ms = preparation_ms(first);
    const bool takes_little = !first.pass_ms.empty() && first.given_up.empty() && first_ms <= preparation_budget_ms;
    if (!timing.timed || !takes_little) return first;
    const double affordable = first_ms > 0 ? preparation_budget_ms / first_ms : timing.max_samples;
    settings.samples = static_cast<int>(std::clamp(affordable, 1.0, static_cast<double>(timing.max_samples)));
    settings.take_kept = false;
    // It has shown that it stays below the limit: what a busy machine makes of its times does not skip the cell.
    settings.limit_s = no_limit_s;
    return renderer.prepare(settings);
}

/// Why the cell cannot be made on this machine; empty where it can. Nothing but the base is loaded for it.
std::string Laboratory::refusal(const Technique& technique, const Cell& cell) const {
    const gpu::Device& device = inputs_.device();
    const InputSizes sizes = input_sizes(cell.view.height_map);
    const View view = inputs_.view(cell.view);
    const std::string unsupported = unsupported_reason(device, technique, cell.parameters, view, sizes.height_map);
    if (!unsupported.empty()) return unsupported;
    MemoryNeed need = cell_need(technique, cell, view.relief.base, sizes, configuration_);
    if (!inputs_.has_map(cell.view)) need = with_inputs(need, sizes, cell.view.height_format);
    return lacking_memory(device, "the cell", need);
}

/// Draws the cell once, judges what it drew, and adds its figures.
void Laboratory::measure(const Cell& cell, const LaboratoryCallbacks& callbacks, Wanted wanted,
                         PreparedCell& prepared) {
    if (callbacks.on_stage) callbacks.on_stage("drawing it once, counted");
    prepared.probe = prepared.renderer->probe();
    CellResult& result = prepared.result;
    const DrawVerdict verdict = judge_draw(inputs_.device(), manifest_of(cell), cell.parameters, *prepared.probe);
    result.reason = verdict.reason;
    if (!verdict.reason.empty()) result.status = CellStatus::failed;
    if (verdict.is_meaningless) {
        prepared.preparation = {};
        return;
    }
    if (wanted == Wanted::picture) return;
    for (const auto& [pass, samples] : prepared.preparation.pass_ms) {
        // Each run is a submission of its own.
        std::vector<std::vector<double>> runs;
        for (const double sample : samples) {
            runs.push_back({sample});
        }
        result.time[pass] = summarize_timing(runs, 1);
    }
    result.prepare_ms = preparation_ms(prepared.preparation);
    result.prepare_bytes = prepared.preparation.bytes;
    result.pipeline = prepared.renderer->pipeline_statistics();
    result.executable = prepared.renderer->executable_statistics();
    compare(cell, callbacks, prepared);
}

/// Work and errors.
void Laboratory::compare(const Cell& cell, const LaboratoryCallbacks& callbacks, PreparedCell& prepared) {
    const auto begin = [&](const std::string& stage) {
        if (callbacks.on_stage) callbacks.on_stage(stage);
    };
    const View& view = cell.view.view;
    const Probe& probe = *prepared.probe;
    CellResult& result = prepared.result;
    const bool self_shadow = view.self_shadow.mode != SelfShadow::Mode::off;
    if (const auto work = summarize_work(probe, self_shadow)) result.figures.add(figures_of(*work));
    const int samples = configuration_.truth.samples;
    if (!inputs_.has_truth(cell.view)) {
        begin(samples == 1 ? "tracing the truth" : fmt::format("tracing the truth, {} samples a pixel", samples));
    }
    inputs_.truth(cell.view);
    begin("comparing with the truth");
    result.figures.add(errors_of(beside_truth(cell, probe), configuration_.lighting, self_shadow));
    prepared.is_compared = true;
}

CellResult blank_result(const Cell& cell) {
    CellResult result;
    result.cell = cell.id;
    result.technique = cell.technique;
    result.preset = cell.preset;
    result.axes = axes_to_json(cell.view);
    result.parameters = parameters_to_json(cell.parameters);
    return result;
}

CellResult ended_result(const Cell& cell, CellStatus status, const std::string& reason) {
    assert(status != CellStatus::ok);
    CellResult result = blank_result(cell);
    result.status = status;
    result.reason = reason;
    return result;
}

std::string describe_ending(const CellResult& result) {
    assert(result.status != CellStatus::ok);
    return fmt::format("{}: {}", result.status == CellStatus::skipped ? "skipped" : "failed", result.reason);
}

FailedPreparations crashed_preparations(const std::map<std::string, std::vector<std::string>>& crashed) {
    FailedPreparations failed;
    for (const auto& [maps, reasons] : crashed) {
        if (reasons.size() >= max_crashes) failed.add(maps, {false, crashed_preparation_reason(reasons)});
    }
    return failed;
}

std::string describe(const PreparationProgress& progress) {
    std::string text = fmt::format("preparing ({}) {:.0f} %", progress.pass, 100 * progress.fraction);
    if (progress.remaining_s >= 0) text += fmt::format(", {:.0f} s left", progress.remaining_s);
    return text;
}

}  // namespace reliefbench
