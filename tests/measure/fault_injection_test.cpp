// Every call of Vulkan fails once, by the layer of tests/faulty_layer: nothing crashes, nothing is left behind (the
// validation layer looks), nothing wrong is recorded, and with a new device the run ends as if nothing had been.

#include "core/error.hpp"
#include "faulty_layer/faulty_layer.hpp"
#include "gpu/device.hpp"
#include "measure/device_cells.hpp"
#include "measure/draw_subject.hpp"
#include "measure/run.hpp"
#include "support/temporary_folder.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

/// The layer as the loader loads it, in this process.
class FaultyLayer {
public:
    FaultyLayer() : library_(dlopen(RELIEFBENCH_FAULTY_LAYER, RTLD_NOW | RTLD_LOCAL)) {
        if (library_ == nullptr) throw std::runtime_error(dlerror());
        look_up("faulty_layer_start", start);
        look_up("faulty_layer_calls", calls);
        look_up("faulty_layer_name", name);
        setenv("VK_ADD_LAYER_PATH", RELIEFBENCH_FAULTY_LAYER_FOLDER, 1);
        setenv("VK_INSTANCE_LAYERS", "VK_LAYER_RELIEFBENCH_faulty", 1);
    }
    ~FaultyLayer() {
        unsetenv("VK_ADD_LAYER_PATH");
        unsetenv("VK_INSTANCE_LAYERS");
        dlclose(library_);
    }
    FaultyLayer(const FaultyLayer&) = delete;
    FaultyLayer& operator=(const FaultyLayer&) = delete;

    decltype(&faulty_layer_start) start = nullptr;
    decltype(&faulty_layer_calls) calls = nullptr;
    decltype(&faulty_layer_name) name = nullptr;

private:
    template <typename Function>
    void look_up(const char* symbol, Function& function) {
        function = reinterpret_cast<Function>(dlsym(library_, symbol));
        if (function == nullptr) throw std::runtime_error(dlerror());
    }

    void* library_;
};

/// What must not depend on faults.
std::string figures(const CellResult& cell) {
    Json kept;
    const Json json = to_json(cell);
    for (const char* key : {"error", "work", "pipeline", "image"})
        kept[key] = json.at(key);
    kept["bytes"] = json.at("prepare").at("bytes");
    return kept.dump();
}

class FaultInjection : public testing::Test {
protected:
    /// A quad, derived maps and tessellation, each as small as it gets.
    static Configuration configuration() {
        const Json json = Json::parse(R"({
            "name": "faults", "techniques": ["flat", "qdm", {"technique": "distance_map", "parameters": {"slices": 2}},
                           {"technique": "tessellation", "parameters": {"factor": 2}}],
            "axes": {"heightmap": "bricks", "heightmap_size": "8x8", "view_angle": 30, "resolution": "8x8"},
            "sampling": {"rule": "fixed", "rounds": 1, "samples_per_visit": 1, "warm_up": 0, "minimum_pass_ms": 0}
        })");
        return parse_configuration(json, "faults", {}, all_manifests());
    }

    static const TechniqueLibrary& library() {
        static const TechniqueLibrary techniques = find_techniques({default_technique_root()});
        return techniques;
    }

    static std::vector<Manifest> all_manifests() { return library().manifests(); }

    struct Execution {
        RunOutcome outcome;
        /// Of this and earlier executions, by cell.
        std::map<std::string, CellResult> cells;
        std::vector<std::string> validation_messages;
        /// Empty, or why there was no device or the run ended.
        std::string error;
    };

    /// Goes on with what the folder has.
    Execution execute(const std::filesystem::path& folder) {
        Execution execution;
        try {
            const gpu::Device device({.choice = {}, .validation = true});
            RunWriter writer = holds_run(folder) ? RunWriter(folder, Json::object(), RunWriter::Continue{})
                                                 : RunWriter(folder, Json::object());
            MeasureOptions options;
            options.earlier = read_earlier_work(folder, draw_pass);
            {
                DeviceCells source(device, library(), configuration_, cells_, writer, {});
                execution.outcome = run_cells(source, configuration_, cells_, writer, {}, steady_clock(), options);
            }
            execution.validation_messages = device.validation_messages();
        } catch (const Error& error) {
            execution.error = error.what();
        }
        if (holds_run(folder)) {
            for (CellResult& cell : read_run(folder).cells)
                execution.cells.emplace(cell.cell, cell);
        }
        return execution;
    }

    std::filesystem::path new_folder() { return folders_ / std::to_string(++folder_count_); }

    /// Which of so many calls fail in turn: with RELIEFBENCH_LONG_TESTS all, else of each function the last, or the
    /// first, too.
    std::vector<long> calls_to_fail(long calls, bool first_too) const {
        std::vector<long> chosen;
        if (std::getenv("RELIEFBENCH_LONG_TESTS") != nullptr) {
            for (long call = 0; call < calls; ++call)
                chosen.push_back(call);
            return chosen;
        }
        std::map<std::string, std::vector<long>> by_function;
        for (long call = 0; call < calls; ++call)
            by_function[layer_.name(call)].push_back(call);
        std::set<long> some;
        for (const auto& [function, its_calls] : by_function)
            some.insert({first_too ? its_calls.front() : its_calls.back(), its_calls.back()});
        return {some.begin(), some.end()};
    }

    FaultyLayer layer_;
    const Configuration configuration_ = configuration();
    const std::vector<Cell> cells_ = expand(configuration_, all_manifests());
    TemporaryFolder folders_;
    int folder_count_ = 0;
};

