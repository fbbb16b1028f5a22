#include "cli/stored_runs.hpp"

#include "core/error.hpp"
#include "core/suggest.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

namespace reliefbench {

namespace {

std::vector<std::string> runs_below(const std::filesystem::path& folder) {
    std::vector<std::string> runs;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        if (holds_run(entry.path())) runs.push_back(entry.path().string());
    }
    std::sort(runs.begin(), runs.end());
    return runs;
}

void refuse_folder_of_runs(const std::string& folder) {
    constexpr std::size_t named = 5;
    if (holds_run(folder)) return;
    std::vector<std::string> runs = runs_below(folder);
    if (runs.empty()) return;  // read_run says what is wrong
    const std::size_t count = runs.size();
    if (count > named) {
        runs.resize(named);
        runs.push_back("...");
    }
    fail("{} is no run, but a folder of {} ({}); name the runs that you mean", folder,
         count == 1 ? "one" : fmt::format("{} runs", count), join(runs));
}

}  // namespace

std::vector<StoredRun> read_stored_runs(const std::vector<std::string>& folders) {
    std::vector<StoredRun> runs;
    std::set<std::filesystem::path> known;
    for (std::string folder : folders) {
        refuse_folder_of_runs(folder);
        while (folder.size() > 1 && folder.ends_with('/')) {
            folder.pop_back();
        }
        std::error_code ignored;
        if (!known.insert(std::filesystem::weakly_canonical(folder, ignored)).second) {
            fail("the run {} is named twice; its evidence counts once", folder);
        }
        runs.push_back({folder, read_run(folder)});
    }
    return runs;
}

void keep_cells(std::vector<StoredRun>& runs, const std::vector<std::string>& texts) {
    if (texts.empty()) return;
    for (const std::string& text : texts) {
        const bool found = std::any_of(runs.begin(), runs.end(), [&](const StoredRun& run) {
            return std::any_of(run.run.cells.begin(), run.run.cells.end(),
                               [&](const CellResult& cell) { return cell.cell.find(text) != std::string::npos; });
        });
        if (!found) fail("--cell: no cell's id contains '{}'; cells.jsonl of a run lists them", text);
    }
    for (StoredRun& run : runs) {
        std::erase_if(run.run.cells, [&](const CellResult& cell) {
            return std::none_of(texts.begin(), texts.end(),
                                [&](const std::string& text) { return cell.cell.find(text) != std::string::npos; });
        });
    }
}

}  // namespace reliefbench
