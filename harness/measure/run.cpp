#include "measure/run.hpp"

#include "core/error.hpp"
#include "core/random.hpp"
#include "gpu/device.hpp"
#include "gpu/device_state.hpp"
#include "measure/cell_figures.hpp"
#include "measure/cell_preparation.hpp"
#include "measure/draw_subject.hpp"
#include "measure/motion.hpp"
#include "measure/recent_state.hpp"
#include "measure/rounds.hpp"
#include "measure/run_pictures.hpp"
#include "measure/shared_inputs.hpp"
#include "measure/stopping_rule.hpp"
#include "measure/time_estimate.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace reliefbench {

namespace {

double total_ms(const std::vector<double>& samples) {
    double sum = 0;
    for (double sample : samples) {
        sum += sample;
    }
    return sum;
}

std::size_t cells_to_measure(const std::vector<Cell>& cells, const EarlierWork& earlier) {
    return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [&](const Cell& cell) {
        return cell.skip_reason.empty() && !earlier.finished.contains(cell.id);
    }));
}

/// The rounds that an interrupted execution has of a cell.
EarlierSamples earlier_samples(const std::vector<RawSamples>& visits) {
    EarlierSamples earlier;
    for (const RawSamples& visit : visits) {
        earlier.samples[visit.pass].push_back(visit.ms);
        earlier.device_s += total_ms(visit.ms) * visit.repeats / 1000.0;
    }
    return earlier;
}

/// Of what the rule asks for; time says nothing about rounds.
int least_rounds(const SamplingSettings& sampling) {
    return sampling.rule == SamplingSettings::Rule::time ? 1 : sampling.rounds;
}

/// One execution of run_cells.
class Execution {
public:
    Execution(const gpu::Device& device, const TechniqueLibrary& library, const Configuration& configuration,
              const std::vector<Cell>& cells, RunWriter& writer,
              const std::function<void(const Progress&)>& on_progress, const Clock& clock,
              const MeasureOptions& options)
        : device_(device),
          library_(library),
          configuration_(configuration),
          cells_(cells),
          writer_(writer),
          on_progress_(on_progress),
          clock_(clock),
          earlier_(options.earlier),
          is_interrupted_(options.is_interrupted),
          start_s_(clock.seconds()),
          map_cache_(options.map_cache),
          in_flight_(options.in_flight.value_or(device.info().type == gpu::DeviceType::cpu ? 1 : 2)),
          device_state_(gpu::open_device_state(device)),
          recent_state_(*device_state_, clock),
          rule_(make_stopping_rule(configuration.sampling)),
          estimate_(cells_to_measure(cells, options.earlier), least_rounds(configuration.sampling)),
          inputs_(device, configuration.lighting, configuration.truth, configuration.object),
          results_(cells.size()) {}

    RunOutcome run() {
        for (std::size_t index = 0; index < cells_.size(); ++index) {
            if (const auto finished = earlier_.finished.find(cells_[index].id); finished != earlier_.finished.end()) {
                results_[index] = finished->second;
                ++cells_done_;
            } else if (!cells_[index].skip_reason.empty()) {
                finish_without_timing(index, CellStatus::skipped, cells_[index].skip_reason);
            }
        }
        if (configuration_.images) write_legends(writer_);
        const std::vector<Block> blocks = make_blocks(cells_);
        for (std::size_t block = 0; block < blocks.size() && !interrupted(); ++block) {
            const std::vector<std::size_t> unfinished = without_finished(blocks[block].cells);
            if (!unfinished.empty()) measure_block(unfinished, block, mix_bits(configuration_.seed + block));
        }
        split_.total_s = clock_.seconds() - start_s_;
        split_.truth_s = inputs_.truth_seconds();
        const bool ended_early = cells_done_ < cells_.size();
        if (ended_early) {
            std::erase_if(results_, [](const CellResult& result) { return result.cell.empty(); });
        }
        return {std::move(results_), ended_early, split_};
    }

private:
    struct ReadyCell {
        std::size_t index = 0;
        Renderer renderer;
        CellResult result;
    };

