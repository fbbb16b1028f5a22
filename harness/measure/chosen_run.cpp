#include "measure/chosen_run.hpp"

#include "core/random.hpp"
#include "measure/cell_figures.hpp"
#include "measure/laboratory.hpp"
#include "measure/run_log.hpp"
#include "measure/stopping_rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace reliefbench {

namespace {

/// Warmed up by its first round alone.
class WarmSubject : public Subject {
public:
    explicit WarmSubject(std::unique_ptr<Subject> subject) : subject_(std::move(subject)) {}

    void warm_up() override {
        if (!std::exchange(is_warm_, true)) subject_->warm_up();
    }
    Samples visit(int count) override { return subject_->visit(count); }
    void submit(int count) override { subject_->submit(count); }
    Samples collect() override { return subject_->collect(); }
    int repeats() const override { return subject_->repeats(); }

private:
    std::unique_ptr<Subject> subject_;
    bool is_warm_ = false;
};

class ChosenExecution {
public:
    ChosenExecution(CellSource& source, const Configuration& configuration, const std::vector<Cell>& cells,
                    RunWriter& writer, CellChooser& chooser, const std::function<void(const Progress&)>& on_progress,
                    const Clock& clock, const ChosenOptions& options)
        : source_(source),
          configuration_(configuration),
          cells_(cells),
          chooser_(chooser),
          on_progress_(on_progress),
          clock_(clock),
          options_(options),
          start_s_(clock.seconds()),
          log_(source, writer, clock, options.earlier.forced),
          rule_(make_stopping_rule(configuration.sampling)),
          is_recorded_(cells.size()) {
        for (std::size_t index = 0; index < cells.size(); ++index)
            index_of_.emplace(cells[index].id, index);
    }

    ChosenOutcome run() {
        take_earlier();
        std::vector<std::size_t> all;
        for (std::size_t index = 0; index < cells_.size(); ++index) {
            if (cells_[index].skip_reason.empty()) {
                all.push_back(index);
            } else if (!is_recorded_[index]) {
                end(index, ended_result(cells_[index], CellStatus::skipped, cells_[index].skip_reason));
            }
        }
        source_.begin_block(all);
        bool is_done = false;
        while (!is_done && !must_end()) {
            std::vector<std::size_t> wanted = chooser_.next_round();
            std::erase_if(wanted, [this](std::size_t index) { return static_cast<bool>(is_recorded_[index]); });
            // The others come with the next round.
            if (wanted.size() > options_.max_ready) wanted.resize(options_.max_ready);
            is_done = wanted.empty();
            if (!is_done) measure_round(wanted);
        }
        tell_cell({});
        if (!interrupted()) finish_all(!is_done);
        log_.split().total_s = clock_.seconds() - start_s_;
        log_.split().truths = source_.truths();
        ChosenOutcome outcome;
        outcome.tally = log_.tally();
        outcome.ended_early = interrupted();
        outcome.device_lost = device_lost_;
        outcome.split = log_.split();
        outcome.is_time_over = !is_done && !interrupted();
        return outcome;
    }

private:
    /// What is measured of a cell that is not recorded yet.
    struct Measured {
        CellResult result;
        SampledSubject sampled;
        double device_s = 0;
        int repeats = 1;
        std::size_t last_round = 0;
    };
    struct Ready {
        ReadyCell cell;
        std::unique_ptr<WarmSubject> subject;
    };

    bool interrupted() const { return device_lost_ || (options_.is_interrupted && options_.is_interrupted()); }
    bool must_end() const { return interrupted() || clock_.seconds() >= options_.deadline_s; }
    void tell_cell(const std::string& cell) const {
        if (options_.on_cell) options_.on_cell(cell);
    }

    void take_earlier() {
        for (const CellResult& result : options_.finished) {
            const auto found = index_of_.find(result.cell);
            if (found == index_of_.end()) continue;
            is_recorded_[found->second] = true;
            ++recorded_;
            chooser_.add_result(found->second, result);
            const auto draw = result.time.find(draw_pass);
            if (draw != result.time.end()) chooser_.add_times(found->second, draw->second, true);
        }
        for (const CellResult& result : options_.cut_off) {
            if (const auto found = index_of_.find(result.cell); found != index_of_.end())
                go_on_with(found->second, result);
        }
        for (const auto& [cell, visits] : options_.earlier.visits)
            round_ = std::max(round_, static_cast<std::size_t>(visits.back().round) + 1);
    }

    /// The chooser knows it as it was left; it is made ready when it is wanted once more.
    void go_on_with(std::size_t index, const CellResult& result) {
        Measured measured{.result = result};
        take_earlier_samples(measured);
        const auto draw = result.time.find(draw_pass);
        if (draw == result.time.end() || measured.sampled.samples.empty()) return;
        measured.repeats = draw->second.repeats;
        measured.sampled.throttled_rounds = result.throttled_rounds;
        measured.sampled.stop = rule_->stop(measured.sampled.samples, measured.device_s);
        chooser_.add_result(index, result);
        chooser_.add_times(index, draw->second, measured.sampled.stop.has_value());
        measured_.emplace(index, std::move(measured));
    }

