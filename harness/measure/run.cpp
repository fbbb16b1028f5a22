#include "measure/run.hpp"

#include "core/error.hpp"
#include "core/random.hpp"
#include "measure/cell_figures.hpp"
#include "measure/cell_preparation.hpp"
#include "measure/draw_subject.hpp"
#include "measure/pictures.hpp"
#include "measure/rounds.hpp"
#include "measure/shared_inputs.hpp"
#include "measure/stopping_rule.hpp"
#include "measure/time_estimate.hpp"

#include <algorithm>
#include <optional>
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

std::size_t cells_to_measure(const std::vector<Cell>& cells) {
    return static_cast<std::size_t>(
        std::count_if(cells.begin(), cells.end(), [](const Cell& cell) { return cell.skip_reason.empty(); }));
}

/// One execution of run_cells.
class Execution {
public:
    Execution(const gpu::Device& device, const TechniqueLibrary& library, const Configuration& configuration,
              const std::vector<Cell>& cells, RunWriter& writer,
              const std::function<void(const Progress&)>& on_progress, const Clock& clock)
        : device_(device),
          library_(library),
          configuration_(configuration),
          cells_(cells),
          writer_(writer),
          on_progress_(on_progress),
          clock_(clock),
          start_s_(clock.seconds()),
          estimate_(cells_to_measure(cells), configuration.sampling.rounds),
          inputs_(device, configuration.lighting, configuration.truth),
          results_(cells.size()) {}

    RunOutcome run() {
        for (std::size_t index = 0; index < cells_.size(); ++index) {
            if (!cells_[index].skip_reason.empty()) {
                finish_without_timing(index, CellStatus::skipped, cells_[index].skip_reason);
            }
        }
        const std::vector<Block> blocks = make_blocks(cells_);
        for (std::size_t block = 0; block < blocks.size(); ++block) {
            measure_block(blocks[block], mix_bits(configuration_.seed + block));
        }
        split_.total_s = clock_.seconds() - start_s_;
        split_.truth_s = inputs_.truth_seconds();
        return {std::move(results_), split_};
    }

private:
    struct ReadyCell {
        std::size_t index = 0;
        Renderer renderer;
        CellResult result;
    };

    void measure_block(const Block& block, std::uint64_t seed) {
        std::vector<ViewKey> views;
        for (std::size_t index : block.cells) {
            views.push_back(cells_[index].view);
        }
        inputs_.keep_only(views);
        std::vector<ReadyCell> ready;
        ready.reserve(block.cells.size());
        for (std::size_t index : block.cells) {
            const double begin_s = clock_.seconds();
            std::optional<ReadyCell> cell = make_ready(index);
            estimate_.add_preparation(clock_.seconds() - begin_s);
            if (cell) {
                ready.push_back(std::move(*cell));
            } else {
                estimate_.drop_cell(0);
            }
        }
        sample(ready, seed);
    }

    /// Empty when the cell was skipped or failed, which is then recorded.
    std::optional<ReadyCell> make_ready(std::size_t index) {
        const Cell& cell = cells_[index];
        report(cell.id);
        std::string reason;
        std::optional<PreparedCell> prepared;
        try {
            const Technique& technique = library_.get(cell.technique);
            const Resolution map_size = inputs_.map(cell.view).map.heights.size;
            reason = unsupported_reason(device_, technique, cell.view.view, map_size);
            if (reason.empty()) {
                prepared.emplace(prepare_cell(device_, technique, cell, inputs_, configuration_));
            }
        } catch (const Error& error) {
            finish_without_timing(index, CellStatus::failed, error.what());
            return std::nullopt;
        }
        if (!prepared) {
            finish_without_timing(index, CellStatus::skipped, reason);
            return std::nullopt;
        }
        for (const auto& [pass, samples] : prepared->preparation.pass_ms) {
            writer_.append_samples({cell.id, pass, 0, 0, 1, samples});
            split_.samples_s += total_ms(samples) / 1000.0;
        }
        if (configuration_.images) {
            write_pictures(cell, prepared->probe);
        }
        return ReadyCell{index, std::move(prepared->renderer), std::move(prepared->result)};
    }

    void write_pictures(const Cell& cell, const Probe& probe) {
        const Truth& truth = inputs_.truth(cell.view);
        write_raster_file(writer_.image_path(cell.id, ".png"), display_picture(probe.colour));
        write_raster_file(writer_.image_path(cell.id, ".truth.png"), display_picture(truth.colour));
        write_raster_file(writer_.image_path(cell.id, ".error.png"),
                          error_picture(probe.hits, truth, inputs_.map(cell.view).map, cell.view.view.relief));
    }

    void sample(std::vector<ReadyCell>& ready, std::uint64_t seed) {
        const SamplingSettings& sampling = configuration_.sampling;
        std::vector<DrawSubject> draws;
        draws.reserve(ready.size());
        std::vector<Subject*> subjects;
        for (ReadyCell& cell : ready) {
            draws.emplace_back(
                [&renderer = cell.renderer](int samples, int repeats) { return renderer.time_draw(samples, repeats); },
                sampling);
            subjects.push_back(&draws.back());
        }
        std::vector<std::size_t> visits(ready.size(), 0);
        std::optional<double> last_visit_s;
        const auto on_visit = [&](const Visit& visit) {
            const ReadyCell& cell = ready[visit.subject];
            const int repeats = draws[visit.subject].repeats();
            for (const auto& [pass, samples] : visit.samples) {
                writer_.append_samples({cell.result.cell, pass, visit.round, visit.order, repeats, samples});
                split_.samples_s += total_ms(samples) * repeats / 1000.0;
            }
            ++visits[visit.subject];
            // The first one comes after all warming up.
            const double now_s = clock_.seconds();
            if (last_visit_s) {
                estimate_.add_visit(now_s - *last_visit_s);
            } else {
                estimate_.add_untimed_visit();
            }
            last_visit_s = now_s;
            report(cell.result.cell);
        };
        const auto on_failure = [&](std::size_t subject, const std::string& reason) {
            ready[subject].result.status = CellStatus::failed;
            ready[subject].result.reason = reason;
            estimate_.drop_cell(visits[subject]);
        };
        const std::vector<SampleRounds> samples = sample_in_rounds(
            subjects, *make_fixed_rule(sampling.rounds), sampling.samples_per_visit, seed, on_visit, on_failure);
        for (std::size_t subject = 0; subject < ready.size(); ++subject) {
            finish(ready[subject], samples[subject], draws[subject].repeats());
        }
    }

    void finish(ReadyCell& cell, const SampleRounds& samples, int repeats) {
        for (const auto& [pass, rounds] : samples) {
            cell.result.time[pass] = summarize_timing(rounds, repeats);
        }
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
    double start_s_;
    TimeEstimate estimate_;
    SharedInputs inputs_;
    std::vector<CellResult> results_;
    std::size_t cells_done_ = 0;
    TimeSplit split_;
};

}  // namespace

RunOutcome run_cells(const gpu::Device& device, const TechniqueLibrary& library, const Configuration& configuration,
                     const std::vector<Cell>& cells, RunWriter& writer,
                     const std::function<void(const Progress&)>& on_progress, const Clock& clock) {
    return Execution(device, library, configuration, cells, writer, on_progress, clock).run();
}

}  // namespace reliefbench
