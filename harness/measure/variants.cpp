#include "measure/variants.hpp"

#include "core/random.hpp"
#include "measure/draw_subject.hpp"
#include "measure/laboratory.hpp"
#include "measure/motion.hpp"
#include "measure/shared_inputs.hpp"
#include "measure/time_estimate.hpp"
#include "technique/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace reliefbench {

namespace {

constexpr const char* base_side = "baseline";
constexpr const char* changed_side = "new side";

std::string with_side(const std::string& side, const std::string& reason) {
    return side + ": " + reason;
}

const Technique* find_technique(const TechniqueLibrary& library, const std::string& id) {
    const auto found = std::find_if(library.techniques.begin(), library.techniques.end(),
                                    [&](const Technique& technique) { return technique.manifest.id == id; });
    return found == library.techniques.end() ? nullptr : &*found;
}

/// The draw of one side. Both sides of a pair share `repeats`, the draws inside one timestamp pair.
class VariantSubject : public Subject {
public:
    VariantSubject(Renderer& renderer, const SamplingSettings& sampling, int& repeats)
        : renderer_(renderer), sampling_(sampling), repeats_(repeats) {}

    void warm_up() override {
        DrawSubject draw([this](int samples, int repeats) { return renderer_.time_draw(samples, repeats); }, sampling_);
        draw.warm_up();
        repeats_ = std::max(repeats_, draw.repeats());
    }

    std::map<std::string, std::vector<double>> visit(int count) override {
        return {{draw_pass, renderer_.time_draw(count, repeats_)}};
    }

private:
    Renderer& renderer_;
    const SamplingSettings& sampling_;
    int& repeats_;
};

/// One execution of measure_variants.
class VariantExecution {
public:
    VariantExecution(const gpu::Device& device, const Variants& variants, const Configuration& configuration,
                     const std::vector<Cell>& cells, const VariantSettings& settings, const VariantCallbacks& callbacks,
                     const Clock& clock)
        : variants_(variants),
          configuration_(configuration),
          cells_(cells),
          settings_(settings),
          callbacks_(callbacks),
          clock_(clock),
          start_s_(clock.seconds()),
          inputs_(device, configuration.lighting, configuration.truth, configuration.object, settings.cache),
          base_(variants.base, configuration_, inputs_, {.cache = settings.cache}),
          changed_(variants.changed, configuration_, inputs_, {.cache = settings.cache}) {
        configuration_.sampling.minimum_pass_ms = settings.minimum_pass_ms;
        // Of preparation passes, whose times are not compared.
        configuration_.sampling.rounds = 1;
        configuration_.sampling.samples_per_visit = 1;
    }

    VariantOutcome run() {
        std::vector<Cell> comparable;
        for (const Cell& cell : cells_) {
            const std::string reason = cell.skip_reason.empty()
                                           ? missing_in_baseline(cell, variants_.base, variants_.changed)
                                           : describe_ending(ended_result(cell, CellStatus::skipped, cell.skip_reason));
            if (reason.empty()) {
                comparable.push_back(cell);
            } else {
                outcome_.unmeasured.push_back({cell.id, reason});
                ++cells_done_;
            }
        }
        std::size_t cells_left = comparable.size();
        const std::vector<Block> blocks = make_blocks(comparable);
        for (std::size_t block = 0; block < blocks.size(); ++block) {
            const double share = static_cast<double>(blocks[block].cells.size()) / static_cast<double>(cells_left);
            measure_block(comparable, blocks[block], share * (settings_.budget_s - outcome_.sampling_s),
                          mix_bits(settings_.seed + block));
            cells_left -= blocks[block].cells.size();
        }
        return std::move(outcome_);
    }

private:
    /// A cell with both sides ready to be sampled.
    struct ReadyPair {
        const ViewKey* view = nullptr;
        PreparedCell base;
        PreparedCell changed;
    };

    void measure_block(const std::vector<Cell>& comparable, const Block& block, double budget_s, std::uint64_t seed) {
        std::vector<ViewKey> views;
        for (const std::size_t index : block.cells) {
            views.push_back(comparable[index].view);
        }
        inputs_.keep_only(views);
        std::vector<ReadyPair> ready;
        ready.reserve(block.cells.size());
        std::size_t prepared = 0;
        for (const std::size_t index : block.cells) {
            stage_ = fmt::format("preparing {} of {}", ++prepared, block.cells.size());
            if (auto pair = make_ready(comparable[index])) {
                ready.push_back(std::move(*pair));
            } else {
                ++cells_done_;
            }
        }
        if (configuration_.motion) ready = follow_motion(std::move(ready));
        sample(ready, budget_s, seed);
    }