void expect_only_right_figures(const std::map<std::string, CellResult>& found,
                               const std::map<std::string, CellResult>& right, const std::string& what) {
    for (const auto& [id, cell] : found) {
        if (cell.status == CellStatus::ok) {
            EXPECT_EQ(figures(cell), figures(right.at(id))) << what << ": " << id;
        } else {
            EXPECT_EQ(cell.status, CellStatus::failed) << what << ": " << id;
            EXPECT_NE(cell.reason, "") << what << ": " << id;
        }
    }
}

TEST_F(FaultInjection, ACallThatFailsCostsOneCellAndNothingElse) {
    layer_.start(-1, false);
    const Execution right = execute(new_folder());
    ASSERT_EQ(right.error, "");
    ASSERT_EQ(right.outcome.tally.ok, cells_.size());
    ASSERT_THAT(right.validation_messages, testing::IsEmpty());
    for (const long call : calls_to_fail(layer_.calls(), true)) {
        layer_.start(call, false);
        const Execution faulty = execute(new_folder());
        const std::string what = std::to_string(call) + " (" + layer_.name(call) + ")";
        EXPECT_THAT(faulty.validation_messages, testing::IsEmpty()) << what;
        EXPECT_LE(faulty.outcome.tally.failed, 1U) << what;
        expect_only_right_figures(faulty.cells, right.cells, what);
        if (faulty.error.empty()) {
            EXPECT_EQ(faulty.cells.size(), cells_.size()) << what;
        }
    }
}

TEST_F(FaultInjection, ALostDeviceCostsTheCellThatLostItAndAnotherDeviceGoesOn) {
    layer_.start(-1, false);
    const Execution right = execute(new_folder());
    ASSERT_EQ(right.error, "");
    for (const long call : calls_to_fail(layer_.calls(), false)) {
        layer_.start(call, true);
        const std::filesystem::path folder = new_folder();
        const Execution lost = execute(folder);
        const std::string what = std::to_string(call) + " (" + layer_.name(call) + ")";
        EXPECT_THAT(lost.validation_messages, testing::IsEmpty()) << what;
        EXPECT_LE(lost.outcome.tally.failed, 1U) << what;
        EXPECT_EQ(lost.outcome.device_lost, lost.outcome.tally.failed == 1) << what;
        expect_only_right_figures(lost.cells, right.cells, what);

        layer_.start(-1, false);
        const Execution resumed = execute(folder);
        EXPECT_EQ(resumed.error, "") << what;
        EXPECT_EQ(resumed.cells.size(), cells_.size()) << what;
        expect_only_right_figures(resumed.cells, right.cells, what);
    }
}

}  // namespace
}  // namespace reliefbench
