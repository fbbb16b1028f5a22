#include "cli/bench_cells.hpp"

#include "core/error.hpp"
#include "measure/cell_preparation.hpp"
#include "technique/map_cache.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace reliefbench {

namespace {

/// As many as make_blocks puts into a block.
constexpr std::size_t most_ready = 64;

}  // namespace

BenchCells::Ready::Ready(std::size_t cell, Renderer made, const SamplingSettings& sampling)
    : index(cell),
      renderer(std::move(made)),
      draw([this](int samples, int repeats) { return renderer.time_draw(samples, repeats); }, sampling) {}

BenchCells::BenchCells(const gpu::Device& device, const TechniqueLibrary& library, const Configuration& configuration,
                       const std::vector<Cell>& cells)
    : device_(&device),
      library_(&library),
      configuration_(&configuration),
      cells_(&cells),
      inputs_(device, configuration.lighting, configuration.truth, configuration.object) {}

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
    try {
        std::optional<Renderer> renderer = known == results_.end() ? make_renderer(index) : open_again(index);
        if (renderer) {
            ready_.emplace_front(index, std::move(*renderer), configuration_->sampling);
            ready_.front().draw.warm_up();
        }
    } catch (const Error& error) {
        fail_cell(index, error.what());
    }
    return results_.at(index);
}

std::optional<double> BenchCells::time_draw() {
    assert(!ready_.empty());
    try {
        return ready_.front().draw.visit(1).at(draw_pass).front();
    } catch (const Error& error) {
        fail_cell(ready_.front().index, error.what());
        return std::nullopt;
    }
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

std::optional<Renderer> BenchCells::make_renderer(std::size_t index) {
    const Cell& cell = (*cells_)[index];
    PreparedOrSkipped prepared =
        cell.skip_reason.empty() ? prepare_cell(*device_, library_->get(cell.technique), cell, inputs_, *configuration_,
                                                {.map_cache = map_cache_folder(), .failed = failed_preparations_})
                                 : PreparedOrSkipped{std::nullopt, cell.skip_reason};
    if (!prepared.cell) {
        CellResult& result = results_[index] = blank_result(cell);
        result.status = CellStatus::skipped;
        result.reason = prepared.skip_reason;
        return std::nullopt;
    }
    results_[index] = std::move(prepared.cell->result);
    return std::move(prepared.cell->renderer);
}

Renderer BenchCells::open_again(std::size_t index) {
    const Cell& cell = (*cells_)[index];
    Renderer renderer(*device_, library_->get(cell.technique), cell.parameters, inputs_.map(cell.view).scene,
                      cell.view.view, configuration_->lighting, configuration_->object);
    renderer.prepare({.cache = map_cache_folder()});
    return renderer;
}

void BenchCells::make_room_for(std::size_t index) {
    if (ready_.size() < most_ready) return;
    ready_.pop_back();
    std::vector<ViewKey> views{(*cells_)[index].view};
    for (const Ready& cell : ready_) {
        views.push_back((*cells_)[cell.index].view);
    }
    inputs_.keep_only(views);
}

void BenchCells::fail_cell(std::size_t index, const std::string& reason) {
    CellResult& result = results_[index] = blank_result((*cells_)[index]);
    result.status = CellStatus::failed;
    result.reason = reason;
    ready_.remove_if([&](const Ready& cell) { return cell.index == index; });
}

}  // namespace reliefbench
