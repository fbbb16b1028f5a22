#pragma once

#include "gpu/device_state.hpp"
#include "measure/subject.hpp"
#include "measure/truth_cache.hpp"
#include "store/cell_result.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace reliefbench {

/// A cell with everything known of it but the draw's time; or one that is skipped or failed, by its result's status,
/// and has no subject.
struct ReadyCell {
    std::size_t index = 0;
    CellResult result;
    std::unique_ptr<Subject> subject = {};
    /// Milliseconds of each run of the preparation's passes, kept for samples.jsonl.
    std::map<std::string, std::vector<double>> preparation_ms = {};
    /// They are of an earlier execution, whose maps were kept: no time of this one.
    bool preparation_kept = false;
};

/// Where a run gets cells that can be sampled: techniques on a device (measure/device_cells.hpp), or a fake in tests of
/// the runner. Cells are named by their index in the run.
class CellSource {
public:
    virtual ~CellSource() = default;

    /// Frees what none of these needs.
    virtual void begin_block(std::span<const std::size_t> cells) = 0;
    /// Cells of one view follow each other. `on_progress` is told what a long preparation is at.
    virtual ReadyCell make_ready(std::size_t cell, const std::function<void(const std::string&)>& on_progress) = 0;
    /// What all cells of a view, made ready, are measured for together; may make them failed. `goes_on` is told the
    /// stage and says whether to go on.
    virtual void finish_view(std::span<ReadyCell> cells,
                             const std::function<bool(const std::string& stage)>& goes_on) = 0;

    /// Asked after a failure: nothing more can be measured with this source.
    virtual bool is_device_lost() const = 0;
    virtual gpu::DeviceStateSource& device_state() = 0;
    /// Visits that the device may have at once: two keep it busy; on a CPU device the host's work would take processors
    /// away from the samples.
    virtual std::size_t in_flight() const = 0;
    /// Of all truths so far.
    virtual TruthWork truths() const = 0;
};

}  // namespace reliefbench
