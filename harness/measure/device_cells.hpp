#pragma once

#include "measure/cell_source.hpp"
#include "measure/laboratory.hpp"
#include "measure/shared_inputs.hpp"
#include "store/run_folder.hpp"
#include "sweep/configuration.hpp"
#include "technique/technique.hpp"

#include <memory>
#include <vector>

namespace reliefbench {

/// Cells drawn by their techniques on a Vulkan device and compared with their truths. Pictures, where the configuration
/// asks for them, go to the run's folder. All that it is given must outlive it.
class DeviceCells : public CellSource {
public:
    DeviceCells(const gpu::Device& device, const TechniqueLibrary& library, const Configuration& configuration,
                const std::vector<Cell>& cells, RunWriter& writer, MapMaking maps);

    void begin_block(std::span<const std::size_t> cells) override;
    ReadyCell make_ready(std::size_t cell, const std::function<void(const std::string&)>& on_progress) override;
    void finish_view(std::span<ReadyCell> cells, const std::function<bool(const std::string& stage)>& goes_on) override;
    bool is_device_lost() const override;
    gpu::DeviceStateSource& device_state() override { return *device_state_; }
    std::size_t in_flight() const override;
    TruthWork truths() const override { return inputs_.truths(); }

private:
    /// False where the memory is used up.
    bool write_pictures(const Cell& cell, const Probe& probe);

    const gpu::Device& device_;
    const Configuration& configuration_;
    const std::vector<Cell>& cells_;
    RunWriter& writer_;
    std::unique_ptr<gpu::DeviceStateSource> device_state_;
    SharedInputs inputs_;
    Laboratory laboratory_;
};

}  // namespace reliefbench
