#include "measure/run_log.hpp"

#include "measure/cell_figures.hpp"
#include "store/chosen_figures.hpp"
#include "store/crashes.hpp"

#include <numeric>
#include <optional>
#include <utility>

namespace reliefbench {

namespace {

double total_ms(const std::vector<double>& samples) {
    return std::accumulate(samples.begin(), samples.end(), 0.0);
}

}  // namespace

RunLog::RunLog(CellSource& source, RunWriter& writer, const Clock& clock, bool forced_resume)
    : writer_(writer), clock_(clock), recent_state_(source.device_state(), clock), forced_resume_(forced_resume) {}

void RunLog::keep_preparation(const ReadyCell& cell) {
    for (const auto& [pass, samples] : cell.preparation_ms)
        writer_.append_samples({cell.result.cell, pass, 0, 0, 1, samples});
}

void RunLog::count_preparation(const ReadyCell& cell) {
    if (cell.result.status != CellStatus::ok || cell.preparation_kept) return;
    for (const auto& [pass, samples] : cell.preparation_ms)
        split_.samples_s += total_ms(samples) / 1000.0;
}

void RunLog::begin_round() {
    round_start_s_ = clock_.seconds();
    round_throttled_ = false;
}

void RunLog::keep_visit(const std::string& cell, int repeats, const Visit& visit) {
    for (const auto& [pass, samples] : visit.samples) {
        writer_.append_samples({cell, pass, visit.round, visit.order, repeats, samples, !visit.counted});
        if (!visit.counted) continue;
        const double inside_s = total_ms(samples) * repeats / 1000.0;
        split_.samples_s += inside_s;
        split_.timing_samples_s += inside_s;
    }
    round_throttled_ = round_throttled_ || visit.throttled;
}

void RunLog::end_round(std::size_t block, int round) {
    const gpu::DeviceState& state = recent_state_.read();
    RoundRecord record{.block = block, .round = round};
    record.seconds = clock_.seconds() - round_start_s_;
    record.clock_mhz = state.clock_mhz;
    record.memory_clock_mhz = state.memory_clock_mhz;
    record.temperature_c = state.temperature_c;
    if (state.throttled) record.throttled = round_throttled_;
    writer_.append_round(record);
    begin_round();
}

void RunLog::finish(ReadyCell& cell, SampledSubject sampled, int repeats) {
    for (const auto& [pass, rounds] : sampled.samples)
        cell.result.time[pass] = summarize_timing(rounds, repeats);
    cell.result.stop = sampled.stop;
    cell.result.throttled_rounds = sampled.throttled_rounds;
    const auto draw = cell.result.time.find(draw_pass);
    const std::optional<double> pixels = value_of(chosen_figures::covered_pixels, cell.result);
    if (draw != cell.result.time.end() && pixels) cell.result.ns_per_pixel = draw->second.median_ms * 1e6 / *pixels;
    record(std::move(cell.result));
}

void RunLog::record(CellResult result) {
    result.forced_resume = forced_resume_;
    writer_.append_cell(result);
    tally_.add(result);
}

std::string crashed_reason(const EarlierWork& earlier, const std::string& cell) {
    const auto crashes = earlier.crashes.find(cell);
    if (crashes == earlier.crashes.end() || crashes->second.size() < max_crashes) return "";
    return crashed_cell_reason(crashes->second);
}

EarlierSamples earlier_samples(const std::vector<RawSamples>& visits) {
    EarlierSamples earlier;
    for (const RawSamples& visit : visits) {
        earlier.samples[visit.pass].push_back(visit.ms);
        earlier.device_s += total_ms(visit.ms) * visit.repeats / 1000.0;
    }
    return earlier;
}

}  // namespace reliefbench
