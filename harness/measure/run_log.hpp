#pragma once

#include "measure/cell_source.hpp"
#include "measure/clock.hpp"
#include "measure/recent_state.hpp"
#include "measure/rounds.hpp"
#include "store/resume.hpp"
#include "store/run_folder.hpp"
#include "store/run_tally.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace reliefbench {

/// Where the wall time went, for the line at the end of a run.
struct TimeSplit {
    double total_s = 0;
    /// Inside GPU timestamps of counted samples: those that are part of a cell's figures and were taken in this
    /// execution. Preparations that were given up, that failed or that an earlier execution made are none.
    double samples_s = 0;
    TruthWork truths = {};
    /// From the first visit of a block to its last, of all blocks, and what of it lay inside GPU timestamps of counted
    /// samples.
    double timing_s = 0;
    double timing_samples_s = 0;
};

/// What a run writes to its folder while cells are made ready, visited and finished, with the sums that its summary
/// tells. All that it is given must outlive it.
class RunLog {
public:
    RunLog(CellSource& source, RunWriter& writer, const Clock& clock, bool forced_resume);

    /// The preparation's times, as soon as a cell has been made ready.
    void keep_preparation(const ReadyCell& cell);
    /// Of a cell that will be sampled: what a failed one took to prepare counts nowhere.
    void count_preparation(const ReadyCell& cell);

    bool is_throttled() { return recent_state_.is_throttled(); }
    void begin_round();
    void keep_visit(const std::string& cell, int repeats, const Visit& visit);
    void end_round(std::size_t block, int round);

    /// With what was sampled; without samples as it is.
    void finish(ReadyCell& cell, SampledSubject sampled, int repeats);
    void record(CellResult result);

    const RunTally& tally() const { return tally_; }
    TimeSplit& split() { return split_; }

private:
    RunWriter& writer_;
    const Clock& clock_;
    RecentState recent_state_;
    bool forced_resume_;
    RunTally tally_;
    TimeSplit split_;
    double round_start_s_ = 0;
    bool round_throttled_ = false;
};

/// Why a cell is failed that too many workers died on; empty where it may be tried.
std::string crashed_reason(const EarlierWork& earlier, const std::string& cell);

/// The rounds that an interrupted execution has of a cell.
EarlierSamples earlier_samples(const std::vector<RawSamples>& visits);

}  // namespace reliefbench
