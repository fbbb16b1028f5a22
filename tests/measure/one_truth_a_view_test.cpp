// The truth of a view is the dearest of a run's inputs, and all techniques and settings of the view share it.

#include "measure/device_cells.hpp"
#include "measure/run.hpp"
#include "support/temporary_folder.hpp"
#include "technique/test_scene.hpp"

#include <gmock/gmock.h>

#include <map>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

using OneTruthAView = test::DeviceTest;

/// Cells on the device, with a count of the truths that were traced while those of each view were made ready.
class CountingCells : public CellSource {
public:
    CountingCells(DeviceCells& cells, const std::vector<Cell>& all) : cells_(&cells), all_(&all) {}

    void begin_block(std::span<const std::size_t> cells) override { cells_->begin_block(cells); }
    ReadyCell make_ready(std::size_t cell, const std::function<void(const std::string&)>& on_progress) override {
        const std::size_t before = cells_->truths().traced;
        ReadyCell ready = cells_->make_ready(cell, on_progress);
        EXPECT_EQ(ready.result.status, CellStatus::ok) << ready.result.reason;
        const double angle = (*all_)[cell].view.view.camera.view_angle;
        ++made[angle];
        traced[angle] += static_cast<int>(cells_->truths().traced - before);
        return ready;
    }
    void finish_view(std::span<ReadyCell> cells, const std::function<bool(const std::string&)>& goes_on) override {
        cells_->finish_view(cells, goes_on);
    }
    bool is_device_lost() const override { return cells_->is_device_lost(); }
    gpu::DeviceStateSource& device_state() override { return cells_->device_state(); }
    std::size_t in_flight() const override { return cells_->in_flight(); }
    TruthWork truths() const override { return cells_->truths(); }

    /// By view angle.
    std::map<double, int> made, traced;

private:
    DeviceCells* cells_;
    const std::vector<Cell>* all_;
};

TEST_F(OneTruthAView, IsTracedForAllTechniquesAndSettingsOfARun) {
    const TechniqueLibrary library = find_techniques({default_technique_root()});
    const Json json = Json::parse(R"({
        "name": "shared",
        "techniques": ["flat", {"technique": "pom", "parameters": {"max_steps": [4, 8]}}, "qdm"],
        "axes": {"heightmap": "rock", "heightmap_size": 16, "resolution": "8x8", "view_angle": [0, 40, 60]},
        "sampling": {"rule": "fixed", "rounds": 1, "samples_per_visit": 1, "warm_up": 0, "minimum_pass_ms": 0}})");
    const Configuration configuration = parse_configuration(json, "test", {}, library.manifests());
    const std::vector<Cell> cells = expand(configuration, library.manifests());
    const TemporaryFolder folder;
    RunWriter writer(folder / "run", Json::object());
    DeviceCells on_device(device(), library, configuration, cells, writer, {});
    CountingCells counting(on_device, cells);
    run_cells(counting, configuration, cells, writer, {}, steady_clock(), {});
    EXPECT_THAT(counting.made, testing::ElementsAre(testing::Pair(0, 4), testing::Pair(40, 4), testing::Pair(60, 4)));
    EXPECT_THAT(counting.traced, testing::ElementsAre(testing::Pair(0, 1), testing::Pair(40, 1), testing::Pair(60, 1)));
}

}  // namespace
}  // namespace reliefbench
