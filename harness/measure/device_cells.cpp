#include "measure/device_cells.hpp"

#include "core/attempt.hpp"
#include "gpu/device.hpp"
#include "measure/draw_subject.hpp"
#include "measure/motion.hpp"
#include "measure/run_pictures.hpp"

#include <utility>

namespace reliefbench {

namespace {

/// What samples a cell, and what it draws with.
class DeviceSubject : public Subject {
public:
    DeviceSubject(Renderer renderer, const SamplingSettings& sampling)
        : renderer_(std::move(renderer)), draw_(timer_of(renderer_), sampling) {}

    void warm_up() override { draw_.warm_up(); }
    Samples visit(int count) override { return draw_.visit(count); }
    void submit(int count) override { draw_.submit(count); }
    Samples collect() override { return draw_.collect(); }
    int repeats() const override { return draw_.repeats(); }
    Renderer& renderer() { return renderer_; }

private:
    Renderer renderer_;
    DrawSubject draw_;
};

}  // namespace

DeviceCells::DeviceCells(const gpu::Device& device, const TechniqueLibrary& library, const Configuration& configuration,
                         const std::vector<Cell>& cells, RunWriter& writer, MapMaking maps)
    : device_(device),
      configuration_(configuration),
      cells_(cells),
      writer_(writer),
      device_state_(gpu::open_device_state(device)),
      inputs_(device, configuration.lighting, configuration.truth, configuration.object, maps.cache),
      laboratory_(library, configuration, inputs_, std::move(maps)) {}

void DeviceCells::begin_block(std::span<const std::size_t> cells) {
    std::vector<ViewKey> views;
    for (const std::size_t index : cells)
        views.push_back(cells_[index].view);
    inputs_.keep_only(views);
}

ReadyCell DeviceCells::make_ready(std::size_t index, const std::function<void(const std::string&)>& on_progress) {
    const Cell& cell = cells_[index];
    PreparedCell prepared = laboratory_.make_ready(
        cell, {.on_stage = on_progress,
               .on_progress = [&](const PreparationProgress& progress) { on_progress(describe(progress)); }});
    if (configuration_.images && prepared.is_compared && !write_pictures(cell, *prepared.probe)) {
        prepared.result = ended_result(cell, CellStatus::failed, memory_used_up);
    }
    ReadyCell ready{.index = index,
                    .result = std::move(prepared.result),
                    .preparation_ms = std::move(prepared.preparation.pass_ms),
                    .preparation_kept = prepared.preparation.kept};
    if (ready.result.status == CellStatus::ok)
        ready.subject = std::make_unique<DeviceSubject>(std::move(*prepared.renderer), configuration_.sampling);
    return ready;
}

bool DeviceCells::write_pictures(const Cell& cell, const Probe& probe) {
    return fits_in_memory([&] { write_cell_pictures(writer_, cell.id, laboratory_.beside_truth(cell, probe)); });
}

void DeviceCells::finish_view(std::span<ReadyCell> cells,
                              const std::function<bool(const std::string& stage)>& goes_on) {
    if (!configuration_.motion || cells.empty()) return;
    std::vector<MotionSubject> subjects;
    for (ReadyCell& cell : cells)
        subjects.push_back({&static_cast<DeviceSubject&>(*cell.subject).renderer(), &cell.result});
    measure_motion(inputs_, cells_[cells.front().index].view, configuration_, subjects,
                   [&goes_on](const std::string& cell) { return goes_on(cell + ", in motion"); });
}

bool DeviceCells::is_device_lost() const {
    return device_.is_lost();
}

std::size_t DeviceCells::in_flight() const {
    return device_.info().type == gpu::DeviceType::cpu ? 1 : 2;
}

}  // namespace reliefbench
