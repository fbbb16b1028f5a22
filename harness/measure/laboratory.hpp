#pragma once

#include "measure/pictures.hpp"
#include "measure/shared_inputs.hpp"
#include "store/cell_result.hpp"
#include "sweep/configuration.hpp"
#include "technique/failed_preparations.hpp"
#include "technique/renderer.hpp"
#include "technique/technique.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// A cell with everything known of it but the draw's time, or how it ended before there was anything to time.
struct PreparedCell {
    /// `ok`, or `skipped` or `failed` with the reason.
    CellResult result;
    /// Empty where the cell was not drawn.
    std::optional<Renderer> renderer = {};
    /// Pass times of the preparation, kept for samples.jsonl; of cells with figures.
    Preparation preparation = {};
    /// What the counted draw showed, of failed cells too; for pictures, dropped before sampling.
    std::optional<Probe> probe = {};
    /// Whether it was compared with its truth: a failed cell is, unless it failed before that or its technique answered
    /// out of range.
    bool is_compared = false;
};

/// What concerns making derived maps.
struct MapMaking {
    /// Where those that take long are kept (core/cache_folder.hpp); empty: nowhere.
    std::filesystem::path cache = {};
    /// Of earlier executions.
    FailedPreparations failed = {};
    /// FailedPreparations::prepare.
    std::function<void(const std::string& maps)> on_maps = {};
    /// Whether each pass is run several times where there is time for it. Else once, for what it makes.
    bool timed = true;
};

/// What is told while a cell is made ready. Each may be empty.
struct LaboratoryCallbacks {
    /// What is begun, in words ("compiling").
    std::function<void(const std::string& stage)> on_stage = {};
    /// How far maps are that take long to make.
    std::function<void(const PreparationProgress&)> on_progress = {};
};

/// Where cells are made ready, for whatever is then done with them: all commands call the same cells skipped and
/// failed, with the same words. All that it is given must outlive it.
class Laboratory {
public:
    Laboratory(const TechniqueLibrary& library, const Configuration& configuration, SharedInputs& inputs,
               MapMaking maps);

    /// Compiles, prepares (each pass timed several times) and draws the cell once, counted, and compares it with its
    /// view's truth. Skipped is what the configuration or the device does not allow, what does not fit into memory and
    /// what takes longer to prepare than the limit; failed is what ends with an Error, an allocation that fails
    /// included, and what is not the technique's picture (technique/draw_verdict.hpp). Maps that could not be made
    /// before are not tried again.
    PreparedCell make_ready(const Cell& cell, const LaboratoryCallbacks& callbacks = {});

    /// The same for its picture alone, which is not compared with its truth and gets no figures.
    PreparedCell make_picture(const Cell& cell, const LaboratoryCallbacks& callbacks = {});

    /// A cell that was made ready before, whose renderer has been freed since: compiled and prepared anew, for its
    /// draw's time. It has no figures, and no limit to its preparation, which has shown that it stays below.
    PreparedCell make_ready_again(const Cell& cell);

    const Manifest& manifest_of(const Cell& cell) const { return library_.get(cell.technique).manifest; }

    /// Frees the inputs that none of these views needs.
    void keep_only(const std::vector<ViewKey>& views) { inputs_.keep_only(views); }

    /// The cell's picture with what it is compared with; `probe` must outlive it, and the truth is valid until that of
    /// another view is asked for.
    DrawnCell beside_truth(const Cell& cell, const Probe& probe);

private:
    struct MapTiming;

    /// What the draw is made ready for.
    enum class Wanted { figures, picture };

    PreparedCell make(const Cell& cell, const LaboratoryCallbacks& callbacks, Wanted wanted);
    void prepare(const Cell& cell, const LaboratoryCallbacks& callbacks, const MapTiming& timing,
                 PreparedCell& prepared);
    Preparation prepare_maps(Renderer& renderer, const LaboratoryCallbacks& callbacks, const MapTiming& timing);
    std::string refusal(const Technique& technique, const Cell& cell) const;
    void measure(const Cell& cell, const LaboratoryCallbacks& callbacks, Wanted wanted, PreparedCell& prepared);
    void compare(const Cell& cell, const LaboratoryCallbacks& callbacks, PreparedCell& prepared);

    const TechniqueLibrary& library_;
    const Configuration& configuration_;
    SharedInputs& inputs_;
    MapMaking maps_;
};

/// Identity of the cell; nothing measured.
CellResult blank_result(const Cell& cell);

/// The same of a cell that is skipped or failed.
CellResult ended_result(const Cell& cell, CellStatus status, const std::string& reason);

/// "failed: <reason>", of a cell that is not ok.
std::string describe_ending(const CellResult& result);

/// Those maps that workers of an earlier execution died on, too often to be tried again (store/crashes.hpp).
FailedPreparations crashed_preparations(const std::map<std::string, std::vector<std::string>>& crashed);

/// "preparing (search) 34 %, 21 s left".
std::string describe(const PreparationProgress& progress);

}  // namespace reliefbench