    /// Both sides of a view's pairs against the same truths. Leaves out the pairs of which a side fails, which is
    /// recorded.
    std::vector<ReadyPair> follow_motion(std::vector<ReadyPair> pairs) {
        for (std::size_t begin = 0; begin < pairs.size();) {
            const ViewKey& view = *pairs[begin].view;
            std::vector<MotionSubject> subjects;
            for (; begin < pairs.size() && *pairs[begin].view == view; ++begin) {
                subjects.push_back({&*pairs[begin].base.renderer, &pairs[begin].base.result});
                subjects.push_back({&*pairs[begin].changed.renderer, &pairs[begin].changed.result});
            }
            measure_motion(inputs_, view, configuration_, subjects, [this](const std::string& cell) {
                report(cell + ", in motion");
                return true;
            });
        }
        std::vector<ReadyPair> kept;
        kept.reserve(pairs.size());
        for (ReadyPair& pair : pairs) {
            if (is_measurable(pair.base, pair.changed)) {
                kept.push_back(std::move(pair));
            } else {
                ++cells_done_;
            }
        }
        return kept;
    }

    /// Empty when it cannot be measured, which is then recorded.
    std::optional<ReadyPair> make_ready(const Cell& cell) {
        const Technique& base = *find_technique(variants_.base, cell.technique);
        PreparedCell prepared_base = prepare(base_, baseline_cell(cell, base.manifest), base_side);
        if (!is_measurable(prepared_base)) return std::nullopt;
        PreparedCell prepared_changed = prepare(changed_, cell, changed_side);
        if (!is_measurable(prepared_base, prepared_changed)) return std::nullopt;
        return ReadyPair{&cell.view, std::move(prepared_base), std::move(prepared_changed)};
    }

    PreparedCell prepare(Laboratory& laboratory, const Cell& cell, const char* side) {
        const auto tell = [&](const std::string& what) { report(cell.id, fmt::format("{} ({})", what, side)); };
        PreparedCell prepared = laboratory.make_ready(
            cell,
            {.on_stage = tell, .on_progress = [&](const PreparationProgress& progress) { tell(describe(progress)); }});
        prepared.probe.reset();
        return prepared;
    }

    /// What cannot be measured of the baseline is recorded.
    bool is_measurable(const PreparedCell& base) {
        if (base.result.status == CellStatus::ok) return true;
        outcome_.unmeasured.push_back({base.result.cell, with_side(base_side, describe_ending(base.result))});
        return false;
    }

    /// The same of both sides.
    bool is_measurable(const PreparedCell& base, const PreparedCell& changed) {
        if (!is_measurable(base)) return false;
        if (changed.result.status == CellStatus::ok) return true;
        outcome_.unmeasured.push_back({changed.result.cell, with_side(changed_side, describe_ending(changed.result)),
                                       changed.result.status == CellStatus::failed});
        return false;
    }

    void sample(std::vector<ReadyPair>& ready, double budget_s, std::uint64_t seed) {
        std::vector<std::unique_ptr<VariantSubject>> subjects;
        std::vector<SubjectPair> pairs;
        std::vector<int> repeats(ready.size(), 1);
        for (std::size_t pair = 0; pair < ready.size(); ++pair) {
            const auto add = [&](PreparedCell& side) {
                subjects.push_back(
                    std::make_unique<VariantSubject>(*side.renderer, configuration_.sampling, repeats[pair]));
                return subjects.back().get();
            };
            Subject* const base = add(ready[pair].base);
            pairs.push_back({base, add(ready[pair].changed)});
        }
        stage_ = "sampling";
        report(fmt::format("{} left", ready.size()));
        std::vector<std::string> failures(ready.size());
        const double begin_s = clock_.seconds();
        const PairCallbacks callbacks{
            .is_decided = [&](std::size_t, const LogRatios& log_ratios) { return callbacks_.is_decided(log_ratios); },
            .on_failure = [&](std::size_t pair, const std::string& reason) { failures[pair] = reason; },
            .on_round =
                [&](std::size_t undecided) {
                    report(fmt::format("{} left", undecided), {}, ready.size() - undecided,
                           begin_s + settings_.budget_s - outcome_.sampling_s - clock_.seconds());
                },
            .on_visit =
                [&](const PairVisit& visit) {
                    if (!callbacks_.on_visit) return;
                    callbacks_.on_visit({ready[visit.pair].changed.result.cell, repeats[visit.pair], visit});
                }};
        std::vector<LogRatios> log_ratios =
            sample_pairs(pairs, {settings_.samples_per_visit, budget_s, seed}, callbacks, clock_);
        outcome_.sampling_s += clock_.seconds() - begin_s;
        for (std::size_t pair = 0; pair < ready.size(); ++pair) {
            ++cells_done_;
            if (failures[pair].empty()) {
                outcome_.measured.push_back({std::move(ready[pair].base.result), std::move(ready[pair].changed.result),
                                             std::move(log_ratios[pair])});
            } else {
                outcome_.unmeasured.push_back({ready[pair].changed.result.cell, "failed: " + failures[pair], true});
            }
        }
    }

