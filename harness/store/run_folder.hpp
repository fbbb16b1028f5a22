#pragma once

#include "store/cell_result.hpp"
#include "store/line_file.hpp"

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// Of a run's folder; the other files are this writer's own.
inline constexpr const char* samples_file = "samples.jsonl";

/// One timing as drawn, for samples.jsonl.
struct RawSamples {
    std::string cell;
    std::string pass;
    int round = 0;
    /// Position of the visit within its round.
    int order = 0;
    int repeats = 1;
    std::vector<double> ms;
    /// The device was throttled: these do not count, another visit took their place.
    bool throttled = false;
};

/// One round of a block, for rounds.jsonl. Empty: the driver does not tell.
struct RoundRecord {
    std::size_t block = 0;
    int round = 0;
    /// Wall time.
    double seconds = 0;
    /// At the round's end.
    std::optional<double> clock_mhz = {};
    std::optional<double> memory_clock_mhz = {};
    std::optional<double> temperature_c = {};
    /// At the end of any visit.
    std::optional<bool> throttled = {};
};

/// images/<cell made fit for a file name><suffix> of a run's folder.
std::filesystem::path image_path(const std::filesystem::path& folder, const std::string& cell,
                                 const std::string& suffix);

/// Writes a run's folder. Every append is one whole line and is flushed; a write that fails (a full disk) is an Error
/// and leaves the file with whole lines only. One process at a time: a second one gets an Error.
class RunWriter {
public:
    /// Creates the run: an Error when the folder cannot be written or already holds one.
    RunWriter(const std::filesystem::path& folder, const Json& run);

    struct Continue {};
    /// Goes on with a run that was interrupted, with `run` in place of its run.json. Last lines that were cut short are
    /// taken out and told.
    RunWriter(const std::filesystem::path& folder, const Json& run, Continue);

    void append_cell(const CellResult& result);
    /// Takes the cells out of cells.jsonl that sampling ended for because the time was over (StopReason::time), for a
    /// run that goes on with them. Their samples stay in the folder.
    std::vector<CellResult> take_out_cut_off_cells();
    void append_samples(const RawSamples& samples);
    void append_round(const RoundRecord& round);
    /// Cells, samples, rounds, crashes and images of another run as they stand there. Last lines that were cut short
    /// are left out, and so are images that are there already (legends).
    void append_recorded(const std::filesystem::path& other_run);
    /// At the run's end: summary.json.
    void write_summary(const Json& summary);
    /// The path that the free function of this name gives; makes the folder on first use.
    std::filesystem::path image_path(const std::string& cell, const std::string& suffix);

    const std::filesystem::path& folder() const { return folder_; }
    /// What was mended in files of the interrupted run, in words.
    const std::vector<std::string>& repairs() const { return repairs_; }

private:
    std::filesystem::path folder_;
    std::optional<LineFile> cells_;
    std::optional<LineFile> samples_;
    std::optional<LineFile> rounds_;
    std::vector<std::string> repairs_;
};

/// summary.json; empty in a run that did not end. Strict as read_run.
std::optional<Json> read_run_summary(const std::filesystem::path& folder);

/// A run as read back.
struct Run {
    Json run;
    std::vector<CellResult> cells;
    /// What the cells may have: this version's, and those that a later one declared in run.json.
    std::shared_ptr<const FigureList> figures = declared_figures();
};

/// Strict: a line that is cut short, is no cell result or repeats a cell is an Error.
Run read_run(const std::filesystem::path& folder);

/// Of a run that may be interrupted or damaged: those up to the first line that cannot be read.
std::vector<CellResult> read_first_cells(const std::filesystem::path& folder);

/// The cells of a cells.jsonl; `file` is for messages.
std::vector<CellResult> parse_cells(std::istream& lines, const std::string& file,
                                    const std::shared_ptr<const FigureList>& figures = declared_figures());

/// run.json alone.
Json read_run_record(const std::filesystem::path& folder);

/// Whether there is a run.json.
bool holds_run(const std::filesystem::path& folder);

/// An Error when the folder holds a run or a part of one.
void refuse_second_run(const std::filesystem::path& folder);

/// A folder in which a run was interrupted before it had a run.json holds empty files at most: they are removed.
void remove_unstarted_run(const std::filesystem::path& folder);

}  // namespace reliefbench
