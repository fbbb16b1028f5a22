#pragma once

#include "core/error.hpp"
#include "measure/cell_source.hpp"
#include "measure/laboratory.hpp"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace reliefbench {

class NothingKnown : public gpu::DeviceStateSource {
public:
    gpu::DeviceState read() override { return {}; }
};

/// A device without a device: every cell is ready at once and takes a millisecond a draw, but for those named.
class FakeCells : public CellSource {
public:
    explicit FakeCells(const std::vector<Cell>& cells) : cells_(&cells) {}

    void begin_block(std::span<const std::size_t> /*cells*/) override {}

    ReadyCell make_ready(std::size_t index, const std::function<void(const std::string&)>& on_progress) override {
        const std::string& id = (*cells_)[index].id;
        made.push_back(id);
        on_progress("compiling");
        ReadyCell ready{.index = index, .result = blank_result((*cells_)[index])};
        if (losing_at_once.contains(id)) {
            lost = true;
            ready.result.status = CellStatus::failed;
            ready.result.reason = "lost";
            return ready;
        }
        if (preparations.contains(id)) ready.preparation_ms = {{"maps", {preparations.at(id)}}};
        ready.preparation_kept = kept.contains(id);
        if (failing.contains(id)) {
            ready.result.status = CellStatus::failed;
            ready.result.reason = "unconverged";
            return ready;
        }
        ready.subject = std::make_unique<Draw>(*this, id);
        return ready;
    }

    void finish_view(std::span<ReadyCell> cells, const std::function<bool(const std::string&)>& /*goes_on*/) override {
        for (ReadyCell& cell : cells) {
            if (failing_in_motion.contains(cell.result.cell)) cell.result.status = CellStatus::failed;
        }
    }
    bool is_device_lost() const override { return lost; }
    gpu::DeviceStateSource& device_state() override { return state_; }
    std::size_t in_flight() const override { return 1; }
    TruthWork truths() const override { return {}; }

    std::vector<std::string> made;
    std::set<std::string> losing_at_once;
    std::set<std::string> losing_when_visited;
    std::set<std::string> failing;
    std::set<std::string> failing_in_motion;
    /// Milliseconds.
    std::map<std::string, double> preparations;
    std::set<std::string> kept;
    bool lost = false;

private:
    class Draw : public Subject {
    public:
        Draw(FakeCells& source, std::string id) : source_(&source), id_(std::move(id)) {}
        void warm_up() override {}
        Samples visit(int count) override {
            source_->lost = source_->lost || source_->losing_when_visited.contains(id_);
            if (source_->lost) fail("the device was lost");
            return {{"draw", std::vector<double>(static_cast<std::size_t>(count), 1.0)}};
        }

    private:
        FakeCells* source_;
        std::string id_;
    };

    const std::vector<Cell>* cells_;
    NothingKnown state_;
};

}  // namespace reliefbench
