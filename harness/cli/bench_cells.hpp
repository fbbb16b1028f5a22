#pragma once

#include "measure/draw_subject.hpp"
#include "measure/laboratory.hpp"
#include "measure/shared_inputs.hpp"
#include "store/cell_result.hpp"
#include "sweep/configuration.hpp"
#include "technique/renderer.hpp"
#include "technique/technique.hpp"

#include <list>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// The cells of a configuration, each prepared when it is first timed and no sooner. At most as many stay prepared as a
/// block has cells, so that memory does not grow with the matrix; what was measured of a cell beside its time is kept.
class BenchCells {
public:
    /// All of them must outlive it.
    BenchCells(const gpu::Device& device, const TechniqueLibrary& library, const Configuration& configuration,
               const std::vector<Cell>& cells);

    /// Everything known of the cell but the draw's time, warmed up where its status is ok.
    const CellResult& prepare(std::size_t index);

    /// One timing in milliseconds per draw, of the cell prepared last; empty when it fails, which its result then
    /// tells.
    std::optional<double> time_draw();

    /// Draws inside one timestamp pair, of the cell prepared last.
    int repeats() const;

    /// Of those prepared so far.
    std::vector<const CellResult*> failed() const;

private:
    struct Ready {
        Ready(std::size_t cell, Renderer made, const SamplingSettings& sampling);
        /// `draw` refers to `renderer`.
        Ready(const Ready&) = delete;
        Ready& operator=(const Ready&) = delete;

        std::size_t index;
        Renderer renderer;
        DrawSubject draw;
    };

    /// Sets the cell's result where it has none yet, and where it ends.
    void make_ready(std::size_t index);
    void warm_up(std::size_t index, Renderer renderer);
    void follow_motion(const Cell& cell, PreparedCell& prepared);
    /// Makes room for the cell, and frees the inputs that no other one needs.
    void make_room_for(std::size_t index);
    void fail_cell(std::size_t index, const std::string& reason);

    const Configuration* configuration_;
    const std::vector<Cell>* cells_;
    SharedInputs inputs_;
    Laboratory laboratory_;
    std::map<std::size_t, CellResult> results_;
    /// The one used last is the first.
    std::list<Ready> ready_;
};

}  // namespace reliefbench
