#include "cli/bench_cells.hpp"

#include "core/attempt.hpp"
#include "core/cache_folder.hpp"
#include "measure/motion.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace reliefbench {

namespace {

/// As many as make_blocks puts into a block.
constexpr std::size_t max_ready = 64;

}  // namespace

BenchCells::Ready::Ready(std::size_t cell, Renderer made, const SamplingSettings& sampling)
    : index(cell),
      renderer(std::move(made)),
      draw([this](int samples, int repeats) { return renderer.time_draw(samples, repeats); }, sampling) {}

BenchCells::BenchCells(const gpu::Device& device, const TechniqueLibrary& library, const Configuration& configuration,
                       const std::vector<Cell>& cells)
    : configuration_(&configuration),
      cells_(&cells),
      inputs_(device, configuration.lighting, configuration.truth, configuration.object, cache_folder()),
      laboratory_(library, configuration, inputs_, {.cache = cache_folder()}) {}

const CellResult& BenchCells::prepare(std::size_t index) {
    const auto known = results_.find(index);
    if (known != results_.end() && known->second.status != CellStatus::ok) return known->second;

    const auto found =
        std::find_if(ready_.begin(), ready_.end(), [&](const Ready& cell) { return cell.index == index; });
    if (found != ready_.end()) {
        ready_.splice(ready_.begin(), ready_, found);
        return known->second;
    }
    make_room_for(index);
    make_ready(index);
    return results_.at(index);
}

std::optional<double> BenchCells::time_draw() {
    assert(!ready_.empty());
    double draw_ms = 0;
    const std::string failure = failure_of([&] { draw_ms = ready_.front().draw.visit(1).at(draw_pass).front(); });
    if (failure.empty()) return draw_ms;
    fail_cell(ready_.front().index, failure);
    return std::nullopt;
}

int BenchCells::repeats() const {
    assert(!ready_.empty());
    return ready_.front().draw.repeats();
}

std::vector<const CellResult*> BenchCells::failed() const {
    std::vector<const CellResult*> cells;
    for (const auto& [index, result] : results_) {
        if (result.status == CellStatus::failed) cells.push_back(&result);
    }
    return cells;
}

void BenchCells::make_ready(std::size_t index) {
    const Cell& cell = (*cells_)[index];
    const bool is_measured = results_.contains(index);
    PreparedCell prepared = is_measured ? laboratory_.make_ready_again(cell) : laboratory_.make_ready(cell);
    prepared.probe.reset();
    if (!is_measured) follow_motion(cell, prepared);
    const bool is_ready = prepared.result.status == CellStatus::ok;
    if (!is_measured || !is_ready) results_[index] = std::move(prepared.result);
    if (is_ready) warm_up(index, std::move(*prepared.renderer));
}

void BenchCells::warm_up(std::size_t index, Renderer renderer) {
    const std::string failure = failure_of([&] {
        ready_.emplace_front(index, std::move(renderer), configuration_->sampling);
        ready_.front().draw.warm_up();
    });
    if (!failure.empty()) fail_cell(index, failure);
}

/// Nothing of it is shown, but what fails in motion fails here as in a run.
void BenchCells::follow_motion(const Cell& cell, PreparedCell& prepared) {
    if (!configuration_->motion || prepared.result.status != CellStatus::ok) return;
    const MotionSubject subject{&*prepared.renderer, &prepared.result};
    measure_motion(inputs_, cell.view, *configuration_, {&subject, 1}, {});
}

void BenchCells::make_room_for(std::size_t index) {
    if (ready_.size() < max_ready) return;
    ready_.pop_back();
    std::vector<ViewKey> views{(*cells_)[index].view};
    for (const Ready& cell : ready_) {
        views.push_back((*cells_)[cell.index].view);
    }
    inputs_.keep_only(views);
}

void BenchCells::fail_cell(std::size_t index, const std::string& reason) {
    results_[index] = ended_result((*cells_)[index], CellStatus::failed, reason);
    ready_.remove_if([&](const Ready& cell) { return cell.index == index; });
}

}  // namespace reliefbench