    void report(const std::string& current, const std::string& detail = {}, std::size_t decided = 0,
                double remaining_s = -1) {
        if (!callbacks_.on_progress) return;
        Progress progress;
        progress.cells_done = cells_done_ + decided;
        progress.cells_total = cells_.size();
        progress.stage = detail.empty() ? stage_ : stage_ + ", " + detail;
        progress.current = current;
        progress.elapsed_s = clock_.seconds() - start_s_;
        progress.remaining_s = remaining_s;
        progress.share = share_done_.of(progress.elapsed_s, remaining_s);
        callbacks_.on_progress(progress);
    }

    const Variants& variants_;
    Configuration configuration_;
    const std::vector<Cell>& cells_;
    const VariantSettings& settings_;
    const VariantCallbacks& callbacks_;
    const Clock& clock_;
    double start_s_;
    SharedInputs inputs_;
    /// One for each side: what one side's manifest makes fail the other's may have mended.
    Laboratory base_;
    Laboratory changed_;
    VariantOutcome outcome_;
    std::size_t cells_done_ = 0;
    /// What progress tells.
    ShareDone share_done_;
    std::string stage_;
};

}  // namespace

std::string missing_in_baseline(const Cell& cell, const TechniqueLibrary& base, const TechniqueLibrary& changed) {
    const Technique* const technique = find_technique(base, cell.technique);
    if (technique == nullptr) {
        for (const auto& [id, message] : base.broken) {
            if (id == cell.technique) return "the baseline's technique cannot be used: " + message;
        }
        return "the baseline has no such technique";
    }
    const Manifest& manifest = technique->manifest;
    for (const auto& [name, value] : cell.parameters) {
        const Parameter* const parameter = manifest.find_parameter(name);
        const std::string value_text = to_string(value);
        if (parameter == nullptr) {
            const Parameter* const own = changed.get(cell.technique).manifest.find_parameter(name);
            if (own == nullptr || own->default_value != value) {
                return fmt::format("the baseline's technique has no parameter {}, which is {} here", name, value_text);
            }
            continue;
        }
        const std::string problem = check_parameter_value(*parameter, value);
        if (!problem.empty()) return fmt::format("the baseline does not take {}={}: {}", name, value_text, problem);
    }
    // Without the preset's name, which says nothing that the values do not.
    const std::string id = cell_id(manifest, baseline_cell(cell, manifest).parameters, cell.view);
    if (id != cell_id(changed.get(cell.technique).manifest, cell.parameters, cell.view))
        return fmt::format("a default has changed: in the baseline this cell is '{}'", id);
    return {};
}

Cell baseline_cell(const Cell& cell, const Manifest& base) {
    Cell result = cell;
    result.parameters = base.defaults();
    for (auto& [name, value] : result.parameters) {
        const auto set = cell.parameters.find(name);
        if (set != cell.parameters.end()) value = set->second;
    }
    return result;
}

VariantOutcome measure_variants(const gpu::Device& device, const Variants& variants, const Configuration& configuration,
                                const std::vector<Cell>& cells, const VariantSettings& settings,
                                const VariantCallbacks& callbacks, const Clock& clock) {
    return VariantExecution(device, variants, configuration, cells, settings, callbacks, clock).run();
}

}  // namespace reliefbench