    bool interrupted() const { return is_interrupted_ && is_interrupted_(); }

    std::vector<std::size_t> without_finished(std::vector<std::size_t> cells) const {
        std::erase_if(cells, [this](std::size_t index) { return earlier_.finished.contains(cells_[index].id); });
        return cells;
    }

    void measure_block(const std::vector<std::size_t>& cells, std::size_t number, std::uint64_t seed) {
        std::vector<ViewKey> views;
        for (std::size_t index : cells) {
            views.push_back(cells_[index].view);
        }
        inputs_.keep_only(views);
        std::vector<ReadyCell> ready;
        ready.reserve(cells.size());
        for (std::span<const std::size_t> left = cells; !left.empty();) {
            const ViewKey& view = cells_[left.front()].view;
            const auto end = std::find_if_not(left.begin(), left.end(),
                                              [&](std::size_t index) { return cells_[index].view == view; });
            const auto of_view = static_cast<std::size_t>(end - left.begin());
            make_view_ready(left.first(of_view), ready);
            left = left.subspan(of_view);
        }
        if (interrupted()) return;
        sample(ready, number, seed);
    }

    /// Appends the cells, all of one view, that can be sampled.
    void make_view_ready(std::span<const std::size_t> indices, std::vector<ReadyCell>& ready) {
        std::vector<ReadyCell> of_view;
        of_view.reserve(indices.size());
        for (std::size_t index : indices) {
            if (interrupted()) return;
            const double begin_s = clock_.seconds();
            std::optional<ReadyCell> cell = make_ready(index);
            estimate_.add_preparation(clock_.seconds() - begin_s);
            if (cell) {
                of_view.push_back(std::move(*cell));
            } else {
                estimate_.drop_cell(0);
            }
        }
        if (configuration_.motion && !of_view.empty()) follow_motion(of_view);
        if (interrupted()) return;
        for (ReadyCell& cell : of_view) {
            if (cell.result.status == CellStatus::ok) {
                ready.push_back(std::move(cell));
            } else {
                estimate_.drop_cell(0);
                record(cell.index, std::move(cell.result));
            }
        }
    }

    void follow_motion(std::vector<ReadyCell>& of_view) {
        const double begin_s = clock_.seconds();
        std::vector<MotionSubject> subjects;
        for (ReadyCell& cell : of_view) {
            subjects.push_back({&cell.renderer, &cell.result});
        }
        measure_motion(inputs_, cells_[of_view.front().index].view, configuration_, subjects,
                       [this](const std::string& cell) {
                           report(cell + ", in motion");
                           return !interrupted();
                       });
        estimate_.extend_preparation(clock_.seconds() - begin_s);
    }

    /// Empty when the cell was skipped or failed, which is then recorded.
    std::optional<ReadyCell> make_ready(std::size_t index) {
        const Cell& cell = cells_[index];
        report(cell.id);
        const LongPreparation long_preparation{
            map_cache_, [&](const PreparationProgress& progress) { report(cell.id + ": " + describe(progress)); }};
        std::optional<PreparedCell> prepared;
        try {
            PreparedOrSkipped outcome =
                prepare_cell(device_, library_.get(cell.technique), cell, inputs_, configuration_, long_preparation);
            if (!outcome.cell) {
                finish_without_timing(index, CellStatus::skipped, outcome.skip_reason);
                return std::nullopt;
            }
            prepared.emplace(std::move(*outcome.cell));
        } catch (const Error& error) {
            finish_without_timing(index, CellStatus::failed, error.what());
            return std::nullopt;
        }
        for (const auto& [pass, samples] : prepared->preparation.pass_ms) {
            writer_.append_samples({cell.id, pass, 0, 0, 1, samples});
            split_.samples_s += total_ms(samples) / 1000.0;
        }
        if (configuration_.images) {
            const DrawnCell drawn{prepared->probe, inputs_.truth(cell.view), inputs_.map(cell.view).map,
                                  cell.view.view.relief};
            write_cell_pictures(writer_, cell.id, drawn);
        }
        return ReadyCell{index, std::move(prepared->renderer), std::move(prepared->result)};
    }