    void take_earlier_samples(Measured& measured) const {
        const auto earlier = options_.earlier.visits.find(measured.result.cell);
        if (earlier == options_.earlier.visits.end()) return;
        EarlierSamples samples = earlier_samples(earlier->second);
        measured.sampled.samples = std::move(samples.samples);
        measured.device_s = samples.device_s;
    }

    void measure_round(const std::vector<std::size_t>& wanted) {
        make_room_for(wanted);
        for (auto begin = wanted.begin(); begin != wanted.end() && !must_end();) {
            const ViewKey& view = cells_[*begin].view;
            const auto end =
                std::find_if_not(begin, wanted.end(), [&](std::size_t index) { return cells_[index].view == view; });
            make_view_ready({begin, end});
            begin = end;
        }
        std::vector<std::size_t> visited;
        for (const std::size_t index : wanted) {
            if (ready_.contains(index)) visited.push_back(index);
        }
        if (!visited.empty() && !must_end()) visit(visited);
        ++round_;
    }

    void make_view_ready(const std::vector<std::size_t>& wanted) {
        std::vector<ReadyCell> made;
        for (const std::size_t index : wanted) {
            if (must_end()) break;
            if (ready_.contains(index)) continue;
            const Cell& cell = cells_[index];
            report("drawing", cell.id);
            if (const std::string reason = crashed_reason(options_.earlier, cell.id); !reason.empty()) {
                end(index, ended_result(cell, CellStatus::failed, reason));
                continue;
            }
            tell_cell(cell.id);
            ReadyCell ready =
                source_.make_ready(index, [&](const std::string& detail) { report("drawing, " + detail, cell.id); });
            log_.keep_preparation(ready);
            log_.count_preparation(ready);
            made.push_back(std::move(ready));
            device_lost_ = made.back().result.status == CellStatus::failed && source_.is_device_lost();
        }
        std::vector<ReadyCell> of_view;
        for (ReadyCell& cell : made) {
            if (cell.result.status == CellStatus::ok) {
                of_view.push_back(std::move(cell));
            } else {
                end(cell.index, std::move(cell.result));
            }
        }
        source_.finish_view(of_view, [this](const std::string& stage) {
            report(stage, {});
            return !interrupted();
        });
        for (ReadyCell& cell : of_view)
            keep_ready(std::move(cell));
    }

    void keep_ready(ReadyCell cell) {
        const std::size_t index = cell.index;
        if (cell.result.status != CellStatus::ok) return end(index, std::move(cell.result));
        auto [known, is_new] = measured_.try_emplace(index);
        if (is_new) {
            known->second.result = cell.result;
            take_earlier_samples(known->second);
            chooser_.add_result(index, cell.result);
        }
        known->second.last_round = round_;
        auto subject = std::make_unique<WarmSubject>(std::move(cell.subject));
        ready_.emplace(index, Ready{std::move(cell), std::move(subject)});
    }

    /// One round of the cells that are ready; a throttled visit is repeated in a round more.
    void visit(const std::vector<std::size_t>& visited) {
        std::vector<Subject*> subjects;
        for (const std::size_t index : visited)
            subjects.push_back(ready_.at(index).subject.get());
        const auto ready_of = [&](std::size_t subject) -> Ready& { return ready_.at(visited[subject]); };
        const double before_s = clock_.seconds();
        RoundCallbacks callbacks;
        callbacks.on_visit = [&](const Visit& visit) {
            const Ready& ready = ready_of(visit.subject);
            log_.keep_visit(ready.cell.result.cell, ready.subject->repeats(), visit);
            report("sampling", ready.cell.result.cell);
        };
        callbacks.on_failure = [&](std::size_t subject, const std::string& reason) {
            if (device_lost_) return;
            CellResult& result = ready_of(subject).cell.result;
            result.status = CellStatus::failed;
            result.reason = reason;
            device_lost_ = source_.is_device_lost();
        };
        callbacks.on_turn = [&](std::size_t subject) { tell_cell(ready_of(subject).cell.result.cell); };
        callbacks.on_warm = [this] { log_.begin_round(); };
        callbacks.on_round = [this](int round) { log_.end_round(0, round); };
        callbacks.is_throttled = [this] { return log_.is_throttled(); };
        callbacks.is_interrupted = [this] { return must_end(); };
        std::vector<SampledSubject> sampled =
            sample_in_rounds(subjects, *make_fixed_rule(1),
                             {.samples_per_visit = configuration_.sampling.samples_per_visit,
                              .seed = mix_bits(configuration_.seed + round_),
                              .in_flight = source_.in_flight(),
                              .first_round = static_cast<int>(round_)},
                             callbacks);
        log_.split().timing_s += clock_.seconds() - before_s;
        for (std::size_t subject = 0; subject < visited.size(); ++subject)
            take_samples(visited[subject], std::move(sampled[subject]));
    }

