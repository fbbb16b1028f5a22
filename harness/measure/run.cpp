#include "measure/run.hpp"

#include "core/random.hpp"
#include "measure/draw_subject.hpp"
#include "measure/laboratory.hpp"
#include "measure/rounds.hpp"
#include "measure/stopping_rule.hpp"
#include "measure/time_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace reliefbench {

namespace {

std::size_t cells_to_measure(const std::vector<Cell>& cells, const EarlierWork& earlier) {
    return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [&](const Cell& cell) {
        return cell.skip_reason.empty() && !earlier.finished.contains(cell.id);
    }));
}

/// Of what the rule asks for; time says nothing about rounds.
int min_rounds(const SamplingSettings& sampling) {
    return sampling.rule == SamplingSettings::Rule::time ? 1 : sampling.rounds;
}

/// One execution of run_cells.
class Execution {
public:
    Execution(CellSource& source, const Configuration& configuration, const std::vector<Cell>& cells, RunWriter& writer,
              const std::function<void(const Progress&)>& on_progress, const Clock& clock,
              const MeasureOptions& options)
        : source_(source),
          configuration_(configuration),
          cells_(cells),
          on_progress_(on_progress),
          clock_(clock),
          options_(options),
          start_s_(clock.seconds()),
          log_(source, writer, clock, options.earlier.forced),
          rule_(make_stopping_rule(configuration.sampling)),
          estimate_(cells_to_measure(cells, options.earlier), min_rounds(configuration.sampling)),
          cells_done_(static_cast<std::size_t>(
              std::ranges::count_if(cells, [this](const Cell& cell) { return is_finished(cell); }))) {}

    RunOutcome run() {
        for (const Cell& cell : cells_) {
            if (!cell.skip_reason.empty() && !is_finished(cell))
                record(ended_result(cell, CellStatus::skipped, cell.skip_reason));
        }
        const std::vector<Block> blocks = make_blocks(cells_);
        for (std::size_t block = 0; block < blocks.size() && !interrupted(); ++block) {
            const std::vector<std::size_t> unfinished = without_finished(blocks[block].cells);
            if (blocks.size() > 1) of_block_ = fmt::format(", block {} of {}", block + 1, blocks.size());
            if (!unfinished.empty()) measure_block(unfinished, block, mix_bits(configuration_.seed + block));
        }
        tell_cell({});
        log_.split().total_s = clock_.seconds() - start_s_;
        log_.split().truths = source_.truths();
        return {log_.tally(), cells_done_ < cells_.size(), device_lost_, log_.split()};
    }

private:
    bool interrupted() const { return device_lost_ || (options_.is_interrupted && options_.is_interrupted()); }

    bool is_finished(const Cell& cell) const { return options_.earlier.finished.contains(cell.id); }

    std::vector<std::size_t> without_finished(std::vector<std::size_t> cells) const {
        std::erase_if(cells, [this](std::size_t index) { return is_finished(cells_[index]); });
        return cells;
    }

    void tell_cell(const std::string& cell) const {
        if (options_.on_cell) options_.on_cell(cell);
    }

    void measure_block(const std::vector<std::size_t>& cells, std::size_t number, std::uint64_t seed) {
        source_.begin_block(cells);
        cells_of_block_ = cells.size();
        prepared_ = 0;
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
        for (const std::size_t index : indices) {
            if (interrupted()) return;
            const double begin_s = clock_.seconds();
            ReadyCell cell = make_ready(index);
            estimate_.add_preparation(clock_.seconds() - begin_s);
            keep_ready(std::move(cell), of_view);
        }
        const double begin_s = clock_.seconds();
        source_.finish_view(of_view, [this](const std::string& stage) {
            report(stage);
            return !interrupted();
        });
        estimate_.extend_preparation(clock_.seconds() - begin_s);
        if (interrupted()) return;
        for (ReadyCell& cell : of_view) {
            log_.count_preparation(cell);
            keep_ready(std::move(cell), ready);
        }
    }

    ReadyCell make_ready(std::size_t index) {
        const Cell& cell = cells_[index];
        stage_ = fmt::format("preparing {} of {}{}", ++prepared_, cells_of_block_, of_block_);
        report(cell.id);
        if (const std::string reason = crashed_reason(options_.earlier, cell.id); !reason.empty())
            return {.index = index, .result = ended_result(cell, CellStatus::failed, reason)};
        tell_cell(cell.id);
        ReadyCell ready = source_.make_ready(index, [&](const std::string& detail) { report(cell.id, detail); });
        log_.keep_preparation(ready);
        return ready;
    }

    /// One that cannot be sampled is recorded. None is after the one that lost the device: it would fail for that
    /// alone.
    void keep_ready(ReadyCell cell, std::vector<ReadyCell>& kept) {
        if (cell.result.status == CellStatus::ok) {
            kept.push_back(std::move(cell));
            return;
        }
        estimate_.drop_cell(0);
        if (device_lost_) return;
        note_failure(cell.result);
        record(std::move(cell.result));
    }

    void note_failure(const CellResult& result) {
        if (result.status == CellStatus::failed) device_lost_ = source_.is_device_lost();
    }

    /// One block's rounds.
    struct Sampling {
        std::size_t block = 0;
        std::vector<ReadyCell>& ready;
        /// By subject.
        std::vector<std::size_t> visits = {};
        double first_visit_s = 0;
        double last_visit_s = 0;
    };