    /// One block's rounds.
    struct Sampling {
        std::size_t block = 0;
        std::vector<ReadyCell>& ready;
        std::vector<DrawSubject> draws = {};
        /// By subject.
        std::vector<std::size_t> visits = {};
        double first_visit_s = 0;
        double last_visit_s = 0;
        double round_start_s = 0;
        bool round_throttled = false;
    };

    void sample(std::vector<ReadyCell>& ready, std::size_t block, std::uint64_t seed) {
        Sampling sampling{.block = block, .ready = ready};
        sampling.draws.reserve(ready.size());
        std::vector<Subject*> subjects;
        for (ReadyCell& cell : ready) {
            sampling.draws.emplace_back(timer_of(cell.renderer), configuration_.sampling);
            subjects.push_back(&sampling.draws.back());
        }
        sampling.visits.resize(ready.size());
        RoundSampling rounds{
            .samples_per_visit = configuration_.sampling.samples_per_visit, .seed = seed, .in_flight = in_flight_};
        go_on_from_earlier(ready, rounds);
        std::vector<SampledSubject> sampled = sample_in_rounds(subjects, *rule_, rounds, callbacks(sampling));
        split_.timing_s += sampling.last_visit_s - sampling.first_visit_s;
        for (std::size_t subject = 0; subject < ready.size(); ++subject) {
            const bool done = sampled[subject].stop || ready[subject].result.status == CellStatus::failed;
            if (done) finish(ready[subject], std::move(sampled[subject]), sampling.draws[subject].repeats());
        }
    }

    void go_on_from_earlier(const std::vector<ReadyCell>& ready, RoundSampling& rounds) const {
        for (const ReadyCell& cell : ready) {
            const auto found = earlier_.visits.find(cell.result.cell);
            rounds.earlier.push_back(found == earlier_.visits.end() ? EarlierSamples{}
                                                                    : earlier_samples(found->second));
            if (found != earlier_.visits.end())
                rounds.first_round = std::max(rounds.first_round, found->second.back().round + 1);
        }
        // Rounds that go on are not in the order of those at the start.
        if (rounds.first_round > 0)
            rounds.seed = mix_bits(rounds.seed + static_cast<std::uint64_t>(rounds.first_round));
    }

    RoundCallbacks callbacks(Sampling& sampling) {
        RoundCallbacks callbacks;
        callbacks.on_warm = [this, &sampling] {
            sampling.first_visit_s = sampling.last_visit_s = sampling.round_start_s = clock_.seconds();
        };
        callbacks.on_visit = [this, &sampling](const Visit& visit) { keep(visit, sampling); };
        callbacks.on_failure = [this, &sampling](std::size_t subject, const std::string& reason) {
            sampling.ready[subject].result.status = CellStatus::failed;
            sampling.ready[subject].result.reason = reason;
            estimate_.drop_cell(sampling.visits[subject]);
        };
        callbacks.on_stop = [this, &sampling](std::size_t subject, StopReason) {
            estimate_.finish_cell(sampling.visits[subject]);
        };
        callbacks.is_interrupted = [this] { return interrupted(); };
        callbacks.is_throttled = [this] { return recent_state_.is_throttled(); };
        callbacks.on_round = [this, &sampling](int round) { keep_round(round, sampling); };
        return callbacks;
    }