    void take_samples(std::size_t index, SampledSubject sampled) {
        Ready& ready = ready_.at(index);
        Measured& measured = measured_.at(index);
        if (ready.cell.result.status == CellStatus::failed) return end(index, std::move(ready.cell.result));
        measured.last_round = round_;
        measured.repeats = ready.subject->repeats();
        measured.sampled.throttled_rounds += sampled.throttled_rounds;
        for (auto& [pass, rounds] : sampled.samples) {
            for (std::vector<double>& samples : rounds) {
                for (const double ms : samples)
                    measured.device_s += ms * measured.repeats / 1000.0;
                measured.sampled.samples[pass].push_back(std::move(samples));
            }
        }
        const auto draw = measured.sampled.samples.find(draw_pass);
        if (draw == measured.sampled.samples.end()) return;
        measured.sampled.stop = rule_->stop(measured.sampled.samples, measured.device_s);
        chooser_.add_times(index, summarize_timing(draw->second, measured.repeats), measured.sampled.stop.has_value());
    }

    /// What was visited least lately goes.
    void make_room_for(const std::vector<std::size_t>& wanted) {
        std::vector<std::size_t> idle;
        for (const auto& [index, ready] : ready_) {
            if (std::ranges::find(wanted, index) == wanted.end()) idle.push_back(index);
        }
        std::ranges::sort(idle, {}, [this](std::size_t index) { return measured_.at(index).last_round; });
        for (const std::size_t index : idle) {
            if (ready_.size() + count_not_ready(wanted) <= options_.max_ready) break;
            ready_.erase(index);
        }
    }

    std::size_t count_not_ready(const std::vector<std::size_t>& wanted) const {
        return static_cast<std::size_t>(
            std::ranges::count_if(wanted, [this](std::size_t index) { return !ready_.contains(index); }));
    }

    void finish(std::size_t index) {
        auto node = measured_.extract(index);
        Measured& measured = node.mapped();
        ReadyCell cell{.index = index, .result = std::move(measured.result)};
        log_.finish(cell, std::move(measured.sampled), measured.repeats);
        leave(index);
    }

    /// Skipped or failed.
    void end(std::size_t index, CellResult result) {
        // It would have failed for that alone.
        if (device_lost_ && result.status != CellStatus::failed) return;
        chooser_.add_result(index, result);
        log_.record(std::move(result));
        measured_.erase(index);
        leave(index);
    }

    void leave(std::size_t index) {
        ready_.erase(index);
        is_recorded_[index] = true;
        ++recorded_;
    }

    void finish_all(bool is_time_over) {
        for (std::size_t index = 0; index < cells_.size(); ++index) {
            if (is_recorded_[index]) continue;
            const auto found = measured_.find(index);
            if (found != measured_.end() && found->second.sampled.samples.contains(draw_pass)) {
                std::optional<StopReason>& stop = found->second.sampled.stop;
                if (!stop) stop = is_time_over ? StopReason::time : StopReason::narrowed;
                finish(index);
            } else if (std::string reason = chooser_.reason_left_out(index); !is_time_over && !reason.empty()) {
                log_.record(ended_result(cells_[index], CellStatus::skipped, reason));
                leave(index);
            }
        }
    }

    void report(const std::string& stage, const std::string& current) {
        if (!on_progress_) return;
        Progress progress;
        progress.cells_done = recorded_ + measured_.size();
        progress.cells_total = cells_.size();
        progress.stage = fmt::format("{}, {}", chooser_.standing(), stage);
        progress.current = current;
        progress.elapsed_s = clock_.seconds() - start_s_;
        on_progress_(progress);
    }

    CellSource& source_;
    const Configuration& configuration_;
    const std::vector<Cell>& cells_;
    CellChooser& chooser_;
    const std::function<void(const Progress&)>& on_progress_;
    const Clock& clock_;
    const ChosenOptions& options_;
    double start_s_;
    RunLog log_;
    std::unique_ptr<StoppingRule> rule_;
    std::map<std::string, std::size_t> index_of_;
    std::vector<char> is_recorded_;
    std::size_t recorded_ = 0;
    std::map<std::size_t, Measured> measured_;
    std::map<std::size_t, Ready> ready_;
    std::size_t round_ = 0;
    bool device_lost_ = false;
};

}  // namespace

ChosenOutcome run_chosen_cells(CellSource& source, const Configuration& configuration, const std::vector<Cell>& cells,
                               RunWriter& writer, CellChooser& chooser,
                               const std::function<void(const Progress&)>& on_progress, const Clock& clock,
                               const ChosenOptions& options) {
    return ChosenExecution(source, configuration, cells, writer, chooser, on_progress, clock, options).run();
}

}  // namespace reliefbench