    void sample(std::vector<ReadyCell>& ready, std::size_t block, std::uint64_t seed) {
        Sampling sampling{.block = block, .ready = ready};
        std::vector<Subject*> subjects;
        for (ReadyCell& cell : ready) {
            subjects.push_back(cell.subject.get());
        }
        sampling.visits.resize(ready.size());
        RoundSampling rounds{.samples_per_visit = configuration_.sampling.samples_per_visit,
                             .seed = seed,
                             .in_flight = source_.in_flight()};
        go_on_from_earlier(ready, rounds);
        warmed_ = 0;
        std::vector<SampledSubject> sampled = sample_in_rounds(subjects, *rule_, rounds, callbacks(sampling));
        log_.split().timing_s += sampling.last_visit_s - sampling.first_visit_s;
        for (std::size_t subject = 0; subject < ready.size(); ++subject) {
            const bool done = sampled[subject].stop || ready[subject].result.status == CellStatus::failed;
            if (done) finish(ready[subject], std::move(sampled[subject]), ready[subject].subject->repeats());
        }
    }

    void go_on_from_earlier(const std::vector<ReadyCell>& ready, RoundSampling& rounds) const {
        for (const ReadyCell& cell : ready) {
            const auto found = options_.earlier.visits.find(cell.result.cell);
            rounds.earlier.push_back(found == options_.earlier.visits.end() ? EarlierSamples{}
                                                                            : earlier_samples(found->second));
            if (found != options_.earlier.visits.end())
                rounds.first_round = std::max(rounds.first_round, found->second.back().round + 1);
        }
        // Rounds that go on are not in the order of those at the start.
        if (rounds.first_round > 0)
            rounds.seed = mix_bits(rounds.seed + static_cast<std::uint64_t>(rounds.first_round));
    }

    RoundCallbacks callbacks(Sampling& sampling) {
        RoundCallbacks callbacks;
        callbacks.on_warm = [this, &sampling] {
            warmed_.reset();
            stage_ = "sampling" + of_block_;
            sampling.first_visit_s = sampling.last_visit_s = clock_.seconds();
            log_.begin_round();
        };
        callbacks.on_visit = [this, &sampling](const Visit& visit) { keep(visit, sampling); };
        callbacks.on_failure = [this, &sampling](std::size_t subject, const std::string& reason) {
            estimate_.drop_cell(sampling.visits[subject]);
            if (device_lost_) return;  // which another cell did
            sampling.ready[subject].result.status = CellStatus::failed;
            sampling.ready[subject].result.reason = reason;
            note_failure(sampling.ready[subject].result);
        };
        callbacks.on_turn = [this, &sampling](std::size_t subject) {
            const std::string& cell = sampling.ready[subject].result.cell;
            tell_cell(cell);
            if (!warmed_) return;
            stage_ = fmt::format("warming up {} of {}{}", ++*warmed_, sampling.ready.size(), of_block_);
            report(cell);
        };
        callbacks.on_stop = [this, &sampling](std::size_t subject, StopReason) {
            estimate_.finish_cell(sampling.visits[subject]);
        };
        callbacks.is_interrupted = [this] { return interrupted(); };
        callbacks.is_throttled = [this] { return log_.is_throttled(); };
        callbacks.on_round = [this, &sampling](int round) { log_.end_round(sampling.block, round); };
        return callbacks;
    }

    void keep(const Visit& visit, Sampling& sampling) {
        const ReadyCell& cell = sampling.ready[visit.subject];
        log_.keep_visit(cell.result.cell, cell.subject->repeats(), visit);
        ++sampling.visits[visit.subject];
        const double now_s = clock_.seconds();
        estimate_.add_visit(now_s - sampling.last_visit_s);
        sampling.last_visit_s = now_s;
        report(cell.result.cell);
    }

    void finish(ReadyCell& cell, SampledSubject sampled, int repeats) {
        const std::string id = cell.result.cell;
        log_.finish(cell, std::move(sampled), repeats);
        ++cells_done_;
        report(id);
    }

    void record(CellResult result) {
        const std::string id = result.cell;
        log_.record(std::move(result));
        ++cells_done_;
        report(id);
    }

    void report(const std::string& current, const std::string& detail = {}) {
        if (!on_progress_) {
            return;
        }
        Progress progress;
        progress.cells_done = cells_done_;
        progress.cells_total = cells_.size();
        progress.stage = detail.empty() ? stage_ : stage_ + ", " + detail;
        progress.current = current;
        progress.elapsed_s = clock_.seconds() - start_s_;
        progress.remaining_s = estimate_.remaining_seconds();
        progress.share = share_done_.of(progress.elapsed_s, progress.remaining_s);
        on_progress_(progress);
    }

    CellSource& source_;
    const Configuration& configuration_;
    const std::vector<Cell>& cells_;
    const std::function<void(const Progress&)>& on_progress_;
    const Clock& clock_;
    const MeasureOptions& options_;
    double start_s_;
    RunLog log_;
    std::unique_ptr<StoppingRule> rule_;
    TimeEstimate estimate_;
    ShareDone share_done_;
    /// Earlier ones, too.
    std::size_t cells_done_;
    bool device_lost_ = false;
    /// What progress tells: of the block at hand, which is named where there are several.
    std::string stage_;
    std::string of_block_;
    std::size_t cells_of_block_ = 0;
    std::size_t prepared_ = 0;
    /// While subjects are warmed up, how many have been.
    std::optional<std::size_t> warmed_;
};

}  // namespace

RunOutcome run_cells(CellSource& source, const Configuration& configuration, const std::vector<Cell>& cells,
                     RunWriter& writer, const std::function<void(const Progress&)>& on_progress, const Clock& clock,
                     const MeasureOptions& options) {
    return Execution(source, configuration, cells, writer, on_progress, clock, options).run();
}

}  // namespace reliefbench