    void keep(const Visit& visit, Sampling& sampling) {
        const ReadyCell& cell = sampling.ready[visit.subject];
        const int repeats = sampling.draws[visit.subject].repeats();
        for (const auto& [pass, samples] : visit.samples) {
            writer_.append_samples(
                {cell.result.cell, pass, visit.round, visit.order, repeats, samples, !visit.counted});
            if (visit.counted) {
                const double inside_s = total_ms(samples) * repeats / 1000.0;
                split_.samples_s += inside_s;
                split_.timing_samples_s += inside_s;
            }
        }
        ++sampling.visits[visit.subject];
        sampling.round_throttled = sampling.round_throttled || visit.throttled;
        const double now_s = clock_.seconds();
        estimate_.add_visit(now_s - sampling.last_visit_s);
        sampling.last_visit_s = now_s;
        report(cell.result.cell);
    }

    void keep_round(int round, Sampling& sampling) {
        const gpu::DeviceState& state = recent_state_.read();
        RoundRecord record{.block = sampling.block, .round = round};
        const double now_s = clock_.seconds();
        record.seconds = now_s - sampling.round_start_s;
        record.clock_mhz = state.clock_mhz;
        record.memory_clock_mhz = state.memory_clock_mhz;
        record.temperature_c = state.temperature_c;
        if (state.throttled) record.throttled = sampling.round_throttled;
        writer_.append_round(record);
        sampling.round_start_s = now_s;
        sampling.round_throttled = false;
    }

    void finish(ReadyCell& cell, SampledSubject sampled, int repeats) {
        for (const auto& [pass, rounds] : sampled.samples) {
            cell.result.time[pass] = summarize_timing(rounds, repeats);
        }
        cell.result.stop = sampled.stop;
        cell.result.throttled_rounds = sampled.throttled_rounds;
        const auto draw = cell.result.time.find(draw_pass);
        if (draw != cell.result.time.end() && cell.result.work) {
            cell.result.ns_per_pixel =
                draw->second.median_ms * 1e6 / static_cast<double>(cell.result.work->covered_pixels);
        }
        record(cell.index, std::move(cell.result));
    }

    void finish_without_timing(std::size_t index, CellStatus status, const std::string& reason) {
        CellResult result = blank_result(cells_[index]);
        result.status = status;
        result.reason = reason;
        record(index, std::move(result));
    }

    void record(std::size_t index, CellResult result) {
        result.forced_resume = earlier_.forced;
        writer_.append_cell(result);
        results_[index] = std::move(result);
        ++cells_done_;
        report(results_[index].cell);
    }

    void report(const std::string& current) const {
        if (!on_progress_) {
            return;
        }
        Progress progress;
        progress.cells_done = cells_done_;
        progress.cells_total = cells_.size();
        progress.current = current;
        progress.elapsed_s = clock_.seconds() - start_s_;
        progress.remaining_s = estimate_.remaining_seconds();
        on_progress_(progress);
    }

    const gpu::Device& device_;
    const TechniqueLibrary& library_;
    const Configuration& configuration_;
    const std::vector<Cell>& cells_;
    RunWriter& writer_;
    const std::function<void(const Progress&)>& on_progress_;
    const Clock& clock_;
    const EarlierWork& earlier_;
    const std::function<bool()>& is_interrupted_;
    double start_s_;
    std::filesystem::path map_cache_;
    std::size_t in_flight_;
    std::unique_ptr<gpu::DeviceStateSource> device_state_;
    RecentState recent_state_;
    std::unique_ptr<StoppingRule> rule_;
    TimeEstimate estimate_;
    SharedInputs inputs_;
    std::vector<CellResult> results_;
    std::size_t cells_done_ = 0;
    TimeSplit split_;
};

}  // namespace

RunOutcome run_cells(const gpu::Device& device, const TechniqueLibrary& library, const Configuration& configuration,
                     const std::vector<Cell>& cells, RunWriter& writer,
                     const std::function<void(const Progress&)>& on_progress, const Clock& clock,
                     const MeasureOptions& options) {
    return Execution(device, library, configuration, cells, writer, on_progress, clock, options).run();
}

}  // namespace reliefbench
